//! Tolerance factors of the closing search.

/// Rounding of a speed, in parts of it, with room.
pub(in crate::dynamics) const SPEED: f64 = 64.0 * f64::EPSILON;
/// Time over which a contact shows how it closes, in units of that within which contacts of its pair close together.
pub(in crate::dynamics) const INSTANT: f64 = 100.0;
/// Looks at a gap per planned step.
pub(in crate::dynamics) const LOOKS: usize = 5;

/// What a search that was cut short counts against the work bound.
pub(in crate::dynamics) const CUT_SHORT: usize = 5_000;
/// Samples of a record that one search covers.
pub(in crate::dynamics) const SAMPLES: f64 = 64.0;
