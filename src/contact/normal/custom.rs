//! A normal law defined outside of this package, as a fraction of a law with static lifetime.

use super::NormalLaw;
use super::phases::Phases;

/// `fraction` times the forces of `law`.
#[derive(Clone, Copy, Debug)]
pub struct Custom {
    /// Law of the whole pair.
    law: &'static dyn NormalLaw,
    /// Fraction of its forces \[–\].
    fraction: f64,
}

impl PartialEq for Custom {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::addr_eq(self.law, other.law) && self.fraction == other.fraction
    }
}

impl Custom {
    /// The whole of `law`.
    pub fn of(law: &'static dyn NormalLaw) -> Self {
        Self { law, fraction: 1.0 }
    }

    /// Law of one of `parts` equal contacts that act in parallel as this law.
    #[must_use]
    pub fn divided(self, parts: f64) -> Self {
        Self { fraction: self.fraction / parts, ..self }
    }

    /// Law of `count` contacts of this law in parallel.
    #[must_use]
    pub fn times(self, count: f64) -> Self {
        Self { fraction: self.fraction * count, ..self }
    }
}

impl Phases for Custom {}

impl NormalLaw for Custom {
    fn elastic(&self, penetration: f64) -> f64 {
        self.fraction * self.law.elastic(penetration)
    }

    fn damping(&self, penetration: f64, velocity: f64) -> f64 {
        self.fraction * self.law.damping(penetration, velocity)
    }

    fn stored_energy(&self, penetration: f64) -> f64 {
        self.fraction * self.law.stored_energy(penetration)
    }

    fn tangent_stiffness(&self, penetration: f64) -> f64 {
        self.fraction * self.law.tangent_stiffness(penetration)
    }

    fn stiffness_bound(&self, deepest: f64) -> f64 {
        self.fraction * self.law.stiffness_bound(deepest)
    }

    fn damping_coefficient(&self, penetration: f64) -> f64 {
        self.fraction * self.law.damping_coefficient(penetration)
    }

    fn damping_bound(&self, deepest: f64) -> f64 {
        self.fraction * self.law.damping_bound(deepest)
    }

    /// A fraction of the force on a mass has the motion of the whole force on the mass divided by the fraction.
    fn frequency(&self, mass: f64, speed: f64) -> f64 {
        self.law.frequency(mass / self.fraction, speed)
    }

    fn depth(&self, mass: f64, speed: f64) -> f64 {
        self.law.depth(mass / self.fraction, speed)
    }

    fn length(&self, penetration: f64, k_t: f64) -> f64 {
        self.fraction * self.law.length(penetration, k_t)
    }

    fn length_slope(&self, penetration: f64, k_t: f64) -> f64 {
        self.fraction * self.law.length_slope(penetration, k_t)
    }

    fn force_scale(&self, depth: f64, speed: f64) -> f64 {
        self.fraction * self.law.force_scale(depth, speed)
    }

    fn change_scale(&self, penetration: f64, change: f64, frequency: f64) -> f64 {
        self.fraction * self.law.change_scale(penetration, change, frequency)
    }

    fn can_pull(&self) -> bool {
        self.law.can_pull()
    }

    fn plastic_power(&self, velocity: f64) -> f64 {
        self.fraction * self.law.plastic_power(velocity)
    }

    fn entry_energy(&self, penetration: f64) -> f64 {
        self.fraction * self.law.entry_energy(penetration)
    }

    fn excludes_pull(&self) -> bool {
        self.law.excludes_pull()
    }

    fn is_along_stretch(&self) -> bool {
        self.law.is_along_stretch()
    }

    fn is_power_series(&self) -> bool {
        self.law.is_power_series()
    }

    fn relative_energy(&self, penetration: f64) -> f64 {
        self.law.relative_energy(penetration)
    }

    fn depth_of_relative_energy(&self, energy: f64) -> f64 {
        self.law.depth_of_relative_energy(energy)
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        add(self.fraction);
        self.law.digest(add);
    }
}
