//! Constants of the search for first zeros: value, unit, effect and reason.

/// Depth of an excursion below 0 that may go unseen, relative to the lengths whose difference the function is: 4e-16 is 1.8 units
/// in the last place, the rounding of a sum of two.
pub(in crate::dynamics) const RESOLUTION: f64 = 4e-16;
/// A function that was below 0 counts as positive again this many resolutions above 0: where its sign changed unseen its value is
/// rounding of either sign. Tuned: far above rounding, far below every gap of interest.
pub(in crate::dynamics) const REARM_RESOLUTIONS: f64 = 64.0;
/// Rounding of a time, relative: 8 units in the last place of an instant and as many of the root before it.
pub(in crate::dynamics) const TIME_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Advances before a search reports how far it has come: a bound on the work of one search.
pub(in crate::dynamics) const MAX_ADVANCES: u32 = 100_000;
/// Successive advances at the shortest length before the resolution is made coarser: a function that stays at rounding level (two
/// faces at rest on each other) ends in a bounded number of evaluations. Tuned.
pub(super) const FLOORED_ADVANCES: u32 = 512;
/// Evaluations of a subdivision at one resolution before it is made coarser, for the same reason. Tuned.
pub(super) const SAMPLES_PER_RESOLUTION: u32 = 64;
/// Factor by which the resolution is made coarser. Tuned: 13 times span the digits of a double.
pub(super) const COARSENING: f64 = 16.0;
/// Iterations on the root of a cubic bound. Any number is safe, because every iterate stays before the root. Tuned.
pub(super) const CUBIC_ITERATIONS: usize = 6;
/// Relative distance from the root of a cubic bound at which the iteration ends: the next advancement starts from a better
/// bound. Tuned.
pub(super) const CUBIC_CONVERGED: f64 = 1e-2;
