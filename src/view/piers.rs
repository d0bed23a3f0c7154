//! Piers: footings, columns and cap beams, and abutments that reach the ground, as a viaduct has them.

use std::f64::consts::TAU;

use glam::{DMat3, DVec2, DVec3};

use super::block::Block;
use crate::scene::{PerDirection, ResolvedPier, Scene};
use crate::sim::History;

/// Sides of a round column as drawn; even.
const SIDES: usize = 16;
/// Height of a bearing between deck and cap, in deck depths.
const PAD: f64 = 0.16;
/// Height of a footing in cap depths, and its sides in those of the column.
const FOOTING: [f64; 2] = [0.5, 1.7];

/// A pier at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pier {
    /// Sizes and stiffness.
    pub resolved: ResolvedPier,
    /// Displacement of its cap \[m\].
    pub displacement: DVec3,
    /// Displacement of its foot \[m\].
    pub foot: DVec3,
    /// Rotation of its cap in plan \[rad\].
    pub theta: f64,
    /// Height of a bearing on it \[m\].
    pad: f64,
}

/// The piers of a scene, as placed or at `t` of a run.
pub(super) fn at(scene: &Scene, run: Option<(&History, f64)>) -> Vec<Pier> {
    let pier = |number: usize| {
        let now = run.and_then(|(history, t)| history.connections().pier(number, t));
        let [displacement, foot] = now.map_or([DVec3::ZERO; 2], |now| [now.place, now.place - now.displacement]);
        let theta = now.map_or(0.0, |now| now.theta);
        Pier { resolved: scene.pier(number), displacement, foot, theta, pad: pad(scene) }
    };
    (0..scene.piers.len()).map(pier).collect()
}

/// Height of a bearing: that of the thinnest deck's.
pub(super) fn pad(scene: &Scene) -> f64 {
    let thinnest = scene.girders.iter().map(|girder| girder.thickness).fold(f64::INFINITY, f64::min);
    if thinnest.is_finite() { PAD * thinnest } else { 0.0 }
}

/// Height of the foot of a pier \[m\].
pub(super) fn foot(pier: &ResolvedPier) -> f64 {
    pier.top.z - pier.height
}

impl Pier {
    /// Its cap.
    pub(super) fn cap(&self) -> Block {
        let [length, width, depth] = self.resolved.cap;
        let axes = DMat3::from_rotation_z(self.theta) * self.resolved.axes;
        let top = self.resolved.top + self.displacement - DVec3::Z * self.pad;
        upright([length, width], top - DVec3::Z * depth, axes, depth)
    }

    /// Position of a place in the world as placed after its cap has moved \[m\].
    pub(super) fn moved(&self, place: DVec3) -> DVec3 {
        let home = self.resolved.top;
        home + self.displacement + DMat3::from_rotation_z(self.theta) * (place - home)
    }

    /// Footings under its columns.
    pub(super) fn footings(&self) -> Vec<Block> {
        let sides = self.column_sides().map(|side| FOOTING[1] * side);
        let height = (FOOTING[0] * self.resolved.cap[2]).min(0.2 * self.resolved.height);
        self.places().map(|place| upright(sides, place + self.foot, self.resolved.axes, height)).collect()
    }

    /// Strips that together are its columns, and their outlines at the foot and under the cap.
    pub(super) fn columns(&self) -> (Vec<Block>, Vec<[DVec3; 2]>) {
        let outline: Vec<DVec2> = match self.resolved.column {
            PerDirection::Both(diameter) => {
                let corner = |i: usize| DVec2::from_angle(TAU * (i as f64 + 0.5) / SIDES as f64) * (0.5 * diameter);
                (0..SIDES).map(corner).collect()
            }
            PerDirection::Each([along, across]) => [[0.5, 0.5], [-0.5, 0.5], [-0.5, -0.5], [0.5, -0.5]]
                .map(|[a, b]| DVec2::new(a * along, b * across))
                .into(),
        };
        let (mut strips, mut lines) = (Vec::new(), Vec::new());
        let under_cap = self.resolved.top.z - self.pad - self.resolved.cap[2];
        for place in self.places() {
            let top = self.moved(place).with_z(under_cap);
            let place = place + self.foot;
            let corners: Vec<DVec3> =
                outline.iter().map(|corner| place + self.resolved.axes * corner.extend(0.0)).collect();
            strips.extend(parted(&corners, top - place));
            let round = (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]]);
            lines.extend(round.clone().chain(round.map(|edge| edge.map(|end| end + top - place))));
            if corners.len() == 4 {
                lines.extend(corners.iter().map(|corner| [*corner, *corner + top - place]));
            }
        }
        (strips, lines)
    }

    fn column_sides(&self) -> [f64; 2] {
        self.resolved.column.xy()
    }

    /// Middles of its columns' feet, evenly across below the cap.
    fn places(&self) -> impl Iterator<Item = DVec3> + '_ {
        let count = self.resolved.columns.max(1);
        let spacing = self.resolved.cap[1] / count as f64;
        let foot = self.resolved.top.with_z(foot(&self.resolved));
        (0..count).map(move |i| {
            let across = (i as f64 - 0.5 * (count as f64 - 1.0)) * spacing;
            foot + self.resolved.axes.y_axis * across
        })
    }
}

/// An upright block over a rectangle whose sides are along `axes`, from the middle of its underside.
fn upright(sides: [f64; 2], foot: DVec3, axes: DMat3, height: f64) -> Block {
    let (u, v) = (axes.x_axis * (0.5 * sides[0]), axes.y_axis * (0.5 * sides[1]));
    // Seen from below, against the clock seen from above.
    Block { face: [foot - u - v, foot - u + v, foot + u + v, foot + u - v], sweep: DVec3::Z * height }
}

/// Blocks over a convex polygon of an even number of corners, anticlockwise seen from above: strips between opposite edges.
fn parted(corners: &[DVec3], sweep: DVec3) -> Vec<Block> {
    let count = corners.len();
    let strip =
        |i: usize| Block { face: [corners[i], corners[count - 1 - i], corners[count - 2 - i], corners[i + 1]], sweep };
    (0..count / 2 - 1).map(strip).collect()
}

/// An abutment's block reaching down to the ground, as one does at the end of a viaduct.
pub(super) fn to_the_ground(block: &Block, level: f64) -> Block {
    let low = block.face.iter().map(|corner| corner.z).fold(f64::INFINITY, f64::min);
    let face = block.face.map(|corner| if corner.z <= low { corner.with_z(corner.z.min(level)) } else { corner });
    Block { face, ..*block }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strips_of_a_column_have_its_area_and_look_down() {
        let corners: Vec<DVec3> =
            (0..SIDES).map(|i| DVec2::from_angle(TAU * i as f64 / SIDES as f64).extend(0.0)).collect();
        let strips = parted(&corners, DVec3::Z * 3.0);
        assert_eq!(strips.len(), SIDES / 2 - 1);
        let area = |block: &Block| {
            let [a, b, c, d] = block.face;
            0.5 * (c - a).cross(d - b).z
        };
        assert!(strips.iter().all(|strip| area(strip) < 0.0), "against the clock seen from below");
        let whole: f64 = strips.iter().map(|strip| -area(strip)).sum();
        let polygon = 0.5 * SIDES as f64 * (TAU / SIDES as f64).sin();
        assert!((whole - polygon).abs() < 1e-12, "{whole} against {polygon}");
    }

    #[test]
    fn an_abutment_reaches_down_to_the_ground() {
        let face = [[0.0, -1.0, 2.0], [0.0, 1.0, 2.0], [0.0, 1.0, 4.0], [0.0, -1.0, 4.0]].map(DVec3::from);
        let block = to_the_ground(&Block { face, sweep: DVec3::X }, -5.0);
        assert_eq!([block.face[0].z, block.face[2].z], [-5.0, 4.0]);
    }
}
