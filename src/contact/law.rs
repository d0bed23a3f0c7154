//! A contact law: forces from where a node is, and the functions whose zeros change the state.
//!
//! Lengths instead of forces wherever a sign is all that matters: `|F_t| − μ_s |F_n|` over K is `|s| − μ_s δ`.

use glam::DVec2;

use super::{Local, paper, return_mapping};

/// Which friction law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Friction {
    /// The paper's (54)–(59) in continuous time (`docs/physics.md#law-paper`).
    Paper,
    /// Elastic-plastic Coulomb after Cundall and Strack.
    ReturnMapping,
}

/// The numbers of one contact, its share of the pair already taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// `K` \[N/m\].
    pub k: f64,
    /// `C_n` \[N·s/m\].
    pub c_n: f64,
    /// `C_t` \[N·s/m\].
    pub c_t: f64,
    /// `μ_s`.
    pub mu_s: f64,
    /// `μ_k`.
    pub mu_k: f64,
    /// Friction law.
    pub friction: Friction,
    /// Whether the normal force is held at 0 or above; when it is, the caller knows the phase.
    pub clamp: bool,
    /// Speed below which sliding in two directions counts as stopped; 0 where sliding has one direction only \[m/s\].
    pub v_stick: f64,
}

/// State of a closed contact with what it remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// p stays at `anchor`, in the face's coordinates, from where the node projected as placed \[m\].
    Stick {
        /// Where p is.
        anchor: DVec2,
    },
    /// Sliding in `direction` (unit). The paper's law in two directions looks at `V_t` instead.
    Slip {
        /// Unit direction of sliding in the face's axes.
        direction: DVec2,
    },
}

/// Forces on the node in the face's axes \[N\], and where p is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// `|F_n| = K δ`.
    pub normal: f64,
    /// Dashpot along the normal.
    pub normal_damping: f64,
    /// Tangential spring (stick, return mapping) or friction (paper's slip).
    pub tangential: DVec2,
    /// Tangential dashpot.
    pub tangential_damping: DVec2,
    /// `X_k − X_p` along the face \[m\].
    pub stretch: DVec2,
    /// `V_t` of (53b) \[m/s\].
    pub sliding: DVec2,
    /// `V_n` of (53b) \[m/s\].
    pub normal_velocity: f64,
    /// Rate of p along the face: the plastic part of the motion \[m/s\].
    pub anchor_rate: DVec2,
}

impl Forces {
    /// Whole normal force \[N\].
    pub fn normal_total(&self) -> f64 {
        self.normal + self.normal_damping
    }

    /// Whole tangential force \[N\].
    pub fn tangential_total(&self) -> DVec2 {
        self.tangential + self.tangential_damping
    }
}

/// What happens to a contact at breakaway.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Breakaway {
    /// The slip that begins.
    pub mode: Mode,
    /// Energy that the jump of p releases \[J\].
    pub released: f64,
}

impl Law {
    /// Whether friction acts at all: without it there is nothing to stick.
    pub fn has_friction(&self) -> bool {
        self.mu_s > 0.0
    }

    /// Forces on the node; the caller asks only while the contact is closed.
    #[inline]
    pub fn forces(&self, mode: &Mode, here: &Local) -> Forces {
        match (mode, self.friction) {
            (Mode::Stick { anchor }, _) => stick(self, *anchor, here),
            (Mode::Slip { direction }, Friction::Paper) => paper::slip(self, *direction, here),
            (Mode::Slip { direction }, Friction::ReturnMapping) => return_mapping::slip(self, *direction, here),
        }
    }

    /// Function that is negative while the state holds and rises through 0 when it ends: breakaway in stick, stopping in
    /// slip.
    #[inline]
    pub fn switch(&self, mode: &Mode, here: &Local) -> f64 {
        match (mode, self.friction) {
            (Mode::Stick { anchor }, _) => (here.way - *anchor).length() - self.mu_s * here.penetration(),
            (Mode::Slip { direction }, Friction::Paper) => paper::stopping(self, *direction, here),
            (Mode::Slip { direction }, Friction::ReturnMapping) => return_mapping::stopping(self, *direction, here),
        }
    }

    /// Mode of a contact that closes: stick if `|V_t| < μ_s |V_n|`, else slip along `V_t` (`docs/physics.md#closing`).
    /// Where the node has no normal velocity the caller passes accelerations.
    pub fn on_closing(&self, here: &Local, tangential: DVec2, normal: f64) -> Mode {
        if tangential.length() < self.mu_s * normal.abs() {
            Mode::Stick { anchor: here.way }
        } else {
            Mode::Slip { direction: tangential.try_normalize().unwrap_or(DVec2::X) }
        }
    }

    /// What breakaway makes of a stick (`docs/physics.md#breakaway`).
    pub fn on_breakaway(&self, anchor: DVec2, here: &Local) -> Breakaway {
        match self.friction {
            Friction::Paper => paper::breakaway(self, anchor, here),
            Friction::ReturnMapping => return_mapping::breakaway(self, anchor, here),
        }
    }

    /// What stopping makes of a slip (`docs/physics.md#stop`).
    pub fn on_stopping(&self, direction: DVec2, here: &Local) -> Mode {
        match self.friction {
            Friction::Paper => Mode::Stick { anchor: here.way },
            Friction::ReturnMapping => Mode::Stick { anchor: here.way - direction * (self.mu_k * here.penetration()) },
        }
    }

    /// Strain energy of the contact's springs \[J\].
    pub fn strain(&self, forces: &Forces) -> f64 {
        0.5 * (forces.normal.powi(2) / self.k + self.k * forces.stretch.length_squared())
    }
}

/// (57a), the same in both laws: spring to p and both dashpots.
fn stick(law: &Law, anchor: DVec2, here: &Local) -> Forces {
    let stretch = here.way - anchor;
    let (sliding, normal_velocity) = here.relative_velocity(stretch);
    Forces {
        normal: law.k * here.penetration(),
        normal_damping: -law.c_n * normal_velocity,
        tangential: stretch * -law.k,
        tangential_damping: sliding * -law.c_t,
        stretch,
        sliding,
        normal_velocity,
        anchor_rate: DVec2::ZERO,
    }
}
