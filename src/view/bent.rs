//! Girders that bend, drawn as they are bent, their deformation larger than it is, coloured by a section force.
//!
//! An end that faces something is drawn where it is, so that no gap seems to close that is open: what is drawn larger is the
//! deformation relative to such ends.

use glam::{DVec2, DVec3};

use super::ViewInput;
use super::list::{Line, Rgba, Solid};
use super::palette::{NEGATIVE, NEUTRAL, POSITIVE, Palette, SELECTED};
use crate::geometry::End;
use crate::scene::Girder;
use crate::scene::facing::Side;
use crate::sim::{History, Motion, OfSection, SectionField};

/// Slices that a girder is drawn in.
const SLICES: usize = 48;
/// Largest drawn deflection without a factor that is asked for, in parts of the length.
const DRAWN: f64 = 0.03;
/// Times of a run at which the largest deflection and force are looked for, beside those of the hardest hit.
const LOOKS: usize = 200;
/// Stations at which they are looked for.
const STATIONS: usize = 17;

/// How girders that bend are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// How many times larger than it is the deformation is drawn.
    pub factor: f64,
    /// Section force that colours them, and its value at the ends of the colours, SI.
    pub colored: Option<(OfSection, f64)>,
}

/// How they are asked to be drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bending {
    /// How many times larger than it is; by none, the largest deflection is 3 % of the girder's length.
    pub factor: Option<f64>,
    /// Section force that colours them.
    pub force: Option<OfSection>,
}

impl Bent {
    /// Of a run; without a factor the largest deflection is drawn as 3 % of the girder's length. `None` where no girder bends.
    pub fn of(history: &History, Bending { factor, force }: Bending) -> Option<Self> {
        let girders = (0..history.scene().girders.len()).filter(|&girder| history.flexible(girder).is_some());
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
    let hit = history.elastic_hit(girder);
    let close = hit.map(|hit| [hit.t, (hit.t + 2.0 * hit.contact_time).min(history.end())]);
    std::iter::once([0.0, history.end()]).chain(close).collect()
}

fn largest_force(history: &History, girder: usize, force: OfSection) -> f64 {
    let of = |span| history.section_field(girder, force, span, [LOOKS, STATIONS]);
    spans(history, girder).into_iter().filter_map(of).map(|field: SectionField| field.largest()).fold(0.0, f64::max)
}

/// Largest deflection that is drawn larger, over what it is to be drawn as.
fn largest_part(history: &History, girder: usize) -> f64 {
    let Some(length) = history.flexible(girder).map(|flexible| flexible.beam.length) else { return 0.0 };
    let fixed = ends_that_face(history, girder);
    let mut most = 0.0f64;
    for [from, until] in spans(history, girder) {
        for i in 0..LOOKS {
            let t = from + (until - from) * i as f64 / LOOKS as f64;
            let shape = Shape::of(history, girder, fixed, t);
            for k in 0..STATIONS {
                let s = length * (k as f64 / (STATIONS - 1) as f64 - 0.5);
                most = most.max(shape.beyond(history, s).truncate().length());
            }
        }
    }
    most / (DRAWN * length)
}

/// Which ends face something: −x, +x.
fn ends_that_face(history: &History, girder: usize) -> [bool; 2] {
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
struct Shape {
    girder: usize,
    t: f64,
    length: f64,
    /// u, v, φ of the ends.
    ends: [DVec3; 2],
    fixed: [bool; 2],
}

impl Shape {
    fn of(history: &History, girder: usize, fixed: [bool; 2], t: f64) -> Self {
        let length = history.flexible(girder).map_or(1.0, |flexible| flexible.beam.length);
        let ends = [-0.5, 0.5].map(|part| history.deformation(girder, part * length, t));
        Self { girder, t, length, ends, fixed }
    }

    /// What is not drawn larger at a station: the motion of the end that faces something as a rigid body; of both, the cubic between
    /// them; of none, nothing.
    fn carried(&self, s: f64) -> DVec3 {
        let with = |end: DVec3, from: f64| DVec3::new(end.x, end.y + end.z * (s - from), end.z);
        let half = 0.5 * self.length;
        match self.fixed {
            [false, false] => DVec3::ZERO,
            [true, false] => with(self.ends[0], -half),
            [false, true] => with(self.ends[1], half),
            [true, true] => cubic(self.ends, self.length, s / self.length + 0.5),
        }
    }

    /// What is.
    fn beyond(&self, history: &History, s: f64) -> DVec3 {
        history.deformation(self.girder, s, self.t) - self.carried(s)
    }

    /// What is drawn.
    fn drawn(&self, history: &History, s: f64, factor: f64) -> DVec3 {
        self.carried(s) + factor * self.beyond(history, s)
    }
}

/// u linear, v the cubic of Hermite with the ends' turns as slopes, φ its slope; x from 0 to 1.
fn cubic([a, b]: [DVec3; 2], length: f64, x: f64) -> DVec3 {
    let (x2, x3) = (x * x, x * x * x);
    let v = a.y * (1.0 - 3.0 * x2 + 2.0 * x3)
        + b.y * (3.0 * x2 - 2.0 * x3)
        + length * (a.z * (x - 2.0 * x2 + x3) + b.z * (x3 - x2));
    let slope =
        (b.y - a.y) * (6.0 * x - 6.0 * x2) / length + a.z * (1.0 - 4.0 * x + 3.0 * x2) + b.z * (3.0 * x2 - 2.0 * x);
    DVec3::new(a.x + (b.x - a.x) * x, v, slope)
}

/// A girder in slices: its solids and the lines along its edges; nothing where it is drawn as a block.
pub(super) struct Slices {
    pub(super) solids: Vec<Solid>,
    pub(super) edges: Vec<Line>,
    pub(super) outline: Vec<Line>,
}

/// A girder that bends as `input` asks for it; `None` where it does not, or as placed.
pub(super) fn slices(
    input: &ViewInput<'_>,
    (number, girder, motion): (usize, &Girder, &Motion),
    palette: &Palette,
    selected: bool,
) -> Option<Slices> {
    let (bent, history) = (input.bent?, input.history?);
    let _ = history.flexible(number)?;
    let t = if input.t.is_finite() { input.t.clamp(0.0, history.end()) } else { 0.0 };
    let shape = Shape::of(history, number, ends_that_face(history, number), t);
    let rims: Vec<[DVec3; 2]> = (0..=SLICES)
        .map(|i| {
            let s = shape.length * (i as f64 / SLICES as f64 - 0.5);
            rim(girder, motion, s, shape.drawn(history, s, bent.factor))
        })
        .collect();
    let colors = colors(history, number, (t, shape.length), bent, palette);
    let up = motion.attitude * DVec3::Z * girder.thickness;
    let solid = |(i, ends): (usize, &[[DVec3; 2]])| {
        let [[a, b], [d, c]] = [ends[0], ends[1]];
        // The underside, seen from below.
        let face = [a, b, c, d].map(DVec3::as_vec3);
        Solid { name: girder.name.clone(), face, sweep: up.as_vec3(), color: colors[i] }
    };
    let solids = rims.windows(2).enumerate().map(solid).collect();
    let lines = outline(&rims, up);
    let line = |group, width: f32, color| {
        let width = width * input.pixels_per_point;
        move |[from, to]: &[DVec3; 2]| Line { group, from: from.as_vec3(), to: to.as_vec3(), width, color }
    };
    let edges = lines.iter().map(line("edges", 1.3, palette.edge)).collect();
    let outline = if selected { lines.iter().map(line("selection", 2.6, SELECTED)).collect() } else { Vec::new() };
    Some(Slices { solids, edges, outline })
}

/// The lower corners of a section that is displaced by (u, v, φ): of the −y edge, of the +y edge \[m\].
fn rim(girder: &Girder, motion: &Motion, s: f64, moved: DVec3) -> [DVec3; 2] {
    let prism = girder.prism();
    [-0.5, 0.5].map(|part| {
        let offset = DVec2::new(part * prism.width * prism.shear(), part * prism.width);
        let place = DVec2::new(s, 0.0) + offset + moved.truncate() + offset.perp() * moved.z;
        motion.place + motion.attitude * place.extend(-0.5 * girder.thickness)
    })
}

/// Edges along the girder and around its ends.
fn outline(rims: &[[DVec3; 2]], up: DVec3) -> Vec<[DVec3; 2]> {
    let mut lines = Vec::new();
    for ends in rims.windows(2) {
        for (from, to) in ends[0].into_iter().zip(ends[1]) {
            lines.extend([DVec3::ZERO, up].map(|above| [from + above, to + above]));
        }
    }
    for [a, b] in [rims.first(), rims.last()].into_iter().flatten().copied() {
        lines.extend([[a, b], [a + up, b + up], [a, a + up], [b, b + up]]);
    }
    lines
}

/// Colour of each slice.
fn colors(history: &History, girder: usize, (t, length): (f64, f64), bent: Bent, palette: &Palette) -> Vec<Rgba> {
    let Some(((force, most), equilibrium)) = bent.colored.zip(history.equilibrium(girder, t)) else {
        return vec![palette.girder; SLICES];
    };
    let middle = |i: usize| length * ((i as f64 + 0.5) / SLICES as f64 - 0.5);
    let value = |i: usize| history.of_section(girder, &equilibrium.at(middle(i)), force);
    (0..SLICES).map(|i| of_value(value(i) / most)).collect()
}

/// Colour of a value from −1 to 1.
pub(super) fn of_value(value: f64) -> Rgba {
    let (to, part) = (if value < 0.0 { NEGATIVE } else { POSITIVE }, value.abs().min(1.0));
    let mixed = |i: usize| {
        let [from, to] = [NEUTRAL, to].map(|color| f64::from(color.0[i]));
        #[expect(clippy::cast_sign_loss, reason = "between two bytes")]
        let byte = (from + part * (to - from)).round() as u8;
        byte
    };
    Rgba::rgb(mixed(0), mixed(1), mixed(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cubic_keeps_places_and_turns_of_both_ends() {
        let ends = [DVec3::new(0.1, 0.2, 0.03), DVec3::new(-0.1, 0.5, -0.02)];
        assert_eq!(cubic(ends, 30.0, 0.0), ends[0]);
        assert!((cubic(ends, 30.0, 1.0) - ends[1]).length() < 1e-15);
        let [before, after] = [0.4999, 0.5001].map(|x| cubic(ends, 30.0, x).y);
        assert!(((after - before) / (30.0 * 0.0002) - cubic(ends, 30.0, 0.5).z).abs() < 1e-8, "φ is the slope of v");
    }

    #[test]
    fn factors_are_round_and_no_larger_than_asked() {
        assert_eq!([1.0, 9.99, 34.7, 1234.0].map(round_factor), [1.0, 9.9, 34.0, 1200.0]);
    }

    #[test]
    fn colours_part_at_zero_and_end_at_the_largest() {
        assert_eq!([of_value(-2.0), of_value(0.0), of_value(1.0)], [NEGATIVE, NEUTRAL, POSITIVE]);
    }
}
