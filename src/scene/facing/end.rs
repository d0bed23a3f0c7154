//! Which ends of girders look at each other.

use glam::DVec3;

use super::{LARGEST_TURN_DEG, Walls};
use crate::geometry::End;
use crate::geometry::broad::Broad;
use crate::geometry::shape::AlignedBox;
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
    pub(super) fn of(scene: &Scene, walls: &Walls<'_>, girder: usize, end: End) -> Self {
        let body = &scene.girders[girder];
        let [a, b, c, d] = placed::end_face(body, end);
        let centre = (a + b + c + d) / 4.0;
        let walls = walls.before(girder, end).iter().map(|&n| &scene.abutments[n]);
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

    /// Whether an end at most `longest` long that this one sees can have its centre in a part of space.
    fn may_see(&self, part: &AlignedBox, longest: f64) -> bool {
        let (middle, half) = ((part.min + part.max) / 2.0 - self.centre, (part.max - part.min) / 2.0);
        // How far the part reaches along an axis, to both sides of its middle.
        let along = |axis: DVec3| (middle.dot(axis), half.dot(axis.abs()));
        let (ahead, deep) = along(self.normal);
        let (beside, wide) = along(DVec3::Z.cross(self.normal));
        // A part is not refused by rounding.
        let slack = 2.0 * SAME * (self.length + longest) + 1e-12 * (middle.length() + half.length());
        ahead + deep >= -slack
            && ahead - deep <= self.wall + slack
            && beside.abs() - wide <= f64::midpoint(self.length, longest) + slack
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
pub(super) fn all(scene: &Scene, walls: &Walls<'_>) -> Vec<EndFace> {
    let girders = 0..scene.girders.len();
    girders.flat_map(|n| End::BOTH.map(|end| EndFace::of(scene, walls, n, end))).collect()
}

/// Ends of girders and who they look at, asked through a tree: a row of n costs about n, not n³.
pub(super) struct Lookout<'a> {
    ends: &'a [EndFace],
    tree: Broad,
    /// Distance from each end to the nearest that it sees \[m\].
    nearest: Vec<f64>,
}

impl<'a> Lookout<'a> {
    /// Finds what is nearest to every end.
    pub(super) fn over(ends: &'a [EndFace]) -> Self {
        let tree = Broad::of(ends.iter().map(|end| AlignedBox { min: end.centre, max: end.centre }));
        let longest = ends.iter().fold(0.0f64, |most, end| most.max(end.length));
        let nearest = |from: &EndFace| {
            let seen = |n: usize| (ends[n].girder != from.girder).then(|| from.sees(&ends[n])).flatten();
            tree.least(from.centre, |part| from.may_see(part, longest), seen)
        };
        let nearest = ends.iter().map(nearest).collect();
        Self { ends, tree, nearest }
    }

    /// Ends of later girders that an end pairs up with: each sees the other with nobody nearer to either.
    pub(super) fn partners(&self, number: usize) -> impl Iterator<Item = &'a EndFace> {
        let (ends, here) = (self.ends, &self.ends[number]);
        let reach = DVec3::splat(self.nearest[number] * (1.0 + 2.0 * SAME));
        let mut near = Vec::new();
        if reach.is_finite() {
            self.tree.meeting(&AlignedBox { min: here.centre - reach, max: here.centre + reach }, &mut near);
        }
        near.retain(|&other| here.girder < ends[other].girder && self.pair_up(number, other));
        near.into_iter().map(|other| &ends[other])
    }

    fn pair_up(&self, here: usize, there: usize) -> bool {
        let Some(distance) = self.ends[here].sees(&self.ends[there]) else { return false };
        distance <= self.nearest[here].min(self.nearest[there]) * (1.0 + SAME)
    }
}
