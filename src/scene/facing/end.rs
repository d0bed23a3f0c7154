//! Ends of girders that face each other.

use std::cell::OnceCell;
use std::collections::BTreeMap;

use glam::DVec3;

use crate::geometry::End;
use crate::geometry::broad::{Along, Broad};
use crate::geometry::shape::AlignedBox;
use crate::scene::{Scene, placed};

/// Two ends face each other when their normals are opposed within this angle \[degrees\].
pub const LARGEST_TURN_DEG: f64 = 30.0;

/// Abutments before each end, by number.
pub(super) struct Walls<'a> {
    scene: &'a Scene,
    by_end: BTreeMap<(&'a str, End), Vec<usize>>,
}

impl<'a> Walls<'a> {
    pub(super) fn of(scene: &'a Scene) -> Self {
        let mut by_end: BTreeMap<(&str, End), Vec<usize>> = BTreeMap::new();
        for (n, abutment) in scene.abutments.iter().enumerate() {
            by_end.entry((&abutment.faces, abutment.end)).or_default().push(n);
        }
        Self { scene, by_end }
    }

    /// Abutments before an end, in the order of the file.
    pub(super) fn before(&self, girder: usize, end: End) -> &[usize] {
        self.by_end.get(&(self.scene.girders[girder].name.as_str(), end)).map_or(&[], Vec::as_slice)
    }
}

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
            && beside.abs() - wide <= self.aside(longest, ahead + deep) + slack
    }

    /// Bound on the sideways offset of an end at most `longest` long that is at most `ahead` before this one \[m\]: `|s cos φ ± a sin φ|`
    /// is its offset along a face turned by φ against this one.
    fn aside(&self, longest: f64, ahead: f64) -> f64 {
        let (sin, cos) = LARGEST_TURN_DEG.to_radians().sin_cos();
        (f64::midpoint(self.length, longest) + ahead.max(0.0) * sin) / cos
    }

    /// Bound on the coordinate along a world axis of an end at most `longest` long that faces this one \[m\].
    fn farthest(&self, axis: usize, longest: f64) -> f64 {
        if axis == 2 || self.wall.is_infinite() {
            return f64::INFINITY;
        }
        let slack = SAME * (self.length + longest);
        let beside = self.aside(longest, self.wall.max(slack));
        let [ahead, aside] = [self.normal[axis].abs(), DVec3::Z.cross(self.normal)[axis].abs()];
        (self.wall.max(slack) * ahead + beside * aside) * (1.0 + SAME) + slack
    }

    /// Whether this end and that one look at each other, and how far they are: the same from both.
    fn sees(&self, other: &Self) -> Option<f64> {
        let across = other.centre - self.centre;
        let slack = SAME * (self.length + other.length);
        // An angle that is the largest but for rounding, on either hand.
        let opposed = self.normal.dot(other.normal) <= SAME - LARGEST_TURN_DEG.to_radians().cos();
        let in_front = across.dot(self.normal) >= -slack && across.dot(other.normal) <= slack;
        // Sideways is along either face, in plan.
        let mean = f64::midpoint(self.length, other.length);
        let beside = [self, other].iter().any(|end| across.dot(DVec3::Z.cross(end.normal)).abs() < mean);
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

/// Ends that are tested in order of their distance along one axis before the tree of boxes is used \[–\]. Affects the work alone. Chosen.
const PATIENCE: usize = 64;

/// Ends of girders and the ends that face them, searched along one axis, and by a tree of boxes after [`PATIENCE`] ends: the work for a
/// row of n girders is about n.
pub(super) struct Lookout<'a> {
    ends: &'a [EndFace],
    along: Along,
    tree: OnceCell<Broad>,
    longest: f64,
    /// Distance from each end to the nearest that it sees \[m\].
    nearest: Vec<f64>,
}

impl<'a> Lookout<'a> {
    /// Finds what is nearest to every end.
    pub(super) fn over(ends: &'a [EndFace]) -> Self {
        let along = Along::of(ends.iter().map(|end| end.centre));
        let longest = ends.iter().fold(0.0f64, |most, end| most.max(end.length));
        let mut lookout = Self { ends, along, tree: OnceCell::new(), longest, nearest: Vec::new() };
        lookout.nearest = (0..ends.len()).map(|n| lookout.nearest_of(n)).collect();
        lookout
    }

    fn tree(&self) -> &Broad {
        let boxes = || self.ends.iter().map(|end| AlignedBox { min: end.centre, max: end.centre });
        self.tree.get_or_init(|| Broad::of(boxes()))
    }

    fn nearest_of(&self, number: usize) -> f64 {
        let (ends, from) = (self.ends, &self.ends[number]);
        let seen = |n: usize| (ends[n].girder != from.girder).then(|| from.sees(&ends[n])).flatten();
        let mut best = f64::INFINITY;
        let farthest = from.farthest(self.along.axis, self.longest);
        for (other, far) in self.along.outward(number).take(PATIENCE) {
            if far > best.min(farthest) {
                return best;
            }
            best = seen(other).map_or(best, |distance| best.min(distance));
        }
        if ends.len() <= PATIENCE {
            return best;
        }
        self.tree().least(from.centre, |part| from.may_see(part, self.longest), seen)
    }

    /// Ends of later girders that an end pairs up with: each sees the other with nobody nearer to either.
    pub(super) fn partners(&self, number: usize) -> impl Iterator<Item = &'a EndFace> {
        let (ends, here) = (self.ends, &self.ends[number]);
        let reach = self.nearest[number] * (1.0 + 2.0 * SAME);
        let mut near: Vec<usize> = Vec::new();
        if reach.is_finite() {
            let within = self.along.outward(number).take_while(|(_, far)| *far <= reach);
            near.extend(within.map(|(other, _)| other).take(PATIENCE));
            if near.len() == PATIENCE {
                let reach = DVec3::splat(reach);
                self.tree().meeting(&AlignedBox { min: here.centre - reach, max: here.centre + reach }, &mut near);
            }
        }
        near.retain(|&other| here.girder < ends[other].girder && self.pair_up(number, other));
        near.sort_unstable();
        near.into_iter().map(|other| &ends[other])
    }

    fn pair_up(&self, here: usize, there: usize) -> bool {
        let Some(distance) = self.ends[here].sees(&self.ends[there]) else { return false };
        distance <= self.nearest[here].min(self.nearest[there]) * (1.0 + SAME)
    }
}
