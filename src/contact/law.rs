//! A contact law: forces from the position and velocity of a node against a face, and the switching functions whose zeros
//! change the state {open, stick, slip}.
//!
//! Switching functions are lengths, not forces: `|F_t| − μ_s N` over `k_t` is `|s| − μ_s ℓ` with `ℓ = N(δ)/k_t`.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::{Local, Normal, NormalLaw};

/// What friction does in slip and on re-stick (`docs/physics.md#friction-laws`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FrictionLaw {
    /// The paper's (54)–(59) in continuous time: the anchor is the projection in slip, the tangential force restarts at 0 on
    /// re-stick.
    Paper,
    /// Elastic-plastic Coulomb (Cundall and Strack): the anchor is dragged, the force is continuous on re-stick.
    #[default]
    ReturnMapping,
}

impl FrictionLaw {
    /// Every law, in the order of the documentation.
    pub const ALL: &'static [Self] = &[Self::Paper, Self::ReturnMapping];
    /// Their words in files.
    pub const WORDS: &'static [&'static str] = &[Self::Paper.label(), Self::ReturnMapping.label()];
    /// The law of a scene that names none.
    pub const DEFAULT: Self = Self::ReturnMapping;

    /// The word used in files and tables.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::ReturnMapping => "return-mapping",
        }
    }
}

/// The law of one contact, or of a whole pair before it is divided among its nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// Force along the normal.
    pub normal: Normal,
    /// Stiffness of the tangential spring \[N/m\].
    pub k_t: f64,
    /// `C_t` \[N·s/m\].
    pub c_t: f64,
    /// `μ_s`.
    pub mu_s: f64,
    /// `μ_k`.
    pub mu_k: f64,
    /// Friction law.
    pub friction: FrictionLaw,
    /// Whether the normal force is held at 0 or above; the phase in which it is, is a state of the contact.
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
    /// Elastic normal force `N(δ)`.
    pub normal: f64,
    /// Damping force along the normal.
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

    /// Powers dissipated by the normal dashpot, the tangential dashpot and friction \[W\].
    pub fn dissipated_powers(&self) -> [f64; 3] {
        [
            -self.normal_damping * self.normal_velocity,
            -self.tangential_damping.dot(self.sliding - self.anchor_rate),
            -self.tangential_total().dot(self.anchor_rate),
        ]
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

    /// Normal force as a length, `ℓ = N(δ)/k_t` \[m\].
    #[inline]
    pub fn length(&self, here: &Local) -> f64 {
        self.normal.length(here.penetration(), self.k_t)
    }

    /// Length of a slipping contact's tangential spring, `μ_k ℓ`, 0 before the face \[m\].
    #[inline]
    pub fn slip_stretch(&self, here: &Local) -> f64 {
        (self.mu_k * self.length(here)).max(0.0)
    }

    /// Derivative of the length by the penetration, `dℓ/dδ` \[–\].
    #[inline]
    pub(super) fn length_slope(&self, here: &Local) -> f64 {
        self.normal.length_slope(here.penetration(), self.k_t)
    }

    /// Normal forces and velocities with the anchor at that stretch; no tangential force.
    #[inline]
    pub(super) fn pressed(&self, here: &Local, stretch: DVec2) -> Forces {
        let (sliding, normal_velocity) = here.relative_velocity(stretch);
        let penetration = here.penetration();
        Forces {
            normal: self.normal.elastic(penetration),
            normal_damping: self.normal.damping(penetration, normal_velocity),
            tangential: DVec2::ZERO,
            tangential_damping: DVec2::ZERO,
            stretch,
            sliding,
            normal_velocity,
            anchor_rate: DVec2::ZERO,
        }
    }

    /// Mode of a contact that closes (`docs/physics.md#closing`): stick if the tangential force grows more slowly than its limit,
    /// `k_t |V_t| < μ_s N′ |V_n|`, else slip along `V_t`. Where the normal velocity is 0, rates are accelerations.
    pub fn on_closing(&self, here: &Local, tangential: DVec2, normal: f64) -> Mode {
        let limit = self.mu_s * self.length_slope(here) * normal.abs();
        // A law with N′(0) = 0 sticks where nothing moves along the face.
        let still = tangential == DVec2::ZERO && normal != 0.0 && self.has_friction();
        if still || tangential.length() < limit {
            Mode::Stick { anchor: here.way }
        } else {
            Mode::Slip { direction: tangential.try_normalize().unwrap_or(DVec2::X) }
        }
    }

    /// Strain energy of normal law and tangential spring \[J\].
    pub fn strain(&self, here: &Local, forces: &Forces) -> f64 {
        self.normal.stored_energy(here.penetration()) + 0.5 * (self.k_t * forces.stretch.length_squared())
    }

    /// Energy of an overlap of rounding size at the instant of closing, `½ N δ` by the trapezoidal rule \[J\].
    pub fn entry_energy(&self, here: &Local) -> f64 {
        0.5 * self.normal.elastic(here.penetration()) * here.penetration()
    }

    /// Whether the normal force has zeros that end a phase of the clamp.
    pub fn has_kinks(&self) -> bool {
        self.clamp && self.normal.can_pull()
    }
}
