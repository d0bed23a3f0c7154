//! First zero of a function by conservative advancement.
//!
//! Where `|g̈| ≤ M`, the first zero from `g, ġ` on is not before that of the parabola `g + ġτ − ½Mτ²`. The search advances by
//! that time and repeats: the advances converge to a zero from the left and pass over minima above 0.

use crate::dynamics::locate::constants::{COARSENING, FLOORED_ADVANCES, MAX_ADVANCES, POLISH_STEPS};
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::root::root;

/// A gap at one instant, with bounds on its motion from there on.
#[derive(Clone, Copy, Debug)]
pub struct BoundedGap {
    /// `g` \[m\].
    pub gap: f64,
    /// `ġ` \[m/s\].
    pub rate: f64,
    /// Bound on `|g̈|` within `window` \[m/s²\].
    pub curvature: f64,
    /// Time for which the bounds hold \[s\].
    pub window: f64,
    /// Whether the gap keeps its sign within `window`, by its distance alone.
    pub out_of_reach: bool,
}

/// Result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FirstZero {
    /// The gap crosses 0 inwards \[s\].
    Crossing(f64),
    /// It does not, up to this time \[s\].
    NoneUntil(f64),
}

impl FirstZero {
    /// Time of the event of a search in a run of this duration: the crossing, or the end of the search, where it continues; infinite at the
    /// end of the run \[s\].
    pub(in crate::dynamics) fn due(self, duration: f64) -> f64 {
        match self {
            Self::NoneUntil(end) if end >= duration => f64::INFINITY,
            Self::Crossing(t) | Self::NoneUntil(t) => t,
        }
    }
}

/// State of a gap after an advance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) enum AdvanceOutcome {
    /// The gap is open, or was not armed.
    Open,
    /// The gap has closed since the last evaluation.
    Closed,
    /// The gap closes within rounding of this evaluation.
    Closing,
}

/// One gap under search: its last evaluation, and the resolution in force.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Advancement {
    here: BoundedGap,
    armed: bool,
    /// Time at which it was first evaluated as positive again \[s\].
    positive_at: Option<f64>,
    resolution: f64,
    finest: f64,
    floored: u32,
}

impl Advancement {
    /// A search that begins where the gap is `here`. A gap that is not `armed` is negative and closes only after it has been
    /// positive again; a dip less deep than `resolution` \[m\] may be missed.
    pub(in crate::dynamics) fn begin(here: BoundedGap, armed: bool, resolution: f64) -> Self {
        Self { here, armed, positive_at: None, resolution, finest: resolution, floored: 0 }
    }

    /// Whether the gap can close at all.
    pub(in crate::dynamics) fn armed(&self) -> bool {
        self.armed
    }

    /// `g` at the last evaluation \[m\].
    pub(in crate::dynamics) fn gap(&self) -> f64 {
        self.here.gap
    }

    /// Time at which a gap that was not armed at the start was evaluated as positive again \[s\].
    pub(in crate::dynamics) fn rearmed_at(&self) -> Option<f64> {
        self.positive_at
    }

    /// Whether the gap cannot close while its bounds hold.
    pub(in crate::dynamics) fn out_of_reach(&self) -> bool {
        self.here.out_of_reach && (self.armed || self.here.gap < 0.0)
    }

    /// Whether the gap closes where the search begins.
    pub(in crate::dynamics) fn crosses_now(&self) -> bool {
        self.armed && self.closing(&self.here)
    }

    fn closing(&self, here: &BoundedGap) -> bool {
        here.gap <= self.resolution && here.rate < 0.0 && closes_at_once(here, self.resolution)
    }

    /// Time to the next evaluation \[s\].
    pub(in crate::dynamics) fn step(&mut self) -> f64 {
        self.step_past(0.0)
    }

    /// Time to the next evaluation of a gap that is known to stay open for `open` \[s\].
    pub(in crate::dynamics) fn step_past(&mut self, open: f64) -> f64 {
        let here = &self.here;
        let advance = if self.out_of_reach() { here.window } else { safe_step(here, self.armed, self.finest) };
        let advance = if self.armed { advance.max(open) } else { advance };
        // Only successive advances at the shortest length make the resolution coarser.
        self.floored = if advance <= shortest_step(here, self.finest) { self.floored + 1 } else { 0 };
        advance.min(here.window)
    }

    /// A time between the last evaluation, at `from`, and the next one at which the gap is open, to bracket a crossing: `from`
    /// itself or, where the gap opens from 0 there, the middle of the advance, where its lower bound is largest.
    pub(in crate::dynamics) fn last_open(&self, from: f64, next: f64) -> f64 {
        if self.here.gap <= 0.0 && self.here.rate > 0.0 { f64::midpoint(from, next) } else { from }
    }

    /// Takes the evaluation `there` at `t`.
    pub(in crate::dynamics) fn advance(&mut self, there: BoundedGap, t: f64) -> AdvanceOutcome {
        if self.armed && there.gap < 0.0 && (there.rate < 0.0 || there.gap < -self.finest) {
            return AdvanceOutcome::Closed;
        }
        if self.armed && self.closing(&there) {
            return AdvanceOutcome::Closing;
        }
        if !self.armed && is_positive_again(there.gap, there.rate, t, self.resolution) {
            (self.armed, self.positive_at) = (true, Some(t));
        }
        self.here = there;
        self.finest = match self.floored {
            0 => self.resolution,
            n if n % FLOORED_ADVANCES == 0 => COARSENING * self.finest,
            _ => self.finest,
        };
        AdvanceOutcome::Open
    }
}

/// First crossing of 0 from above in `[from, to]`; a dip less deep than `resolution` \[m\] may be missed.
///
/// A gap that is not `armed` is negative without having crossed 0: crossings count after it has been positive again.
pub fn first_crossing(
    mut sample: impl FnMut(f64) -> BoundedGap,
    from: f64,
    to: f64,
    armed: bool,
    resolution: f64,
) -> FirstZero {
    let here = sample(from);
    first_crossing_from(here, sample, [from, to], armed, resolution)
}

/// First crossing as by [`first_crossing`], where the evaluation at `from` is known.
pub(in crate::dynamics) fn first_crossing_from(
    here: BoundedGap,
    mut sample: impl FnMut(f64) -> BoundedGap,
    [from, to]: [f64; 2],
    armed: bool,
    resolution: f64,
) -> FirstZero {
    let (mut t, mut advancement) = (from, Advancement::begin(here, armed, resolution));
    if advancement.crosses_now() {
        return FirstZero::Crossing(t);
    }
    for _ in 0..MAX_ADVANCES {
        if t >= to {
            break;
        }
        let safe = t + advancement.step();
        if safe >= to && advancement.armed {
            // Open up to the end for certain: no look there.
            return FirstZero::NoneUntil(to);
        }
        let next = safe.min(to);
        if next <= t {
            // The advance is below the round-off of time.
            return if advancement.armed { FirstZero::Crossing(t) } else { FirstZero::NoneUntil(next) };
        }
        let there = sample(next);
        match advancement.advance(there, next) {
            AdvanceOutcome::Open => t = next,
            AdvanceOutcome::Closed => {
                let open = advancement.last_open(t, next);
                return FirstZero::Crossing(root(|at| -sample(at).gap, open, next));
            }
            AdvanceOutcome::Closing => return FirstZero::Crossing(polish(&mut sample, next, &there, to)),
        }
    }
    FirstZero::NoneUntil(t.min(to))
}

/// Time without a zero: root of the parabola that bounds the gap from below (armed) or from above (not armed) \[s\].
fn safe_step(here: &BoundedGap, armed: bool, finest: f64) -> f64 {
    let (gap, rate) = if armed { (here.gap.max(0.0), here.rate) } else { (-here.gap, -here.rate) };
    let m = here.curvature;
    let root = (rate * rate + 2.0 * m * gap).sqrt();
    let safe = if rate < 0.0 {
        2.0 * gap / (root - rate)
    } else if m > 0.0 {
        (rate + root) / m
    } else {
        f64::INFINITY
    };
    safe.max(if armed { shortest_step(here, finest) } else { step_within(m, finest) })
}

/// Shortest advance: within it no dip is deeper than `finest` \[s\].
fn shortest_step(here: &BoundedGap, finest: f64) -> f64 {
    let shortest = step_within(here.curvature, finest);
    // Towards 0 the depth grows with the rate already.
    if here.rate < 0.0 { shortest.min(finest / -here.rate) } else { shortest }
}

/// Time in which this curvature moves a gap by `finest` from rest \[s\].
fn step_within(curvature: f64, finest: f64) -> f64 {
    if curvature > 0.0 { (2.0 * finest / curvature).sqrt() } else { f64::INFINITY }
}

/// Whether the bound on `g̈` cannot reverse `ġ` before the gap is below −`resolution`: `ġ² > 2M (g + resolution)`.
fn closes_at_once(here: &BoundedGap, resolution: f64) -> bool {
    here.rate * here.rate > 2.0 * here.curvature * (here.gap.max(0.0) + resolution)
}

/// Zero by Newton's method from `t`, where the gap `here` is within the resolution of 0 and falling; at most `to`.
pub(in crate::dynamics) fn polish(
    sample: &mut impl FnMut(f64) -> BoundedGap,
    t: f64,
    here: &BoundedGap,
    to: f64,
) -> f64 {
    let (mut t, mut here) = (t, *here);
    for _ in 0..POLISH_STEPS {
        let next = (t - here.gap / here.rate).min(to);
        if next == t || !next.is_finite() {
            break;
        }
        t = next;
        here = sample(t);
        if here.rate >= 0.0 {
            break;
        }
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(offset: f64, count: &mut u32) -> impl FnMut(f64) -> BoundedGap {
        move |t| {
            *count += 1;
            BoundedGap {
                gap: offset + t.cos(),
                rate: -t.sin(),
                curvature: 1.0,
                window: f64::INFINITY,
                out_of_reach: false,
            }
        }
    }

    #[test]
    fn a_dip_of_a_billionth_is_found_where_it_begins() {
        let mut count = 0;
        let depth: f64 = 1e-9;
        let found = first_crossing(wave(1.0 - depth, &mut count), 0.0, 100.0, true, 1e-15);
        let exact = std::f64::consts::PI - (2.0 * depth).sqrt();
        let FirstZero::Crossing(t) = found else { panic!("missed: {found:?}") };
        // Near the tip rounding of the gap, 1e-16, moves the crossing by 1e-16/√(2e-9).
        assert!((t - exact).abs() < 1e-11, "{t} against {exact}");
        assert!(count < 200, "{count} evaluations");
    }

    #[test]
    fn a_graze_above_the_face_is_no_crossing_and_costs_little() {
        let mut count = 0;
        let found = first_crossing(wave(1.0 + 1e-12, &mut count), 0.0, 20.0, true, 1e-15);
        assert_eq!(found, FirstZero::NoneUntil(20.0), "never touches");
        assert!(count < 400, "{count} evaluations");
    }

    #[test]
    fn faces_at_rest_on_each_other_end_the_search() {
        let mut count = 0u32;
        let rest = |_t: f64| BoundedGap { gap: 0.0, rate: 0.0, curvature: 10.0, window: 1.0, out_of_reach: false };
        let found = first_crossing(
            |t| {
                count += 1;
                rest(t)
            },
            0.0,
            10.0,
            true,
            1e-15,
        );
        assert_eq!(found, FirstZero::NoneUntil(10.0), "no motion, no touch");
        assert!(count < 20_000, "{count} evaluations");
    }

    #[test]
    fn a_gap_that_opens_from_zero_closes_where_the_parabola_that_bounds_it_does() {
        let parabola = |t: f64| BoundedGap {
            gap: t * (1.0 - t),
            rate: 1.0 - 2.0 * t,
            curvature: 2.0,
            window: f64::INFINITY,
            out_of_reach: false,
        };
        let found = first_crossing(parabola, 0.0, 10.0, true, 1e-15);
        let FirstZero::Crossing(t) = found else { panic!("missed: {found:?}") };
        assert!((t - 1.0).abs() < 1e-15, "{t}: not where it opens");
    }
}
