//! Constants of closed-form free motion: value, unit, effect and reason.

/// Samples of a record between two stored states of a flight: a look-up advances over at most this many, exactly. Tuned: memory
/// against time.
pub(super) const CACHED_SAMPLES: usize = 8;
/// Terms of the Taylor series of the matrix exponential: at most 0.5 per factor, the last is 0.5^20/20! ≈ 4e-25, below ε after 1e8
/// cells.
pub(super) const TAYLOR_TERMS: u32 = 20;
/// `max(γ, ω) τ` below which the integrals of the impulse response are summed as power series: their closed forms divide differences
/// of nearly equal numbers by ω². 19 terms then leave less than 0.3^20/20!.
pub(super) const SERIES_LIMIT: f64 = 0.3;
/// Term of a series in parts of its sum that changes no bit of the sum \[–\]: half of the last bit is ε/4 of it at the least, four times this.
pub(super) const NEGLIGIBLE: f64 = f64::EPSILON / 16.0;
/// `ω²/γ²` below which the integrals of an overdamped oscillator are differences of those of its two decays: the other closed forms divide
/// by ω² differences that vanish with ω². Both rates then differ by more than a factor of 5, so that nothing cancels.
pub(super) const SOFT: f64 = 0.5;
/// Relative difference below which two oscillators are one but for rounding.
pub(super) const OSCILLATOR_ROUNDING: f64 = 1e-12;
/// Sum of the stiffnesses of a girder's bearings and of connections beside them that is round-off, in parts of its terms \[–\]: of some
/// ten bearings, each from a difference of two forces.
pub(super) const CANCELLED: f64 = 64.0 * f64::EPSILON;
/// Phase of a cell, of the fastest motion \[rad\]. Chosen: 1e5 rad are then 18 squarings.
pub(super) const CELL_PHASE: f64 = 0.5;
/// Rate that stands for that of a body which nothing holds or shakes \[1/s\]. Chosen: cells of 500 s, whose motion the series has exactly.
pub(super) const LEAST_CELL_RATE: f64 = 1e-3;
/// Phase of the fastest motion over which the work of forces bounds a flight \[rad\]. Chosen: longer, bounds are looser; shorter, they are
/// evaluated more often.
pub(super) const BOUND_PHASE: f64 = 0.5;
/// Phase `√|γ² − ω²| τ` below which the response is a series about critical damping \[rad\]: its first term left out, u⁴/9! with u the square of
/// the phase, is 3e-22.
pub(super) const NEAR_CRITICAL: f64 = 1e-2;
