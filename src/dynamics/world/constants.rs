//! Constants of a group's setup: unit, effect and reason.

/// Differences of the placed gaps of a pair's nodes that count as 0, per size of the contact geometry \[–\]:
/// round-off of a sum of four terms.
pub(super) const AXIAL_GAP_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Impact speed at which the frequency of a pair's contact is evaluated for its simultaneity interval \[m/s\]. The
/// frequency of a linear law is independent of it, that of Hertz's law grows with its fifth root.
pub(super) const NOMINAL_IMPACT_SPEED: f64 = 1.0;
/// Circular frequency that stands for that of a device without stiffness \[rad/s\]: such a device has no time scale.
pub(super) const NOMINAL_FREQUENCY: f64 = 1.0;
