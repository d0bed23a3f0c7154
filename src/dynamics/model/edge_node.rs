//! A node on an edge of an end face, where that edge crosses a side of the facing face (`docs/physics.md#edge-nodes`).
//!
//! Both ends of the edge are measured as nodes against the face: gap `g` and distance `d` of the projection from the
//! side, positive inwards. The projections cross at the part `s = d₀/(d₀ − d₁)` of the edge, and the gap there is
//! `(1 − s) g₀ + s g₁`. Times `(d₁ − d₀)/D`, with `D` the difference as placed, it is
//!
//! ```text
//! f = (g₀ d₁ − g₁ d₀)/D
//! ```
//!
//! whose zeros are those of the gap, and whose second derivative is bounded by those of the four distances.

use glam::{DVec2, DVec3};

use crate::contact::parameters::edge_slack;
use crate::contact::{Frame, Home, Local, locate};
use crate::geometry::Face;

/// Least sine of the angle between an edge and a side that it crosses, as placed \[–\]: 30°. Edges closer to parallel
/// cross anywhere along their length at the least roll, and bound a sliver only.
const LEAST_SINE: f64 = 0.5;

/// Distance of an edge node from the crossing, per size of the face, at which it is moved to the crossing \[–\]: the
/// lever of its force is wrong by less. Tuned.
const SLIDE: f64 = 1e-3;

/// An edge of one face and a side of the facing one that stands across it.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Both ends of the edge against the face, as placed.
    ends: [Home; 2],
    /// From the first end to the second as placed, world axes \[m\].
    span: DVec3,
    /// Both ends in the coordinates of the face that the edge bounds \[m\].
    own: [DVec2; 2],
    /// First corner of the side, in the face's coordinates \[m\].
    from: DVec2,
    /// Unit vector along the side, the face on its left.
    side: DVec2,
    /// Length of the side \[m\].
    length: f64,
    /// `D`: distance of the second end from the side less that of the first, as placed \[m\].
    across: f64,
    /// Distance up to which a crossing beyond an end counts as on the edge or on the side \[m\].
    tolerance: f64,
    /// Distance of the node from the crossing at which it is moved \[m\].
    slide: f64,
    /// Distance as placed, along the face, by which the edge is on one side of the side's line or beyond one of its ends;
    /// negative where they cross \[m\].
    clear: f64,
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

/// Where an edge crosses the side of a face, seen along the face's normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct Crossing {
    /// Part of the edge from its first end \[–\].
    part: f64,
    /// Place on the side from its first corner \[m\].
    along: f64,
}

impl Crossing {
    /// Rate of the gap of the point of the edge that is at the crossing \[m/s\].
    pub(in crate::dynamics) fn gap_rate(&self, here: &EdgeEnds) -> f64 {
        (1.0 - self.part) * here.ends[0].gap_rate + self.part * here.ends[1].gap_rate
    }
}

impl Edge {
    /// The edge from `ends[0]` to `ends[1]`, with its bounded face's coordinates of both in `own`, and the side of
    /// `face` from corner `side` on; `None` where they stand nearly parallel.
    pub(in crate::dynamics) fn of(
        ends: &[(Home, DVec2); 2],
        face: &Face,
        side: usize,
        frames: impl Fn() -> [Frame; 2],
    ) -> Option<Self> {
        let [first, second] = [side, (side + 1) % 4].map(|corner| face.coordinates(face.corners[corner]));
        let length = (second - first).length();
        let [(one, at), (other, end)] = *ends;
        let mut edge = Self {
            ends: [one, other],
            span: other.arm - one.arm,
            own: [at, end],
            from: first,
            side: (second - first) / length,
            length,
            across: 1.0,
            tolerance: edge_slack(face),
            slide: SLIDE * face.size(),
            clear: 0.0,
        };
        let [node, facing] = frames();
        let placed = edge.ends(&node, &facing);
        edge.clear = edge.beside(&placed);
        let [a, b] = placed.inset;
        edge.across = b - a;
        (edge.across.abs() >= LEAST_SINE * edge.length()).then_some(edge)
    }

    /// Length of the edge \[m\].
    pub fn length(&self) -> f64 {
        self.span.length()
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

    /// `f` \[m\] and its rate \[m/s\].
    pub(in crate::dynamics) fn gap(&self, here: &EdgeEnds) -> [f64; 2] {
        let ([a, b], [d, e], [dr, er]) = (here.ends, here.inset, here.inset_rate);
        let rate = a.gap_rate * e + a.gap * er - b.gap_rate * d - b.gap * dr;
        [(a.gap * e - b.gap * d) / self.across, rate / self.across]
    }

    /// `f` \[m\] at poses of the edge's and the face's body.
    pub(crate) fn gap_at(&self, node: &Frame, face: &Frame) -> f64 {
        self.gap(&self.ends(node, face))[0]
    }

    /// Factor by which the round-off of the ends' gaps enters `f` \[–\].
    pub(in crate::dynamics) fn amplification(&self, here: &EdgeEnds) -> f64 {
        (here.inset[0].abs() + here.inset[1].abs()) / self.across.abs()
    }

    /// Bound on `|f̈|` \[m/s²\] over an interval of length `stretch` \[s\] from bounds on the speed \[m/s\] and the
    /// acceleration \[m/s²\] of both ends in the face's frame.
    pub(in crate::dynamics) fn curvature(&self, here: &EdgeEnds, [speed, acceleration]: [f64; 2], stretch: f64) -> f64 {
        let now: f64 = here.ends.iter().map(|end| end.gap.abs()).chain(here.inset.iter().map(|d| d.abs())).sum();
        // f̈ D = g̈₀ d₁ + 2 ġ₀ ḋ₁ + g₀ d̈₁ − g̈₁ d₀ − 2 ġ₁ ḋ₀ − g₁ d̈₀.
        (acceleration * (now + 4.0 * speed * stretch) + 4.0 * speed * speed) / self.across.abs()
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

    /// Whether no crossing on the edge and the side can be while points of both bodies are displaced by at most `moved` from
    /// where they were placed \[m\].
    pub(in crate::dynamics) fn stays_clear(&self, moved: f64) -> bool {
        self.clear > moved
    }

    /// The crossing; `None` where it is more than `tolerance` \[m\] beyond an end of the edge or of the side.
    pub(in crate::dynamics) fn crossing(&self, here: &EdgeEnds, tolerance: f64) -> Option<Crossing> {
        let [d, e] = here.inset;
        let part = d / (d - e);
        let [a, b] = here.ends.map(|end| self.side.dot(end.at - self.from));
        let along = a + part * (b - a);
        let on = |at: f64, length: f64| at >= -tolerance && at <= length + tolerance;
        (on(part * self.length(), self.length()) && on(along, self.length)).then_some(Crossing { part, along })
    }

    /// Positive where a node of the edge, by its projection, is too far from the side or beyond its ends \[m\].
    pub(in crate::dynamics) fn left(&self, at: DVec2) -> f64 {
        let (inset, along) = (self.side.perp_dot(at - self.from), self.side.dot(at - self.from));
        (inset.abs() - self.slide).max(along.max(self.length - along) - self.length - self.tolerance)
    }

    /// Distance up to which a crossing beyond an end counts as on the edge or on the side \[m\].
    pub(in crate::dynamics) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Distance from the crossing at which a node is moved \[m\].
    pub(in crate::dynamics) fn slide(&self) -> f64 {
        self.slide
    }

    /// Whether a node of the edge, by its projection, has slid from the crossing.
    pub(in crate::dynamics) fn has_slid(&self, at: DVec2) -> bool {
        self.side.perp_dot(at - self.from).abs() > 0.5 * self.slide
    }

    /// A node of the edge in the coordinates of the face that the edge bounds \[m\].
    pub(in crate::dynamics) fn own_place(&self, shift: DVec3) -> DVec2 {
        self.own[0].lerp(self.own[1], 0.5 + shift.dot(self.span) / self.span.length_squared())
    }

    /// The node from the middle of its edge as placed, world axes \[m\].
    pub(in crate::dynamics) fn shift(&self, crossing: &Crossing) -> DVec3 {
        self.span * (crossing.part - 0.5)
    }

    /// The crossing in the coordinates of the face that the edge bounds (`own`), or of the facing face \[m\].
    pub(in crate::dynamics) fn place(&self, crossing: &Crossing, own: bool) -> DVec2 {
        if own { self.own[0].lerp(self.own[1], crossing.part) } else { self.from + self.side * crossing.along }
    }
}
