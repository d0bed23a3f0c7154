//! Step-size control with automatic choice of the method: explicit steps of order 8, implicit ones where stability or
//! noise holds the explicit ones short. No physics.

use crate::dynamics::integrator::constants::{
    BEYOND_EVENT, CAP_STRETCH, GROWING_ERROR, IMPLICIT_STEP_WORTH, LARGEST_IMPLICIT, LIMITED_ERROR,
    METHOD_CHANGE_STEPS, NEARLY_ACCEPTED, OVERFLOW_FACTOR, REPEATED_REJECTION, SHORTEST_CUT, STABILITY_LIMITED,
    STEP_SAFETY, TRIAL_STEPS, UNSOLVED_FACTOR, WORTHWHILE_CUT,
};
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::dop853;
use crate::dynamics::integrator::dop853::Dop853;
use crate::dynamics::integrator::radau_iia;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::system::ImplicitSystem;

/// Method and step length with which an integrator continues after an event.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::dynamics) struct ControllerState {
    /// Length of the first attempt; 0 for one from the frequency of the system \[s\].
    pub step: f64,
    /// Whether the method is implicit.
    pub stiff: bool,
}

impl ControllerState {
    /// The shorter step and the implicit method of two states.
    pub(in crate::dynamics) fn with(self, other: Self) -> Self {
        let step = if self.step == 0.0 { other.step } else { self.step.min(other.step) };
        Self { step, stiff: self.stiff || other.stiff }
    }
}

/// Limits of the end and the length of a step.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct StepLimits {
    /// Latest end \[s\].
    pub cap: f64,
    /// Next kink of the ground's motion, beyond which no step extends: one that ends there is not limited by its error \[s\].
    pub kink: f64,
    /// Length of the first attempt without a known step length \[s\].
    pub first: f64,
    /// Largest length \[s\].
    pub longest: f64,
    /// Forecast interval from the start of the step to the next event \[s\].
    pub soon: f64,
    /// Smallest length; a step that has to be shorter fails \[s\].
    pub smallest: f64,
}

impl StepLimits {
    /// Length to attempt of a step of length `h` from `t` \[s\]: [`BEYOND_EVENT`] times the forecast interval where
    /// that is worth a cut, otherwise `h`.
    fn reach(&self, t: f64, h: f64) -> f64 {
        let enough = BEYOND_EVENT * self.soon;
        let room = self.smallest.max(SHORTEST_CUT * t);
        if enough < WORTHWHILE_CUT * h && enough > room { enough } else { h }
    }
}

/// Outcome of an attempted step.
struct Attempt {
    /// Error estimate in units of the tolerance.
    error: f64,
    /// Length of the next step over that of this one.
    factor: f64,
}

/// A step within the tolerance.
struct AcceptedStep {
    /// Length \[s\].
    length: f64,
    /// Error estimate in units of the tolerance.
    error: f64,
    /// Whether it ends at a kink of the ground's motion.
    at_kink: bool,
}

/// Both methods for a system of one size, and the one in use.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct StepController {
    size: usize,
    rk: Dop853,
    radau: Option<Box<Radau>>,
    /// Workspace of an implicit method that is not in use.
    spare: Option<Box<Radau>>,
    state: ControllerState,
    /// Error of the last accepted step, in units of the tolerance.
    error: f64,
    /// Successive steps that favour the other method.
    doubts: u32,
    /// Steps with the method in use that do not end at a kink, and explicit ones after which the implicit method is tried.
    steps: u32,
    trial: u32,
}

impl StepController {
    /// A controller for systems of `size` components that continues with the method and the step length of `state`.
    pub(in crate::dynamics) fn new(size: usize, state: ControllerState) -> Self {
        let state = ControllerState { stiff: state.stiff && size <= LARGEST_IMPLICIT, ..state };
        let mut controller = Self { size, state, trial: TRIAL_STEPS, ..Self::default() };
        controller.rk.resize(size);
        controller
    }

    /// Changes to the implicit method only where stability limits explicit steps: the right-hand side has no noise.
    pub(in crate::dynamics) fn expect_no_noise(&mut self) {
        self.trial = u32::MAX;
    }

    /// Takes over the workspace of an implicit method of an ended island.
    pub(in crate::dynamics) fn borrow(&mut self, spare: Option<Box<Radau>>) {
        self.spare = spare;
    }

    /// Hands over the workspace of the implicit method, if there is one.
    pub(in crate::dynamics) fn give_back(&mut self) -> Option<Box<Radau>> {
        self.spare.take().or_else(|| self.radau.take())
    }

    /// Evaluates the slope at the start of the next step, for a first step and after a kink.
    pub(in crate::dynamics) fn start(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &[f64]) {
        self.rk.start(system, t, y);
        if let Some(radau) = &mut self.radau {
            radau.forget();
        }
    }

    /// Slope at the start of the next step.
    pub(in crate::dynamics) fn slope(&self) -> &[f64] {
        self.rk.slope()
    }

    /// Method and length of the next step.
    pub(in crate::dynamics) fn state(&self) -> ControllerState {
        self.state
    }

    /// Error of the last accepted step, in units of the tolerance.
    pub(in crate::dynamics) fn error(&self) -> f64 {
        self.error
    }

    /// Takes a step from `(t, y)` and returns its dense output and its end \[s\]; `y` becomes the state there.
    ///
    /// # Errors
    ///
    /// The length of a step that has to be shorter than the smallest.
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
            // A remainder before the cap would cost a step: the step is stretched to the cap.
            let end = if t + CAP_STRETCH * reach >= limits.cap { limits.cap } else { t + reach };
            let taken = end - t;
            if taken <= 0.0 {
                return Err(h);
            }
            let Attempt { error, factor } = self.attempt(system, t, y, taken);
            if error <= 1.0 {
                self.error = error;
                let cut = end == limits.cap || reach < h;
                self.state.step = if cut { h.max(taken * factor) } else { taken * factor }.min(limits.longest);
                return Ok((
                    self.accept(system, t, y, AcceptedStep { length: taken, error, at_kink: end >= limits.kink }),
                    end,
                ));
            }
            // After a second rejection the error estimate is unreliable: a motion within the step is over long before
            // its end.
            h = taken * factor.min(if refused && error > NEARLY_ACCEPTED { REPEATED_REJECTION } else { STEP_SAFETY });
            refused = true;
            if h < limits.smallest || t + h <= t {
                return Err(h);
            }
        }
    }

    /// Takes an explicit step that is part of one within the tolerance and returns its dense output; `y` becomes the
    /// state at its end.
    pub(in crate::dynamics) fn repeat_explicit(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &mut [f64],
        h: f64,
    ) -> DenseOutput {
        self.rk.start(system, t, y);
        // The error of the longer step was accepted.
        let _ = self.rk.attempt(system, t, y, h);
        self.rk.accept(system, t, y, h)
    }

    /// Attempts a step of length `h` \[s\].
    fn attempt(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &[f64], h: f64) -> Attempt {
        if self.state.stiff {
            let spare = &mut self.spare;
            let radau = self.radau.get_or_insert_with(|| {
                let mut radau = spare.take().unwrap_or_default();
                radau.resize(self.size);
                radau
            });
            let error = radau.attempt(system, t, y, self.rk.slope(), h);
            Attempt { error, factor: if error.is_finite() { radau_iia::next_factor(error) } else { UNSOLVED_FACTOR } }
        } else {
            let error = self.rk.attempt(system, t, y, h);
            Attempt { error, factor: if error.is_finite() { dop853::next_factor(error) } else { OVERFLOW_FACTOR } }
        }
    }

    /// Accepts the attempted step and compares its cost with that of the other method. A step that ends at a kink is limited by
    /// neither method: that is no reason for an implicit one, nor will the next be longer.
    fn accept(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &mut [f64],
        AcceptedStep { length: h, error, at_kink }: AcceptedStep,
    ) -> DenseOutput {
        let cost = system.implicit_cost();
        let (dense, doubt) = match &mut self.radau {
            Some(radau) if self.state.stiff => {
                let dense = radau.accept(t, y, h);
                self.rk.start(system, t + h, y);
                // The rate of a slip direction grows without bound towards the end of a touch: explicit steps would
                // become arbitrarily short.
                (
                    dense,
                    system.auxiliary_count() == 0
                        && (at_kink || error > GROWING_ERROR)
                        && h * radau.fastest(system) < IMPLICIT_STEP_WORTH * cost,
                )
            }
            _ => {
                let dense = self.rk.accept(system, t, y, h);
                let spare = self.size <= LARGEST_IMPLICIT && error < LIMITED_ERROR && !at_kink;
                let doubt = spare && self.rk.stiffness(system, &dense) > STABILITY_LIMITED;
                (dense, doubt)
            }
        };
        self.doubts = if doubt { self.doubts + 1 } else { 0 };
        self.steps += u32::from(!at_kink);
        let waited = f64::from(self.steps) >= f64::from(self.trial) * cost;
        let try_it = !self.state.stiff && waited && self.size <= LARGEST_IMPLICIT;
        if try_it {
            self.trial = self.trial.saturating_mul(2);
        }
        // A change to implicit steps is paid with as many of them: so much is first spent on explicit ones.
        let patience = f64::from(METHOD_CHANGE_STEPS) * if self.state.stiff { 1.0 } else { cost };
        if f64::from(self.doubts) >= patience || try_it {
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
        let limits =
            |soon: f64| StepLimits { cap: 1.0, kink: f64::INFINITY, first: 1e-9, longest: 1.0, soon, smallest: 1e-18 };
        assert_eq!(limits(1e-6).reach(9.0, 1e-4), BEYOND_EVENT * 1e-6, "a little beyond the change");
        assert_eq!(limits(9e-5).reach(9.0, 1e-4), 1e-4, "not worth a step of its own");
        assert_eq!(limits(5e-16).reach(9.0, 1e-4), 1e-4, "less than a bit of the time it would end at");
    }

    /// Decay at this rate towards `cos t`, with the number of evaluations of its slope.
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
        StepLimits { cap, kink: f64::INFINITY, first, longest: f64::INFINITY, soon: f64::INFINITY, smallest: 1e-12 }
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
    fn steps_that_end_at_kinks_stay_explicit_however_small_their_error() {
        let mut system = Relaxation { rate: 10.0, evaluations: 0 };
        let controller = ControllerState { step: 0.01, stiff: true };
        let (mut control, mut y) = (StepController::new(1, controller), [1.0]);
        let (mut t, mut implicit) = (0.0, 0);
        for number in 1..=200 {
            let kink = f64::from(number) * 0.01;
            while t < kink {
                control.start(&mut system, t, &y);
                let limits = StepLimits { kink, ..open(kink, 0.01) };
                (_, t) = control.step(&mut system, t, &mut y, limits).expect("a step");
                implicit += u32::from(control.state().stiff);
            }
        }
        assert!(implicit < METHOD_CHANGE_STEPS, "{implicit} implicit steps of a tenth of a time constant, of 200");
        assert!((y[0] - 2f64.cos()).abs() < 1e-9, "{}", y[0]);
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
