//! Constants of the search for first zeros: value, unit, effect and reason.

/// Depth of an excursion below 0 that may go unseen, relative to the lengths whose difference the function is: 4e-16 is 1.8 units
/// in the last place, the rounding of a sum of two.
pub(in crate::dynamics) const RESOLUTION: f64 = 4e-16;
/// A function that was below 0 counts as positive again this many resolutions above 0: where its sign changed unseen its value is
/// rounding of either sign. Tuned: a power of 2 far above 1, far below every gap of interest (64 × 4e-16 of the size).
pub(in crate::dynamics) const ARMED: f64 = 64.0;
/// Rounding of a time, relative: 8 units in the last place of an instant and as many of the root before it.
pub(in crate::dynamics) const CLOCK: f64 = 16.0 * f64::EPSILON;
