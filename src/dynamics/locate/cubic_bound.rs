//! Lower bound of a function of time by a cubic, for conservative advancement of third order.
//!
//! Where `g̈` is known and `|g⃛| ≤ J`, the function stays above `g + ġτ + ½g̈τ² − ⅙Jτ³`. The first root of the cubic is
//! approached from below and never passed, so the step is safe after any number of iterations; steps converge to a crossing
//! with third order.

use crate::dynamics::locate::constants::{CUBIC_CONVERGED, CUBIC_ITERATIONS};

/// Lower bound of a gap: `g` \[m\], `ġ`, `g̈`, and `J ≥ |g⃛|` \[m/s³\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct CubicBound {
    pub gap: f64,
    pub rate: f64,
    pub bend: f64,
    pub jerk: f64,
}

impl CubicBound {
    fn value(&self, t: f64) -> f64 {
        self.gap + t * (self.rate + t * (0.5 * self.bend - t * self.jerk / 6.0))
    }

    fn slope(&self, t: f64) -> f64 {
        self.rate + t * (self.bend - 0.5 * t * self.jerk)
    }

    /// A time within which the gap cannot close; infinite where it never can \[s\].
    pub(in crate::dynamics) fn safe_step(&self) -> f64 {
        if self.gap < 0.0 || !self.jerk.is_finite() {
            return 0.0;
        }
        if self.jerk == 0.0 && self.rate >= 0.0 && self.bend >= 0.0 {
            return f64::INFINITY;
        }
        // The cubic is convex up to its inflection and concave behind it; before its peak it is lowest at one end.
        let under = self.bend * self.bend + 2.0 * self.jerk * self.rate;
        let inflection = if self.bend > 0.0 { self.bend / self.jerk } else { 0.0 };
        let peak = match (under >= 0.0, self.bend > 0.0) {
            (false, _) => 0.0,
            (true, true) => (self.bend + under.sqrt()) / self.jerk,
            // The same root, without cancellation.
            (true, false) => 2.0 * self.rate.max(0.0) / (under.sqrt() - self.bend).max(f64::MIN_POSITIVE),
        };
        if self.rate < 0.0 && self.bend > 0.0 {
            // In the convex part Newton's method from the left stays left of the root; is there a root before the minimum?
            let lowest = if under >= 0.0 { -2.0 * self.rate / (self.bend + under.sqrt()) } else { inflection };
            if self.value(lowest) <= 0.0 {
                return self.newton_from_left();
            }
        }
        self.concave(peak.max(inflection))
    }

    /// Whether this bound is above another at all later times.
    pub(in crate::dynamics) fn is_above(&self, other: &Self) -> bool {
        self.gap >= other.gap && self.rate >= other.rate && self.bend >= other.bend && self.jerk <= other.jerk
    }

    /// Newton's method in the convex part, from the left.
    fn newton_from_left(&self) -> f64 {
        let mut t = 0.0;
        for _ in 0..CUBIC_ITERATIONS {
            let (value, slope) = (self.value(t), self.slope(t));
            if value <= 0.0 || slope >= 0.0 {
                break;
            }
            let step = -value / slope;
            t += step;
            if step <= CUBIC_CONVERGED * t {
                break;
            }
        }
        t
    }

    /// Root from `low` on, where the cubic is not negative, concave and falling: Newton's method stays right of the root,
    /// chords stay left of it.
    fn concave(&self, mut low: f64) -> f64 {
        if !low.is_finite() {
            return low;
        }
        let mut at_low = self.value(low).max(0.0);
        let (fall, bent) = (-self.slope(low).min(0.0), (low * self.jerk - self.bend).max(0.0));
        // Slope and curvature, each alone, reach 0 by then.
        let most = (at_low / fall).min((2.0 * at_low / bent).sqrt());
        let most = if most.is_finite() { most } else { (6.0 * at_low / self.jerk).cbrt() };
        let mut high = low + most;
        for _ in 0..CUBIC_ITERATIONS {
            let at_high = self.value(high);
            if at_high >= 0.0 || high <= low {
                return high;
            }
            low += (high - low) * at_low / (at_low - at_high);
            if high - low <= CUBIC_CONVERGED * high {
                break;
            }
            at_low = self.value(low).max(0.0);
            high = (high - at_high / self.slope(high)).min(high).max(low);
        }
        low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first root by small steps.
    fn slowly(cubic: &CubicBound) -> f64 {
        (1..4_000_000).map(|i| f64::from(i) * 1e-6).find(|&t| cubic.value(t) < 0.0).unwrap_or(f64::INFINITY)
    }

    #[test]
    fn leaps_end_before_the_first_root_and_near_it() {
        for gap in [0.0, 1e-3, 0.3] {
            for rate in [-1.0, -0.1, 0.0, 0.4] {
                for bend in [-2.0, 0.0, 0.7, 12.0] {
                    for jerk in [0.5, 9.0] {
                        let cubic = CubicBound { gap, rate, bend, jerk };
                        let (leap, root) = (cubic.safe_step(), slowly(&cubic));
                        assert!(leap <= root, "{cubic:?}: {leap} beyond {root}");
                        assert!(leap >= 0.9 * root - 2e-6 || root > 3.9, "{cubic:?}: {leap} of {root}");
                    }
                }
            }
        }
    }
}
