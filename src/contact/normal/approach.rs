//! Linear spring with a dashpot that acts in the approach alone, law `approach`: `N = K δ − [V_n < 0] C V_n`.

use super::phases::{Phases, Stage};
use super::{Linear, NormalLaw};

/// Spring, and dashpot in the approach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// Spring and dashpot of the approach.
    pub linear: Linear,
    /// Present stage.
    pub stage: Stage,
}

impl Approach {
    /// Law in its approach.
    pub fn of(linear: Linear) -> Self {
        Self { linear, stage: Stage::Approach }
    }

    /// Law of one of `parts` equal contacts that act in parallel as this law.
    #[must_use]
    pub fn divided(self, parts: f64) -> Self {
        Self { linear: self.linear.divided(parts), ..self }
    }

    /// Law of `count` contacts of this law and of equal penetration in parallel.
    #[must_use]
    pub fn times(self, count: f64) -> Self {
        Self { linear: self.linear.times(count), ..self }
    }

    /// The linear law that acts in the present stage.
    fn present(&self) -> Linear {
        match self.stage {
            Stage::Approach => self.linear,
            Stage::Return => Linear { c: 0.0, ..self.linear },
        }
    }
}

impl Phases for Approach {
    fn has_phases(&self) -> bool {
        self.linear.c > 0.0
    }

    fn begun(self, _: f64, _: f64) -> Self {
        Self::of(self.linear)
    }

    fn resumed(self, before: Self, _: f64) -> Self {
        Self { stage: before.stage, ..self }
    }

    fn phase_end(&self, _: f64, velocity: f64) -> f64 {
        self.stage.end(velocity)
    }

    fn phase_end_scale(&self, _: f64, speed: f64) -> f64 {
        speed
    }

    fn phase_end_change(&self, change: f64, frequency: f64) -> f64 {
        change * frequency
    }

    fn next_phase(self, _: f64) -> Self {
        Self { stage: self.stage.next(), ..self }
    }
}

impl NormalLaw for Approach {
    fn elastic(&self, penetration: f64) -> f64 {
        self.linear.elastic(penetration)
    }

    fn damping(&self, penetration: f64, velocity: f64) -> f64 {
        self.present().damping(penetration, velocity)
    }

    fn stored_energy(&self, penetration: f64) -> f64 {
        self.linear.stored_energy(penetration)
    }

    fn tangent_stiffness(&self, penetration: f64) -> f64 {
        self.linear.tangent_stiffness(penetration)
    }

    fn stiffness_bound(&self, deepest: f64) -> f64 {
        self.linear.stiffness_bound(deepest)
    }

    fn damping_coefficient(&self, penetration: f64) -> f64 {
        self.present().damping_coefficient(penetration)
    }

    fn damping_bound(&self, deepest: f64) -> f64 {
        self.present().damping_bound(deepest)
    }

    fn frequency(&self, mass: f64, speed: f64) -> f64 {
        self.linear.frequency(mass, speed)
    }

    fn depth(&self, mass: f64, speed: f64) -> f64 {
        self.linear.depth(mass, speed)
    }

    /// The dashpot pushes in the approach, and there is none on the way out.
    fn can_pull(&self) -> bool {
        false
    }

    fn is_along_stretch(&self) -> bool {
        true
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        add(self.linear.k);
        add(self.linear.c);
    }

    fn length(&self, penetration: f64, k_t: f64) -> f64 {
        self.linear.length(penetration, k_t)
    }

    fn length_slope(&self, penetration: f64, k_t: f64) -> f64 {
        self.linear.length_slope(penetration, k_t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: Approach = Approach { linear: Linear { k: 1e5, c: 200.0 }, stage: Stage::Approach };

    #[test]
    fn the_dashpot_acts_on_the_way_in_alone() {
        assert_eq!(LAW.damping(1e-3, -0.1), 20.0, "approach");
        let back = LAW.next_phase(1e-3);
        assert_eq!((back.damping(1e-3, 0.1), back.elastic(1e-3)), (0.0, 100.0), "return");
        assert_eq!(back.next_phase(1e-3), LAW, "approach again");
        assert_eq!(back.begun(0.0, -0.1), LAW, "the next touch begins in approach");
    }

    #[test]
    fn a_stage_ends_where_the_velocity_changes_sign() {
        assert!(LAW.phase_end(1e-3, -0.1) < 0.0 && LAW.phase_end(1e-3, 0.1) > 0.0, "approach");
        let back = LAW.next_phase(1e-3);
        assert!(back.phase_end(1e-3, 0.1) < 0.0 && back.phase_end(1e-3, -0.1) > 0.0, "return");
        assert!(
            !Approach::of(Linear { c: 0.0, ..LAW.linear }).has_phases(),
            "without a dashpot there is nothing to end"
        );
    }
}
