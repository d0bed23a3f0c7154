//! The first closing of a gap within a planned step, from looks at it and a bound on how sharply it bends.
//!
//! Between two looks a gap differs from the straight line between them by no more than `½ M x (h − x)`. Where that reaches
//! through the face, the stretch is halved, so what is not seen is less deep than the resolution, whatever moves.

use crate::dynamics::locate::constants::{COARSENING, REARM_RESOLUTIONS, SAMPLES_PER_RESOLUTION};
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::root::{root, root_between};

/// A gap and its rate at a time.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct GapSample {
    /// When \[s\].
    pub t: f64,
    /// `g` \[m\].
    pub gap: f64,
    /// `ġ` \[m/s\].
    pub rate: f64,
}

/// One gap within one step.
pub(in crate::dynamics) struct Subdivision<A, C, N> {
    sample: A,
    bend: C,
    noise: N,
    armed: bool,
    out: Option<f64>,
    resolution: f64,
    instant: f64,
    finest: f64,
    looks: u32,
}

impl<A: FnMut(f64) -> GapSample, C: FnMut(&GapSample, f64) -> f64, N: FnMut(f64) -> f64> Subdivision<A, C, N> {
    /// `ask` looks at a time, `bend` bounds `|g̈|` from a look to a time, `noise` is what the rate at a time may err by; what
    /// is less deep than `resolution` may go unseen \[m\], and an `instant` is soon enough to see how a node goes in \[s\]. A
    /// node that is not `armed` is behind the face without having come in through it.
    pub(in crate::dynamics) fn new(
        (sample, bend, noise): (A, C, N),
        armed: bool,
        resolution: f64,
        instant: f64,
    ) -> Self {
        Self { sample, bend, noise, armed, out: None, resolution, instant, finest: resolution, looks: 0 }
    }

    /// When a node that was behind came out in front \[s\].
    pub(in crate::dynamics) fn rearmed_at(&self) -> Option<f64> {
        self.out
    }

    /// When the gap closes first, past looks in rising order of time.
    pub(in crate::dynamics) fn first_closing(&mut self, looks: &[GapSample]) -> Option<f64> {
        looks.windows(2).find_map(|pair| self.between(pair[0], pair[1]))
    }

    fn between(&mut self, before: GapSample, after: GapSample) -> Option<f64> {
        let middle = f64::midpoint(before.t, after.t);
        if before.t < middle && middle < after.t && self.hides(&before, &after) {
            self.looks += 1;
            self.finest *= if self.looks.is_multiple_of(SAMPLES_PER_RESOLUTION) { COARSENING } else { 1.0 };
            let between = (self.sample)(middle);
            return self.between(before, between).or_else(|| self.between(between, after));
        }
        if self.armed && after.gap < 0.0 && (after.gap < -self.resolution || self.evidence(&after) > 0.0) {
            return Some(self.crossing(&before, &after));
        }
        if !self.armed && self.is_out(&after) {
            (self.armed, self.out) = (true, Some(after.t));
        }
        None
    }

    /// Above 0 where a node is behind its face, or on its way there, by more than its place or its rate may err by.
    fn evidence(&mut self, sample_at: &GapSample) -> f64 {
        (-sample_at.rate - (self.noise)(sample_at.t)).max(-sample_at.gap - self.resolution)
    }

    /// When a node that is behind the face at the second of two looks came in. Where it touched it before they part, that is
    /// as soon as there is evidence: bodies that the ground alone drives go alike, and by which rounding a node goes in, sticks
    /// or slips, would be chance. It is then no deeper than the resolution.
    fn crossing(&mut self, before: &GapSample, after: &GapSample) -> f64 {
        let sample = &mut self.sample;
        let at = root(|t| -sample(t).gap, before.t, after.t);
        if before.gap > self.resolution {
            return at;
        }
        let soon = sample((at + self.instant).min(after.t));
        let first = self.evidence(&soon);
        if first > 0.0 {
            // Where both bodies still stand, nothing shows how it goes in.
            return if (self.noise)(at) > 0.0 { at } else { soon.t };
        }
        let last = self.evidence(after);
        let evidence = |t: f64| {
            let sample_at = (self.sample)(t);
            self.evidence(&sample_at)
        };
        root_between(evidence, [soon.t, after.t], [first, last])
    }

    fn is_out(&self, sample_at: &GapSample) -> bool {
        is_positive_again(sample_at.gap, sample_at.rate, sample_at.t, self.resolution)
    }

    /// Whether something may happen between two looks that they do not show: a dip behind the face, a coming out before it,
    /// or, where they are on either side, a crossing back and forth.
    fn hides(&mut self, before: &GapSample, after: &GapSample) -> bool {
        let (side, room) = if self.armed { (1.0, self.finest) } else { (-1.0, REARM_RESOLUTIONS * self.finest) };
        let crosses = if self.armed { after.gap < 0.0 } else { self.is_out(after) };
        // Rounding of the face, for one that has just opened or gone through.
        let [a, b] = [before.gap, after.gap].map(|gap| (side * gap).max(0.0));
        let h = after.t - before.t;
        let bend = (self.bend)(before, after.t);
        let (sag, slope) = (0.125 * bend * h * h, (after.gap - before.gap).abs());
        if crosses {
            // Less steep than it bends, it may cross more than once, by as much as it sags.
            return slope < 4.0 * sag && sag > self.finest;
        }
        // Between them the line less the sag is lowest at one of them, or inside.
        let lowest = 0.5 * (a + b) - sag - if sag > 0.0 { slope * slope / (16.0 * sag) } else { 0.0 };
        slope < 4.0 * sag && lowest < -room
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `offset − cos t`, whose second derivative is within ±1: least at t = 0, in front from there on where `offset` > 1.
    fn bowl(offset: f64, count: &mut u32) -> impl FnMut(f64) -> GapSample {
        move |t| {
            *count += 1;
            GapSample { t, gap: offset - t.cos(), rate: t.sin() }
        }
    }

    /// Searches from −1 to 1.03, seen at the ends only.
    fn search(offset: f64, side: f64, armed: bool) -> (Option<f64>, Option<f64>, u32) {
        let mut count = 0;
        let (closing, out) = {
            let mut sample = bowl(offset, &mut count);
            let mut sample = move |t: f64| {
                let sample_at = sample(t);
                GapSample { gap: side * sample_at.gap, rate: side * sample_at.rate, ..sample_at }
            };
            let looks = [sample(-1.0), sample(1.03)];
            let mut subdivision = Subdivision::new((sample, |_: &GapSample, _| 1.0, |_| 0.0), armed, 1e-15, 0.0);
            (subdivision.first_closing(&looks), subdivision.rearmed_at())
        };
        (closing, out, count)
    }

    #[test]
    fn a_dip_that_no_look_shows_is_found_where_it_begins() {
        for depth in [1e-3, 1e-6, 1e-9] {
            let (closing, _, count) = search(1.0 - depth, 1.0, true);
            let exact = -(1.0f64 - depth).acos();
            let closing = closing.unwrap_or_else(|| panic!("missed at {depth:e}"));
            // Near the tip rounding of the gap, 1e-16, moves the crossing by 1e-16/√(2 depth).
            assert!((closing - exact).abs() < 1e-11, "{closing} against {exact}");
            assert!(count < 200, "{count} looks");
        }
    }

    #[test]
    fn a_graze_above_the_face_is_no_closing() {
        let (closing, _, count) = search(1.0 + 1e-12, 1.0, true);
        assert!(closing.is_none() && count < 200, "{closing:?} after {count} looks");
    }

    #[test]
    fn a_node_that_comes_out_and_goes_in_again_unseen_is_met() {
        let (closing, out, _) = search(1.0 - 1e-6, -1.0, false);
        let exact = (1.0f64 - 1e-6).acos();
        assert!(closing.is_some_and(|t| (t - exact).abs() < 1e-9), "{closing:?} against {exact}");
        assert!(out.is_some_and(|t| t.abs() < exact), "out between: {out:?}");
    }

    #[test]
    fn bodies_that_go_alike_close_when_they_are_seen_to_differ() {
        let sample = |t: f64| GapSample { t, gap: -1e-20 * t.powi(3), rate: -3e-20 * t * t };
        let find = |noise: f64| {
            let looks = [sample(0.0), sample(0.5), sample(1.0)];
            Subdivision::new((sample, |_: &GapSample, _| 6e-20, |t: f64| noise * t), true, 1e-15, 1e-6)
                .first_closing(&looks)
        };
        let closing = find(9e-21).unwrap_or_else(|| panic!("it closes"));
        assert!((closing - 0.3).abs() < 1e-12, "3e-20 t² is above 9e-21 t from 0.3 on: {closing}");
        assert_eq!(find(0.0), Some(1e-6), "from rest, where nothing is rounding, as soon as it shows");
        assert_eq!(find(4e-20), None, "never as long as it could be rounding");
    }

    #[test]
    fn a_gap_at_rest_in_the_face_ends_the_search() {
        let mut count = 0u32;
        let mut sample = |t: f64| {
            count += 1;
            GapSample { t, gap: 0.0, rate: 0.0 }
        };
        let looks = [sample(0.0), sample(10.0)];
        let closing =
            Subdivision::new((sample, |_: &GapSample, _| 1.0, |_| 0.0), true, 1e-16, 0.0).first_closing(&looks);
        assert!(closing.is_none() && count < 20_000, "{closing:?} after {count} looks");
    }
}
