//! One of two doors to parry (the other is [`broad`](super::broad)): convex bodies, how far apart they are, and what a
//! ray hits.
//!
//! A body is a prism between two polygons of four corners: a girder, or the block behind an abutment's face.

use glam::{DQuat, DVec2, DVec3};
use parry3d::math::Pose;
use parry3d::query::{self, Ray, RayCast};
use parry3d::shape::{ConvexPolyhedron, SupportMap};

use super::Prism;

/// Where a body stands: its origin in the world, and the turn from its frame to the world's.
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

/// How far apart two parallelograms are along the axis that parts them most, by their sides' normals: negative when they
/// overlap, and then the shortest way out \[m\]. Corners follow one another along the outline.
pub fn plan_separation(one: &[DVec2; 4], other: &[DVec2; 4]) -> f64 {
    let normals = [one, other].into_iter().flat_map(|corners| {
        [corners[1] - corners[0], corners[2] - corners[1]].map(|side| side.perp().normalize_or_zero())
    });
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

/// How far a point is from a convex polygon along the side that parts them most; negative inside, and then the shortest way
/// out \[m\].
pub fn plan_distance(polygon: &[DVec2; 4], point: DVec2) -> f64 {
    let middle = polygon.iter().sum::<DVec2>() / 4.0;
    let beyond = |i: usize| {
        let (from, side) = (polygon[i], polygon[(i + 1) % 4] - polygon[i]);
        // Outside is where the middle is not, whichever way round the corners go.
        -side.perp_dot(point - from) * side.perp_dot(middle - from).signum() / side.length()
    };
    (0..4).map(beyond).fold(f64::NEG_INFINITY, f64::max)
}

/// What two convex polygons share, a convex polygon; empty or without area where they do not overlap.
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

/// A convex body in its own frame.
#[derive(Clone, Debug)]
pub struct Convex(ConvexPolyhedron);

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
        ConvexPolyhedron::from_convex_mesh(corners.to_vec(), &TRIANGLES).map(Self)
    }

    /// How far apart two bodies are along the axis that parts them most: negative when they overlap, and then the
    /// shortest way out; 0 when they touch \[m\].
    ///
    /// Apart, it is at most the true [`distance`](Self::distance). By the separating axes (normals of the sides, and
    /// edges crossed), because parry's EPA answers 0 for aligned overlapping boxes, which every planar scene is full of.
    pub fn separation(&self, stand: Stand, other: &Self, other_stand: Stand) -> f64 {
        let (here, there) = (stand.pose(), other_stand.pose());
        let along = |axis: DVec3| {
            let front = self.0.support_point(&here, axis);
            let back = other.0.support_point(&there, -axis);
            (back - front).dot(axis)
        };
        let axes = self.normals(here).chain(other.normals(there).map(|n| -n)).chain(self.crossed(here, other, there));
        axes.map(along).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Outward normals of the sides, in the world.
    fn normals(&self, pose: Pose) -> impl Iterator<Item = DVec3> {
        self.0.faces().iter().map(move |face| pose.rotation * face.normal)
    }

    /// Unit vectors square to an edge of each body, both ways round.
    fn crossed(&self, here: Pose, other: &Self, there: Pose) -> impl Iterator<Item = DVec3> {
        let edges = self.0.edges().iter().map(move |edge| here.rotation * edge.dir);
        let pairs = edges.flat_map(move |e| other.0.edges().iter().map(move |f| e.cross(there.rotation * f.dir)));
        // Nearly parallel edges add no axis, only a badly rounded one.
        let axes = pairs.filter(|cross| cross.length() > 1e-6).map(|cross| cross / cross.length());
        axes.flat_map(|axis| [axis, -axis])
    }

    /// Shortest distance between two bodies; 0 when they touch or overlap \[m\].
    pub fn distance(&self, stand: Stand, other: &Self, other_stand: Stand) -> f64 {
        query::distance(&stand.pose(), &self.0, &other_stand.pose(), &other.0).map_or(0.0, |found| found.distance)
    }

    /// How far along a ray its first point inside the body lies, in lengths of `direction`; 0 from inside.
    pub fn pick(&self, stand: Stand, origin: DVec3, direction: DVec3) -> Option<f64> {
        if direction.length_squared() == 0.0 {
            return None;
        }
        self.0.cast_ray(&stand.pose(), &Ray::new(origin, direction), f64::INFINITY, true)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};

    use super::*;

    fn girder(length: f64, skew_deg: f64) -> Convex {
        girder_of(&Prism { length, width: 0.4 * length, thickness: 0.1 * length, skew: f64::to_radians(skew_deg) })
    }

    fn girder_of(prism: &Prism) -> Convex {
        Convex::girder(prism).expect("a prism with volume")
    }

    fn at(x: f64) -> Stand {
        Stand { place: DVec3::new(x, 0.0, 0.0), attitude: DQuat::IDENTITY }
    }

    #[test]
    fn aligned_prisms_overlap_by_the_shortest_way_out() {
        // From a millimetre model to a ten kilometre one; in units of its length a girder is 1 × 0.4 × 0.1.
        for length in [1e-3, 0.19, 30.0, 1e4] {
            for skew_deg in [90.0_f64, 60.0, 135.0] {
                let (body, skew) = (girder(length, skew_deg), skew_deg.to_radians());
                for (i, j, k) in grid() {
                    let d = DVec3::new(0.125 * i, 0.05 * j, 0.025 * k) * length;
                    let there = Stand { place: d, attitude: DQuat::IDENTITY };
                    let ends = (d.x * skew.sin() - d.y * skew.cos()).abs() - length * skew.sin();
                    let expected = ends.max(d.y.abs() - 0.4 * length).max(d.z.abs() - 0.1 * length);
                    let found = body.separation(at(0.0), &body, there);
                    // Apart, an edge may part them more than any side does.
                    let off = if expected > 0.0 { expected - found } else { (found - expected).abs() } / length;
                    // 64 roundings of numbers of the size of the length.
                    assert!(off < 64.0 * f64::EPSILON, "{length} m, β {skew_deg}°, at {d}: {found} for {expected}");
                }
            }
        }
    }

    fn grid() -> impl Iterator<Item = (f64, f64, f64)> {
        let range = || (-9..=9).map(f64::from);
        let coarse = || (-3..=3).map(|n| 3.0 * f64::from(n));
        range().flat_map(move |i| coarse().flat_map(move |j| coarse().map(move |k| (i, j, k))))
    }

    #[test]
    fn turned_prisms_are_parted_by_their_edges_too() {
        // Two cubes, edge to edge: the second stands on a corner line, turned 45° about z and then tilted 45°.
        let cube = Convex::girder(&Prism { length: 1.0, width: 1.0, thickness: 1.0, skew: FRAC_PI_2 }).expect("a cube");
        let here = Stand { place: DVec3::ZERO, attitude: DQuat::from_rotation_z(FRAC_PI_4) };
        let tilted = DQuat::from_rotation_y(FRAC_PI_4);
        // The first has an upright edge at x = √½; the second a level one, along y, at −√½ from its centre.
        for gap in [-0.01, 0.0, 0.3] {
            let there = Stand { place: DVec3::new(2.0 * 0.5_f64.sqrt() + gap, 0.0, 0.0), attitude: tilted };
            let off = cube.separation(here, &cube, there) - gap;
            assert!(off.abs() < 16.0 * f64::EPSILON, "edges crossed along x: off by {off:e}");
        }
    }

    fn square(at: DVec2, half: f64, turn: f64) -> [DVec2; 4] {
        let axis = DVec2::from_angle(turn);
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| at + axis.rotate(DVec2::new(x, y) * half))
    }

    #[test]
    fn in_plan_the_axis_that_parts_most_is_a_side_of_either() {
        let here = square(DVec2::ZERO, 1.0, 0.0);
        // Side by side; corner on side, where the turned square's own sides part less; across a corner, by its own sides.
        let cases = [
            (square(DVec2::new(2.3, 0.4), 1.0, 0.0), 0.3),
            (square(DVec2::new(1.9, 0.4), 1.0, 0.0), -0.1),
            (square(DVec2::new(1.0 + 2.0_f64.sqrt() - 0.2, 0.0), 1.0, FRAC_PI_4), -0.2),
            (
                square(DVec2::splat(1.5 + FRAC_PI_4.cos()), 1.0, FRAC_PI_4),
                2.0_f64.sqrt() * (1.5 + FRAC_PI_4.cos()) - 1.0 - 2.0_f64.sqrt(),
            ),
        ];
        for (i, (there, expected)) in cases.into_iter().enumerate() {
            for found in [plan_separation(&here, &there), plan_separation(&there, &here)] {
                assert!((found - expected).abs() < 1e-14, "case {i}: {found} for {expected}");
            }
        }
    }

    #[test]
    fn a_point_is_as_far_in_as_its_nearest_side() {
        let mut square = square(DVec2::new(1.0, 0.0), 1.0, FRAC_PI_4);
        for _ in 0..2 {
            assert!((plan_distance(&square, DVec2::new(1.0, 0.0)) + 1.0).abs() < 1e-15, "the middle");
            // The corner at x = 1 − √2 stands apart along either of its sides.
            let found = plan_distance(&square, DVec2::new(1.0 - 2.0 * SQRT_2, 0.0));
            assert!((found - 1.0).abs() < 1e-14, "before a corner: {found}");
            square.reverse();
        }
    }

    #[test]
    fn the_centre_of_what_is_shared_is_that_of_the_polygon() {
        let here = square(DVec2::ZERO, 1.0, 0.0);
        let strip = common_centre(&here, &square(DVec2::new(1.5, 0.5), 1.0, 0.0)).expect("they overlap");
        assert!(strip.distance(DVec2::new(0.75, 0.25)) < 1e-15, "{strip}");
        // A corner enters a side: a triangle of height 0.3, its centroid a third of it behind the side.
        let corner = square(DVec2::new(1.0 + 2.0_f64.sqrt() - 0.3, 0.0), 1.0, FRAC_PI_4);
        for (a, b) in [(here, corner), (corner, here)] {
            let centre = common_centre(&a, &b).expect("they overlap");
            assert!(centre.distance(DVec2::new(0.9, 0.0)) < 1e-14, "{centre}");
        }
        let turned_round = [corner[3], corner[2], corner[1], corner[0]];
        assert!(common_centre(&here, &turned_round).is_some_and(|c| c.distance(DVec2::new(0.9, 0.0)) < 1e-14));
        assert_eq!(common_centre(&here, &square(DVec2::splat(3.0), 0.5, 0.0)), None, "apart");
    }

    #[test]
    fn distance_is_the_gap_square_to_the_face() {
        let body = girder(30.0, 60.0);
        let square = 0.5 * 60.0_f64.to_radians().sin();
        let found = body.distance(at(0.0), &body, at(30.5));
        // What parry's GJK leaves over.
        assert!((found - square).abs() < 1e-11 * 30.0, "{found} for {square}");
    }

    #[test]
    fn prisms_apart_along_a_side_are_told_without_building_them() {
        for skew_deg in [90.0, 60.0, 135.0] {
            let prism = Prism { length: 30.0, width: 10.0, thickness: 2.0, skew: f64::to_radians(skew_deg) };
            let (body, corners) = (girder_of(&prism), prism.corners());
            for (i, j, k) in grid() {
                let shift = DVec3::new(4.0 * i, 1.5 * j, 0.3 * k);
                let found = stand_apart(&corners, &corners.map(|corner| corner + shift));
                let there = Stand { place: shift, attitude: DQuat::IDENTITY };
                let apart = body.separation(at(0.0), &body, there);
                // Prisms alike part along a side, never across two edges only; what touches may go either way.
                assert!(found == (apart > 0.0) || apart.abs() < 1e-12, "β {skew_deg}°, at {shift}: {apart}");
            }
        }
    }

    #[test]
    fn a_block_lies_behind_its_face() {
        // From y to z is anticlockwise seen from +x; this one goes from z to y.
        let face = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)].map(|(z, y)| DVec3::new(3.0, y, z));
        let found = AlignedBox::around(&block_behind(face, 0.5));
        assert_eq!((found.min.x, found.max.x), (3.0, 3.5), "behind is away from the side it is seen from");
    }

    #[test]
    fn a_ray_is_stopped_by_the_side_it_meets_first() {
        let body = girder(2.0, 90.0);
        let up = body.pick(at(0.0), DVec3::new(0.3, 0.1, 5.0), DVec3::NEG_Z).expect("it points down at the deck");
        assert!((up - 4.9).abs() < 1e-9, "the top lies at 0.1 m: {up}");
        assert_eq!(body.pick(at(0.0), DVec3::new(0.3, 0.1, 5.0), DVec3::Z), None, "it points away");
        assert_eq!(body.pick(at(0.0), DVec3::ZERO, DVec3::ZERO), None, "a ray without direction hits nothing");
    }
}
