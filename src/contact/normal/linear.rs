//! Linear spring and dashpot, paper (54): `N = K δ − C V_n`.

use super::NormalLaw;
use super::phases::Phases;

/// Spring and dashpot in parallel (Kelvin–Voigt).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// Stiffness `K` \[N/m\].
    pub k: f64,
    /// Dashpot `C_n` \[N·s/m\].
    pub c: f64,
}

impl Linear {
    /// Law of one of `parts` equal contacts that act in parallel as this law.
    #[must_use]
    pub fn divided(self, parts: f64) -> Self {
        Self { k: self.k / parts, c: self.c / parts }
    }

    /// Law of `count` contacts of this law in parallel.
    #[must_use]
    pub fn times(self, count: f64) -> Self {
        Self { k: self.k * count, c: self.c * count }
    }
}

impl Phases for Linear {}

impl NormalLaw for Linear {
    #[inline]
    fn elastic(&self, penetration: f64) -> f64 {
        self.k * penetration
    }

    #[inline]
    fn damping(&self, _: f64, velocity: f64) -> f64 {
        -self.c * velocity
    }

    /// `½ K δ²`, as `N²/2K`.
    fn stored_energy(&self, penetration: f64) -> f64 {
        0.5 * (self.elastic(penetration).powi(2) / self.k)
    }

    #[inline]
    fn tangent_stiffness(&self, _: f64) -> f64 {
        self.k
    }

    fn stiffness_bound(&self, _: f64) -> f64 {
        self.k
    }

    #[inline]
    fn damping_coefficient(&self, _: f64) -> f64 {
        self.c
    }

    fn damping_bound(&self, _: f64) -> f64 {
        self.c
    }

    /// `√(K/m)`: half a period of the oscillator, at any speed.
    fn frequency(&self, mass: f64, _: f64) -> f64 {
        (self.k / mass).sqrt()
    }

    fn depth(&self, mass: f64, speed: f64) -> f64 {
        speed / self.frequency(mass, speed)
    }

    /// On the way out the dashpot pulls where `C |V_n|` exceeds `K δ`.
    fn can_pull(&self) -> bool {
        self.c > 0.0
    }

    /// K alone: C shows in the states.
    #[inline]
    fn is_along_stretch(&self) -> bool {
        true
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        add(self.k);
    }

    /// δ itself to the last bit where both springs have one stiffness (57a).
    #[inline]
    fn length(&self, penetration: f64, k_t: f64) -> f64 {
        if self.k == k_t { penetration } else { self.elastic(penetration) / k_t }
    }

    #[inline]
    fn length_slope(&self, _: f64, k_t: f64) -> f64 {
        if self.k == k_t { 1.0 } else { self.k / k_t }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: Linear = Linear { k: 1.55e5, c: 220.5 };

    #[test]
    fn force_energy_and_stiffness_belong_together() {
        let (depth, step) = (3e-3, 1e-6);
        let difference = |f: &dyn Fn(f64) -> f64| (f(depth + step) - f(depth - step)) / (2.0 * step);
        let slope = difference(&|depth| LAW.elastic(depth));
        assert!((slope / LAW.tangent_stiffness(depth) - 1.0).abs() < 1e-10, "dN/dδ is {slope}");
        let force = difference(&|depth| LAW.stored_energy(depth));
        assert!((force / LAW.elastic(depth) - 1.0).abs() < 1e-10, "dU/dδ is {force}");
        assert_eq!(LAW.elastic(0.0), 0.0, "nothing at the face");
    }

    #[test]
    fn the_dashpot_acts_against_the_velocity() {
        assert!(LAW.damping(1e-3, -0.5) > 0.0, "on the way in it adds");
        assert!(LAW.damping(1e-3, 0.5) < 0.0, "on the way out it pulls");
        assert!(LAW.can_pull() && !Linear { c: 0.0, ..LAW }.can_pull(), "only a dashpot pulls");
    }

    #[test]
    fn the_energy_of_an_impact_goes_into_the_depth() {
        let (mass, speed) = (2.0, 0.5);
        let stored = LAW.stored_energy(LAW.depth(mass, speed));
        assert!((stored / (0.5 * mass * speed * speed) - 1.0).abs() < 1e-14, "{stored} J");
    }

    #[test]
    fn parts_add_up() {
        let part = LAW.divided(4.0);
        assert_eq!(part.times(4.0), LAW, "four of four");
        assert_eq!(4.0 * part.elastic(1e-3), LAW.elastic(1e-3), "their forces");
    }

    #[test]
    fn like_springs_have_like_lengths() {
        assert_eq!(LAW.length(0.1, LAW.k), 0.1, "to the last bit");
        assert!((LAW.length(0.1, 2.0 * LAW.k) - 0.05).abs() < 1e-17, "half of it on twice the stiffness");
        assert_eq!(LAW.length_slope(0.1, LAW.k), 1.0, "one to one");
    }
}
