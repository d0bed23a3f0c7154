//! How many samples a curve takes, and how many of them are drawn: a run that swings faster than the picture has columns is drawn as
//! the band between the lowest and the highest value of each column, never as the slow wave that too few samples would make of it.

use egui_plot::{Line, PlotPoints};

/// A curve: `[t, value]`.
pub(in crate::app) type Curve = Vec<[f64; 2]>;

/// Largest distance of a curve from the straight line between two samples, in parts of the curve's range: 2 of 100 points of a
/// chart's height. A sine is met with 11 samples a period, and its crests within the same part.
const ROUGH: f64 = 0.02;

/// Where in the interval between two samples the curve is compared with the line: the golden section, so that an interval of whole
/// periods is not taken for a straight line.
const INSIDE: f64 = 0.381_966_011_250_105_1;

/// Intervals that are looked at (chosen): of a motion that is fast in a tenth of the window a dozen.
const LOOKED_AT: usize = 120;

/// Part of the intervals that may be rough: a hit bends a curve at one instant, and more samples elsewhere show nothing more.
const ROUGH_PART: f64 = 0.05;

/// Into how many parts each of `intervals` intervals of a window \[s\] is to be cut, 1 or a power of 2, for a line through the
/// samples to show the curves: no more than leave `most` samples.
pub(super) fn parts(
    [from, to]: [f64; 2],
    intervals: usize,
    most: usize,
    mut values: impl FnMut(f64) -> Vec<f64>,
) -> usize {
    let mut parts = 1;
    while intervals * parts * 2 <= most && is_rough([from, to], intervals * parts, &mut values) {
        parts *= 2;
    }
    parts
}

fn is_rough([from, to]: [f64; 2], intervals: usize, values: &mut impl FnMut(f64) -> Vec<f64>) -> bool {
    let step = (to - from) / intervals as f64;
    let looked_at = LOOKED_AT.min(intervals);
    let mut range: Vec<[f64; 2]> = Vec::new();
    let mut apart: Vec<Vec<f64>> = Vec::with_capacity(looked_at);
    for number in 0..looked_at {
        let start = from + step * (number * intervals / looked_at) as f64;
        let [first, inside, last] = [0.0, INSIDE, 1.0].map(|part| values(start + step * part));
        range.resize(first.len(), [f64::INFINITY, f64::NEG_INFINITY]);
        for seen in [&first, &inside, &last] {
            for ([low, high], &value) in range.iter_mut().zip(seen) {
                (*low, *high) = (low.min(value), high.max(value));
            }
        }
        let line = first.iter().zip(&last).map(|(first, last)| first + INSIDE * (last - first));
        apart.push(inside.iter().zip(line).map(|(value, line)| (value - line).abs()).collect());
    }
    let is_rough =
        |apart: &&Vec<f64>| apart.iter().zip(&range).any(|(apart, [low, high])| *apart > ROUGH * (high - low));
    apart.iter().filter(is_rough).count() as f64 > ROUGH_PART * looked_at as f64
}

/// A curve of at most two points a column: of each of `columns` columns of a window the lowest and the highest, in the order of time.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a column, inside the window")]
pub(super) fn by_columns(curve: Curve, [from, to]: [f64; 2], columns: usize) -> Curve {
    if curve.len() <= 2 * columns {
        return curve;
    }
    let column = |p: &[f64; 2]| ((p[0] - from) / (to - from) * columns as f64).max(0.0) as usize;
    let mut drawn = Curve::with_capacity(2 * columns + 2);
    for within in curve.chunk_by(|a, b| column(a) == column(b)) {
        let by_value = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let ends = (within.iter().min_by(by_value), within.iter().max_by(by_value));
        let (Some(low), Some(high)) = ends else { continue };
        let (first, last) = if low[0] <= high[0] { (low, high) } else { (high, low) };
        drawn.push(*first);
        drawn.extend((first != last).then_some(*last));
    }
    drawn
}

/// The line of a plot through these points and no others. `egui_plot` draws lines of several points a column as bands by itself, and
/// a band that is followed by a stretch without points is joined to the next one by a filled triangle.
pub(in crate::app) fn line<'a>(name: &str, points: Vec<[f64; 2]>) -> Line<'a> {
    Line::new(name, PlotPoints::new(points)).allow_band(false)
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: usize = 1500;

    fn sine(periods: f64) -> (usize, Curve) {
        let value = |t: f64| (std::f64::consts::TAU * periods * t).sin();
        let parts = parts([0.0, 1.0], COLUMNS, 100_000, |t| vec![value(t)]);
        let samples = COLUMNS * parts;
        (parts, (0..=samples).map(|i| i as f64 / samples as f64).map(|t| [t, value(t)]).collect())
    }

    #[test]
    fn a_slow_curve_is_drawn_as_it_was_sampled() {
        let (parts, curve) = sine(20.0);
        assert_eq!((parts, by_columns(curve.clone(), [0.0, 1.0], COLUMNS)), (1, curve), "75 samples a period");
    }

    #[test]
    fn a_sine_faster_than_the_columns_fills_its_band() {
        // At 749.5 periods every sample of 1500 columns lies by a crest of a slow wave; at 1500 all samples are equal.
        for periods in [400.0, 749.5, 1500.0, 3000.0] {
            let (parts, curve) = sine(periods);
            assert!(parts >= 2, "{periods} periods: {parts}");
            let drawn = by_columns(curve, [0.0, 1.0], COLUMNS);
            assert!(drawn.len() <= 2 * COLUMNS + 2, "{} points", drawn.len());
            // Over two periods, or a column where that is longer, the drawn points reach both crests.
            let width = 2.0 * (1.0 / periods).max(1.0 / COLUMNS as f64);
            for start in (0..50).map(|i| f64::from(i) / 51.0) {
                let near = drawn.iter().filter(|p| p[0] >= start && p[0] <= start + width).map(|p| p[1]);
                let [low, high] = near.fold([0.0, 0.0], |[low, high]: [f64; 2], v| [low.min(v), high.max(v)]);
                assert!(low < -0.97 && high > 0.97, "{periods} periods at {start}: {low} to {high}");
            }
        }
    }

    #[test]
    fn one_kink_asks_for_no_more_samples_and_their_number_is_bounded() {
        assert_eq!(parts([0.0, 1.0], COLUMNS, 100_000, |t| vec![(t - 0.3).abs()]), 1, "one hit");
        assert_eq!(parts([0.0, 1.0], COLUMNS, 7000, |t| vec![(1e5 * t).sin()]), 4, "not beyond 7000 samples");
    }
}
