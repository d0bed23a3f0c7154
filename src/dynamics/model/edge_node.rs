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

use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::contact::parameters::edge_slack;
use crate::contact::{ContactGeometry, Frame, Local, locate};
use crate::dynamics::model::face_choice::FaceChoice;
use crate::geometry::Face;

pub mod node_place;

/// Least sine of the angle between an edge and a side that it crosses \[–\]: 30°. Edges closer to parallel
/// cross anywhere along their length at the least roll, and bound a sliver only.
pub(in crate::dynamics) const LEAST_SINE: f64 = 0.5;

/// Two edges of bodies that have met have no contact where the sine of their angle is below [`LEAST_SINE`] and its product with the sine
/// of the angle between their common perpendicular and the nearer face's normal is below this \[–\]: a corner enters before the edges
/// penetrate by this part of half their length. Edges closer to parallel than this have none at any angle of their faces. Chosen:
/// with a tenth of it one of 100 hits of long edges overlaps where four do, and a scene of girders thrown in space (seed 3000021) takes
/// over a minute of processor time where all 41 took 143 s.
const SLIVER: f64 = 3.5e-3;

/// Least cosine of the angle between the common perpendicular and the normal of either face \[–\]: 45°. Edges with another one
/// belong to faces beside these, as those of two level tops that cross in plan.
const ALONG: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Distance of an edge node from the crossing, per size of the face, at which it is moved to the crossing \[–\]: the
/// lever of its force is wrong by less. Tuned.
const SLIDE: f64 = 1e-3;

/// An edge of one face and a side of the facing one that stands across it.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Both ends of the edge against the face, as placed.
    ends: [ContactGeometry; 2],
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
    pub(in crate::dynamics) tolerance: f64,
    /// Distance of the node from the crossing at which it is moved \[m\].
    pub(in crate::dynamics) slide: f64,
    /// Distance as placed, along the face, by which the edge is on one side of the side's line or beyond one of its ends;
    /// negative where they cross \[m\].
    clear: f64,
    /// Sine of the angle between edge and side as placed \[–\].
    sine: f64,
    /// Whether the side, an edge of the other body, has a node at the crossing as well.
    shared: bool,
    /// The face that the edge bounds among those of its body, and the facing face among those of the other: of bodies that have met,
    /// where an edge is in a pair for each of its faces with each of the other edge's.
    faces: Option<Arc<[FaceChoice; 2]>>,
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

/// Crossing of an edge with the side of a face, projected along the face's normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct Crossing {
    /// Part of the edge from its first end at which the projections cross \[–\].
    part: f64,
    /// Place on the side from its first corner \[m\].
    along: f64,
    /// Part of the edge at which its line is nearest to that of the side \[–\].
    nearest: f64,
    /// Distance of that place, or of the crossing, beyond an end of the side \[m\].
    overhang: f64,
    /// Sine of the angle between edge and side \[–\].
    sine: f64,
    /// Common perpendicular of edge and side, outward of the face's body, axes as placed.
    normal: DVec3,
}

impl Edge {
    /// The edge between `ends`, with their coordinates in the face that it bounds and the outward normal of that face as
    /// placed, and the side of `face` from corner `side` on.
    pub(in crate::dynamics) fn of(
        ends: &[(ContactGeometry, DVec2); 2],
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
            faces: None,
        };
        edge.sine = edge.span.cross(edge.along()).length() / edge.length();
        edge.clear = edge.beside(&edge.ends(node, stand));
        edge
    }

    /// The edge with or without a node of the side at the crossing.
    pub(in crate::dynamics) fn with_other(self, shared: bool) -> Self {
        Self { shared, ..self }
    }

    /// The edge of bodies that have met, with the two faces among those of their bodies.
    pub(in crate::dynamics) fn among(self, faces: Option<Arc<[FaceChoice; 2]>>) -> Self {
        Self { faces, ..self }
    }

    /// Whether it is of bodies that have met, between which every face can touch.
    pub(in crate::dynamics) fn is_of_met(&self) -> bool {
        self.faces.is_some()
    }

    /// Whether a crossing can belong to the two faces of bodies that have met while either turns relative to the other by at most
    /// `turned` \[rad\]: the common perpendicular turns by no more than that over the sine of the angle between edge and side.
    pub(in crate::dynamics) fn may_belong(&self, [node, face]: [&Frame; 2], turned: f64) -> bool {
        let Some([own, facing]) = self.faces.as_deref() else { return true };
        let seen = |own: DVec3| {
            let own = node.turn(own);
            own + face.turned.transpose() * own
        };
        let across = seen(self.span).cross(self.along());
        let sine = across.length() / self.length();
        if sine + turned < SLIVER {
            return false;
        }
        let normal = across.normalize_or_zero() * across.dot(facing.own).signum();
        let slack = 2.0 * turned / sine;
        own.may_be_opposed_most(seen, normal, slack) && facing.may_be_opposed_most(|normal| normal, -normal, slack)
    }

    /// Whether a crossing belongs to the two faces: of facing ends where its normal is within 45° of the normals of both, of bodies
    /// that have met where of all faces of either body these two look along it the most.
    pub(in crate::dynamics) fn is_between_faces(&self, crossing: &Crossing, [node, face]: [&Frame; 2]) -> bool {
        let seen = |own: DVec3| {
            let own = node.turn(own);
            own + face.turned.transpose() * own
        };
        match self.faces.as_deref() {
            Some([own, facing]) => {
                own.is_opposed_most(seen, crossing.normal) && facing.is_opposed_most(|normal| normal, -crossing.normal)
            }
            None => self.looks(crossing, [node, face]).into_iter().all(|cosine| cosine >= ALONG),
        }
    }

    /// Whether no crossing can belong to the two faces of bodies that have met while either turns relative to the other by at most
    /// `turned` \[rad\]: the normal of a crossing is less from either face's than half of the angle to the face's neighbour.
    pub(in crate::dynamics) fn looks_elsewhere(&self, [node, face]: [&Frame; 2], turned: f64) -> bool {
        let Some([own, facing]) = self.faces.as_deref() else { return false };
        let opposed = -node.turn(own.own).dot(face.turn(facing.own));
        opposed.clamp(-1.0, 1.0).acos() > own.reach() + facing.reach() + turned
    }

    /// Whether the side has a node at the crossing as well.
    pub(in crate::dynamics) fn is_shared(&self) -> bool {
        self.shared
    }

    /// Both ends of the edge against the face, as placed.
    pub(in crate::dynamics) fn homes(&self) -> [&ContactGeometry; 2] {
        self.ends.each_ref()
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
        self.ends_at([0, 1].map(|i| locate(&self.ends[i], node, face)))
    }

    /// Both ends, given as nodes relative to the face, with their distances from the side.
    pub(in crate::dynamics) fn ends_at(&self, ends: [Local; 2]) -> EdgeEnds {
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
        self.clear > moved || self.sine + turned < self.least_sine()
    }

    fn least_sine(&self) -> f64 {
        if self.faces.is_some() { SLIVER } else { LEAST_SINE }
    }

    /// Whether the two edges of bodies that have met bound a sliver at their crossing.
    pub(in crate::dynamics) fn is_sliver(&self, crossing: &Crossing, poses: [&Frame; 2]) -> bool {
        let [own, facing] = self.looks(crossing, poses);
        let nearer = own.max(facing).min(1.0);
        self.is_of_met() && crossing.sine < LEAST_SINE && crossing.sine * (1.0 - nearer * nearer).sqrt() < SLIVER
    }

    /// Cosines of the angles between the normal of a crossing and those of the two faces, as far as they look at each other \[–\].
    fn looks(&self, crossing: &Crossing, [node, face]: [&Frame; 2]) -> [f64; 2] {
        let own = node.turn(self.outward);
        let own = own + face.turned.transpose() * own;
        [-crossing.normal.dot(own), crossing.normal.dot(self.ends[0].axes.z_axis)]
    }

    /// The crossing; `None` where it is more than `tolerance` \[m\] beyond an end of the edge or of the side, where edge and
    /// side are nearly parallel, and of facing ends where either face looks elsewhere.
    pub(in crate::dynamics) fn crossing(&self, [node, face]: [&Frame; 2], tolerance: f64) -> Option<Crossing> {
        let here = self.ends(node, face);
        let part = here.inset[0] / (here.inset[0] - here.inset[1]);
        let [start, end] = here.ends.map(|end| end.at.extend(end.gap));
        let (edge, side) = (end - start, self.side.extend(0.0));
        let along = side.dot(start - self.from.extend(0.0) + part * edge);
        let on = |at: f64, length: f64| at >= -tolerance && at <= length + tolerance;
        let across = edge.cross(side);
        let sine = across.length() / self.length();
        if !(sine >= self.least_sine() && on(part * self.length(), self.length()) && on(along, self.length)) {
            return None;
        }
        let nearest = (self.from.extend(0.0) - start).cross(side).dot(across) / across.length_squared();
        let normal = self.ends[0].axes * across.normalize_or_zero() * across.z.signum();
        let beyond = |at: f64| (at - self.length).max(-at).max(0.0);
        let overhang = beyond(along).max(beyond(along + (nearest - part) * side.dot(edge)));
        let crossing = Crossing { part, along, nearest, overhang, sine, normal };
        (self.is_of_met() || self.is_between_faces(&crossing, [node, face])).then_some(crossing)
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

    /// The crossing in the coordinates of the face that the edge bounds (`own`), or of the facing face \[m\].
    pub(in crate::dynamics) fn on_face(&self, crossing: &Crossing, own: bool) -> DVec2 {
        if own { self.own[0].lerp(self.own[1], crossing.part) } else { self.from + self.side * crossing.along }
    }
}

#[cfg(test)]
mod tests;
