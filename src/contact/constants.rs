//! Tolerance factors of the contact laws: unit, effect, and derivation or the word "tuned".

/// Gap as placed, per sum of the lengths whose difference it is, below which it is 0 \[–\]: round-off of a sum of
/// four terms.
pub(super) const PLACED_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Distance of a projection outside of a face's polygon, per size of the face, up to which it counts as inside \[–\].
/// Tuned: far above the round-off of ends placed edge on edge, 1e-16, and far below any width.
pub(super) const EDGE_TOLERANCE: f64 = 1e-9;
/// Speed below which sliding in two directions counts as stopped \[m/s\] (`docs/physics.md#stop`): regularises the
/// direction of friction. Tuned.
pub(super) const V_STICK: f64 = 1e-6;
/// Tangential velocity at a breakaway of law `paper`, per speed of the node, below which it is round-off and the
/// spring gives the direction of slip \[–\] (`docs/physics.md#breakaway`). Tuned.
pub(super) const SLIDING_ROUNDING: f64 = 1e-12;
/// Halvings of a bracket in the inversion of a restitution \[–\]: a bracket of 100 is then below 1e-22.
pub(super) const BISECTIONS: usize = 80;
/// Upper end of the bracket of a damping ratio \[–\]: `H(ζ)` is below 0.01, the least restitution of a scene, from ζ = 50.
pub(super) const LARGEST_RATIO: f64 = 100.0;
/// `δ_y/δ_m` of a bilinear spring \[–\] (`DesRoches` and Muthukumar, from memory).
pub(super) const YIELD_FRACTION: f64 = 0.1;
