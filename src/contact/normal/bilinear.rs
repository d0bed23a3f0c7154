//! Bilinear spring, law `bilinear` (`DesRoches` and Muthukumar; `docs/physics.md#other-normal-laws`): `N = K₂ δ + z` with a
//! elastic-plastic part z, `ż = (K₁ − K₂) δ̇` within `0 ≤ z ≤ z_y = (K₁ − K₂) δ_y`.

use super::NormalLaw;
use super::phases::Phases;

/// Branch of the elastic-plastic part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Branch {
    /// `z = (K₁ − K₂)(δ − δ₀)` with this penetration `δ₀` at z = 0 \[m\].
    Elastic(f64),
    /// `z = z_y`: δ grows and the spring yields.
    Upper,
    /// `z = 0`: δ falls.
    Lower,
}

/// Bilinear spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bilinear {
    /// Stiffness `K₁` up to yield, and at the beginning of unloading \[N/m\].
    pub k1: f64,
    /// Stiffness `K₂` after yield \[N/m\].
    pub k2: f64,
    /// Penetration `δ_y` at yield \[m\].
    pub yielding: f64,
    /// Present branch.
    pub branch: Branch,
}

impl Bilinear {
    /// Law of one of `parts` equal contacts that act in parallel as this law.
    #[must_use]
    pub fn divided(self, parts: f64) -> Self {
        Self { k1: self.k1 / parts, k2: self.k2 / parts, ..self }
    }

    /// Law of `count` contacts of this law and of equal penetration in parallel.
    #[must_use]
    pub fn times(self, count: f64) -> Self {
        Self { k1: self.k1 * count, k2: self.k2 * count, ..self }
    }

    /// `K₁ − K₂` \[N/m\].
    fn stiffness_drop(&self) -> f64 {
        self.k1 - self.k2
    }

    /// The elastic-plastic part as a length, `z/(K₁ − K₂)`, from 0 to `δ_y` \[m\].
    fn stretch(&self, penetration: f64) -> f64 {
        match self.branch {
            Branch::Elastic(origin) => penetration - origin,
            Branch::Upper => self.yielding,
            Branch::Lower => 0.0,
        }
    }

    /// Energy lost in a touch with this largest penetration, the area of the loop `(K₁ − K₂) δ_y (δ_m − δ_y)` \[J\].
    pub fn loop_area(&self, deepest: f64) -> f64 {
        self.stiffness_drop() * self.yielding * (deepest - self.yielding).max(0.0)
    }
}

impl Phases for Bilinear {
    fn has_phases(&self) -> bool {
        true
    }

    /// Loaded from δ = 0.
    fn begun(self, penetration: f64, _: f64) -> Self {
        let branch = if penetration > self.yielding { Branch::Upper } else { Branch::Elastic(0.0) };
        Self { branch, ..self }
    }

    /// Elastic: z reaches `z_y` or returns to 0, as a length \[m\]. A spring that has not yielded returns to z = 0 at
    /// δ = 0, where the contact opens. Upper and lower: the normal velocity changes sign \[m/s\].
    fn phase_end(&self, penetration: f64, velocity: f64) -> f64 {
        match self.branch {
            Branch::Elastic(0.0) => penetration - self.yielding,
            Branch::Elastic(_) => {
                let stretch = self.stretch(penetration);
                (stretch - self.yielding).max(-stretch)
            }
            Branch::Upper => velocity,
            Branch::Lower => -velocity,
        }
    }

    fn phase_end_scale(&self, _: f64, speed: f64) -> f64 {
        match self.branch {
            Branch::Elastic(_) => self.yielding,
            Branch::Upper | Branch::Lower => speed,
        }
    }

    fn phase_end_change(&self, change: f64, frequency: f64) -> f64 {
        match self.branch {
            Branch::Elastic(_) => change,
            Branch::Upper | Branch::Lower => change * frequency,
        }
    }

    fn next_phase(self, penetration: f64) -> Self {
        let branch = match self.branch {
            Branch::Elastic(_) if self.stretch(penetration) > 0.5 * self.yielding => Branch::Upper,
            Branch::Elastic(_) => Branch::Lower,
            Branch::Upper => Branch::Elastic(penetration - self.yielding),
            Branch::Lower => Branch::Elastic(penetration),
        };
        Self { branch, ..self }
    }
}

impl NormalLaw for Bilinear {
    fn elastic(&self, penetration: f64) -> f64 {
        self.k2 * penetration + self.stiffness_drop() * self.stretch(penetration)
    }

    fn damping(&self, _: f64, _: f64) -> f64 {
        0.0
    }

    /// `½ K₂ δ² + z²/(2 (K₁ − K₂))`.
    fn stored_energy(&self, penetration: f64) -> f64 {
        0.5 * (self.k2 * penetration.powi(2) + self.stiffness_drop() * self.stretch(penetration).powi(2))
    }

    fn tangent_stiffness(&self, _: f64) -> f64 {
        match self.branch {
            Branch::Elastic(_) => self.k1,
            Branch::Upper | Branch::Lower => self.k2,
        }
    }

    fn stiffness_bound(&self, _: f64) -> f64 {
        self.k1
    }

    fn damping_coefficient(&self, _: f64) -> f64 {
        0.0
    }

    fn damping_bound(&self, _: f64) -> f64 {
        0.0
    }

    /// Of the spring before it yields, which is the faster one.
    fn frequency(&self, mass: f64, _: f64) -> f64 {
        (self.k1 / mass).sqrt()
    }

    /// From `½ K₂ δ_m² + (K₁ − K₂) δ_y δ_m − ½ (K₁ − K₂) δ_y² = ½ m v²` where the spring yields.
    fn depth(&self, mass: f64, speed: f64) -> f64 {
        let elastic = speed * (mass / self.k1).sqrt();
        if elastic <= self.yielding {
            return elastic;
        }
        let (push, energy) = (self.stiffness_drop() * self.yielding, 0.5 * mass * speed * speed);
        let rest = energy + 0.5 * push * self.yielding;
        // The positive root without cancellation.
        2.0 * rest / (push + (push * push + 2.0 * self.k2 * rest).sqrt())
    }

    /// `z ≥ 0`.
    fn can_pull(&self) -> bool {
        false
    }

    fn entry_energy(&self, penetration: f64) -> f64 {
        self.stored_energy(penetration)
    }

    /// On the upper branch `z_y δ̇`.
    fn plastic_power(&self, velocity: f64) -> f64 {
        match self.branch {
            Branch::Upper => -self.stiffness_drop() * self.yielding * velocity,
            Branch::Elastic(_) | Branch::Lower => 0.0,
        }
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        [self.k1, self.k2, self.yielding].into_iter().for_each(add);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: Bilinear = Bilinear { k1: 1e6, k2: 1e5, yielding: 1e-4, branch: Branch::Elastic(0.0) };

    fn agree(what: &str, got: f64, expected: f64) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs(), "{what}: {got} is not {expected}");
    }

    #[test]
    fn the_loop_is_that_of_an_elastic_plastic_part_beside_a_spring() {
        let deepest = 5e-4;
        let upper = LAW.next_phase(1e-4);
        assert_eq!(upper.branch, Branch::Upper, "z = z_y");
        agree("continuous at yield", upper.elastic(1e-4), LAW.elastic(1e-4));
        let unloading = upper.next_phase(deepest);
        agree("continuous at the deepest point", unloading.elastic(deepest), upper.elastic(deepest));
        agree("with K₁", unloading.tangent_stiffness(deepest), 1e6);
        let lower = unloading.next_phase(deepest - 1e-4);
        assert_eq!(lower.branch, Branch::Lower, "z = 0");
        agree("on the line K₂ δ", lower.elastic(3e-4), 30.0);
        // In: the energy at the deepest point and the plastic work so far; out: the rest.
        let work = 0.5 * 100.0 * 1e-4 + 0.5 * (100.0 + 140.0) * 4e-4;
        agree("stored and lost", upper.stored_energy(deepest) + LAW.loop_area(deepest), work);
    }

    #[test]
    fn phases_end_at_yield_at_a_turn_and_where_the_elastic_range_is_used() {
        assert!(LAW.phase_end(0.9e-4, -0.1) < 0.0 && LAW.phase_end(1.1e-4, -0.1) > 0.0, "yield");
        assert!(LAW.phase_end(-1e-9, 0.1) < 0.0, "an elastic touch ends by opening");
        let upper = LAW.next_phase(1e-4);
        assert!(upper.phase_end(2e-4, -0.1) < 0.0 && upper.phase_end(2e-4, 0.1) > 0.0, "turn");
        let unloading = upper.next_phase(5e-4);
        assert!(unloading.phase_end(4.5e-4, 0.1) < 0.0, "within the elastic range");
        assert!(unloading.phase_end(3.9e-4, 0.1) > 0.0 && unloading.phase_end(5.1e-4, -0.1) > 0.0, "both ends");
        assert_eq!(unloading.next_phase(5e-4).branch, Branch::Upper, "loaded again");
        assert_eq!(unloading.begun(0.0, -0.1), LAW, "recovered at once");
        assert_eq!(LAW.begun(2e-4, 0.0), upper, "pressed beyond yield");
    }

    #[test]
    fn the_largest_penetration_has_the_energy_of_the_impact() {
        for speed in [0.01, 0.1, 0.5] {
            let deepest = LAW.depth(2.0, speed);
            let reached = LAW.begun(deepest, 0.0);
            let stored = reached.stored_energy(deepest) + LAW.loop_area(deepest);
            agree("½ m v²", stored, speed * speed);
        }
    }
}
