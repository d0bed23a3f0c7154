//! One step after another, by whichever method takes fewer evaluations: explicit steps of order eight, implicit ones where
//! the explicit ones are held short by their stability or by noise. Knows no physics.

use crate::dynamics::integrator::dense_output::Dense;
use crate::dynamics::integrator::dop853;
use crate::dynamics::integrator::dop853::Dop853;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::system::ImplicitSystem;

/// Explicit steps that span more time constants of the fastest motion than this, though their error is less than
/// [`SPARE`], are held short by their stability.
const STIFF: f64 = 0.7;
/// See [`STIFF`].
const SPARE: f64 = 0.02;
/// Factor to the next try from the second refusal on.
const AGAIN: f64 = 0.2;
/// Refused with no more than this, the next try will do.
const ALMOST: f64 = 3.0;
/// So many of them in a row change the method.
const CONVINCED: u32 = 4;
/// Explicit steps of one touch after which the other method is tried, and after twice as many again: noise, too, can hold
/// them short.
const TRIAL: u32 = 64;
/// An implicit step costs as much as explicit ones over so many time constants.
const WORTH: f64 = 12.0;
/// With a smaller error than this the next step will be longer.
const GROWING: f64 = 0.2;
/// A step goes so far beyond a change that is likely, where that is less than this part of its length.
const BEYOND: f64 = 1.5;
/// See [`BEYOND`].
pub(in crate::dynamics) const WORTHWHILE: f64 = 0.3;
/// A change so soon is now, in parts of the time: a step to it would be lost in the rounding of its ends.
const INSTANT: f64 = 64.0 * f64::EPSILON;
/// Components beyond which elimination costs more than short steps.
const LARGEST: usize = 160;

/// How an integrator goes on after an event.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::dynamics) struct Pace {
    /// Length of the step to try first; 0 where nothing is known \[s\].
    pub step: f64,
    /// Whether explicit steps were too short.
    pub stiff: bool,
}

impl Pace {
    /// The more careful of two.
    pub(in crate::dynamics) fn with(self, other: Self) -> Self {
        let step = if self.step == 0.0 { other.step } else { self.step.min(other.step) };
        Self { step, stiff: self.stiff || other.stiff }
    }
}

/// Where a step may end and how short it may be.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Limits {
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

impl Limits {
    /// How far a step of length `h` from `t` is worth taking: not far beyond what is likely to end it \[s\].
    fn reach(&self, t: f64, h: f64) -> f64 {
        let enough = BEYOND * self.soon;
        let room = self.smallest.max(INSTANT * t);
        if enough < WORTHWHILE * h && enough > room { enough } else { h }
    }
}

/// Both methods for a system of one size, and which of them is in use.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Stepper {
    size: usize,
    rk: Dop853,
    radau: Option<Box<Radau>>,
    /// Memory that another one has left.
    spare: Option<Box<Radau>>,
    pace: Pace,
    /// Steps in a row that spoke against the method in use.
    doubts: u32,
    /// Steps with the method in use, and explicit ones after which the other is given a try.
    steps: u32,
    trial: u32,
}

impl Stepper {
    /// For systems of `size` components, going on at `pace`.
    pub(in crate::dynamics) fn new(size: usize, pace: Pace) -> Self {
        let pace = Pace { stiff: pace.stiff && size <= LARGEST, ..pace };
        let mut stepper = Self { size, pace, trial: TRIAL, ..Self::default() };
        stepper.rk.resize(size);
        stepper
    }

    /// Only stability will change the method: there is no noise that could hold explicit steps short.
    pub(in crate::dynamics) fn trust(&mut self) {
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
    pub(in crate::dynamics) fn pace(&self) -> Pace {
        self.pace
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
        limits: Limits,
    ) -> Result<(Dense, f64), f64> {
        let mut h = if self.pace.step > 0.0 { self.pace.step } else { limits.first }.min(limits.longest);
        let mut refused = false;
        loop {
            let reach = limits.reach(t, h);
            // A last sliver would cost as much as a step: stretch to the cap.
            let end = if t + 1.05 * reach >= limits.cap { limits.cap } else { t + reach };
            let taken = end - t;
            let (error, factor) = self.attempt(system, t, y, taken);
            if error <= 1.0 {
                let cut = end == limits.cap || reach < h;
                self.pace.step = if cut { h.max(taken * factor) } else { taken * factor }.min(limits.longest);
                return Ok((self.accept(system, t, y, taken, error), end));
            }
            // Refused twice, the estimate is no guide: something is over far sooner than the step.
            h = taken * factor.min(if refused && error > ALMOST { AGAIN } else { 0.9 });
            refused = true;
            if h < limits.smallest || t + h <= t {
                return Err(h);
            }
        }
    }

    /// Takes an explicit step that is part of one within the tolerance: its continuous answer; `y` becomes the state at its
    /// end.
    pub(in crate::dynamics) fn again(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &mut [f64],
        h: f64,
    ) -> Dense {
        self.rk.start(system, t, y);
        // Its estimate is known to be small enough.
        let _ = self.rk.attempt(system, t, y, h);
        self.rk.accept(system, t, y, h)
    }

    /// The same of an implicit step; nothing where that is not within the tolerance. The next step has to be started.
    pub(in crate::dynamics) fn again_implicit(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &mut [f64],
        h: f64,
    ) -> Option<Dense> {
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
        if self.pace.stiff {
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
    fn accept(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &mut [f64], h: f64, error: f64) -> Dense {
        let (dense, doubt) = match &mut self.radau {
            Some(radau) if self.pace.stiff => {
                let dense = radau.accept(t, y, h);
                self.rk.start(system, t + h, y);
                // What turns gets faster without bound where a touch ends: explicit steps would come to nothing.
                (dense, system.auxiliary_count() == 0 && error > GROWING && h * radau.fastest(system) < WORTH)
            }
            _ => {
                let dense = self.rk.accept(system, t, y, h);
                let spare = self.size <= LARGEST && error < SPARE;
                let doubt = spare && self.rk.stiffness(system, &dense) > STIFF;
                (dense, doubt)
            }
        };
        self.doubts = if doubt { self.doubts + 1 } else { 0 };
        self.steps += 1;
        let try_it = !self.pace.stiff && self.steps >= self.trial && self.size <= LARGEST;
        if try_it {
            self.trial = self.trial.saturating_mul(2);
        }
        if self.doubts >= CONVINCED || try_it {
            self.change_method();
        }
        dense
    }

    fn change_method(&mut self) {
        (self.doubts, self.steps) = (0, 0);
        self.pace.stiff = !self.pace.stiff;
        if let Some(radau) = &mut self.radau {
            radau.resize(self.size);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_ends_soon_after_a_likely_change_but_not_at_once() {
        let limits = |soon: f64| Limits { cap: 1.0, first: 1e-9, longest: 1.0, soon, smallest: 1e-18 };
        assert_eq!(limits(1e-6).reach(9.0, 1e-4), BEYOND * 1e-6, "a little beyond the change");
        assert_eq!(limits(9e-5).reach(9.0, 1e-4), 1e-4, "not worth a step of its own");
        assert_eq!(limits(5e-16).reach(9.0, 1e-4), 1e-4, "less than a bit of the time it would end at");
    }
}
