//! A normal law defined outside of this package, as a fraction of a law with static lifetime.

use super::NormalLaw;
use super::phased::{AnyPhased, Phase, PhasedLaw};
use super::phases::Phases;

/// A law of the whole pair.
#[derive(Clone, Copy, Debug)]
enum Whole {
    /// Of a single phase.
    Single(&'static dyn NormalLaw),
    /// Of several phases, in this one.
    Phased(&'static dyn AnyPhased, Phase),
}

/// `fraction` times the forces of a law of the whole pair.
#[derive(Clone, Copy, Debug)]
pub struct Custom {
    /// Law of the whole pair.
    law: Whole,
    /// Fraction of its forces \[–\].
    fraction: f64,
}

impl PartialEq for Custom {
    fn eq(&self, other: &Self) -> bool {
        let is_same_law = match (self.law, other.law) {
            (Whole::Single(one), Whole::Single(other)) => std::ptr::addr_eq(one, other),
            (Whole::Phased(one, now), Whole::Phased(other, then)) => std::ptr::addr_eq(one, other) && now == then,
            (Whole::Single(_), Whole::Phased(..)) | (Whole::Phased(..), Whole::Single(_)) => false,
        };
        is_same_law && self.fraction == other.fraction
    }
}

impl Custom {
    /// The whole of `law`, of a single phase.
    pub fn of(law: &'static dyn NormalLaw) -> Self {
        Self { law: Whole::Single(law), fraction: 1.0 }
    }

    /// The whole of `law`, in the phase in which it is given.
    pub fn phased<L: PhasedLaw>(law: &'static L) -> Self {
        Self { law: Whole::Phased(law, law.phase()), fraction: 1.0 }
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

    /// An answer of the law of the whole pair in its present phase.
    fn whole<T: Default>(&self, mut question: impl FnMut(&(dyn NormalLaw + 'static)) -> T) -> T {
        match self.law {
            Whole::Single(law) => question(law),
            Whole::Phased(law, phase) => {
                let mut answer = T::default();
                law.in_phase(phase, &mut |law| answer = question(law));
                answer
            }
        }
    }

    /// An answer of a law of several phases; `single` of others.
    fn phased_or<T>(&self, single: T, question: impl Fn(&(dyn AnyPhased + 'static), Phase) -> T) -> T {
        match self.law {
            Whole::Single(_) => single,
            Whole::Phased(law, phase) => question(law, phase),
        }
    }

    /// The law in the phase that follows from the present one.
    fn changed(self, next: impl Fn(&dyn AnyPhased, Phase) -> Phase) -> Self {
        match self.law {
            Whole::Single(_) => self,
            Whole::Phased(law, phase) => Self { law: Whole::Phased(law, next(law, phase)), ..self },
        }
    }
}

impl Phases for Custom {
    fn has_phases(&self) -> bool {
        self.phased_or(false, AnyPhased::has_phases)
    }

    fn begun(self, penetration: f64, velocity: f64) -> Self {
        self.changed(|law, phase| law.begun(phase, penetration, velocity))
    }

    fn resumed(self, before: Self, penetration: f64) -> Self {
        match before.law {
            Whole::Single(_) => self.begun(penetration, 0.0),
            Whole::Phased(_, before) => self.changed(|law, phase| law.resumed(phase, before, penetration)),
        }
    }

    fn phase_end(&self, penetration: f64, velocity: f64) -> f64 {
        self.phased_or(f64::NEG_INFINITY, |law, phase| law.phase_end(phase, penetration, velocity))
    }

    fn phase_end_scale(&self, depth: f64, speed: f64) -> f64 {
        self.phased_or(0.0, |law, phase| law.phase_end_scale(phase, depth, speed))
    }

    fn phase_end_change(&self, change: f64, frequency: f64) -> f64 {
        self.phased_or(0.0, |law, phase| law.phase_end_change(phase, change, frequency))
    }

    fn next_phase(self, penetration: f64) -> Self {
        self.changed(|law, phase| law.next_phase(phase, penetration))
    }
}

impl NormalLaw for Custom {
    fn elastic(&self, penetration: f64) -> f64 {
        self.fraction * self.whole(|law| law.elastic(penetration))
    }

    fn damping(&self, penetration: f64, velocity: f64) -> f64 {
        self.fraction * self.whole(|law| law.damping(penetration, velocity))
    }

    fn stored_energy(&self, penetration: f64) -> f64 {
        self.fraction * self.whole(|law| law.stored_energy(penetration))
    }

    fn tangent_stiffness(&self, penetration: f64) -> f64 {
        self.fraction * self.whole(|law| law.tangent_stiffness(penetration))
    }

    fn stiffness_bound(&self, deepest: f64) -> f64 {
        self.fraction * self.whole(|law| law.stiffness_bound(deepest))
    }

    fn damping_coefficient(&self, penetration: f64) -> f64 {
        self.fraction * self.whole(|law| law.damping_coefficient(penetration))
    }

    fn damping_bound(&self, deepest: f64) -> f64 {
        self.fraction * self.whole(|law| law.damping_bound(deepest))
    }

    /// A fraction of the force on a mass has the motion of the whole force on the mass divided by the fraction.
    fn frequency(&self, mass: f64, speed: f64) -> f64 {
        self.whole(|law| law.frequency(mass / self.fraction, speed))
    }

    fn depth(&self, mass: f64, speed: f64) -> f64 {
        self.whole(|law| law.depth(mass / self.fraction, speed))
    }

    fn length(&self, penetration: f64, k_t: f64) -> f64 {
        self.fraction * self.whole(|law| law.length(penetration, k_t))
    }

    fn length_slope(&self, penetration: f64, k_t: f64) -> f64 {
        self.fraction * self.whole(|law| law.length_slope(penetration, k_t))
    }

    fn force_scale(&self, depth: f64, speed: f64) -> f64 {
        self.fraction * self.whole(|law| law.force_scale(depth, speed))
    }

    fn change_scale(&self, penetration: f64, change: f64, frequency: f64) -> f64 {
        self.fraction * self.whole(|law| law.change_scale(penetration, change, frequency))
    }

    fn can_pull(&self) -> bool {
        self.whole(NormalLaw::can_pull)
    }

    fn excludes_pull(&self) -> bool {
        self.whole(NormalLaw::excludes_pull)
    }

    fn is_along_stretch(&self) -> bool {
        self.whole(NormalLaw::is_along_stretch)
    }

    fn is_power_series(&self) -> bool {
        self.whole(NormalLaw::is_power_series)
    }

    fn plastic_power(&self, velocity: f64) -> f64 {
        self.fraction * self.whole(|law| law.plastic_power(velocity))
    }

    fn entry_energy(&self, penetration: f64) -> f64 {
        self.fraction * self.whole(|law| law.entry_energy(penetration))
    }

    fn relative_energy(&self, penetration: f64) -> f64 {
        self.whole(|law| law.relative_energy(penetration))
    }

    fn depth_of_relative_energy(&self, energy: f64) -> f64 {
        self.whole(|law| law.depth_of_relative_energy(energy))
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        add(self.fraction);
        self.whole(|law| law.digest(add));
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Approach, Linear, Stage};
    use super::*;

    const LINEAR: Linear = Linear { k: 1e5, c: 200.0 };
    static APPROACH: Approach = Approach { linear: LINEAR, stage: Stage::Approach };

    impl PhasedLaw for Approach {
        fn phase(&self) -> Phase {
            Phase { number: u32::from(self.stage == Stage::Return), memory: 0.0 }
        }

        fn in_phase(self, phase: Phase) -> Self {
            Self { stage: if phase.number == 0 { Stage::Approach } else { Stage::Return }, ..self }
        }
    }

    #[test]
    fn a_fraction_of_a_law_answers_as_the_law_divided() {
        let (custom, own) = (Custom::phased(&APPROACH).divided(4.0), APPROACH.divided(4.0));
        for (custom, own) in [(custom, own), (custom.next_phase(1e-3), own.next_phase(1e-3))] {
            assert_eq!(custom.forces(1e-3, -0.1), own.forces(1e-3, -0.1), "forces");
            assert_eq!(custom.depth(2.0, 0.5), own.depth(2.0, 0.5), "depth");
            assert_eq!(custom.is_along_stretch(), own.is_along_stretch(), "place of the reaction");
            assert_eq!(custom.phase_end(1e-3, -0.1), Phases::phase_end(&own, 1e-3, -0.1), "end of the phase");
        }
        assert_ne!(custom, custom.next_phase(1e-3), "laws in different phases differ");
        assert_eq!(custom.next_phase(1e-3).begun(0.0, -0.1), custom, "the next touch");
    }

    #[test]
    fn a_law_of_a_single_phase_has_no_end() {
        let custom = Custom::of(&LINEAR);
        assert!(!custom.has_phases() && custom.phase_end(1e-3, 0.1) == f64::NEG_INFINITY, "none");
        assert_eq!(custom.begun(0.0, -0.1), custom, "as before");
    }
}
