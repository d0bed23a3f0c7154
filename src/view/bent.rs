//! Girders that bend, drawn in slices as they are bent, coloured by a section force.

use glam::DVec3;

use super::ViewInput;
use super::bending::{Bent, Shape, ends_that_face};
use super::list::{Line, Rgba, Solid};
use super::palette::{Palette, SELECTED};
use crate::dynamics::elastic::Fields;
use crate::plot::Colors;
use crate::plot::color_map::level;
use crate::scene::Girder;
use crate::sim::{History, Motion};

/// Slices that a girder is drawn in.
const SLICES: usize = 48;

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
    let _ = history.sections().flexible(number)?;
    let t = if input.t.is_finite() { input.t.clamp(0.0, history.end()) } else { 0.0 };
    let shape = Shape::of(history, number, ends_that_face(history, number), t);
    let rims: Vec<Rim> = (0..=SLICES)
        .map(|i| {
            let s = shape.length * (i as f64 / SLICES as f64 - 0.5);
            Rim::of(girder, motion, s, shape.drawn(history, s, bent.factor))
        })
        .collect();
    let colors = colors(history, number, (t, shape.length), bent, palette);
    let solid = |(i, ends): (usize, &[Rim])| {
        let [[a, b], [d, c]] = [ends[0].lower, ends[1].lower];
        let up = ends[0].up.midpoint(ends[1].up);
        // The underside, seen from below.
        let face = [a, b, c, d].map(DVec3::as_vec3);
        Solid { name: girder.name.clone(), face, sweep: up.as_vec3(), color: colors[i] }
    };
    let solids = rims.windows(2).enumerate().map(solid).collect();
    let lines = outline(&rims);
    let line = |group, width: f32, color| {
        let width = width * input.pixels_per_point;
        move |[from, to]: &[DVec3; 2]| Line { group, from: from.as_vec3(), to: to.as_vec3(), width, color }
    };
    let edges = lines.iter().map(line("edges", 1.3, palette.edge)).collect();
    let outline = if selected { lines.iter().map(line("selection", 2.6, SELECTED)).collect() } else { Vec::new() };
    Some(Slices { solids, edges, outline })
}

/// A section as it is drawn.
#[derive(Clone, Copy)]
struct Rim {
    /// Lower corners, of the −y edge, of the +y edge \[m\].
    lower: [DVec3; 2],
    /// From these to the upper ones \[m\].
    up: DVec3,
}

impl Rim {
    /// The section at s, moved.
    fn of(girder: &Girder, motion: &Motion, s: f64, moved: Fields) -> Self {
        let prism = girder.prism();
        let lower = [-0.5, 0.5].map(|part| {
            let across = part * prism.width;
            let offset = DVec3::new(across * prism.shear(), across, -0.5 * girder.thickness);
            motion.place + motion.attitude * (DVec3::X * s + offset + moved.displacement(offset))
        });
        let up = DVec3::Z * girder.thickness;
        Self { lower, up: motion.attitude * (up + moved.turned.cross(up)) }
    }
}

/// Edges along the girder and around its ends.
fn outline(rims: &[Rim]) -> Vec<[DVec3; 2]> {
    let mut lines = Vec::new();
    for ends in rims.windows(2) {
        let [near, far] = [ends[0], ends[1]];
        for (from, to) in near.lower.into_iter().zip(far.lower) {
            lines.extend([[from, to], [from + near.up, to + far.up]]);
        }
    }
    for Rim { lower: [a, b], up } in [rims.first(), rims.last()].into_iter().flatten().copied() {
        lines.extend([[a, b], [a + up, b + up], [a, a + up], [b, b + up]]);
    }
    lines
}

/// Colour of each slice.
fn colors(history: &History, girder: usize, (t, length): (f64, f64), bent: Bent, palette: &Palette) -> Vec<Rgba> {
    let Some(((force, most), equilibrium)) = bent.colored.zip(history.sections().equilibrium(girder, t)) else {
        return vec![palette.girder; SLICES];
    };
    let middle = |i: usize| length * ((i as f64 + 0.5) / SLICES as f64 - 0.5);
    let value = |i: usize| history.sections().component(girder, &equilibrium.at(middle(i)), force);
    (0..SLICES).map(|i| of_value(force.is_signed(), value(i) / most)).collect()
}

/// Colour of a value in parts of the largest: from −1 of values of both signs, from 0 of others, to 1, as in a chart over time and station.
pub(super) fn of_value(signed: bool, value: f64) -> Rgba {
    let low = if signed { -1.0 } else { 0.0 };
    let [r, g, b] = Colors::of_signed(signed).rgb(level(value, [low, 1.0]));
    Rgba::rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_part_at_zero_and_end_at_the_largest() {
        let [least, none, most] = [-2.0, 0.0, 1.0].map(|value| of_value(true, value).0.map(i32::from));
        assert_eq!([least, most], [-1.0, 2.0].map(|value| of_value(true, value).0.map(i32::from)), "held at the ends");
        assert!(least[0] > least[1] && most[1] > most[0], "purple below, green above: {least:?} {most:?}");
        assert!(none[..3].iter().all(|channel| *channel > 0xf0), "light in the middle: {none:?}");
    }
}
