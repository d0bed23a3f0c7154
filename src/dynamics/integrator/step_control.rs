//! One step after another, by whichever method takes fewer evaluations: explicit steps of order eight, implicit ones where
//! the explicit ones are held short by their stability or by noise. Knows no physics.

use crate::dynamics::integrator::constants::{
    BEYOND_EVENT, GROWING_ERROR, IMPLICIT_STEP_WORTH, LARGEST_IMPLICIT, LIMITED_ERROR, METHOD_CHANGE_STEPS,
    NEARLY_ACCEPTED, REPEATED_REJECTION, SHORTEST_CUT, STABILITY_LIMITED, TRIAL_STEPS, WORTHWHILE_CUT,
};
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::dop853;
use crate::dynamics::integrator::dop853::Dop853;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::system::ImplicitSystem;

/// How an integrator goes on after an event.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::dynamics) struct ControllerState {
    /// Length of the step to try first; 0 where nothing is known \[s\].
    pub step: f64,
    /// Whether explicit steps were too short.
    pub stiff: bool,
}

impl ControllerState {
    /// The more careful of two.
    pub(in crate::dynamics) fn with(self, other: Self) -> Self {
        let step = if self.step == 0.0 { other.step } else { self.step.min(other.step) };
        Self { step, stiff: self.stiff || other.stiff }
    }
}

/// Where a step may end and how short it may be.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct StepLimits {
    /// It ends here at the latest \[s\].
    pub cap: f64,
    /// Length of the very first try \[s\].
    pub first: f64,
    /// No step may be longer \[s\].
    pub longest: f64,
    /// Something is likely to change so long after its start \[s\].
    pub soon: f64,
    /// A shorter step cannot be followed \[s\].
    pub smallest: f64,
}

impl StepLimits {
    /// How far a step of length `h` from `t` is worth taking: not far beyond what is likely to end it \[s\].
    fn reach(&self, t: f64, h: f64) -> f64 {
        let enough = BEYOND_EVENT * self.soon;
        let room = self.smallest.max(SHORTEST_CUT * t);
        if enough < WORTHWHILE_CUT * h && enough > room { enough } else { h }
    }
}

/// Both methods for a system of one size, and which of them is in use.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct StepController {
    size: usize,
    rk: Dop853,
    radau: Option<Box<Radau>>,
    /// Memory that another one has left.
    spare: Option<Box<Radau>>,
    state: ControllerState,
    /// Steps in a row that spoke against the method in use.
    doubts: u32,
    /// Steps with the method in use, and explicit ones after which the other is given a try.
    steps: u32,
    trial: u32,
}

impl StepController {
    /// For systems of `size` components, going on at `pace`.
    pub(in crate::dynamics) fn new(size: usize, state: ControllerState) -> Self {
        let state = ControllerState { stiff: state.stiff && size <= LARGEST_IMPLICIT, ..state };
        let mut stepper = Self { size, state, trial: TRIAL_STEPS, ..Self::default() };
        stepper.rk.resize(size);
        stepper
    }

    /// Only stability will change the method: there is no noise that could hold explicit steps short.
    pub(in crate::dynamics) fn expect_no_noise(&mut self) {
        self.trial = u32::MAX;
    }

    /// Takes over the memory of an implicit method that is no longer in use.
    pub(in crate::dynamics) fn borrow(&mut self, spare: Option<Box<Radau>>) {
        self.spare = spare;
    }

    /// Gives its own away at its end.
    pub(in crate::dynamics) fn give_back(&mut self) -> Option<Box<Radau>> {
        self.spare.take().or_else(|| self.radau.take())
    }

    /// Evaluates the slope at the start of the next step anew: at a start, and after a kink.
    pub(in crate::dynamics) fn start(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &[f64]) {
        self.rk.start(system, t, y);
        if let Some(radau) = &mut self.radau {
            radau.forget();
        }
    }

    /// What is known of the system holds no longer.
    pub(in crate::dynamics) fn forget(&mut self) {
        if let Some(radau) = &mut self.radau {
            radau.resize(self.size);
        }
    }

    /// Slope at the start of the next step.
    pub(in crate::dynamics) fn slope(&self) -> &[f64] {
        self.rk.slope()
    }

    /// How it would go on.
    pub(in crate::dynamics) fn state(&self) -> ControllerState {
        self.state
    }

    /// Takes a step from `(t, y)`: its continuous answer and its end; `y` becomes the state there.
    ///
    /// # Errors
    /// The length of a step that would have to be shorter than the smallest.
    pub(in crate::dynamics) fn step(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &mut [f64],
        limits: StepLimits,
    ) -> Result<(DenseOutput, f64), f64> {
        let mut h = if self.state.step > 0.0 { self.state.step } else { limits.first }.min(limits.longest);
        let mut refused = false;
        loop {
            let reach = limits.reach(t, h);
            // A last sliver would cost as much as a step: stretch to the cap.
            let end = if t + 1.05 * reach >= limits.cap { limits.cap } else { t + reach };
            let taken = end - t;
            let (error, factor) = self.attempt(system, t, y, taken);
            if error <= 1.0 {
                let cut = end == limits.cap || reach < h;
                self.state.step = if cut { h.max(taken * factor) } else { taken * factor }.min(limits.longest);
                return Ok((self.accept(system, t, y, taken, error), end));
            }
            // Refused twice, the estimate is no guide: something is over far sooner than the step.
            h = taken * factor.min(if refused && error > NEARLY_ACCEPTED { REPEATED_REJECTION } else { 0.9 });
            refused = true;
            if h < limits.smallest || t + h <= t {
                return Err(h);
            }
        }
    }

    /// Takes an explicit step that is part of one within the tolerance: its continuous answer; `y` becomes the state at its
    /// end.
    pub(in crate::dynamics) fn repeat_explicit(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &mut [f64],
        h: f64,
    ) -> DenseOutput {
        self.rk.start(system, t, y);
        // Its estimate is known to be small enough.
        let _ = self.rk.attempt(system, t, y, h);
        self.rk.accept(system, t, y, h)
    }

    /// The same of an implicit step; nothing where that is not within the tolerance. The next step has to be started.
    pub(in crate::dynamics) fn repeat_implicit(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &mut [f64],
        h: f64,
    ) -> Option<DenseOutput> {
        self.rk.start(system, t, y);
        let radau = self.radau.as_mut()?;
        radau.forget();
        if radau.attempt(system, t, y, self.rk.slope(), h) > 1.0 {
            return None;
        }
        Some(radau.accept(t, y, h))
    }

    /// The error of a step of length `h`, 1 being the tolerance, and the factor to the next.
    fn attempt(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &[f64], h: f64) -> (f64, f64) {
        if self.state.stiff {
            let spare = &mut self.spare;
            let radau = self.radau.get_or_insert_with(|| {
                let mut radau = spare.take().unwrap_or_default();
                radau.resize(self.size);
                radau
            });
            let error = radau.attempt(system, t, y, self.rk.slope(), h);
            (error, if error.is_finite() { radau.next_factor(error) } else { 0.25 })
        } else {
            let error = self.rk.attempt(system, t, y, h);
            (error, if error.is_finite() { dop853::next_factor(error) } else { 0.1 })
        }
    }

    /// Accepts the step just tried and considers whether the other method would have done it for less.
    fn accept(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &mut [f64], h: f64, error: f64) -> DenseOutput {
        let (dense, doubt) = match &mut self.radau {
            Some(radau) if self.state.stiff => {
                let dense = radau.accept(t, y, h);
                self.rk.start(system, t + h, y);
                // What turns gets faster without bound where a touch ends: explicit steps would come to nothing.
                (
                    dense,
                    system.auxiliary_count() == 0
                        && error > GROWING_ERROR
                        && h * radau.fastest(system) < IMPLICIT_STEP_WORTH,
                )
            }
            _ => {
                let dense = self.rk.accept(system, t, y, h);
                let spare = self.size <= LARGEST_IMPLICIT && error < LIMITED_ERROR;
                let doubt = spare && self.rk.stiffness(system, &dense) > STABILITY_LIMITED;
                (dense, doubt)
            }
        };
        self.doubts = if doubt { self.doubts + 1 } else { 0 };
        self.steps += 1;
        let try_it = !self.state.stiff && self.steps >= self.trial && self.size <= LARGEST_IMPLICIT;
        if try_it {
            self.trial = self.trial.saturating_mul(2);
        }
        if self.doubts >= METHOD_CHANGE_STEPS || try_it {
            self.change_method();
        }
        dense
    }

    fn change_method(&mut self) {
        (self.doubts, self.steps) = (0, 0);
        self.state.stiff = !self.state.stiff;
        if let Some(radau) = &mut self.radau {
            radau.resize(self.size);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::integrator::system::System;

    #[test]
    fn a_step_ends_soon_after_a_likely_change_but_not_at_once() {
        let limits = |soon: f64| StepLimits { cap: 1.0, first: 1e-9, longest: 1.0, soon, smallest: 1e-18 };
        assert_eq!(limits(1e-6).reach(9.0, 1e-4), BEYOND_EVENT * 1e-6, "a little beyond the change");
        assert_eq!(limits(9e-5).reach(9.0, 1e-4), 1e-4, "not worth a step of its own");
        assert_eq!(limits(5e-16).reach(9.0, 1e-4), 1e-4, "less than a bit of the time it would end at");
    }

    /// A decay at this rate towards `cos t`, and how often its slope was evaluated.
    struct Relaxation {
        rate: f64,
        evaluations: u32,
    }

    impl System for Relaxation {
        fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
            self.evaluations += 1;
            out[0] = -self.rate * (y[0] - t.cos()) - t.sin();
        }

        fn size2(&self, d: &[f64]) -> f64 {
            (d[0] / 1e-10).powi(2)
        }
    }

    impl ImplicitSystem for Relaxation {}

    fn open(cap: f64, first: f64) -> StepLimits {
        StepLimits { cap, first, longest: f64::INFINITY, soon: f64::INFINITY, smallest: 1e-12 }
    }

    #[test]
    fn a_step_too_long_is_shortened_until_its_error_is_accepted_and_the_last_ends_at_the_cap() {
        let mut system = Relaxation { rate: 1.0, evaluations: 0 };
        let (mut control, mut y, mut t) = (StepController::new(1, ControllerState::default()), [1.5], 0.0);
        control.start(&mut system, t, &y);
        let mut lengths = Vec::new();
        while t < 3.0 {
            let before = system.evaluations;
            let (dense, end) = control.step(&mut system, t, &mut y, open(3.0, 50.0)).expect("a step");
            assert!(dense.from == t && (t + dense.step - end).abs() < 1e-15, "the step is from {t} to {end}");
            lengths.push((dense.step, system.evaluations - before));
            t = end;
        }
        assert_eq!(t, 3.0, "at the cap exactly");
        // An attempt takes 11 evaluations, an acceptance 4 more.
        let rejected = |evaluations: u32| (evaluations - 15) / 11;
        assert!(lengths.iter().all(|(_, evaluations)| (evaluations - 15) % 11 == 0), "attempts: {lengths:?}");
        assert!(lengths[0].0 < 3.0 && rejected(lengths[0].1) >= 1, "rejected at first: {lengths:?}");
        let later: u32 = lengths[1..].iter().map(|(_, evaluations)| rejected(*evaluations)).sum();
        assert!(later as usize <= lengths.len() / 2, "seldom later: {lengths:?}");
        let exact = 3f64.cos() + 0.5 * (-3f64).exp();
        assert!((y[0] - exact).abs() < 1e-8, "{} against {exact}", y[0]);
    }

    #[test]
    fn steps_limited_by_stability_change_the_method() {
        let mut system = Relaxation { rate: 1e5, evaluations: 0 };
        let (mut control, mut y, mut t) = (StepController::new(1, ControllerState::default()), [1.0], 0.0);
        control.start(&mut system, t, &y);
        let mut explicit = 0;
        while t < 1.0 {
            let (_, end) = control.step(&mut system, t, &mut y, open(1.0, 1e-5)).expect("a step");
            explicit += u32::from(!control.state().stiff);
            t = end;
        }
        assert!(control.state().stiff && explicit <= TRIAL_STEPS, "{explicit} explicit steps");
        assert!(system.evaluations < 20_000, "1e5 time constants in {} evaluations", system.evaluations);
        assert!((y[0] - 1f64.cos()).abs() < 1e-8, "{}", y[0]);
    }

    #[test]
    fn a_step_that_never_is_accepted_is_an_error() {
        let mut system = Relaxation { rate: f64::NAN, evaluations: 0 };
        let (mut control, mut y) = (StepController::new(1, ControllerState::default()), [1.0]);
        control.start(&mut system, 0.0, &y);
        let refused = control.step(&mut system, 0.0, &mut y, open(1.0, 0.1));
        assert!(refused.is_err_and(|h| h < 1e-12), "shorter than the smallest");
        assert_eq!(y, [1.0], "the state is as it was");
    }

    #[test]
    fn the_more_careful_of_two_states_is_kept() {
        let state = |step: f64, stiff: bool| ControllerState { step, stiff };
        assert_eq!(state(0.0, false).with(state(0.3, true)), state(0.3, true), "an unknown step gives way");
        assert_eq!(state(0.2, true).with(state(0.3, false)), state(0.2, true), "the shorter step, either stiff");
    }
}
