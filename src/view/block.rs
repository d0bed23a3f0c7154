//! Bodies as solid blocks in the world: what is drawn, framed and picked.

use glam::DVec3;

use crate::geometry::End;
use crate::scene::{Abutment, Girder, ResolvedPier, Scene, placed};
use crate::sim::Motion;

/// A flat four-sided face swept along a vector: every body of a scene is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// The face, anticlockwise seen from outside \[m\].
    pub face: [DVec3; 4],
    /// From the face to the opposite one \[m\].
    pub sweep: DVec3,
}

impl Block {
    /// The face's corners, then those of the opposite face in the same order \[m\].
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|i| self.face[i % 4] + if i < 4 { DVec3::ZERO } else { self.sweep })
    }

    /// Outward normal (not of unit length) and a point of each of the six sides.
    pub fn sides(&self) -> [(DVec3, DVec3); 6] {
        let [a, b, c, d] = self.face;
        let front = (c - a).cross(d - b);
        std::array::from_fn(|i| match i {
            0 => (front, a),
            1 => (-front, a + self.sweep),
            _ => {
                let (from, to) = (self.face[i - 2], self.face[(i - 1) % 4]);
                (self.sweep.cross(to - from), from)
            }
        })
    }

    /// Distance along a ray to its entry into the block, in lengths of `along`, 0 from inside; `None` where it misses.
    pub fn entry(&self, from: DVec3, along: DVec3) -> Option<f64> {
        let (mut enter, mut leave) = (0.0f64, f64::INFINITY);
        for (normal, point) in self.sides() {
            let (toward, ahead) = (normal.dot(along), normal.dot(point - from));
            if toward == 0.0 {
                if ahead < 0.0 {
                    return None;
                }
            } else if toward < 0.0 {
                enter = enter.max(ahead / toward);
            } else {
                leave = leave.min(ahead / toward);
            }
        }
        (enter <= leave).then_some(enter)
    }

    /// Its twelve edges \[m\].
    pub fn edges(&self) -> [[DVec3; 2]; 12] {
        let p = self.corners();
        std::array::from_fn(|i| match i {
            0..4 => [p[i], p[(i + 1) % 4]],
            4..8 => [p[i], p[4 + (i + 1) % 4]],
            _ => [p[i - 8], p[i - 4]],
        })
    }
}

/// A girder as placed.
pub fn girder_block(girder: &Girder) -> Block {
    let face = placed::end_face(girder, End::Plus);
    Block { face, sweep: -placed::axes(girder).x_axis * girder.length }
}

/// A girder where its motion has brought it.
pub fn moved_girder_block(girder: &Girder, motion: &Motion) -> Block {
    let prism = girder.prism();
    let face = prism.end_face(End::Plus).map(|corner| motion.place + motion.attitude * corner);
    Block { face, sweep: motion.attitude * DVec3::new(-prism.length, 0.0, 0.0) }
}

/// A pier as placed, from its foot to the top of its cap and as wide as that.
pub fn pier_block(pier: &ResolvedPier) -> Block {
    let [length, width, _] = pier.cap;
    let (u, v) = (pier.axes.x_axis * (0.5 * length), pier.axes.y_axis * (0.5 * width));
    let foot = pier.top - DVec3::Z * pier.height;
    // Seen from below, against the clock seen from above.
    Block { face: [foot - u - v, foot - u + v, foot + u + v, foot + u - v], sweep: DVec3::Z * pier.height }
}

/// An abutment's backwall with the block behind its face; `None` while it names no girder.
pub fn abutment_block(scene: &Scene, abutment: &Abutment) -> Option<Block> {
    let face = placed::abutment_face(scene, abutment)?;
    let [a, b, c, d] = face;
    let normal = (c - a).cross(d - b).normalize_or_zero();
    Some(Block { face, sweep: -normal * placed::abutment_depth(scene, abutment) })
}
