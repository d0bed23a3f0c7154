//! Girders that bend, drawn in slices as they are bent, coloured by a section force.

use glam::{DVec2, DVec3};

use super::ViewInput;
use super::bending::{Bent, Shape, ends_that_face};
use super::list::{Line, Rgba, Solid};
use super::palette::{NEGATIVE, NEUTRAL, POSITIVE, Palette, SELECTED};
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
    fn colours_part_at_zero_and_end_at_the_largest() {
        assert_eq!([of_value(-2.0), of_value(0.0), of_value(1.0)], [NEGATIVE, NEUTRAL, POSITIVE]);
    }
}
