//! Hertz's spring `N = k_h δ^{3/2}` with one of four dashpots: laws `hertz`, `hertz-viscous`, `hertz-damp` and
//! `jankowski` (`docs/physics.md#other-normal-laws`). In front of the face, δ < 0, there is no force.

use std::f64::consts::PI;

use super::NormalLaw;
use super::constants::{ENERGY_POWER, HERTZ_DURATION, LEAST_IMPACT_SPEED};
use super::phases::{Phases, Stage};

/// Dashpot of a Hertz spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HertzDashpot {
    /// `−c δ^{1/4} V_n` (Tsuji); without damping, c = 0 \[N·s/m^{5/4}\].
    Viscous(f64),
    /// That dashpot in the approach alone (Jankowski).
    Approach(f64, Stage),
    /// `−(a/v_in) k_h δ^{3/2} V_n` (Hunt and Crossley) with this `a/v_in` \[s/m\]; before a touch, with a \[–\].
    Relative(f64),
}

/// Hertz's spring with a dashpot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hertz {
    /// Stiffness `k_h` \[N/m^{3/2}\].
    pub k: f64,
    /// Dashpot.
    pub dashpot: HertzDashpot,
}

impl Hertz {
    /// Law of one of `parts` equal contacts that act in parallel as this law.
    #[must_use]
    pub fn divided(self, parts: f64) -> Self {
        self.scaled(|value| value / parts)
    }

    /// Law of `count` contacts of this law and of equal penetration in parallel.
    #[must_use]
    pub fn times(self, count: f64) -> Self {
        self.scaled(|value| value * count)
    }

    /// A dashpot relative to the spring's force is scaled with it.
    fn scaled(self, scale: impl Fn(f64) -> f64) -> Self {
        let dashpot = match self.dashpot {
            HertzDashpot::Viscous(c) => HertzDashpot::Viscous(scale(c)),
            HertzDashpot::Approach(c, stage) => HertzDashpot::Approach(scale(c), stage),
            relative @ HertzDashpot::Relative(_) => relative,
        };
        Self { k: scale(self.k), dashpot }
    }

    /// Constant c of the dashpots that act on `δ^{1/4} V_n` at present \[N·s/m^{5/4}\].
    fn viscous(&self) -> f64 {
        match self.dashpot {
            HertzDashpot::Viscous(c) | HertzDashpot::Approach(c, Stage::Approach) => c,
            HertzDashpot::Approach(_, Stage::Return) | HertzDashpot::Relative(_) => 0.0,
        }
    }
}

impl Phases for Hertz {
    fn has_phases(&self) -> bool {
        matches!(self.dashpot, HertzDashpot::Approach(c, _) if c > 0.0)
    }

    /// The impact speed of `hertz-damp` counts as at least [`LEAST_IMPACT_SPEED`]; `a/v_in` is not bounded at `v_in = 0`.
    fn begun(self, _: f64, velocity: f64) -> Self {
        let dashpot = match self.dashpot {
            HertzDashpot::Approach(c, _) => HertzDashpot::Approach(c, Stage::Approach),
            HertzDashpot::Relative(a) => HertzDashpot::Relative(a / (-velocity).max(LEAST_IMPACT_SPEED)),
            viscous @ HertzDashpot::Viscous(_) => viscous,
        };
        Self { dashpot, ..self }
    }

    fn resumed(self, before: Self, _: f64) -> Self {
        let dashpot = match (self.dashpot, before.dashpot) {
            (HertzDashpot::Approach(c, _), HertzDashpot::Approach(_, stage)) => HertzDashpot::Approach(c, stage),
            (HertzDashpot::Relative(_), begun @ HertzDashpot::Relative(_)) => begun,
            (own, _) => own,
        };
        Self { dashpot, ..self }
    }

    fn phase_end(&self, _: f64, velocity: f64) -> f64 {
        match self.dashpot {
            HertzDashpot::Approach(_, stage) => stage.end(velocity),
            _ => f64::NEG_INFINITY,
        }
    }

    fn phase_end_scale(&self, _: f64, speed: f64) -> f64 {
        speed
    }

    fn phase_end_change(&self, change: f64, frequency: f64) -> f64 {
        change * frequency
    }

    fn next_phase(self, _: f64) -> Self {
        let dashpot = match self.dashpot {
            HertzDashpot::Approach(c, stage) => HertzDashpot::Approach(c, stage.next()),
            other => other,
        };
        Self { dashpot, ..self }
    }
}

impl NormalLaw for Hertz {
    fn elastic(&self, penetration: f64) -> f64 {
        let depth = penetration.max(0.0);
        self.k * depth * depth.sqrt()
    }

    fn damping(&self, penetration: f64, velocity: f64) -> f64 {
        -self.damping_coefficient(penetration) * velocity
    }

    /// `⅖ k_h δ^{5/2}`.
    fn stored_energy(&self, penetration: f64) -> f64 {
        0.4 * self.elastic(penetration) * penetration
    }

    fn tangent_stiffness(&self, penetration: f64) -> f64 {
        1.5 * self.k * penetration.max(0.0).sqrt()
    }

    fn stiffness_bound(&self, deepest: f64) -> f64 {
        self.tangent_stiffness(deepest)
    }

    fn damping_coefficient(&self, penetration: f64) -> f64 {
        match self.dashpot {
            HertzDashpot::Relative(per_speed) => per_speed * self.elastic(penetration),
            _ => self.viscous() * penetration.max(0.0).sqrt().sqrt(),
        }
    }

    fn damping_bound(&self, deepest: f64) -> f64 {
        self.damping_coefficient(deepest)
    }

    /// From the duration `T = ⅘ B(⅖, ½) δ_m/v₀` of an impact.
    fn frequency(&self, mass: f64, speed: f64) -> f64 {
        PI * speed / (HERTZ_DURATION * self.depth(mass, speed))
    }

    /// `(5 m v₀² / 4 k_h)^{2/5}`.
    fn depth(&self, mass: f64, speed: f64) -> f64 {
        (1.25 * mass * speed * speed / self.k).powf(0.4)
    }

    fn can_pull(&self) -> bool {
        match self.dashpot {
            HertzDashpot::Viscous(c) => c > 0.0,
            HertzDashpot::Relative(per_speed) => per_speed > 0.0,
            HertzDashpot::Approach(..) => false,
        }
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        add(self.k);
        match self.dashpot {
            HertzDashpot::Viscous(c) | HertzDashpot::Approach(c, _) => add(c),
            HertzDashpot::Relative(a) => add(a),
        }
    }

    /// A dashpot in proportion to the spring's force pulls, in a deep touch pulled apart fast; its law has no pull.
    fn excludes_pull(&self) -> bool {
        matches!(self.dashpot, HertzDashpot::Relative(_))
    }

    fn is_power_series(&self) -> bool {
        false
    }

    /// `⅖ N δ`.
    fn entry_energy(&self, penetration: f64) -> f64 {
        self.elastic(penetration) * penetration / ENERGY_POWER
    }

    /// `δ^{5/2}`.
    fn relative_energy(&self, penetration: f64) -> f64 {
        penetration.max(0.0).powf(ENERGY_POWER)
    }

    fn depth_of_relative_energy(&self, energy: f64) -> f64 {
        energy.powf(ENERGY_POWER.recip())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(dashpot: HertzDashpot) -> Hertz {
        Hertz { k: 4e6, dashpot }
    }

    #[test]
    fn there_is_no_force_in_front_of_the_face() {
        for dashpot in [HertzDashpot::Viscous(900.0), HertzDashpot::Approach(900.0, Stage::Approach)] {
            let law = law(dashpot);
            assert_eq!((law.elastic(-1e-3), law.damping(-1e-3, -0.1), law.stored_energy(-1e-3)), (0.0, 0.0, -0.0));
        }
    }

    #[test]
    fn force_energy_and_stiffness_belong_together() {
        let law = law(HertzDashpot::Viscous(0.0));
        let (depth, step) = (1e-3, 1e-8);
        let slope = |f: &dyn Fn(f64) -> f64| (f(depth + step) - f(depth - step)) / (2.0 * step);
        assert!((slope(&|d| law.stored_energy(d)) / law.elastic(depth) - 1.0).abs() < 1e-8, "dE/dδ = N");
        assert!((slope(&|d| law.elastic(d)) / law.tangent_stiffness(depth) - 1.0).abs() < 1e-8, "dN/dδ");
        let speed = 0.5;
        assert!((law.stored_energy(law.depth(2.0, speed)) - 0.25).abs() < 1e-14, "½ m v² at the largest depth");
    }

    #[test]
    fn an_energy_has_the_depth_at_which_it_is_stored() {
        let law = law(HertzDashpot::Viscous(0.0));
        let [one, two] = [1e-3, 2e-3].map(|depth| [law.relative_energy(depth), law.stored_energy(depth)]);
        assert!((two[0] / one[0] / (two[1] / one[1]) - 1.0).abs() < 1e-14, "in proportion to the stored energy");
        assert!((law.depth_of_relative_energy(two[0]) / 2e-3 - 1.0).abs() < 1e-14, "inverse");
        assert!((law.entry_energy(1e-3) / one[1] - 1.0).abs() < 1e-14, "⅖ N δ");
    }

    #[test]
    fn only_the_relative_dashpot_excludes_a_pull() {
        assert!(law(HertzDashpot::Relative(2.0)).excludes_pull(), "hertz-damp");
        assert!(!law(HertzDashpot::Viscous(900.0)).excludes_pull(), "hertz-viscous");
    }

    #[test]
    fn the_relative_dashpot_takes_its_speed_at_the_closing() {
        let before = law(HertzDashpot::Relative(2.0));
        let begun = before.begun(0.0, -0.5);
        assert_eq!(begun.dashpot, HertzDashpot::Relative(4.0), "a / v_in");
        // 1 + a δ̇/v_in is 3 at the beginning.
        assert!((begun.damping(1e-3, -0.5) / begun.elastic(1e-3) - 2.0).abs() < 1e-15);
        let half = before.divided(2.0);
        assert_eq!(half.resumed(begun, 1e-3), Hertz { k: 2e6, ..begun }, "a node that takes over keeps the speed");
        assert_eq!(
            before.begun(0.0, 0.1).dashpot,
            HertzDashpot::Relative(2.0 / LEAST_IMPACT_SPEED),
            "pressed, not hit"
        );
    }

    #[test]
    fn the_dashpot_of_the_approach_ends_at_the_deepest_point() {
        let law = law(HertzDashpot::Approach(900.0, Stage::Approach));
        assert!(law.has_phases() && law.damping(1e-3, -0.1) > 0.0, "approach");
        assert_eq!(law.next_phase(1e-3).damping(1e-3, 0.1), 0.0, "return");
        assert_eq!(law.next_phase(1e-3).begun(0.0, -0.1), law, "the next touch");
    }

    #[test]
    fn parts_add_up_to_the_whole() {
        for dashpot in [HertzDashpot::Viscous(900.0), HertzDashpot::Relative(3.0)] {
            let (whole, part) = (law(dashpot), law(dashpot).divided(4.0));
            assert!((4.0 * part.damping(1e-3, 0.1) / whole.damping(1e-3, 0.1) - 1.0).abs() < 1e-15);
            assert!((4.0 * part.elastic(1e-3) / whole.elastic(1e-3) - 1.0).abs() < 1e-15);
            assert!((part.times(4.0).k / whole.k - 1.0).abs() < 1e-15);
        }
    }
}
