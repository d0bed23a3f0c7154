//! Contact of two edges: an edge of one face across a side of the facing one, with the normal along the common
//! perpendicular of both (`docs/physics.md#edge-nodes`).
//!
//! Both ends of the edge are measured as nodes against the face: gap `g` and distance `d` of the projection from the
//! side, positive inwards. The projections cross at the part `s = d₀/(d₀ − d₁)` of the edge, and the gap there is
//! `(1 − s) g₀ + s g₁`. Times `|d₁ − d₀|/L`, with `L` the length of the edge, it is
//!
//! ```text
//! f = ±(g₀ d₁ − g₁ d₀)/L
//! ```
//!
//! with the sign of `d₁ − d₀`. Its zeros are those of the distance of the two lines, and its second derivative is
//! bounded by those of the four distances.

use glam::{DMat3, DVec2, DVec3};

use crate::contact::parameters::edge_slack;
use crate::contact::{Frame, Home, Local, locate};
use crate::geometry::Face;

/// Least sine of the angle between an edge and a side that it crosses \[–\]: 30°. Edges closer to parallel
/// cross anywhere along their length at the least roll, and bound a sliver only.
const LEAST_SINE: f64 = 0.5;

/// Least cosine of the angle between the common perpendicular and the normal of either face \[–\]: 45°. Edges with another one
/// belong to faces beside these, as those of two level tops that cross in plan.
const ALONG: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Distance of an edge node from the crossing, per size of the face, at which it is moved to the crossing \[–\]: the
/// lever of its force is wrong by less. Tuned.
const SLIDE: f64 = 1e-3;

/// Where the node of a contact is and how its contact is directed, axes of the bodies as placed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NodePlace {
    /// Node from that of its site, of an edge node the middle of the edge \[m\].
    pub shift: DVec3,
    /// Unit normal of an edge node's contact, outward of the face's body; 0 for a corner, whose normal is the face's.
    pub normal: DVec3,
    /// How far the node may be beyond an end of the side: faces that are not parallel see a crossing beside the place where
    /// its edges are nearest \[m\].
    pub overhang: f64,
}

/// An edge of one face and a side of the facing one that stands across it.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Both ends of the edge against the face, as placed.
    ends: [Home; 2],
    /// From the first end to the second as placed, world axes \[m\].
    span: DVec3,
    /// Outward unit normal of the face that the edge bounds, as placed.
    outward: DVec3,
    /// Both ends in the coordinates of the face that the edge bounds \[m\].
    own: [DVec2; 2],
    /// First corner of the side, in the face's coordinates \[m\].
    from: DVec2,
    /// Unit vector along the side, the face on its left.
    side: DVec2,
    /// Length of the side \[m\].
    length: f64,
    /// Distance up to which a crossing beyond an end counts as on the edge or on the side \[m\].
    tolerance: f64,
    /// Distance of the node from the crossing at which it is moved \[m\].
    slide: f64,
    /// Distance as placed, along the face, by which the edge is on one side of the side's line or beyond one of its ends;
    /// negative where they cross \[m\].
    clear: f64,
    /// Sine of the angle between edge and side as placed \[–\].
    sine: f64,
    /// Whether the side, an edge of the other body, has a node at the crossing as well.
    shared: bool,
}

/// Both ends of an edge relative to the face.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct EdgeEnds {
    ends: [Local; 2],
    /// Distances of the projections from the side, positive inwards \[m\].
    pub inset: [f64; 2],
    /// Rates of these in the face's frame \[m/s\].
    inset_rate: [f64; 2],
}

impl EdgeEnds {
    /// Sign of `d₁ − d₀`.
    pub(in crate::dynamics) fn sense(&self) -> f64 {
        (self.inset[1] - self.inset[0]).signum()
    }
}

/// Where an edge crosses the side of a face, seen along the face's normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct Crossing {
    /// Part of the edge from its first end at which the projections cross \[–\].
    part: f64,
    /// Place on the side from its first corner \[m\].
    along: f64,
    /// Part of the edge at which its line is nearest to that of the side \[–\].
    nearest: f64,
    /// How far beyond an end of the side that, or the crossing, is \[m\].
    overhang: f64,
    /// Common perpendicular of edge and side, outward of the face's body, axes as placed.
    normal: DVec3,
}

impl Edge {
    /// The edge between `ends`, with their coordinates in the face that it bounds and the outward normal of that face as
    /// placed, and the side of `face` from corner `side` on.
    pub(in crate::dynamics) fn of(
        ends: &[(Home, DVec2); 2],
        outward: DVec3,
        (face, side): (&Face, usize),
        [node, stand]: [&Frame; 2],
    ) -> Self {
        let [first, second] = [side, (side + 1) % 4].map(|corner| face.coordinates(face.corners[corner]));
        let length = (second - first).length();
        let mut edge = Self {
            ends: ends.map(|(home, _)| home),
            own: ends.map(|(_, own)| own),
            span: ends[1].0.arm - ends[0].0.arm,
            outward,
            from: first,
            side: (second - first) / length,
            length,
            tolerance: edge_slack(face),
            slide: SLIDE * face.size(),
            clear: 0.0,
            sine: 0.0,
            shared: false,
        };
        edge.sine = edge.span.cross(edge.along()).length() / edge.length();
        edge.clear = edge.beside(&edge.ends(node, stand));
        edge
    }

    /// The same with a node of the side at the crossing as well, or not.
    pub(in crate::dynamics) fn with_other(self, shared: bool) -> Self {
        Self { shared, ..self }
    }

    /// Whether the side has a node at the crossing as well.
    pub(in crate::dynamics) fn is_shared(&self) -> bool {
        self.shared
    }

    /// Length of the edge \[m\].
    pub fn length(&self) -> f64 {
        self.span.length()
    }

    /// Unit vector along the side as placed, world axes.
    fn along(&self) -> DVec3 {
        self.ends[0].axes * self.side.extend(0.0)
    }

    /// Both ends relative to the face.
    pub(in crate::dynamics) fn ends(&self, node: &Frame, face: &Frame) -> EdgeEnds {
        let ends = [0, 1].map(|i| locate(&self.ends[i], node, face));
        EdgeEnds {
            ends,
            inset: ends.map(|end| self.side.perp_dot(end.at - self.from)),
            inset_rate: ends.map(|end| self.side.perp_dot(end.rate)),
        }
    }

    /// `f` \[m\] and its rate \[m/s\], with the sign `sense`.
    pub(in crate::dynamics) fn gap(&self, here: &EdgeEnds, sense: f64) -> [f64; 2] {
        let ([a, b], [d, e], [dr, er]) = (here.ends, here.inset, here.inset_rate);
        let rate = a.gap_rate * e + a.gap * er - b.gap_rate * d - b.gap * dr;
        let scale = sense / self.length();
        [(a.gap * e - b.gap * d) * scale, rate * scale]
    }

    /// Factor by which the round-off of the ends' gaps enters `f` \[–\].
    pub(in crate::dynamics) fn amplification(&self, here: &EdgeEnds) -> f64 {
        (here.inset[0].abs() + here.inset[1].abs()) / self.length()
    }

    /// Bound on `|f̈|` \[m/s²\] over an interval of length `stretch` \[s\] from bounds on the speed \[m/s\] and the
    /// acceleration \[m/s²\] of both ends in the face's frame.
    pub(in crate::dynamics) fn curvature(&self, here: &EdgeEnds, [speed, acceleration]: [f64; 2], stretch: f64) -> f64 {
        let now: f64 = here.ends.iter().map(|end| end.gap.abs()).chain(here.inset.iter().map(|d| d.abs())).sum();
        // f̈ L = g̈₀ d₁ + 2 ġ₀ ḋ₁ + g₀ d̈₁ − g̈₁ d₀ − 2 ġ₁ ḋ₀ − g₁ d̈₀.
        (acceleration * (now + 4.0 * speed * stretch) + 4.0 * speed * speed) / self.length()
    }

    /// Whether no crossing on the edge and the side can be in the face's plane while both ends move by at most `reach` \[m\]:
    /// both ends are before the plane, on one side of the side's line, or beyond one of its ends.
    pub(in crate::dynamics) fn is_clear(&self, here: &EdgeEnds, reach: f64) -> bool {
        here.ends.iter().all(|end| end.gap > reach) || self.beside(here) > reach
    }

    /// Distance along the face by which both ends are on one side of the side's line, or beyond one of its ends; negative
    /// where they are not \[m\].
    fn beside(&self, here: &EdgeEnds) -> f64 {
        let along = here.ends.map(|end| self.side.dot(end.at - self.from));
        let least = |values: [f64; 2]| values[0].min(values[1]);
        let lines = least(here.inset).max(least(here.inset.map(|d| -d)));
        let ends = least(along.map(|at| at - self.length)).max(least(along.map(|at| -at)));
        lines.max(ends - self.tolerance)
    }

    /// Whether no crossing on the edge and the side can be while points of both bodies are displaced by at most `moved` \[m\],
    /// and unit vectors by at most `turned` \[–\], from where they were placed.
    pub(in crate::dynamics) fn stays_clear(&self, [moved, turned]: [f64; 2]) -> bool {
        self.clear > moved || self.sine + turned < LEAST_SINE
    }

    /// The crossing; `None` where it is more than `tolerance` \[m\] beyond an end of the edge or of the side, and where edge and
    /// side are within 30° of parallel or either face looks elsewhere.
    pub(in crate::dynamics) fn crossing(&self, [node, face]: [&Frame; 2], tolerance: f64) -> Option<Crossing> {
        let here = self.ends(node, face);
        let part = here.inset[0] / (here.inset[0] - here.inset[1]);
        let [start, end] = here.ends.map(|end| end.at.extend(end.gap));
        let (edge, side) = (end - start, self.side.extend(0.0));
        let along = side.dot(start - self.from.extend(0.0) + part * edge);
        let on = |at: f64, length: f64| at >= -tolerance && at <= length + tolerance;
        let across = edge.cross(side);
        let sine = across.length() / self.length();
        if !(sine >= LEAST_SINE && on(part * self.length(), self.length()) && on(along, self.length)) {
            return None;
        }
        let nearest = (self.from.extend(0.0) - start).cross(side).dot(across) / across.length_squared();
        let normal = self.ends[0].axes * across.normalize_or_zero() * across.z.signum();
        let own = node.turn(self.outward);
        let own = own + face.turned.transpose() * own;
        let looks = normal.dot(self.ends[0].axes.z_axis) >= ALONG && normal.dot(own) <= -ALONG;
        let beyond = |at: f64| (at - self.length).max(-at).max(0.0);
        let overhang = beyond(along).max(beyond(along + (nearest - part) * side.dot(edge)));
        looks.then_some(Crossing { part, along, nearest, overhang, normal })
    }

    /// Sine of the angle between the two faces \[–\].
    pub(in crate::dynamics) fn tilt(&self, [node, face]: [&Frame; 2]) -> f64 {
        node.turn(self.outward).cross(face.turn(self.ends[0].axes.z_axis)).length()
    }

    /// Rate of the distance of the two lines at the crossing \[m/s\].
    pub(in crate::dynamics) fn distance_rate(&self, crossing: &Crossing, here: &EdgeEnds) -> f64 {
        let [a, b] = here.ends.map(|end| end.rate.extend(end.gap_rate));
        a.lerp(b, crossing.part).dot(self.ends[0].axes.transpose() * crossing.normal)
    }

    /// Distance of the two lines along their common perpendicular, negative where the edge is in the face's body \[m\];
    /// `None` where they do not cross.
    pub(crate) fn distance(&self, node: &Frame, face: &Frame) -> Option<f64> {
        let crossing = self.crossing([node, face], self.tolerance)?;
        let first = locate(&self.ends[0], node, face);
        Some((first.at - self.from).extend(first.gap).dot(self.ends[0].axes.transpose() * crossing.normal))
    }

    /// Node and contact geometry as placed, from those of the middle of the edge against the face: axes along the side,
    /// across it and along the normal, with their origin at the first corner of the side.
    pub(in crate::dynamics) fn home(&self, middle: &Home, place: &NodePlace) -> Home {
        let node = middle.shifted(place.shift);
        if place.normal == DVec3::ZERO {
            return node;
        }
        let along = self.along();
        let axes = DMat3::from_cols(along, place.normal.cross(along), place.normal);
        node.before(node.axes * self.from.extend(0.0), axes)
    }

    /// Positive where a node of the edge is too far from the side or beyond its ends \[m\]; its projection is its place
    /// along and across the side.
    pub(in crate::dynamics) fn left(&self, place: &NodePlace, at: DVec2) -> f64 {
        let beyond = at.x.max(self.length - at.x) - self.length;
        (at.y.abs() - self.slide).max(beyond - self.tolerance - place.overhang)
    }

    /// Distance up to which a crossing beyond an end counts as on the edge or on the side \[m\].
    pub(in crate::dynamics) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Distance from the crossing at which a node is moved \[m\].
    pub(in crate::dynamics) fn slide(&self) -> f64 {
        self.slide
    }

    /// Whether a node of the edge, by its place along and across the side, has slid from the crossing.
    pub(in crate::dynamics) fn has_slid(&self, at: DVec2) -> bool {
        at.y.abs() > 0.5 * self.slide
    }

    /// A place along and across the side in the coordinates of the face \[m\].
    pub(in crate::dynamics) fn to_face(&self, at: DVec2) -> DVec2 {
        self.from + self.side * at.x + self.side.perp() * at.y
    }

    /// The node at a crossing.
    pub(in crate::dynamics) fn place(&self, crossing: &Crossing) -> NodePlace {
        let Crossing { nearest, normal, overhang, .. } = *crossing;
        NodePlace { shift: self.span * (nearest - 0.5), normal, overhang }
    }

    /// A node in the coordinates of the face that the edge bounds \[m\].
    pub(in crate::dynamics) fn own_place(&self, place: &NodePlace) -> DVec2 {
        self.own[0].lerp(self.own[1], 0.5 + place.shift.dot(self.span) / self.span.length_squared())
    }

    /// The crossing in the coordinates of the face that the edge bounds (`own`), or of the facing face \[m\].
    pub(in crate::dynamics) fn on_face(&self, crossing: &Crossing, own: bool) -> DVec2 {
        if own { self.own[0].lerp(self.own[1], crossing.part) } else { self.from + self.side * crossing.along }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::turned_by;
    use glam::DQuat;

    /// A unit square in the plane z = 0 with its outward normal up, and an edge at height `h` across its side y = 0,
    /// rising by `slope` inwards, of a face that looks down.
    fn across(h: f64, slope: f64) -> (Edge, Home, [Frame; 2]) {
        let quad = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)].map(DVec3::from);
        let face = Face::new(quad, 0.5).expect("a square");
        let frames = [DVec3::new(0.3, 0.1, 2.0), DVec3::ZERO].map(Frame::fixed);
        let point = |y: f64| DVec3::new(0.3, y, h + slope * y);
        let home = |at: DVec3| {
            Home::of(at - frames[0].home, (frames[0].home, DMat3::IDENTITY), &face, (DVec3::ZERO, DMat3::IDENTITY))
        };
        let edge = Edge::of(
            &[point(-0.4), point(0.6)].map(|at| (home(at), at.truncate())),
            DVec3::NEG_Z,
            (&face, 0),
            [&frames[0], &frames[1]],
        );
        (edge, home(point(-0.4).midpoint(point(0.6))), frames)
    }

    #[test]
    fn the_normal_is_perpendicular_to_both_edges_and_the_distance_along_it() {
        for slope in [0.0, 0.3, -0.9] {
            let (edge, _, [node, face]) = across(0.02, slope);
            let crossing = edge.crossing([&node, &face], edge.tolerance()).expect("they cross");
            let normal = DVec3::new(0.0, -slope, 1.0).normalize_or_zero();
            assert!((crossing.normal - normal).length() < 1e-15, "{} at slope {slope}", crossing.normal);
            let distance = edge.distance(&node, &face).expect("they cross");
            assert!((distance - 0.02 * normal.z).abs() < 1e-15, "{distance} m at slope {slope}");
        }
    }

    #[test]
    fn the_gap_is_0_where_the_lines_meet_and_its_rate_is_its_derivative() {
        let (edge, _, [node, face]) = across(0.0, 0.4);
        let ends = edge.ends(&node, &face);
        assert!(edge.gap(&ends, ends.sense())[0].abs() < 1e-16, "the lines meet");
        let moving = |t: f64| Frame {
            shift: DVec3::new(0.1, 0.2, 0.3) * t,
            turned: turned_by(DQuat::from_scaled_axis(DVec3::new(0.5, -0.7, 0.2) * t)),
            velocity: DVec3::new(0.1, 0.2, 0.3),
            spin: DVec3::new(0.5, -0.7, 0.2),
            level: false,
            ..node
        };
        let at = |t: f64| edge.gap(&edge.ends(&moving(t), &face), ends.sense());
        let dt = 1e-5;
        let slope = (at(0.1 + dt)[0] - at(0.1 - dt)[0]) / (2.0 * dt);
        assert!((at(0.1)[1] / slope - 1.0).abs() < 1e-8, "{} against {slope}", at(0.1)[1]);
    }

    #[test]
    fn the_node_at_a_crossing_is_on_the_side_with_the_distance_as_its_gap() {
        let (edge, middle, [node, face]) = across(-0.01, 0.7);
        let crossing = edge.crossing([&node, &face], edge.tolerance()).expect("they cross");
        let place = edge.place(&crossing);
        let here = locate(&edge.home(&middle, &place), &node, &face);
        let distance = edge.distance(&node, &face).expect("they cross");
        assert!((here.gap - distance).abs() < 1e-15 && here.at.y.abs() < 1e-15, "{here:?}");
        assert!(edge.left(&place, here.at) < 0.0 && !edge.has_slid(here.at), "on the side, not slid");
        assert!((edge.to_face(here.at) - DVec2::new(0.3, 0.0)).length() < 1e-15, "its place on the face");
    }

    #[test]
    fn edges_that_miss_each_other_or_are_nearly_parallel_do_not_cross() {
        let (edge, _, [node, face]) = across(0.0, 0.0);
        let beside = Frame { shift: DVec3::X * 0.8, ..node };
        assert_eq!(edge.crossing([&beside, &face], edge.tolerance()), None, "beyond the side's end");
        let turned = |degrees: f64| Frame {
            turned: turned_by(DQuat::from_rotation_z(f64::to_radians(degrees))),
            level: false,
            ..node
        };
        assert!(edge.crossing([&turned(55.0), &face], edge.tolerance()).is_some(), "35° from parallel");
        assert_eq!(edge.crossing([&turned(65.0), &face], edge.tolerance()), None, "25° from parallel");
        let over = Frame { turned: turned_by(DQuat::from_rotation_y(std::f64::consts::PI)), level: false, ..node };
        let over = Frame { shift: DVec3::new(0.0, 0.0, -4.0), ..over };
        assert_eq!(edge.crossing([&over, &face], edge.tolerance()), None, "the edge's face looks up, too");
    }
}
