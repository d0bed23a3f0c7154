//! A contact law: forces from position and velocity of a node relative to a face, and the switching functions whose
//! zeros change the state {open, stick, slip} (`docs/physics.md#contact-events`).
//!
//! Switching functions of stick are lengths: `|F_t| − μ_s N` over `k_t` is `|s| − μ_s ℓ` with `ℓ = N(δ)/k_t`.

use std::fmt::Debug;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::{Local, Normal, NormalLaw};

/// Friction law of a pair in a scene (`docs/physics.md#friction-laws`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FrictionLaw {
    /// (54)–(59) of the paper in continuous time: in slip the anchor is the projection, and on return to stick the
    /// tangential force restarts at 0.
    Paper,
    /// Elastic-plastic Coulomb friction (Cundall and Strack): the anchor is dragged, the force is continuous on
    /// return to stick.
    #[default]
    ReturnMapping,
}

impl FrictionLaw {
    /// All laws, in the order of the documentation.
    pub const ALL: &'static [Self] = &[Self::Paper, Self::ReturnMapping];
    /// Names of all laws in files.
    pub const WORDS: &'static [&'static str] = &[Self::Paper.label(), Self::ReturnMapping.label()];
    /// Law of a scene without a law.
    pub const DEFAULT: Self = Self::ReturnMapping;

    /// Name in files and tables.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::ReturnMapping => "return-mapping",
        }
    }
}

/// Direction of friction in slip where sliding has two directions. Where it has one, it is that with which the slip began.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlipDirection {
    /// Constant, that with which the slip began.
    Constant,
    /// That of `V_t` at every instant, regularised: `V_t / max(|V_t|, v_stick)`.
    OfVelocity,
    /// A state of the integrator, the angle φ with `φ̇ = d⊥·Ẋ / (μ_k ℓ + ℓ_r)` and `d = (cos φ, sin φ)`, Ẋ the rate of the
    /// node along the face and `ℓ_r` a regularisation length (`docs/physics.md#law-return-mapping`).
    State,
}

/// Derivative of friction by `V_t` of a law with [`SlipDirection::OfVelocity`]: `along d dᵀ + across t tᵀ`, with t perpendicular to d
/// \[N·s/m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingDerivative {
    /// Unit direction d of `V_t` in the face's axes.
    pub direction: DVec2,
    /// By the speed \[N·s/m\].
    pub along: f64,
    /// By the velocity across, which turns the direction \[N·s/m\].
    pub across: f64,
}

/// A friction law: forces in slip, end of slip, and the changes between stick and slip (`docs/physics.md#friction-laws`).
///
/// Stick is the same in all laws, (57a): a spring and a dashpot to the anchor, up to `|F_t| = μ_s N`. The numbers μ, `k_t`, `C_t` and
/// `v_stick` are those of the [`Law`].
pub trait FrictionRule: Debug + Send + Sync {
    /// Forces on the node in slip along the unit direction `direction` of the face's axes \[N\].
    fn slip(&self, law: &Law, direction: DVec2, here: &Local) -> Forces;

    /// Those forces where the direction is a state that turns at its regularised rate, with the regularisation length \[m\].
    fn slip_turning(&self, law: &Law, direction: DVec2, here: &Local, _regularisation: f64) -> Forces {
        self.slip(law, direction, here)
    }

    /// Switching function of slip, negative while it lasts (`docs/physics.md#stop`) \[m/s\].
    fn stopping(&self, law: &Law, direction: DVec2, here: &Local) -> f64;

    /// Slip after breakaway, and the energy released (`docs/physics.md#breakaway`).
    fn breakaway(&self, law: &Law, anchor: DVec2, here: &Local) -> Breakaway;

    /// Stick after a stop (`docs/physics.md#stop`).
    fn on_stopping(&self, law: &Law, direction: DVec2, here: &Local) -> Mode;

    /// Direction of friction where sliding has two.
    fn direction(&self) -> SlipDirection;

    /// Whether the tangential force is continuous at a stop. Where it is not, stick may exceed the static limit at once.
    fn is_continuous_at_stop(&self) -> bool;

    /// Whether the tangential dashpot acts in slip as in stick.
    fn is_damped_in_slip(&self) -> bool;

    /// Derivative of friction by `V_t`, for [`SlipDirection::OfVelocity`]; by default that of `−μ_k N V_t / max(|V_t|, v_stick)`.
    fn sliding_derivative(&self, law: &Law, forces: &Forces) -> SlidingDerivative {
        let (speed, least) = (forces.sliding.length(), law.v_stick);
        let friction = law.mu_k * forces.normal;
        SlidingDerivative {
            direction: forces.sliding.try_normalize().unwrap_or(DVec2::X),
            along: if speed < least { -friction / least } else { 0.0 },
            across: -friction / speed.max(least),
        }
    }
}

/// Friction law of a contact, stored by value.
#[derive(Clone, Copy, Debug)]
pub enum Friction {
    /// A law of this package.
    Named(FrictionLaw),
    /// A law defined outside of this package.
    Custom(&'static dyn FrictionRule),
}

impl PartialEq for Friction {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Named(one), Self::Named(other)) => one == other,
            (Self::Custom(one), Self::Custom(other)) => std::ptr::addr_eq(*one, *other),
            (Self::Named(_), Self::Custom(_)) | (Self::Custom(_), Self::Named(_)) => false,
        }
    }
}

impl From<FrictionLaw> for Friction {
    fn from(law: FrictionLaw) -> Self {
        Self::Named(law)
    }
}

/// Law of one contact, or of a pair before its division among nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// Normal law.
    pub normal: Normal,
    /// Stiffness of the tangential spring `k_t` \[N/m\].
    pub k_t: f64,
    /// Tangential dashpot `C_t` \[N·s/m\].
    pub c_t: f64,
    /// Coefficient of static friction `μ_s` \[–\].
    pub mu_s: f64,
    /// Coefficient of kinetic friction `μ_k` \[–\].
    pub mu_k: f64,
    /// Friction law.
    pub friction: Friction,
    /// Whether the normal force is held at 0 or above (`clamp`); whether it is held at 0 at present is part of a
    /// contact's state.
    pub clamp: bool,
    /// Speed `v_stick` below which sliding in two directions counts as stopped; 0 for one direction of sliding
    /// \[m/s\].
    pub v_stick: f64,
}

/// Mode of a closed contact, with the quantities that the forces depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Stick: the anchor p stays on the face.
    Stick {
        /// Position of p along the face, relative to the projection of the node as placed \[m\].
        anchor: DVec2,
    },
    /// Slip along `direction`; law `paper` in two directions of sliding takes the direction of `V_t` instead.
    Slip {
        /// Unit direction of sliding in the face's axes.
        direction: DVec2,
    },
}

/// Forces on the node in the face's axes \[N\], and the anchor p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// Elastic normal force `N(δ)` \[N\].
    pub normal: f64,
    /// Normal damping force \[N\].
    pub normal_damping: f64,
    /// Force of the tangential spring (stick, return mapping), or friction (slip of law `paper`) \[N\].
    pub tangential: DVec2,
    /// Force of the tangential dashpot \[N\].
    pub tangential_damping: DVec2,
    /// Stretch, tangential part of `X_k − X_p` \[m\].
    pub stretch: DVec2,
    /// Tangential velocity `V_t` of (53b) \[m/s\].
    pub sliding: DVec2,
    /// Normal velocity `V_n` of (53b) \[m/s\].
    pub normal_velocity: f64,
    /// Rate of the anchor along the face, the plastic part of the motion \[m/s\].
    pub anchor_rate: DVec2,
}

impl Forces {
    /// Sum of the normal forces \[N\].
    pub fn normal_total(&self) -> f64 {
        self.normal + self.normal_damping
    }

    /// Sum of the tangential forces \[N\].
    pub fn tangential_total(&self) -> DVec2 {
        self.tangential + self.tangential_damping
    }
}

/// Transition of a contact at breakaway.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Breakaway {
    /// Mode after breakaway.
    pub mode: Mode,
    /// Energy released by the jump of the anchor \[J\].
    pub released: f64,
}

impl Law {
    /// Whether the law has friction; without it there is no stick.
    pub fn has_friction(&self) -> bool {
        self.mu_s > 0.0
    }

    /// Normal force as a length, `ℓ = N(δ)/k_t` \[m\].
    #[inline]
    pub fn length(&self, here: &Local) -> f64 {
        self.normal.length(here.penetration(), self.k_t)
    }

    /// Stretch of the tangential spring in slip, `μ_k ℓ`; 0 in front of the face \[m\].
    #[inline]
    pub fn slip_stretch(&self, here: &Local) -> f64 {
        (self.mu_k * self.length(here)).max(0.0)
    }

    /// Derivative of the length by the penetration, `dℓ/dδ` \[–\].
    #[inline]
    pub fn length_slope(&self, here: &Local) -> f64 {
        self.normal.length_slope(here.penetration(), self.k_t)
    }

    /// Velocities `(V_t, V_n)` of the node relative to the point of the face's body at which the reaction acts \[m/s\]: the
    /// anchor, (53b), or the node's own place (`docs/physics.md#point-of-action`).
    #[inline]
    pub fn velocity(&self, here: &Local, stretch: DVec2) -> (DVec2, f64) {
        if self.normal.is_along_stretch() { here.relative_velocity(stretch) } else { (here.rate, here.gap_rate) }
    }

    /// Normal forces and velocities with the anchor at stretch `stretch`, without tangential force.
    #[inline]
    pub fn pressed(&self, here: &Local, stretch: DVec2) -> Forces {
        let (sliding, normal_velocity) = self.velocity(here, stretch);
        let [normal, normal_damping] = self.normal.forces(here.penetration(), normal_velocity);
        Forces {
            normal,
            normal_damping,
            tangential: DVec2::ZERO,
            tangential_damping: DVec2::ZERO,
            stretch,
            sliding,
            normal_velocity,
            anchor_rate: DVec2::ZERO,
        }
    }

    /// Mode of a contact at its closing (`docs/physics.md#closing`): stick if the tangential force grows more slowly
    /// than its limit, `k_t |V_t| < μ_s N′ |V_n|`, otherwise slip along `V_t`. Where both velocities are 0, the rates
    /// given are accelerations.
    pub fn on_closing(&self, here: &Local, tangential: DVec2, normal: f64) -> Mode {
        let limit = self.mu_s * self.length_slope(here) * normal.abs();
        // For N′(0) = 0 a contact without tangential velocity sticks.
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

    /// Powers dissipated by the normal law, the tangential dashpot and friction \[W\].
    pub fn dissipated_powers(&self, forces: &Forces) -> [f64; 3] {
        let velocity = forces.normal_velocity;
        [
            self.normal.plastic_power(velocity) - forces.normal_damping * velocity,
            -forces.tangential_damping.dot(forces.sliding - forces.anchor_rate),
            -forces.tangential_total().dot(forces.anchor_rate),
        ]
    }

    /// Energy of the normal spring of a node that closes behind its face, at a crossing by round-off \[J\].
    pub fn entry_energy(&self, here: &Local) -> f64 {
        self.normal.entry_energy(here.penetration())
    }

    /// Whether the normal force has kinks within a touch: zeros that switch the clamp, or ends of phases.
    pub fn has_kinks(&self) -> bool {
        (self.clamp && self.normal.can_pull()) || self.normal.has_phases()
    }

    /// Law of a touch that begins with a node here.
    #[must_use]
    pub fn begun(self, here: &Local) -> Self {
        let (_, velocity) = self.velocity(here, DVec2::ZERO);
        Self { normal: self.normal.begun(here.penetration(), velocity), ..self }
    }

    /// Law of a node that takes over, at this penetration \[m\], from one of the same pair with the law `before`.
    #[must_use]
    pub fn resumed(self, before: &Self, penetration: f64) -> Self {
        Self { normal: self.normal.resumed(before.normal, penetration), ..self }
    }
}
