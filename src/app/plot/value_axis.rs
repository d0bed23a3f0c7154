//! The upright axis of a chart: which values it shows, the ticks along it, the unit that fits them.

use egui_plot::GridMark;

use crate::app::text;

/// Least height of a chart: three ticks have room in it \[points\].
pub(super) const LEAST_HEIGHT: f32 = 40.0;

/// Height of a chart from which its numbers have their usual size: between its free ends three of them, a quarter of that apart at least, lie
/// on none another \[points\].
const ROOMY: f32 = 46.0;

/// Zoom by the wheel, per point that it scrolls \[–\]. Chosen: a notch of 120 points nearly doubles.
pub(super) const WHEEL: f32 = 0.005;

/// Size of the numbers along an axis, usual and in a lower chart \[points\].
const LETTERS: [f32; 2] = [10.5, 8.8];

/// Least distance of two numbers along an axis \[points\].
const APART: f32 = 12.0;

/// How far the ends of an axis stay free of numbers, so that none reaches into the next chart \[points\].
const END: f32 = 5.0;

/// Height of a line of numbers in parts of their size \[–\], 8.5 of 10.5 points: closer than that one lies on another.
const LINE: f32 = 0.81;

/// Steps for an axis in which no round one has three numbers with room between them, in parts of a power of ten. Neighbours differ
/// by a third at most: the largest with three numbers is then more than a quarter of the axis.
const LESS_ROUND: [f64; 21] =
    [10.0, 8.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5, 1.2, 1.0, 0.8, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.12, 0.1];

/// Decades below the largest magnitude that a logarithmic axis shows.
const DECADES: f64 = 6.0;

/// Values along the height of a chart; of a logarithmic one their decimal logarithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ValueAxis {
    /// Lowest and highest.
    pub(super) range: [f64; 2],
    /// Top and bottom \[points\].
    pub(super) edges: [f32; 2],
    /// Whether values are logarithms.
    pub(super) log: bool,
}

impl ValueAxis {
    /// Where a value stands \[points\].
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    pub(super) fn y(&self, value: f64) -> f32 {
        let [low, high] = self.range;
        let [top, bottom] = self.edges.map(f64::from);
        (bottom + (value - low) / (high - low) * (top - bottom)).clamp(-1e5, 1e5) as f32
    }

    /// Which value stands at a place; of a logarithmic axis its decimal logarithm.
    pub(super) fn value(&self, y: f32) -> f64 {
        self.range[0] + f64::from(self.edges[1] - y) * self.per_point()
    }

    fn per_point(&self) -> f64 {
        (self.range[1] - self.range[0]) / f64::from((self.edges[1] - self.edges[0]).max(1.0))
    }

    /// The range after zooming by a factor about a place (below 1 comes nearer).
    pub(super) fn zoomed(&self, factor: f64, y: f32) -> [f64; 2] {
        let about = self.value(y);
        let range = self.range.map(|end| about + (end - about) * factor);
        let widest = range[1] - range[0];
        let scale = range[0].abs().max(range[1].abs());
        // Nearer than this neighbouring numbers are one.
        if widest > 1e-12 * scale && widest < 1e300 { range } else { self.range }
    }

    /// The range after moving it by so many points downwards.
    pub(super) fn panned(&self, points: f32) -> [f64; 2] {
        self.range.map(|end| end + f64::from(points) * self.per_point())
    }

    /// Values with a number beside them: three at least, none on another.
    pub(super) fn ticks(&self) -> Ticks {
        let height = self.edges[1] - self.edges[0];
        let margin = self.per_point() * f64::from(END);
        let inside = [self.range[0] + margin, self.range[1] - margin];
        let room = f64::from((height - 2.0 * END) / APART);
        let line = f64::from(LINE * self.letters() / APART);
        if self.log { decades(inside, room.max(3.0), line) } else { round(inside, room, line) }
    }

    /// Size of its numbers \[points\].
    pub(super) fn letters(&self) -> f32 {
        LETTERS[usize::from(self.edges[1] - self.edges[0] < ROOMY)]
    }
}

/// Values along an axis, and the distance of neighbouring ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Ticks {
    pub(super) values: Vec<f64>,
    step: f64,
    log: bool,
}

impl Ticks {
    /// The number of a tick, with as many digits as tell it from its neighbours; `factor` from the curve's unit to the axis'.
    pub(super) fn words(&self, value: f64, factor: f64) -> String {
        if self.log {
            return text::short(10f64.powf(value) * factor);
        }
        let (value, step) = (value * factor, self.step * factor);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 9")]
        let decimals = (1e-9 - step.log10()).ceil().clamp(0.0, 9.0) as usize;
        let more = usize::from((step * 10f64.powf(decimals as f64)).fract().abs() > 0.01);
        // Adding 0 turns −0 into 0.
        let words = format!("{:.*}", decimals + more, if value.abs() < 1e-6 * step { 0.0 } else { value });
        words.replace('-', "−")
    }
}

/// Multiples of the largest of 1, 2, 2.5, 5, … that has three of them inside; every other where not all fit into a room of so many
/// [`APART`], which none is closer to another than `line` of these.
fn round([low, high]: [f64; 2], room: f64, line: f64) -> Ticks {
    let (span, fit) = (high - low, room.max(3.0));
    if !(span.is_finite() && span > 0.0) {
        return Ticks::default();
    }
    let power = 10f64.powf(span.log10().floor());
    let multiples = |step: f64| {
        let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
        (first, last - first + 1.0)
    };
    let steps = [10.0, 5.0, 2.5, 2.0, 1.0, 0.5, 0.25, 0.2, 0.1, 0.05, 0.025, 0.02, 0.01].map(|m| m * power);
    let Some(step) = steps.into_iter().find(|step| multiples(*step).1 >= 3.0) else { return Ticks::default() };
    // The finest that fits: a finer one has more numbers, and all of them round.
    let fits = |finer: &f64| *finer <= step && (3.0..=fit.min(6.0)).contains(&multiples(*finer).1);
    let step = steps.into_iter().rfind(fits).unwrap_or(step);
    let count = multiples(step).1;
    // Five or six in too little room: every other one is three.
    let every: u8 = if count > fit && count >= 5.0 { 2 } else { 1 };
    let crowded = step * f64::from(every) / span * room < line;
    let less_round = LESS_ROUND.iter().map(|m| m * power).find(|step| multiples(*step).1 >= 3.0);
    let (step, every) = less_round.filter(|_| crowded).map_or((step, every), |step| (step, 1));
    let (first, count) = multiples(step);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few")]
    let values = (0..count as usize).step_by(usize::from(every)).map(|n| (first + n as f64) * step).collect();
    Ticks { values, step, log: false }
}

/// Powers of ten, and 2 and 5 times them where there are fewer than three; within less than a decade round values.
fn decades([low, high]: [f64; 2], fit: f64, line: f64) -> Ticks {
    let at = |multiples: &[f64]| -> Vec<f64> {
        #[expect(clippy::cast_possible_truncation, reason = "decimal exponents of doubles")]
        let powers = (low.floor() as i64)..=(high.floor() as i64);
        let all = powers.flat_map(|power| multiples.iter().map(move |m| m.log10() + power as f64));
        all.filter(|v| (low..=high).contains(v)).collect()
    };
    let powers = at(&[1.0]);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few")]
    let every = (powers.len() as f64 / fit).ceil().max(1.0) as usize;
    let powers: Vec<f64> = powers.into_iter().step_by(every).collect();
    let more = [powers, at(&[1.0, 3.0]), at(&[1.0, 2.0, 5.0])];
    let values = more.into_iter().find(|values| values.len() >= 3).unwrap_or_else(|| {
        let linear = round([low, high].map(|end| 10f64.powf(end)), fit, line);
        linear.values.into_iter().map(f64::log10).collect()
    });
    Ticks { values, step: 1.0, log: true }
}

/// Lowest and highest of some values with a margin, 0 inside; of logarithms no more than [`DECADES`] of them.
pub(super) fn range(values: impl Iterator<Item = f64>, log: bool) -> [f64; 2] {
    let finite = values.filter(|v| v.is_finite());
    if log {
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if low > high {
            return [-1.0, 0.0];
        }
        let low = low.max(high - DECADES).min(high - 0.5);
        let margin = (high - low) * 0.05;
        return [low - margin, high + margin];
    }
    let (low, high) = finite.fold((0.0f64, 0.0f64), |(l, h), v| (l.min(v), h.max(v)));
    // What is 0 but for rounding is drawn as 0.
    if high - low < 1e-9 {
        return [-1.0, 1.0];
    }
    let margin = (high - low) * 0.08;
    [low - margin, high + margin]
}

/// Unit that an axis counts in.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct AxisUnit {
    /// Numbers on the axis per value in the unit of the quantity \[–\].
    pub(super) factor: f64,
    /// Name, `kN`.
    pub(super) name: String,
}

/// Unit in which numbers of this magnitude read well: thousands of newtons are kN, what is far from 1 is counted in powers of ten.
pub(super) fn fitting(unit: &str, most: f64) -> AxisUnit {
    let plain = || AxisUnit { factor: 1.0, name: unit.to_owned() };
    let prefixed = |factor: f64, prefix: &str| AxisUnit { factor, name: format!("{prefix}{unit}") };
    let base = unit.split('·').next().unwrap_or(unit);
    match most {
        m if !(m.is_finite() && m > 0.0) => plain(),
        m if matches!(base, "N" | "J") && m >= 1e6 => prefixed(1e-6, "M"),
        m if matches!(base, "N" | "J") && m >= 1e4 => prefixed(1e-3, "k"),
        m if (1e-2..1e5).contains(&m) => plain(),
        m => {
            let power = 3.0 * (m.log10() / 3.0).floor();
            // egui's font has no raised minus.
            AxisUnit { factor: 10f64.powf(-power), name: format!("1e{power:.0} {unit}") }
        }
    }
}

/// Marks of a plot's grid, at the ticks of an axis `room` points long: three at least.
pub(in crate::app) fn grid_marks((low, high): (f64, f64), room: f32, log: bool) -> Vec<GridMark> {
    let axis = ValueAxis { range: [low, high], edges: [0.0, room], log };
    axis.ticks().values.into_iter().map(|value| GridMark { value, step_size: high - low }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(range: [f64; 2], height: f32) -> ValueAxis {
        ValueAxis { range, edges: [100.0, 100.0 + height], log: false }
    }

    #[test]
    #[expect(clippy::cast_possible_truncation, reason = "some hundred points")]
    fn every_chart_has_three_numbers_none_on_another() {
        // Seeded: ranges of any size and place, heights from the least on.
        let mut seed = 17_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..20_000 {
            let scale = 10f64.powf(24.0 * next() - 12.0);
            let low = (next() - 0.5) * scale;
            let height = LEAST_HEIGHT + 300.0 * next() as f32;
            let axis = axis([low, low + scale * (0.05 + next())], height);
            let ticks = axis.ticks();
            assert!(ticks.values.len() >= 3, "{axis:?}: {ticks:?}");
            let gaps = ticks.values.windows(2).map(|two| axis.y(two[0]) - axis.y(two[1]));
            assert!(gaps.clone().all(|gap| gap > 0.8 * axis.letters()), "{axis:?}: {:?}", gaps.collect::<Vec<_>>());
            let words: Vec<String> = ticks.values.iter().map(|v| ticks.words(*v, 1.0 / scale)).collect();
            assert!(words.windows(2).all(|two| two[0] != two[1]), "told apart: {words:?}");
        }
    }

    #[test]
    fn a_logarithmic_axis_has_three_numbers_too() {
        for range in [[-6.0, 0.0], [0.1, 0.9], [2.2, 2.9], [-3.0, -1.5], [-9.0, 9.0], [0.0, 0.4]] {
            let ticks = ValueAxis { log: true, ..axis(range, 60.0) }.ticks();
            assert!(ticks.values.len() >= 3, "{range:?}: {ticks:?}");
        }
    }

    #[test]
    fn zooming_keeps_the_value_under_the_pointer() {
        let before = axis([-1.0, 3.0], 200.0);
        let after = ValueAxis { range: before.zoomed(0.5, 130.0), ..before };
        let at = |axis: &ValueAxis| axis.range[0] + f64::from(axis.edges[1] - 130.0) * axis.per_point();
        assert!((at(&before) - at(&after)).abs() < 1e-12, "stays");
        assert!((after.range[1] - after.range[0] - 2.0).abs() < 1e-12, "half of it");
        assert_eq!(before.panned(50.0), [0.0, 4.0], "a quarter of the height down shows what lies above");
    }

    #[test]
    fn units_fit_their_numbers() {
        let cases =
            [("N", 1.73e7, 1e-6, "MN"), ("J", 2e4, 1e-3, "kJ"), ("mm", 12.0, 1.0, "mm"), ("°", 3e-5, 1e6, "1e-6 °")];
        for (unit, most, factor, wanted) in cases {
            let AxisUnit { factor: found, name: words } = fitting(unit, most);
            assert!((found / factor - 1.0).abs() < 1e-12 && words == wanted, "{most} {unit}: {found} {words}");
        }
    }
}
