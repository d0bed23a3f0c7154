//! Drawing of elastic girders: magnification of their deformation, and the motion that it is relative to.
//!
//! An end that faces something is drawn where it is, so that no gap seems to close that is open: what is drawn larger is the
//! deformation relative to such ends.

use glam::{DVec2, DVec3};

use crate::dynamics::elastic::Fields;
use crate::geometry::End;
use crate::scene::facing::Side;
use crate::sim::{History, OfSection, SectionField};

/// Largest drawn deflection without a factor that is asked for, in parts of the length.
const DRAWN: f64 = 0.03;
/// Times of a run at which the largest deflection and force are looked for, beside those of the hardest hit.
const LOOKS: usize = 200;
/// Stations at which they are looked for.
const STATIONS: usize = 17;

/// Drawing of elastic girders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// Magnification of the deformation \[–\].
    pub factor: f64,
    /// Section force that colours them, and its value at the ends of the colours, SI.
    pub colored: Option<(OfSection, f64)>,
}

/// Settings for the drawing of elastic girders.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bending {
    /// Magnification \[–\]; by none, the largest deflection is 3 % of the girder's length.
    pub factor: Option<f64>,
    /// Section force that colours them.
    pub force: Option<OfSection>,
}

impl Bent {
    /// Of a run; without a factor the largest deflection is drawn as 3 % of the girder's length. `None` where no girder bends.
    pub fn of(history: &History, Bending { factor, force }: Bending) -> Option<Self> {
        let girders =
            (0..history.scene().girders.len()).filter(|&girder| history.sections().flexible(girder).is_some());
        let girders: Vec<usize> = girders.collect();
        let _ = girders.first()?;
        let most = |of: &dyn Fn(usize) -> f64| girders.iter().map(|&girder| of(girder)).fold(0.0, f64::max);
        let factor =
            factor.unwrap_or_else(|| round_factor(most(&|girder| 1.0 / largest_part(history, girder).max(1e-12))));
        let colored = force.map(|force| (force, most(&|girder| largest_force(history, girder, force))));
        Some(Self { factor, colored: colored.filter(|(_, most)| *most > 0.0) })
    }
}

/// A factor of two digits at most.
fn round_factor(factor: f64) -> f64 {
    let power = 10f64.powf(factor.max(1.0).log10().floor() - 1.0);
    (factor / power).floor().max(1.0) * power
}

/// Times at which a girder is looked at: all over the run, and closely in its hardest hit.
fn spans(history: &History, girder: usize) -> Vec<[f64; 2]> {
    let hit = history.sections().elastic_hit(girder);
    let close = hit.map(|hit| [hit.t, (hit.t + 2.0 * hit.contact_time).min(history.end())]);
    std::iter::once([0.0, history.end()]).chain(close).collect()
}

fn largest_force(history: &History, girder: usize, force: OfSection) -> f64 {
    let of = |span| history.sections().field(girder, force, span, [LOOKS, STATIONS]);
    spans(history, girder).into_iter().filter_map(of).map(|field: SectionField| field.largest()).fold(0.0, f64::max)
}

/// Largest deflection that is drawn larger, over what it is to be drawn as.
fn largest_part(history: &History, girder: usize) -> f64 {
    let Some(length) = history.sections().flexible(girder).map(|flexible| flexible.beam.length) else { return 0.0 };
    let fixed = ends_that_face(history, girder);
    let mut most = 0.0f64;
    for [from, until] in spans(history, girder) {
        for i in 0..LOOKS {
            let t = from + (until - from) * i as f64 / LOOKS as f64;
            let shape = Shape::of(history, girder, fixed, t);
            for k in 0..STATIONS {
                let s = length * (k as f64 / (STATIONS - 1) as f64 - 0.5);
                most = most.max(shape.beyond(history, s).moved.length());
            }
        }
    }
    most / (DRAWN * length)
}

/// Whether each end faces something: −x, +x.
pub(super) fn ends_that_face(history: &History, girder: usize) -> [bool; 2] {
    let faces = |end: End| {
        history
            .model()
            .pairs
            .iter()
            .flat_map(|pair| [pair.first, pair.second])
            .any(|side| side == Side::Girder(girder, end))
    };
    [faces(End::Minus), faces(End::Plus)]
}

/// The deformation of a girder at one time.
pub(super) struct Shape {
    girder: usize,
    t: f64,
    /// Of the girder \[m\].
    pub(super) length: f64,
    /// Motion of the ends.
    ends: [Fields; 2],
    fixed: [bool; 2],
}

impl Shape {
    pub(super) fn of(history: &History, girder: usize, fixed: [bool; 2], t: f64) -> Self {
        let length = history.sections().flexible(girder).map_or(1.0, |flexible| flexible.beam.length);
        let ends = [-0.5, 0.5].map(|part| history.sections().deformation(girder, part * length, t));
        Self { girder, t, length, ends, fixed }
    }

    /// Motion at a station that is not magnified: the rigid motion of the end that faces something; of two such ends, the cubic between
    /// them; of none, zero \[m, rad\].
    fn carried(&self, s: f64) -> Fields {
        let with = |end: Fields, from: f64| Fields { moved: end.displacement(DVec3::X * (s - from)), ..end };
        let half = 0.5 * self.length;
        match self.fixed {
            [false, false] => Fields::default(),
            [true, false] => with(self.ends[0], -half),
            [false, true] => with(self.ends[1], half),
            [true, true] => cubic(self.ends, self.length, s / self.length + 0.5),
        }
    }

    /// Motion at a station that is magnified: the deformation less [`carried`](Self::carried) \[m, rad\].
    fn beyond(&self, history: &History, s: f64) -> Fields {
        history.sections().deformation(self.girder, s, self.t) + self.carried(s) * -1.0
    }

    /// Motion drawn at a station, magnified by `factor` \[m, rad\].
    pub(super) fn drawn(&self, history: &History, s: f64, factor: f64) -> Fields {
        self.carried(s) + self.beyond(history, s) * factor
    }
}

/// u and ψ linear, v and w the cubic of Hermite with the ends' turns `φ_z` and `−φ_y` as slopes, φ its slope; x from 0 to 1.
fn cubic([a, b]: [Fields; 2], length: f64, x: f64) -> Fields {
    let (x2, x3) = (x * x, x * x * x);
    let [[from, slope], [to, slope_to]] =
        [a, b].map(|end| [DVec2::new(end.moved.y, end.moved.z), DVec2::new(end.turned.z, -end.turned.y)]);
    let across = from * (1.0 - 3.0 * x2 + 2.0 * x3)
        + to * (3.0 * x2 - 2.0 * x3)
        + length * (slope * (x - 2.0 * x2 + x3) + slope_to * (x3 - x2));
    let slope = (to - from) * (6.0 * x - 6.0 * x2) / length
        + slope * (1.0 - 4.0 * x + 3.0 * x2)
        + slope_to * (3.0 * x2 - 2.0 * x);
    let linear = |a: f64, b: f64| a + (b - a) * x;
    Fields {
        moved: DVec3::new(linear(a.moved.x, b.moved.x), across.x, across.y),
        turned: DVec3::new(linear(a.turned.x, b.turned.x), -slope.y, slope.x),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cubic_keeps_places_and_turns_of_both_ends() {
        let end = |moved: [f64; 3], turned: [f64; 3]| Fields { moved: moved.into(), turned: turned.into() };
        let ends = [end([0.1, 0.2, -0.3], [0.01, 0.02, 0.03]), end([-0.1, 0.5, 0.1], [0.0, 0.04, -0.02])];
        assert_eq!(cubic(ends, 30.0, 0.0), ends[0]);
        let away = cubic(ends, 30.0, 1.0) + ends[1] * -1.0;
        assert!(away.moved.length() + away.turned.length() < 1e-15);
        let [before, after] = [0.4999, 0.5001].map(|x| cubic(ends, 30.0, x).moved);
        let (slope, turned) = ((after - before) / (30.0 * 0.0002), cubic(ends, 30.0, 0.5).turned);
        assert!((slope.y - turned.z).abs() < 1e-8, "φ_z is the slope of v");
        assert!((slope.z + turned.y).abs() < 1e-8, "φ_y is that of w, downwards");
    }

    #[test]
    fn factors_are_round_and_no_larger_than_asked() {
        assert_eq!([1.0, 9.99, 34.7, 1234.0].map(round_factor), [1.0, 9.9, 34.0, 1200.0]);
    }
}
