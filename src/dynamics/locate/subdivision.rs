//! First zero of a gap within a planned step, by subdivision with a bound on its second derivative.
//!
//! Between two samples an interval h apart a gap differs from the chord by at most `½ M x (h − x)`, `M ≥ |g̈|`. Where that
//! reaches below 0, the interval is halved, so that no dip deeper than the resolution is missed.

use crate::dynamics::locate::constants::{COARSENING, REARM_RESOLUTIONS, SAMPLES_PER_RESOLUTION};
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::root::{root_between, root_with_slope};

/// A gap and its rate at a time.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct GapSample {
    /// Time \[s\].
    pub t: f64,
    /// `g` \[m\].
    pub gap: f64,
    /// `ġ` \[m/s\].
    pub rate: f64,
}

/// First closing of a gap within a search.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::dynamics) struct GapClosing {
    /// First crossing of 0 from above; `None` without one before the end of the search \[s\].
    pub closing: Option<f64>,
    /// Time at which a gap that was not armed is first positive again \[s\].
    pub rearmed_at: Option<f64>,
}

impl GapClosing {
    /// No closing until the end of the search.
    pub(in crate::dynamics) const NONE: Self = Self { closing: None, rearmed_at: None };

    /// A closing of an armed gap at `t` \[s\].
    pub(in crate::dynamics) fn at(t: f64) -> Self {
        Self { closing: Some(t), rearmed_at: None }
    }
}

/// Search of one gap within one step.
pub(in crate::dynamics) struct Subdivision<A, C, N> {
    sample: A,
    curvature: C,
    rate_error: N,
    armed: bool,
    positive_at: Option<f64>,
    resolution: f64,
    delay: f64,
    finest: f64,
    evaluations: u32,
}

impl<A: FnMut(f64) -> GapSample, C: FnMut(&GapSample, f64) -> f64, N: FnMut(f64) -> f64> Subdivision<A, C, N> {
    /// A search by the functions `sample` of a time, `curvature`, the bound on `|g̈|` from a sample to a time \[m/s²\], and
    /// `rate_error`, the error of the rate at a time \[m/s\]. A dip less deep than `resolution` \[m\] may be missed; the sign of
    /// the rate is tested `delay` \[s\] after a crossing. A gap that is not `armed` is negative without having crossed 0.
    pub(in crate::dynamics) fn new(
        (sample, curvature, rate_error): (A, C, N),
        armed: bool,
        resolution: f64,
        delay: f64,
    ) -> Self {
        Self {
            sample,
            curvature,
            rate_error,
            armed,
            positive_at: None,
            resolution,
            delay,
            finest: resolution,
            evaluations: 0,
        }
    }

    /// Searches between samples in rising order of time.
    pub(in crate::dynamics) fn search(mut self, samples: &[GapSample]) -> GapClosing {
        let closing = samples.windows(2).find_map(|pair| self.between(pair[0], pair[1]));
        GapClosing { closing, rearmed_at: self.positive_at }
    }

    fn between(&mut self, before: GapSample, after: GapSample) -> Option<f64> {
        let middle = f64::midpoint(before.t, after.t);
        if before.t < middle && middle < after.t && self.may_hide_zeros(&before, &after) {
            self.evaluations += 1;
            self.finest *= if self.evaluations.is_multiple_of(SAMPLES_PER_RESOLUTION) { COARSENING } else { 1.0 };
            let between = (self.sample)(middle);
            return self.between(before, between).or_else(|| self.between(between, after));
        }
        if self.armed && after.gap < 0.0 && (after.gap < -self.resolution || self.evidence(&after) > 0.0) {
            return Some(self.crossing(&before, &after));
        }
        if !self.armed && self.is_out(&after) {
            (self.armed, self.positive_at) = (true, Some(after.t));
        }
        None
    }

    /// Positive where the gap is below −resolution, or its rate negative by more than the error of the rate.
    fn evidence(&mut self, sample_at: &GapSample) -> f64 {
        (-sample_at.rate - (self.rate_error)(sample_at.t)).max(-sample_at.gap - self.resolution)
    }

    /// Time at which a gap that is negative at the second of two samples crossed 0. A gap within the resolution of 0 at the first one
    /// counts as closing from the time at which its depth or its rate exceeds its error: of bodies that move alike under the ground alone,
    /// round-off would decide where it closes. Its depth is then at most the resolution.
    fn crossing(&mut self, before: &GapSample, after: &GapSample) -> f64 {
        let sample = &mut self.sample;
        let falling = |sample: &GapSample| [-sample.gap, -sample.rate];
        let at = root_with_slope(|t| falling(&sample(t)), [before.t, after.t], [before, after].map(falling));
        if before.gap > self.resolution {
            return at;
        }
        let later = sample((at + self.delay).min(after.t));
        let first = self.evidence(&later);
        if first > 0.0 {
            // Of bodies that move alike until `at` the rate there has no sign.
            let there = (self.sample)(at);
            return if self.evidence(&there) > 0.0 { at } else { later.t };
        }
        let last = self.evidence(after);
        let evidence = |t: f64| {
            let sample_at = (self.sample)(t);
            self.evidence(&sample_at)
        };
        root_between(evidence, [later.t, after.t], [first, last])
    }

    fn is_out(&self, sample_at: &GapSample) -> bool {
        is_positive_again(sample_at.gap, sample_at.rate, sample_at.t, self.resolution)
    }

    /// Whether the bound allows zeros between two samples that their signs do not show: two of samples of one sign, three of
    /// samples of either sign.
    fn may_hide_zeros(&mut self, before: &GapSample, after: &GapSample) -> bool {
        let (side, room) = if self.armed { (1.0, self.finest) } else { (-1.0, REARM_RESOLUTIONS * self.finest) };
        let crosses = if self.armed { after.gap < 0.0 } else { self.is_out(after) };
        // A gap that has just opened or closed may be negative by round-off.
        let [a, b] = [before.gap, after.gap].map(|gap| (side * gap).max(0.0));
        let h = after.t - before.t;
        let (sag, slope) = (0.125 * (self.curvature)(before, after.t) * h * h, (after.gap - before.gap).abs());
        if crosses {
            // A chord less steep than the bounding parabola allows more than one crossing, as deep as the sag.
            return slope < 4.0 * sag && sag > self.finest;
        }
        // Least value of the chord less the sag.
        let lowest = 0.5 * (a + b) - sag - if sag > 0.0 { slope * slope / (16.0 * sag) } else { 0.0 };
        slope < 4.0 * sag && lowest < -room
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `offset − cos t`, whose second derivative is within ±1 and whose minimum is `offset − 1` at t = 0.
    fn bowl(offset: f64, count: &mut u32) -> impl FnMut(f64) -> GapSample {
        move |t| {
            *count += 1;
            GapSample { t, gap: offset - t.cos(), rate: t.sin() }
        }
    }

    /// Searches from −1 to 1.03, sampled at the ends.
    fn search(offset: f64, side: f64, armed: bool) -> (Option<f64>, Option<f64>, u32) {
        let mut count = 0;
        let (closing, out) = {
            let mut sample = bowl(offset, &mut count);
            let mut sample = move |t: f64| {
                let sample_at = sample(t);
                GapSample { gap: side * sample_at.gap, rate: side * sample_at.rate, ..sample_at }
            };
            let ends = [sample(-1.0), sample(1.03)];
            let subdivision = Subdivision::new((sample, |_: &GapSample, _| 1.0, |_| 0.0), armed, 1e-15, 0.0);
            let found = subdivision.search(&ends);
            (found.closing, found.rearmed_at)
        };
        (closing, out, count)
    }

    #[test]
    fn a_dip_between_two_samples_is_found_where_it_begins() {
        for depth in [1e-3, 1e-6, 1e-9] {
            let (closing, _, count) = search(1.0 - depth, 1.0, true);
            let exact = -(1.0f64 - depth).acos();
            let closing = closing.unwrap_or_else(|| panic!("missed at {depth:e}"));
            // Near the tip rounding of the gap, 1e-16, moves the crossing by 1e-16/√(2 depth).
            assert!((closing - exact).abs() < 1e-11, "{closing} against {exact}");
            assert!(count < 200, "{count} evaluations");
        }
    }

    #[test]
    fn a_graze_above_the_face_is_no_closing() {
        let (closing, _, count) = search(1.0 + 1e-12, 1.0, true);
        assert!(closing.is_none() && count < 200, "{closing:?} after {count} evaluations");
    }

    #[test]
    fn a_gap_that_opens_and_closes_between_two_samples_is_found() {
        let (closing, out, _) = search(1.0 - 1e-6, -1.0, false);
        let exact = (1.0f64 - 1e-6).acos();
        assert!(closing.is_some_and(|t| (t - exact).abs() < 1e-9), "{closing:?} against {exact}");
        assert!(out.is_some_and(|t| t.abs() < exact), "positive between: {out:?}");
    }

    #[test]
    fn bodies_that_move_alike_close_when_their_difference_exceeds_its_error() {
        let sample = |t: f64| GapSample { t, gap: -1e-20 * t.powi(3), rate: -3e-20 * t * t };
        let find = |noise: f64| {
            let ends = [sample(0.0), sample(0.5), sample(1.0)];
            Subdivision::new((sample, |_: &GapSample, _| 6e-20, |t: f64| noise * t), true, 1e-15, 1e-6)
                .search(&ends)
                .closing
        };
        let closing = find(9e-21).unwrap_or_else(|| panic!("it closes"));
        assert!((closing - 0.3).abs() < 1e-12, "3e-20 t² is above 9e-21 t from 0.3 on: {closing}");
        assert_eq!(find(0.0), Some(1e-6), "without error of the rate, after the delay");
        assert_eq!(find(4e-20), None, "never while the rate is within its error");
    }

    #[test]
    fn a_gap_at_rest_in_the_face_ends_the_search() {
        let mut count = 0u32;
        let mut sample = |t: f64| {
            count += 1;
            GapSample { t, gap: 0.0, rate: 0.0 }
        };
        let ends = [sample(0.0), sample(10.0)];
        let closing =
            Subdivision::new((sample, |_: &GapSample, _| 1.0, |_| 0.0), true, 1e-16, 0.0).search(&ends).closing;
        assert!(closing.is_none() && count < 20_000, "{closing:?} after {count} evaluations");
    }
}
