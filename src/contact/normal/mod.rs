//! Normal contact laws: normal force as a function of the penetration δ and the normal velocity
//! (`docs/physics.md#normal-law`).
//!
//! All quantities that depend on the shape of `N(δ)` are methods of [`NormalLaw`]: forces, stored energy, stiffness,
//! time scale, and the scales of numerical tolerances. A new law is one file with an implementation of the trait, one
//! variant of [`Normal`] and its arms in `of_each!`, [`Normal::divided`] and [`Normal::times`].

mod custom;
mod linear;

use std::fmt::Debug;

pub use custom::Custom;
pub use linear::Linear;

/// A normal contact law. δ is the penetration \[m\], `V_n` the normal velocity of (53b), positive apart \[m/s\].
///
/// `N(δ)` is smooth through δ = 0 and not defined by a case there: an integrator evaluates it a little before the face.
pub trait NormalLaw: Debug + Send + Sync {
    /// Elastic force `N(δ)` \[N\], rising in δ, `N(0) = 0`.
    fn elastic(&self, penetration: f64) -> f64;

    /// Damping force at penetration δ and normal velocity `V_n` \[N\]; positive on the way in.
    fn damping(&self, penetration: f64, velocity: f64) -> f64;

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
    /// A law defined outside of this package.
    Custom(Custom),
}

/// Evaluates an expression for the law of either variant.
macro_rules! of_each {
    ($normal:expr, $law:ident => $value:expr) => {
        match $normal {
            Normal::Linear($law) => $value,
            Normal::Custom($law) => $value,
        }
    };
}

impl Normal {
    /// Law of one of `parts` equal contacts that act in parallel as this law.
    #[must_use]
    pub fn divided(self, parts: f64) -> Self {
        match self {
            Self::Linear(law) => Self::Linear(law.divided(parts)),
            Self::Custom(law) => Self::Custom(law.divided(parts)),
        }
    }

    /// Law of `count` contacts of this law and of equal penetration in parallel.
    #[must_use]
    pub fn times(self, count: f64) -> Self {
        match self {
            Self::Linear(law) => Self::Linear(law.times(count)),
            Self::Custom(law) => Self::Custom(law.times(count)),
        }
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
