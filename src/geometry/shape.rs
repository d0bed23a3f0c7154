//! One of two doors to parry (the other is [`broad`](super::broad)): convex bodies, how far apart they are, and what a
//! ray hits.
//!
//! A body is a prism between two polygons of four corners: a girder, or the block behind an abutment's face.

use glam::{DQuat, DVec2, DVec3};
use parry3d::math::Pose;
use parry3d::query::{self, Ray, RayCast};
use parry3d::shape::ConvexPolyhedron;

use super::Prism;

/// Sine of the angle of two edges below which their cross product is no axis \[–\]. Chosen: of unit vectors that round by 2e-16 its direction
/// then errs by 2e-10.
const NEARLY_PARALLEL: f64 = 1e-6;

/// Pose of a body: its origin in the world, and the rotation from its frame to the world's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Origin of the body's frame \[m\].
    pub place: DVec3,
    /// Body to world.
    pub attitude: DQuat,
}

impl Stand {
    /// The body's frame is the world's.
    pub const WORLD: Self = Self { place: DVec3::ZERO, attitude: DQuat::IDENTITY };

    fn pose(self) -> Pose {
        Pose::from_parts(self.place, self.attitude)
    }
}

/// A box with its sides along the axes: lowest and highest corner \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlignedBox {
    /// Lowest corner.
    pub min: DVec3,
    /// Highest corner.
    pub max: DVec3,
}

impl AlignedBox {
    /// The smallest around some points.
    pub fn around(points: &[DVec3]) -> Self {
        Self::around_all(points.iter().copied())
    }

    /// The same.
    pub fn around_all(points: impl Iterator<Item = DVec3>) -> Self {
        let none = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
        points.fold(none, |hull, p| Self { min: hull.min.min(p), max: hull.max.max(p) })
    }
}

/// Corners of the block that reaches `depth` behind a flat face, anticlockwise seen from outside: back, then face.
pub fn block_behind(face: [DVec3; 4], depth: f64) -> [DVec3; 8] {
    let [a, b, c, d] = face;
    let back = (c - a).cross(d - b).normalize_or_zero() * depth;
    [a - back, b - back, c - back, d - back, a, b, c, d]
}

/// Distance of two convex quadrilaterals along the axis that parts them most, by their sides' normals; negative when they overlap, and then
/// the shortest way out \[m\]. Corners follow one another along the outline.
pub fn plan_separation(one: &[DVec2; 4], other: &[DVec2; 4]) -> f64 {
    let normals = [one, other]
        .into_iter()
        .flat_map(|corners| (0..4).map(|i| (corners[(i + 1) % 4] - corners[i]).perp().normalize_or_zero()));
    let range = |corners: &[DVec2; 4], normal: DVec2| {
        let along = corners.map(|corner| corner.dot(normal));
        along.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], s| [low.min(s), high.max(s)])
    };
    normals
        .map(|normal| {
            let [[low, high], [lowest, highest]] = [range(one, normal), range(other, normal)];
            (lowest - high).max(low - highest)
        })
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Distance of a point from a convex polygon along the side that parts them most; negative inside, and then the shortest way out \[m\].
pub fn plan_distance(polygon: &[DVec2; 4], point: DVec2) -> f64 {
    let middle = polygon.iter().sum::<DVec2>() / 4.0;
    let beyond = |i: usize| {
        let (from, side) = (polygon[i], polygon[(i + 1) % 4] - polygon[i]);
        // Outside is where the middle is not, whichever way round the corners go.
        -side.perp_dot(point - from) * side.perp_dot(middle - from).signum() / side.length()
    };
    (0..4).map(beyond).fold(f64::NEG_INFINITY, f64::max)
}

/// Intersection of two convex polygons, a convex polygon; empty or without area where they do not overlap.
pub fn common_area(one: &[DVec2; 4], other: &[DVec2; 4]) -> Vec<DVec2> {
    let middle = other.iter().sum::<DVec2>() / 4.0;
    (0..4).fold(one.to_vec(), |shared, i| {
        let (from, side) = (other[i], other[(i + 1) % 4] - other[i]);
        // Inside is where the middle is, whichever way round the corners go.
        let inwards = side.perp() * side.perp_dot(middle - from).signum();
        clipped(&shared, |point| inwards.dot(point - from))
    })
}

/// Centroid of what two convex polygons share; `None` where they share no area.
pub fn common_centre(one: &[DVec2; 4], other: &[DVec2; 4]) -> Option<DVec2> {
    let shared = common_area(one, other);
    let first = *shared.first()?;
    let (mut area, mut moment) = (0.0, DVec2::ZERO);
    for two in shared.windows(2).skip(1) {
        let twice = (two[0] - first).perp_dot(two[1] - first);
        area += twice;
        moment += twice * ((two[0] - first) + (two[1] - first)) / 3.0;
    }
    (area != 0.0).then(|| first + moment / area)
}

/// The part of a convex polygon where `inside` is not negative, `inside` being linear (Sutherland and Hodgman).
fn clipped(polygon: &[DVec2], inside: impl Fn(DVec2) -> f64) -> Vec<DVec2> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, &here) in polygon.iter().enumerate() {
        let next = polygon[(i + 1) % polygon.len()];
        let [a, b] = [inside(here), inside(next)];
        if a >= 0.0 {
            kept.push(here);
        }
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            kept.push(here + (next - here) * (a / (a - b)));
        }
    }
    kept
}

/// Whether all of one prism lies in front of a side of the other; where not, they may still stand apart.
pub fn stand_apart(one: &[DVec3; 8], other: &[DVec3; 8]) -> bool {
    let beyond_a_side = |body: &[DVec3; 8], other: &[DVec3; 8]| {
        SIDES.iter().any(|&[a, b, c]| {
            let normal = (body[b] - body[a]).cross(body[c] - body[a]);
            let level = normal.dot(body[a]);
            other.iter().all(|corner| normal.dot(*corner) > level)
        })
    };
    beyond_a_side(one, other) || beyond_a_side(other, one)
}

/// Three corners of each side of a prism, anticlockwise seen from outside.
const SIDES: [[usize; 3]; 6] = [[0, 2, 1], [4, 5, 6], [0, 1, 5], [1, 2, 6], [2, 3, 7], [3, 0, 4]];

/// Sine of the angle up to which two directions of a body are one \[–\]: round-off.
const PARALLEL: f64 = 1e-9;

/// A convex body in its own frame.
#[derive(Clone, Debug)]
pub struct Convex {
    hull: ConvexPolyhedron,
    prism: Hexahedron,
}

/// The corners of a body between two polygons, with the axes that can part it from another.
#[derive(Clone, Debug)]
pub struct Hexahedron {
    corners: [DVec3; 8],
    /// Unit normals of the sides and unit vectors along the edges; of parallel ones the first.
    normals: Vec<DVec3>,
    edges: Vec<DVec3>,
}

/// Edges of a prism by their corners: around the first polygon, around the second, and between the two.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Unit vectors along these; of parallel ones the first.
fn directions<const N: usize>(vectors: [DVec3; N]) -> Vec<DVec3> {
    let mut all: Vec<DVec3> = Vec::new();
    for vector in vectors {
        let unit = vector.normalize_or_zero();
        if all.iter().all(|known| known.cross(unit).length() > PARALLEL) {
            all.push(unit);
        }
    }
    all
}

/// Triangles over the corners of a prism: the first four corners seen from inside, the last four from outside, sides.
const TRIANGLES: [[u32; 3]; 12] = [
    [0, 2, 1],
    [0, 3, 2],
    [4, 5, 6],
    [4, 6, 7],
    [0, 1, 5],
    [0, 5, 4],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 7],
    [2, 7, 6],
    [3, 0, 4],
    [3, 4, 7],
];

impl Convex {
    /// A girder, in its own frame; `None` when it has no volume to speak of.
    pub fn girder(prism: &Prism) -> Option<Self> {
        Self::between(prism.corners())
    }

    /// The block that reaches `depth` behind a flat face, anticlockwise seen from outside; in the frame of the face.
    pub fn behind(face: [DVec3; 4], depth: f64) -> Option<Self> {
        Self::between(block_behind(face, depth))
    }

    /// The prism between two polygons, both anticlockwise seen from the side of the second; `None` when it has no volume
    /// to speak of.
    pub fn between(corners: [DVec3; 8]) -> Option<Self> {
        let hull = ConvexPolyhedron::from_convex_mesh(corners.to_vec(), &TRIANGLES)?;
        Some(Self { hull, prism: Hexahedron::between(corners) })
    }

    /// [`Hexahedron::separation`].
    pub fn separation(&self, stand: Stand, other: &Self, other_stand: Stand) -> f64 {
        self.prism.separation(stand, &other.prism, other_stand)
    }

    /// Its corners and axes.
    pub fn prism(&self) -> &Hexahedron {
        &self.prism
    }

    /// Shortest distance between two bodies; 0 when they touch or overlap \[m\].
    pub fn distance(&self, stand: Stand, other: &Self, other_stand: Stand) -> f64 {
        query::distance(&stand.pose(), &self.hull, &other_stand.pose(), &other.hull).map_or(0.0, |found| found.distance)
    }

    /// Distance along a ray to its first point inside the body, in lengths of `direction` \[–\]; 0 from inside.
    pub fn pick(&self, stand: Stand, origin: DVec3, direction: DVec3) -> Option<f64> {
        if direction.length_squared() == 0.0 {
            return None;
        }
        self.hull.cast_ray(&stand.pose(), &Ray::new(origin, direction), f64::INFINITY, true)
    }
}

impl Hexahedron {
    /// Between two polygons, both anticlockwise seen from the side of the second. Of a side that is not flat the axis is normal to three
    /// of its corners.
    pub fn between(corners: [DVec3; 8]) -> Self {
        let normals = SIDES.map(|[a, b, c]| (corners[b] - corners[a]).cross(corners[c] - corners[a]));
        let edges = EDGES.map(|[from, to]| corners[to] - corners[from]);
        Self { corners, normals: directions(normals), edges: directions(edges) }
    }

    /// Distance of two bodies along the axis that parts them most; negative when they overlap, and then the shortest way out; 0 when they
    /// touch \[m\].
    ///
    /// Apart, it is at most the true [`distance`](Convex::distance). By the separating axes (normals of the sides, and
    /// edges crossed), because parry's EPA answers 0 for aligned overlapping boxes, which every planar scene is full of.
    pub fn separation(&self, stand: Stand, other: &Self, other_stand: Stand) -> f64 {
        // About the other's origin: places round with the distance of the two, not with that from the world's origin.
        let here = self.corners.map(|corner| stand.place - other_stand.place + stand.attitude * corner);
        let there = other.corners.map(|corner| other_stand.attitude * corner);
        let range = |corners: &[DVec3; 8], axis: DVec3| {
            corners
                .iter()
                .map(|corner| corner.dot(axis))
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], s| [low.min(s), high.max(s)])
        };
        let along = |axis: DVec3| {
            let ([low, high], [lowest, highest]) = (range(&here, axis), range(&there, axis));
            (lowest - high).max(low - highest)
        };
        let turned = |directions: &[DVec3], stand: Stand| -> Vec<DVec3> {
            directions.iter().map(|&direction| stand.attitude * direction).collect()
        };
        let (own, others) = (turned(&self.edges, stand), turned(&other.edges, other_stand));
        let crossed = own.iter().flat_map(|e| others.iter().map(move |f| e.cross(*f)));
        // Nearly parallel edges add no axis, only a badly rounded one.
        let crossed = crossed.filter(|cross| cross.length() > NEARLY_PARALLEL).map(|cross| cross / cross.length());
        let normals = turned(&self.normals, stand).into_iter().chain(turned(&other.normals, other_stand));
        normals.chain(crossed).map(along).fold(f64::NEG_INFINITY, f64::max)
    }
}

#[cfg(test)]
mod tests;
