//! Normal laws of several phases defined outside of this package: the phase of a touch as two numbers, which a contact stores.

use super::NormalLaw;
use super::phases::Phases;

/// Phase of a touch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phase {
    /// Which of the law's phases.
    pub number: u32,
    /// Memory of the touch in this phase, as a penetration \[m\]; 0 without.
    pub memory: f64,
}

/// A normal law of several phases with its phase among its fields, as [`Approach`](super::Approach) and [`Bilinear`](super::Bilinear).
pub trait PhasedLaw: NormalLaw + Phases + 'static {
    /// Present phase.
    fn phase(&self) -> Phase;

    /// The law in another phase.
    #[must_use]
    fn in_phase(self, phase: Phase) -> Self;
}

/// A [`PhasedLaw`] of any type; its phase is stored beside it.
pub(super) trait AnyPhased: std::fmt::Debug + Send + Sync {
    /// Calls `then` with the law in a phase.
    fn in_phase(&self, phase: Phase, then: &mut dyn FnMut(&(dyn NormalLaw + 'static)));
    /// [`Phases::has_phases`] in a phase.
    fn has_phases(&self, phase: Phase) -> bool;
    /// Phase after [`Phases::begun`].
    fn begun(&self, phase: Phase, penetration: f64, velocity: f64) -> Phase;
    /// Phase after [`Phases::resumed`].
    fn resumed(&self, phase: Phase, before: Phase, penetration: f64) -> Phase;
    /// [`Phases::phase_end`] in a phase.
    fn phase_end(&self, phase: Phase, penetration: f64, velocity: f64) -> f64;
    /// [`Phases::phase_end_scale`] in a phase.
    fn phase_end_scale(&self, phase: Phase, depth: f64, speed: f64) -> f64;
    /// [`Phases::phase_end_change`] in a phase.
    fn phase_end_change(&self, phase: Phase, change: f64, frequency: f64) -> f64;
    /// Phase after [`Phases::next_phase`].
    fn next_phase(&self, phase: Phase, penetration: f64) -> Phase;
}

impl<L: PhasedLaw> AnyPhased for L {
    fn in_phase(&self, phase: Phase, then: &mut dyn FnMut(&(dyn NormalLaw + 'static))) {
        then(&PhasedLaw::in_phase(*self, phase));
    }

    fn has_phases(&self, phase: Phase) -> bool {
        Phases::has_phases(&PhasedLaw::in_phase(*self, phase))
    }

    fn begun(&self, phase: Phase, penetration: f64, velocity: f64) -> Phase {
        Phases::begun(PhasedLaw::in_phase(*self, phase), penetration, velocity).phase()
    }

    fn resumed(&self, phase: Phase, before: Phase, penetration: f64) -> Phase {
        let [law, before] = [phase, before].map(|phase| PhasedLaw::in_phase(*self, phase));
        Phases::resumed(law, before, penetration).phase()
    }

    fn phase_end(&self, phase: Phase, penetration: f64, velocity: f64) -> f64 {
        Phases::phase_end(&PhasedLaw::in_phase(*self, phase), penetration, velocity)
    }

    fn phase_end_scale(&self, phase: Phase, depth: f64, speed: f64) -> f64 {
        Phases::phase_end_scale(&PhasedLaw::in_phase(*self, phase), depth, speed)
    }

    fn phase_end_change(&self, phase: Phase, change: f64, frequency: f64) -> f64 {
        Phases::phase_end_change(&PhasedLaw::in_phase(*self, phase), change, frequency)
    }

    fn next_phase(&self, phase: Phase, penetration: f64) -> Phase {
        Phases::next_phase(PhasedLaw::in_phase(*self, phase), penetration).phase()
    }
}
