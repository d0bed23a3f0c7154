//! Tolerance factors of the integrators: unit, effect, and derivation or the word "tuned". All without a unit but
//! counts.

// Radau IIA: Newton iteration.

/// Most Newton iterations per attempt; then the step is shortened. Tuned.
pub(super) const NEWTON_ITERATIONS: usize = 12;
/// Newton's iteration ends when the remaining error of the stages is below this part of the tolerance (κ of Hairer
/// and Wanner, section IV.8, there 0.01 to 0.1).
pub(super) const NEWTON_RESIDUAL: f64 = 5e-2;
/// Part of [`NEWTON_RESIDUAL`] below which the first correction ends the iteration, without a convergence rate. Tuned.
pub(super) const NEWTON_FIRST_SHARE: f64 = 2e-3;
/// An iteration whose corrections no longer shrink has reached round-off; it is accepted up to this part of the
/// tolerance. Tuned.
pub(super) const NEWTON_STALLED: f64 = 0.2;
/// Convergence rate up to which the Jacobian is kept for the next step: every iteration then gives a
/// digit.
pub(super) const NEWTON_GOOD_RATE: f64 = 0.1;
/// Relative difference of step lengths up to which the factored matrices are reused: far below the effect of the
/// approximate Jacobian on the rate of convergence.
pub(super) const SAME_STEP: f64 = 1e-6;
/// Rounds of the power method for the spectral radius of the Jacobian; the second half is read. Tuned: the estimate
/// is compared with a bound that is good to a factor.
pub(super) const POWER_ROUNDS: usize = 12;
/// Ratio of step lengths up to which the last collocation polynomial is extrapolated for the start of the iteration:
/// beyond, a polynomial of degree 5 is worse than no change.
pub(super) const EXTRAPOLATED_STEPS: f64 = 10.0;
/// Largest step, in units of the shortest time constant without auxiliary components, that is taken without a Jacobian.
/// Measured on a sliding deck at a tolerance of 2e-4: 326 million instructions with 0, 319 with 0.1, 317 with 0.3, 319
/// with 1.
pub(super) const QUIET_STEP: f64 = 0.3;

// Radau IIA: error estimate.

/// Relative tolerance from which the error estimate is multiplied by [`COARSE_FACTOR`]. Measured, see there.
pub(super) const COARSE_TOLERANCE: f64 = 1e-6;
/// Factor on the error estimate at coarse tolerances: it is of order 5, the method of order 9, and with long steps it
/// is no longer far above the error. Measured on a sliding deck: at tolerances of 8e-5 to 2e-4 it is 1.1e-6 to 1.8e-6 m
/// off with factor 1, 1e-7 to 2.4e-7 m with factor 4; from 1e-6 down the factor does not change the distance.
pub(super) const COARSE_FACTOR: f64 = 4.0;

// Dormand–Prince 8(5,3).

/// Time constants of a decay that an explicit step may span. With R the stability function, the estimate exceeds the
/// error |R(−z) − e^(−z)| up to z = 5.056; at 5.654, inside the region of stability, it crosses 0 while a quarter of
/// the decaying part is left.
pub(in crate::dynamics) const RESOLVED_DECAY: f64 = 5.0;

/// Time constants of a device's memory that an explicit step may span. Of a component that follows a slow motion at this rate the dense
/// output errs by 0.2 to 2.5 of the estimate up to 3, by 60 of it at 5, where the estimate includes the end alone (tested).
pub(in crate::dynamics) const RESOLVED_RELAXATION: f64 = 3.0;
/// Part of the change up to which a force's series converges that a step may span: the terms from the order of the estimate on fall by
/// this factor each. Measured on two girders with a damper of α = 0.3, 22 tolerances from 1e-10 to 1e-9: at most 1.3e-9 m off with 0.7,
/// 2.2e-9 m with 0.5, which takes a seventh more instructions, 1.8e-7 m without.
pub(in crate::dynamics) const RESOLVED_CHANGE: f64 = 0.7;

// Step control.

/// Explicit steps that span more time constants of the fastest motion than this, though their error is below
/// [`LIMITED_ERROR`], are limited by stability. Tuned.
pub(super) const STABILITY_LIMITED: f64 = 0.7;
/// Error, in parts of the tolerance, below which a step is not limited by accuracy: one of 0.02^(−1/8) = 1.6 times
/// the length is within the tolerance.
pub(super) const LIMITED_ERROR: f64 = 0.02;
/// Safety factor of a step length that follows from an error estimate, and largest factor after a rejection (Hairer,
/// Nørsett and Wanner, section II.4).
pub(super) const STEP_SAFETY: f64 = 0.9;
/// Least factor from one step length to the next. Tuned.
pub(super) const SHORTEST_FACTOR: f64 = 0.2;
/// Largest factor from one explicit step length to the next (that of the program DOP853).
pub(super) const LONGEST_FACTOR_EXPLICIT: f64 = 6.0;
/// Largest factor from one implicit step length to the next. Tuned.
pub(super) const LONGEST_FACTOR_IMPLICIT: f64 = 8.0;
/// Factor to the next attempt where Newton's method fails. Tuned.
pub(super) const UNSOLVED_FACTOR: f64 = 0.25;
/// Factor to the next attempt where the error of an explicit step is not finite. Tuned.
pub(super) const OVERFLOW_FACTOR: f64 = 0.1;
/// Part of its length by which a step is at most stretched to the cap: a shorter remainder would cost a step. Tuned.
pub(super) const CAP_STRETCH: f64 = 1.05;
/// Factor to the next attempt from the second rejection on, where the error is above [`NEARLY_ACCEPTED`]. Tuned.
pub(super) const REPEATED_REJECTION: f64 = 0.2;
/// Error of a rejected step up to which the estimate's own factor is used: 3^(1/8) shortens it by an eighth. Tuned.
pub(super) const NEARLY_ACCEPTED: f64 = 3.0;
/// Successive steps limited by stability after which the method changes. Tuned (DOP853 waits for 15).
pub(super) const METHOD_CHANGE_STEPS: u32 = 4;
/// Explicit steps between two events after which the implicit method is tried, doubled after each trial: round-off in
/// the right-hand side can limit explicit steps as well. Tuned.
pub(super) const TRIAL_STEPS: u32 = 64;
/// Time constants of the fastest motion below which an implicit step is not worth its cost: an explicit step, of about
/// as many evaluations, is stable up to six. Measured: with 5, 8 and 12 the lesson of stick and slip takes 91, 127 and
/// 127 million instructions, a spinning pair 118, 137 and 142, four other scenes from 8 % less to 1 % more with 5 than
/// with 12.
pub(super) const IMPLICIT_STEP_WORTH: f64 = 5.0;
/// Error, in parts of the tolerance, below which the next implicit step will be longer: the method is not given up
/// then. Tuned.
pub(super) const GROWING_ERROR: f64 = 0.2;
/// Length of a step that is cut for a forecast event, per interval to the event: its end is beyond the event. Tuned.
pub(super) const BEYOND_EVENT: f64 = 1.5;
/// Part of the proposed length below which a step is cut for a forecast event. Tuned.
pub(in crate::dynamics) const WORTHWHILE_CUT: f64 = 0.3;
/// Shortest interval to a forecast event for which a step is cut, relative to the time: a shorter step would be
/// round-off of its ends.
pub(super) const SHORTEST_CUT: f64 = 64.0 * f64::EPSILON;
/// Components beyond which the elimination of an implicit step, which grows with their cube, costs more than short
/// explicit steps. Tuned.
pub(super) const LARGEST_IMPLICIT: usize = 160;
/// `α` of a singular system, in parts of its largest entry \[–\]: round-off outside of its range enters a solution as `ε/α = 2e-9`.
pub(super) const TIKHONOV: f64 = 1e-7;
/// Solutions by residuals of a singular system: with the first they take the error of its range to `(α/σ)⁶`, below ε for every eigenvalue σ
/// above 4e-5 of its largest entry; girders of a row have such.
pub(super) const REFINEMENTS: usize = 5;
