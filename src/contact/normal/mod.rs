//! Normal contact laws: normal force as a function of the penetration δ and the normal velocity
//! (`docs/physics.md#normal-law`).
//!
//! All quantities that depend on the shape of `N(δ)` are methods of [`NormalLaw`]: forces, stored energy, stiffness,
//! time scale, and the scales of numerical tolerances. A new law is one file with implementations of the trait and of
//! [`Phases`], one variant of [`Normal`] and its arms in the matches of this file; its name in a scene: `contact/calibration.rs`. From
//! outside of the package a law enters as [`Normal::Custom`], with its phases as a [`PhasedLaw`].

mod approach;
mod bilinear;
mod constants;
mod custom;
mod hertz;
mod linear;
mod phased;
mod phases;

use std::fmt::Debug;

pub use approach::Approach;
pub use bilinear::{Bilinear, Branch};
pub use constants::LEAST_IMPACT_SPEED;
pub use custom::Custom;
pub use hertz::{Hertz, HertzDashpot};
pub use linear::Linear;
pub use phased::{Phase, PhasedLaw};
pub use phases::{Phases, Stage};

/// A normal contact law. δ is the penetration \[m\], `V_n` the normal velocity of (53b), positive apart \[m/s\].
///
/// An integrator evaluates `N(δ)` a little before the face too, δ < 0.
pub trait NormalLaw: Debug + Send + Sync {
    /// Elastic force `N(δ)` \[N\], rising in δ, `N(0) = 0`.
    fn elastic(&self, penetration: f64) -> f64;

    /// Damping force at penetration δ and normal velocity `V_n` \[N\]; positive on the way in.
    fn damping(&self, penetration: f64, velocity: f64) -> f64;

    /// Elastic and damping force at once \[N\].
    fn forces(&self, penetration: f64, velocity: f64) -> [f64; 2] {
        [self.elastic(penetration), self.damping(penetration, velocity)]
    }

    /// Energy stored by the elastic force, `∫ N dδ` from 0 \[J\].
    fn stored_energy(&self, penetration: f64) -> f64;

    /// Tangent stiffness `dN/dδ` \[N/m\].
    fn tangent_stiffness(&self, penetration: f64) -> f64;

    /// Largest tangent stiffness at penetrations up to `deepest` \[N/m\].
    fn stiffness_bound(&self, deepest: f64) -> f64;

    /// Tangent damping `−∂N/∂V_n` at `V_n = 0` \[N·s/m\].
    fn damping_coefficient(&self, penetration: f64) -> f64;

    /// Largest tangent damping at penetrations up to `deepest` \[N·s/m\].
    fn damping_bound(&self, deepest: f64) -> f64;

    /// Circular frequency π/t of a contact of duration t between a mass \[kg\] and a fixed face at that impact speed
    /// \[m/s\], without damping \[rad/s\].
    fn frequency(&self, mass: f64, speed: f64) -> f64;

    /// Largest penetration of that impact \[m\].
    fn depth(&self, mass: f64, speed: f64) -> f64;

    /// Whether elastic and damping force together can be negative, a pull, at δ > 0.
    fn can_pull(&self) -> bool;

    /// Parameters by which a digest distinguishes laws.
    fn digest(&self, add: &mut dyn FnMut(f64));

    /// Power of internal friction of the spring, in addition to that of the damping force \[W\].
    fn plastic_power(&self, _velocity: f64) -> f64 {
        0.0
    }

    /// Whether the reaction on the face's body acts at the anchor: normal and tangential spring have one constant stiffness, so that
    /// their force points along the stretch (`docs/physics.md#point-of-action`).
    fn is_along_stretch(&self) -> bool {
        false
    }

    /// Whether the law itself has no pull: elastic and damping force together are held at 0 or above.
    fn excludes_pull(&self) -> bool {
        false
    }

    /// Whether the force is a power series in δ at δ = 0; that of `δ^{3/2}` is none.
    fn is_power_series(&self) -> bool {
        true
    }

    /// Stored energy of a touch that begins at this penetration, by default that of a force in proportion to δ, `½ N δ` \[J\].
    fn entry_energy(&self, penetration: f64) -> f64 {
        self.elastic(penetration) * penetration / 2.0
    }

    /// Stored energy of a spring that has not yielded, per its constant, which alone differs among the contacts of a pair; by default `δ²`,
    /// of a force in proportion to δ \[m², or another unit of the law's own\].
    fn relative_energy(&self, penetration: f64) -> f64 {
        penetration * penetration
    }

    /// Penetration of this [`relative_energy`](Self::relative_energy) \[m\].
    fn depth_of_relative_energy(&self, energy: f64) -> f64 {
        energy.sqrt()
    }

    /// Normal force as a length: the stretch of a spring of stiffness `k_t` that carries `N(δ)`, `N/k_t` \[m\].
    fn length(&self, penetration: f64, k_t: f64) -> f64 {
        self.elastic(penetration) / k_t
    }

    /// Derivative of the length by δ, `N′/k_t` \[–\].
    fn length_slope(&self, penetration: f64, k_t: f64) -> f64 {
        self.tangent_stiffness(penetration) / k_t
    }

    /// Scale of the normal force at penetrations and speeds of these sizes, for the tolerance of its zeros \[N\].
    fn force_scale(&self, depth: f64, speed: f64) -> f64 {
        self.elastic(depth) + self.damping_coefficient(depth) * speed
    }

    /// Scale of the change of the normal force at δ by a change of δ of this size at this circular frequency \[N\].
    fn change_scale(&self, penetration: f64, change: f64, frequency: f64) -> f64 {
        change * (self.tangent_stiffness(penetration) + self.damping_coefficient(penetration) * frequency)
    }
}

/// Normal law of a contact, stored by value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Normal {
    /// Kelvin–Voigt, (54).
    Linear(Linear),
    /// Linear, with a dashpot in the approach alone.
    Approach(Approach),
    /// Hertz's spring with a dashpot.
    Hertz(Hertz),
    /// Bilinear spring.
    Bilinear(Bilinear),
    /// A law defined outside of this package.
    Custom(Custom),
}

/// Evaluates an expression of [`NormalLaw`] for a law: directly for the linear one, whose few operations are then part of
/// the loop around them, through the trait for the others.
macro_rules! of_each {
    ($normal:expr, $law:ident => $value:expr) => {
        match $normal {
            Normal::Linear($law) => $value,
            other => {
                let $law = other.other_than_linear();
                $value
            }
        }
    };
}

/// Evaluates an expression of [`Phases`] for the law of each variant.
macro_rules! phase_of_each {
    ($normal:expr, $law:ident => $value:expr) => {
        match $normal {
            Normal::Linear($law) => $value,
            Normal::Approach($law) => $value,
            Normal::Hertz($law) => $value,
            Normal::Bilinear($law) => $value,
            Normal::Custom($law) => $value,
        }
    };
}

/// Maps the law of each variant to one of the same variant.
macro_rules! as_each {
    ($normal:expr, $law:ident => $value:expr) => {
        match $normal {
            Normal::Linear($law) => Normal::Linear($value),
            Normal::Approach($law) => Normal::Approach($value),
            Normal::Hertz($law) => Normal::Hertz($value),
            Normal::Bilinear($law) => Normal::Bilinear($value),
            Normal::Custom($law) => Normal::Custom($value),
        }
    };
}

impl Normal {
    /// The law as one of any kind.
    #[cold]
    fn other_than_linear(&self) -> &dyn NormalLaw {
        phase_of_each!(self, law => law)
    }

    /// Law of one of `parts` equal contacts that act in parallel as this law.
    #[must_use]
    pub fn divided(self, parts: f64) -> Self {
        as_each!(self, law => law.divided(parts))
    }

    /// Law of `count` contacts of this law and of equal penetration in parallel.
    #[must_use]
    pub fn times(self, count: f64) -> Self {
        as_each!(self, law => law.times(count))
    }

    /// Law of a touch that begins at this penetration \[m\], 0 but for a node that is inside already, and normal velocity,
    /// positive apart \[m/s\].
    #[must_use]
    pub fn begun(self, penetration: f64, velocity: f64) -> Self {
        as_each!(self, law => law.begun(penetration, velocity))
    }

    /// Law of a node that takes over, at this penetration \[m\], from one of the same pair with the law `before`.
    #[must_use]
    pub fn resumed(self, before: Self, penetration: f64) -> Self {
        match (self, before) {
            (Self::Approach(law), Self::Approach(before)) => Self::Approach(law.resumed(before, penetration)),
            (Self::Hertz(law), Self::Hertz(before)) => Self::Hertz(law.resumed(before, penetration)),
            (Self::Custom(law), Self::Custom(before)) => Self::Custom(law.resumed(before, penetration)),
            (Self::Linear(_) | Self::Approach(_) | Self::Hertz(_) | Self::Bilinear(_) | Self::Custom(_), _) => {
                self.begun(penetration, 0.0)
            }
        }
    }

    /// Whether a touch has several phases, which end by events.
    pub fn has_phases(&self) -> bool {
        phase_of_each!(self, law => law.has_phases())
    }

    /// Switching function of the end of the present phase, negative while it lasts, in a unit of the phase's own.
    pub fn phase_end(&self, penetration: f64, velocity: f64) -> f64 {
        phase_of_each!(self, law => law.phase_end(penetration, velocity))
    }

    /// Scale of that function at penetrations \[m\] and speeds \[m/s\] of these sizes.
    pub fn phase_end_scale(&self, depth: f64, speed: f64) -> f64 {
        phase_of_each!(self, law => law.phase_end_scale(depth, speed))
    }

    /// Scale of its change by a change of δ of this size \[m\] at this circular frequency \[rad/s\].
    pub fn phase_end_change(&self, change: f64, frequency: f64) -> f64 {
        phase_of_each!(self, law => law.phase_end_change(change, frequency))
    }

    /// Law in the phase after the present one, which ends at this penetration \[m\].
    #[must_use]
    pub fn next_phase(self, penetration: f64) -> Self {
        as_each!(self, law => law.next_phase(penetration))
    }
}

impl NormalLaw for Normal {
    #[inline]
    fn elastic(&self, penetration: f64) -> f64 {
        of_each!(self, law => law.elastic(penetration))
    }

    #[inline]
    fn damping(&self, penetration: f64, velocity: f64) -> f64 {
        of_each!(self, law => law.damping(penetration, velocity))
    }

    #[inline]
    fn forces(&self, penetration: f64, velocity: f64) -> [f64; 2] {
        of_each!(self, law => law.forces(penetration, velocity))
    }

    fn stored_energy(&self, penetration: f64) -> f64 {
        of_each!(self, law => law.stored_energy(penetration))
    }

    #[inline]
    fn tangent_stiffness(&self, penetration: f64) -> f64 {
        of_each!(self, law => law.tangent_stiffness(penetration))
    }

    fn stiffness_bound(&self, deepest: f64) -> f64 {
        of_each!(self, law => law.stiffness_bound(deepest))
    }

    #[inline]
    fn damping_coefficient(&self, penetration: f64) -> f64 {
        of_each!(self, law => law.damping_coefficient(penetration))
    }

    fn damping_bound(&self, deepest: f64) -> f64 {
        of_each!(self, law => law.damping_bound(deepest))
    }

    fn frequency(&self, mass: f64, speed: f64) -> f64 {
        of_each!(self, law => law.frequency(mass, speed))
    }

    fn depth(&self, mass: f64, speed: f64) -> f64 {
        of_each!(self, law => law.depth(mass, speed))
    }

    fn can_pull(&self) -> bool {
        of_each!(self, law => law.can_pull())
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        of_each!(self, law => law.digest(add));
    }

    #[inline]
    fn plastic_power(&self, velocity: f64) -> f64 {
        of_each!(self, law => law.plastic_power(velocity))
    }

    #[inline]
    fn is_along_stretch(&self) -> bool {
        of_each!(self, law => law.is_along_stretch())
    }

    fn excludes_pull(&self) -> bool {
        of_each!(self, law => law.excludes_pull())
    }

    fn is_power_series(&self) -> bool {
        of_each!(self, law => law.is_power_series())
    }

    fn entry_energy(&self, penetration: f64) -> f64 {
        of_each!(self, law => law.entry_energy(penetration))
    }

    fn relative_energy(&self, penetration: f64) -> f64 {
        of_each!(self, law => law.relative_energy(penetration))
    }

    fn depth_of_relative_energy(&self, energy: f64) -> f64 {
        of_each!(self, law => law.depth_of_relative_energy(energy))
    }

    #[inline]
    fn length(&self, penetration: f64, k_t: f64) -> f64 {
        of_each!(self, law => law.length(penetration, k_t))
    }

    #[inline]
    fn length_slope(&self, penetration: f64, k_t: f64) -> f64 {
        of_each!(self, law => law.length_slope(penetration, k_t))
    }

    fn force_scale(&self, depth: f64, speed: f64) -> f64 {
        of_each!(self, law => law.force_scale(depth, speed))
    }

    fn change_scale(&self, penetration: f64, change: f64, frequency: f64) -> f64 {
        of_each!(self, law => law.change_scale(penetration, change, frequency))
    }
}
