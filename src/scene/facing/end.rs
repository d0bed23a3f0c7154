//! Which ends of girders look at each other.

use glam::DVec3;

use super::LARGEST_TURN_DEG;
use crate::geometry::End;
use crate::scene::{Scene, placed};

/// The end of a girder as placed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EndFace {
    pub(super) girder: usize,
    pub(super) end: End,
    /// Centre of the face, in the world \[m\].
    pub(super) centre: DVec3,
    /// Outward unit normal.
    pub(super) normal: DVec3,
    /// `b0 / sin β` \[m\].
    length: f64,
    /// Lower and upper edge \[m\].
    height: [f64; 2],
    /// Distance from the centre to the nearest abutment that faces this end \[m\].
    wall: f64,
}

/// Distances that differ by less than this part of themselves are the same.
const SAME: f64 = 1e-9;

impl EndFace {
    pub(super) fn of(scene: &Scene, girder: usize, end: End) -> Self {
        let body = &scene.girders[girder];
        let [a, b, c, d] = placed::end_face(body, end);
        let centre = (a + b + c + d) / 4.0;
        let walls = scene.abutments.iter().filter(|w| w.faces == body.name && w.end == end);
        let distances = walls.filter_map(|w| placed::abutment_face(scene, w)).map(|f| {
            let normal = (f[2] - f[0]).cross(f[3] - f[1]).normalize_or_zero();
            (centre - f[0]).dot(normal).abs()
        });
        Self {
            girder,
            end,
            centre,
            normal: (c - a).cross(d - b).normalize_or_zero(),
            length: body.prism().end_length(),
            height: [a.z, d.z],
            wall: distances.fold(f64::INFINITY, f64::min),
        }
    }

    /// Whether this end looks at that one, and how far it is.
    fn sees(&self, other: &Self) -> Option<f64> {
        let across = other.centre - self.centre;
        let slack = SAME * (self.length + other.length);
        let opposed = self.normal.dot(other.normal) <= -LARGEST_TURN_DEG.to_radians().cos();
        let in_front = across.dot(self.normal) >= -slack && across.dot(other.normal) <= slack;
        // Sideways is along the face, in plan.
        let side = DVec3::Z.cross(self.normal);
        let beside = across.dot(side).abs() < f64::midpoint(self.length, other.length);
        let level = self.height[0] < other.height[1] && other.height[0] < self.height[1];
        let free = across.dot(self.normal) < self.wall && -across.dot(other.normal) < other.wall;
        (opposed && in_front && beside && level && free).then(|| across.length())
    }
}

/// Both ends of every girder, in the order of the file.
pub(super) fn all(scene: &Scene) -> Vec<EndFace> {
    let girders = 0..scene.girders.len();
    girders.flat_map(|n| End::BOTH.map(|end| EndFace::of(scene, n, end))).collect()
}

/// Whether two ends face each other with nobody nearer to either.
pub(super) fn pair_up(here: &EndFace, there: &EndFace, all: &[EndFace]) -> bool {
    let Some(distance) = here.sees(there) else { return false };
    let nearest = |from: &EndFace| {
        let others = all.iter().filter(|to| to.girder != from.girder);
        others.filter_map(|to| from.sees(to)).fold(f64::INFINITY, f64::min)
    };
    distance <= nearest(here).min(nearest(there)) * (1.0 + SAME)
}
