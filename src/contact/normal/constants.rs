//! Constants of the normal laws.

/// Power of δ in the energy stored by a Hertz spring, `⅖ k_h δ^{5/2}` \[–\].
pub(super) const ENERGY_POWER: f64 = 2.5;
/// Duration of an elastic impact on a Hertz spring in units of `δ_max / v₀`, `2 ∫₀¹ dx/√(1 − x^{5/2}) = ⅘ B(⅖, ½)` \[–\].
pub(super) const HERTZ_DURATION: f64 = 2.943_275_184_324_704_7;
/// Impact speed below which `hertz-damp` has the dashpot of this speed, `v_floor` \[m/s\]: a slower hit rebounds with
/// more than its e. Tuned; the dashpot of a touch without impact, a/0, has no bound.
pub const LEAST_IMPACT_SPEED: f64 = 1e-3;
