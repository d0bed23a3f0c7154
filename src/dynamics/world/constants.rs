//! Constants of a group's setup: unit, effect and reason.

/// Differences of the placed gaps of a pair's nodes that count as 0, per size of the contact geometry \[–\]:
/// round-off of a sum of four terms.
pub(super) const AXIAL_GAP_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Impact speed at which the frequency of a pair's contact is evaluated for its simultaneity interval \[m/s\]. The
/// frequency of a linear law is independent of it, that of Hertz's law grows with its fifth root.
pub(super) const NOMINAL_IMPACT_SPEED: f64 = 1.0;
/// Most coordinates of a linear block. Its decomposition costs their cube, and a look at one body of it their number, where the state of a
/// step costs the same for every size: measured, a run with its readings is not slower up to about 30, the run alone up to about 60
/// (docs/cost.md#viaducts).
pub(super) const MOST_BLOCK_COORDINATES: usize = 36;
/// Circular frequency that stands for that of a device without stiffness \[rad/s\]: such a device has no time scale.
pub(super) const NOMINAL_FREQUENCY: f64 = 1.0;
/// Change of a force per size of it over a displacement of 1 m that is round-off \[–\]: of a few sums and products.
pub(super) const FORCE_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Distance of two vertices below which they are one, per size of the face \[–\]. Tuned: above the round-off of ends
/// placed edge on edge, below any width.
pub(super) const ONE_VERTEX: f64 = 1e-6;
