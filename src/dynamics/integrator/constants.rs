//! Tuning factors of the integrators: value, unit, effect and reason.

/// Newton iterations before the step is shortened.
pub(super) const PATIENCE: usize = 12;
/// What may be left of the stages' equations, in parts of the tolerance.
pub(super) const LEFT: f64 = 5e-2;
/// Corrections that no longer shrink are rounding; it is let pass up to this part of the tolerance.
pub(super) const STALLED: f64 = 0.2;
/// Newton's method that converges better than this keeps its Jacobian.
pub(super) const GOOD: f64 = 0.1;
/// Steps that differ by less are one.
pub(super) const SAME: f64 = 1e-6;
/// Rounds of the power method for the fastest rate.
pub(super) const ROUNDS: usize = 12;
/// A polynomial begins no step that is so many times longer than its own.
pub(super) const FARTHEST: f64 = 10.0;
/// From this tolerance on fewer stages are cheaper.
pub(super) const COARSE: f64 = 1e-6;
/// What an error of five stages counts for: counted once a sliding deck is 1.7e-6 m off at 1e-4, four times 1.7e-7 m.
pub(super) const CAUTION: f64 = 4.0;
/// Steps shorter than this part of the fastest time constant, and than the next by the fourth root of the tolerance, take
/// three stages and no Jacobian.
pub(super) const QUIET: f64 = 0.3;
pub(super) const SHORT: f64 = 3.5;
