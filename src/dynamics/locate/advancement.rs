//! Finding the first crossing without missing one.
//!
//! In flight the second derivative of a gap is bounded, so from `g, ġ` the first crossing cannot come before the
//! parabola `g + ġτ − ½Mτ²` does: leap there, and again. The leaps close in on a crossing from the left and step over
//! everything else.

use crate::dynamics::locate::constants::{COARSENING, FLOORED_ADVANCES, MAX_ADVANCES};
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::root::root;

/// A gap at one instant, with a promise about its future.
#[derive(Clone, Copy, Debug)]
pub struct BoundedGap {
    /// `g` \[m\].
    pub gap: f64,
    /// `ġ` \[m/s\].
    pub rate: f64,
    /// Bound on `|g̈|` while the promise holds \[m/s²\].
    pub curvature: f64,
    /// How long the promise holds \[s\].
    pub window: f64,
    /// Whether the gap cannot close while the promise holds, whatever the parabola says.
    pub out_of_reach: bool,
}

/// What a search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FirstZero {
    /// The gap crosses 0 inwards \[s\].
    Crossing(f64),
    /// It does not, up to this time \[s\].
    NoneUntil(f64),
}

/// What a look shows of a gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) enum AdvanceOutcome {
    /// It is open, or was not armed.
    Open,
    /// It has closed since the last look.
    Closed,
    /// It closes within rounding of this look.
    Closing,
}

/// One gap under search: how it stands, and how finely it is looked at.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Advancement {
    here: BoundedGap,
    armed: bool,
    /// When a look found it in front \[s\].
    out: Option<f64>,
    resolution: f64,
    finest: f64,
    floored: u32,
}

impl Advancement {
    /// Begins where the gap is `here`.
    pub(in crate::dynamics) fn begin(here: BoundedGap, armed: bool, resolution: f64) -> Self {
        Self { here, armed, out: None, resolution, finest: resolution, floored: 0 }
    }

    /// Whether the gap can close at all.
    pub(in crate::dynamics) fn armed(&self) -> bool {
        self.armed
    }

    /// `g` at the last look \[m\].
    pub(in crate::dynamics) fn gap(&self) -> f64 {
        self.here.gap
    }

    /// When a look found the node in front, that was not when the search began \[s\].
    pub(in crate::dynamics) fn rearmed_at(&self) -> Option<f64> {
        self.out
    }

    /// Whether the gap cannot close while the promise holds.
    pub(in crate::dynamics) fn out_of_reach(&self) -> bool {
        self.armed && self.here.out_of_reach
    }

    /// Whether it closes where the search begins.
    pub(in crate::dynamics) fn crosses_now(&self) -> bool {
        self.armed && self.closing(&self.here)
    }

    fn closing(&self, look: &BoundedGap) -> bool {
        look.gap <= self.resolution && look.rate < 0.0 && closes_at_once(look, self.resolution)
    }

    /// How far the next look may be \[s\].
    pub(in crate::dynamics) fn step(&mut self) -> f64 {
        self.step_past(0.0)
    }

    /// The same, where the gap is known to stay open for `open` \[s\].
    pub(in crate::dynamics) fn step_past(&mut self, open: f64) -> f64 {
        let here = &self.here;
        let leap = if self.out_of_reach() { here.window } else { safe_step(here, self.armed, self.finest) };
        let leap = if self.armed { leap.max(open) } else { leap };
        // Only leaps at the finest count: those that get on need no help.
        self.floored = if leap <= floor_of(here, self.finest) { self.floored + 1 } else { 0 };
        leap.min(here.window)
    }

    /// A time from the last look at `from` up to the next one at which the gap is open, to bracket a crossing: the last look
    /// itself, or, where the gap opens from 0 there, the middle of the leap, where the parabola that bounds it is highest.
    pub(in crate::dynamics) fn last_open(&self, from: f64, next: f64) -> f64 {
        if self.here.gap <= 0.0 && self.here.rate > 0.0 { f64::midpoint(from, next) } else { from }
    }

    /// The next look, at `t`.
    pub(in crate::dynamics) fn advance(&mut self, there: BoundedGap, t: f64) -> AdvanceOutcome {
        if self.armed && there.gap < 0.0 && (there.rate < 0.0 || there.gap < -self.finest) {
            return AdvanceOutcome::Closed;
        }
        if self.armed && self.closing(&there) {
            return AdvanceOutcome::Closing;
        }
        if !self.armed && is_positive_again(there.gap, there.rate, t, self.resolution) {
            (self.armed, self.out) = (true, Some(t));
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

/// First crossing of 0 from above in `[from, to]`; `resolution` is the depth of a dip that may go unseen \[m\].
///
/// A node that is not `armed` is behind the face without having come in through it: the search first waits until the gap
/// is above 0 again.
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

/// The same where the first look is known.
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
        let next = (t + advancement.step()).min(to);
        if next <= t {
            // Less than the clock can tell.
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

/// The safe leap: root of the parabola that bounds the gap from below (armed) or above (waiting to be armed).
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
    safe.max(if armed { floor_of(here, finest) } else { curved_floor(m, finest) })
}

/// The shortest leap worth taking: within it no dip is deeper than `finest`.
fn floor_of(here: &BoundedGap, finest: f64) -> f64 {
    let floor = curved_floor(here.curvature, finest);
    // Where the speed is real, rounding of the gap is a time, not a curvature.
    if here.rate < 0.0 { floor.min(finest / -here.rate) } else { floor }
}

fn curved_floor(curvature: f64, finest: f64) -> f64 {
    if curvature > 0.0 { (2.0 * finest / curvature).sqrt() } else { f64::INFINITY }
}

/// Within the resolution and going in faster than the bound can turn it round.
fn closes_at_once(here: &BoundedGap, resolution: f64) -> bool {
    here.rate * here.rate > 2.0 * here.curvature * (here.gap.max(0.0) + resolution)
}

/// Newton's method from inside the resolution.
pub(in crate::dynamics) fn polish(
    sample: &mut impl FnMut(f64) -> BoundedGap,
    t: f64,
    here: &BoundedGap,
    to: f64,
) -> f64 {
    let (mut t, mut here) = (t, *here);
    for _ in 0..3 {
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
        assert!(count < 200, "{count} looks");
    }

    #[test]
    fn a_graze_above_the_face_is_no_crossing_and_costs_little() {
        let mut count = 0;
        let found = first_crossing(wave(1.0 + 1e-12, &mut count), 0.0, 20.0, true, 1e-15);
        assert_eq!(found, FirstZero::NoneUntil(20.0), "never touches");
        assert!(count < 400, "{count} looks");
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
        assert!(count < 20_000, "{count} looks");
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
