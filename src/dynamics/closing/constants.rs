//! Tolerance factors of the closing search: unit, effect, and derivation or the word "tuned".

/// Least relative error of a gap's rate, per speed of node and face \[–\]; a larger tolerance of the run takes its
/// place. Tuned: 64 units of round-off.
pub(in crate::dynamics) const SPEED_ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Interval over which velocities are differenced for the acceleration at a closing, and after which a touch that the
/// samples do not decide is sampled again, in simultaneity intervals of the pair \[–\]. Tuned: 1e-7 rad of the
/// contact's oscillation, short against it and 100 times the interval of simultaneous events.
pub(in crate::dynamics) const CLOSING_INTERVAL: f64 = 100.0;
/// Samples of a gap at equal intervals of a planned step, both ends included, with which the subdivision begins; the
/// bound on the gap's second derivative decides where it is refined. Tuned.
pub(in crate::dynamics) const STEP_SAMPLES: usize = 5;
/// Horizon of one search in flight of a body on springs whose phases end, in sampling intervals \[–\]. Tuned: another phase of the
/// same body often ends before.
pub(in crate::dynamics) const PHASE_END_SAMPLES: f64 = 4.0;

/// Half of the distance of bodies that have met, in parts of the smallest side of either, within which all their pairs are searched
/// \[–\]. Tuned: a search of all pairs has its own advances from there, which end at the touch.
pub(in crate::dynamics) const NEAR: f64 = 1e-3;
/// Most advances by the distance of two bodies in one search.
pub(in crate::dynamics) const PARTED_ADVANCES: usize = 64;
