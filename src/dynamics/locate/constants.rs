//! Constants of the search for first zeros: value, unit, effect and reason.

/// Depth of an excursion below 0 that may go unseen, relative to the lengths whose difference the function is: 4e-16 is 1.8 units
/// in the last place, the rounding of a sum of two.
pub(in crate::dynamics) const RESOLUTION: f64 = 4e-16;
/// A function that was below 0 counts as positive again this many resolutions above 0; closer to 0 its sign is round-off. Tuned.
pub(in crate::dynamics) const REARM_RESOLUTIONS: f64 = 64.0;
/// Rounding of a time, relative: 8 units in the last place of an instant and as many of the root before it.
pub(in crate::dynamics) const TIME_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Advances before a search reports how far it has come: a bound on the work of one search.
pub(in crate::dynamics) const MAX_ADVANCES: u32 = 100_000;
/// Successive advances at the shortest length before the resolution is made coarser: the search of a function that stays within
/// round-off of 0 (two faces at rest on each other) then ends in a bounded number of evaluations. Tuned.
pub(super) const FLOORED_ADVANCES: u32 = 512;
/// Evaluations of a subdivision at one resolution before the resolution is made coarser: bounds its work. Tuned.
pub(super) const SAMPLES_PER_RESOLUTION: u32 = 64;
/// Factor by which the resolution is made coarser. Tuned: 13 times span the digits of a double.
pub(super) const COARSENING: f64 = 16.0;
/// Iterations on the root of a cubic bound. Any number is safe, because every iterate stays before the root. Tuned.
pub(super) const CUBIC_ITERATIONS: usize = 6;
/// Relative distance from the root of a cubic bound at which the iteration ends: the next advancement starts from a better
/// bound. Tuned.
pub(super) const CUBIC_CONVERGED: f64 = 1e-2;
/// Newton steps from within the resolution of a zero. Each squares the relative distance. Tuned.
pub(super) const POLISH_STEPS: u32 = 3;
/// Evaluations of a bracketed root: a bound on its work. Two rounds reduce a bracket by 2⁴ at least, so that the 52 bits of a
/// double relative to the bracket take 104 evaluations at most; the rest is room for roots near 0.
pub(super) const MAX_ROOT_EVALUATIONS: u32 = 200;
/// Evaluations of a bracketed root after which its progress is compared with that of bisection. Tuned.
pub(super) const ROUND: u32 = 4;
/// Factor by which [`ROUND`] bisections reduce a bracket: 2⁴. Secants that reduce it by less are followed by bisections.
pub(super) const ROUND_REDUCTION: f64 = 16.0;
/// Factor on the least distance of a secant from the ends of its bracket after a secant that was closer. Tuned.
pub(super) const MARGIN_GROWTH: f64 = 4.0;
/// Newton steps of a root with a slope, from that of the cubic through the ends of its interval: a step's motion differs from a cubic by
/// 1e-3 of the interval or less, and three squarings of the error reach a double's precision. The fourth is a reserve.
pub(super) const NEWTON_STEPS: u32 = 4;
/// Steps towards the root of that cubic, whose digits the Newton steps bring: a bound on their number.
pub(super) const CUBIC_STEPS: u32 = 12;
/// Halvings towards a zero at the start of an interval in search of a value below 0: to 2⁻³⁰ ≈ 1e-9 of the interval. Tuned.
pub(super) const DIP_HALVINGS: u32 = 30;
/// Times at which a function that starts at 0 is tested for a positive value, in parts of the interval \[–\]. A rise shorter than the first is,
/// for two terms of a power series, less than a millionth of the later fall; the second serves where the value at the first is rounding.
/// Chosen.
pub(super) const RISE_LOOKS: [f64; 2] = [1.0 / 1024.0, 1.0 / 32.0];
/// Height above the vertex of the parabola through three samples within which the function may reach 0, in parts of their
/// second difference. Tuned.
pub(super) const EXCURSION_MARGIN: f64 = 0.25;
/// Reductions of an interval by a third in search of a value above 0: (2/3)⁴⁸ ≈ 4e-9 of the interval. Tuned.
pub(super) const EXCURSION_REDUCTIONS: u32 = 48;
/// Samples of a record that one search in flight covers: bounds on a flight hold between two kinks alone \[–\]. Tuned.
pub(in crate::dynamics) const SAMPLES_PER_SEARCH: f64 = 64.0;
/// Part of the interval to which the root of a cubic is found \[–\]. Chosen: a thousandth of what a step's
/// motion differs from a cubic by ([`NEWTON_STEPS`]).
pub(super) const CUBIC_ROOT_FRACTION: f64 = 1e-6;
