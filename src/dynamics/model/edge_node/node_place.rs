//! Node of an edge and normal of its contact (`docs/physics.md#edge-nodes`).

use glam::{DMat3, DVec2, DVec3};

use super::{Crossing, Edge};
use crate::contact::ContactGeometry;

/// Node and normal of a contact, axes of the bodies as placed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NodePlace {
    /// Node from that of its site, of an edge node the middle of the edge \[m\].
    pub shift: DVec3,
    /// Unit normal of an edge node's contact, outward of the face's body; 0 for a corner, whose normal is the face's.
    pub normal: DVec3,
    /// Allowed distance of the node beyond an end of the side \[m\]: of faces that are not parallel the crossing is beside the place where
    /// the edges are nearest.
    pub overhang: f64,
    /// Part by which an edge node's normal follows the common perpendicular as the bodies turn; by the rest it stays with the face's body
    /// \[–\].
    pub follow: f64,
}

impl Edge {
    /// Node and contact geometry as placed, from those of the middle of the edge against the face: axes along the side,
    /// across it and along the normal, with their origin at the first corner of the side.
    pub(in crate::dynamics) fn geometry(&self, middle: &ContactGeometry, place: &NodePlace) -> ContactGeometry {
        let node = middle.shifted(place.shift);
        if place.normal == DVec3::ZERO {
            return node;
        }
        let along = self.along();
        let axes = DMat3::from_cols(along, place.normal.cross(along), place.normal);
        let node = node.before(node.axes * self.from.extend(0.0), axes);
        if place.follow > 0.0 { node.across(self.span / self.length(), place.follow) } else { node }
    }

    /// Positive where a node of the edge is too far from the side or beyond its ends \[m\]; its projection is its place
    /// along and across the side.
    pub(in crate::dynamics) fn left(&self, place: &NodePlace, at: DVec2) -> f64 {
        let beyond = at.x.max(self.length - at.x) - self.length;
        (at.y.abs() - self.slide).max(beyond - self.tolerance - place.overhang)
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
        NodePlace { shift: self.span * (nearest - 0.5), normal, overhang, follow: self.follow(crossing) }
    }

    /// Part by which the normal of a node at a crossing follows the common perpendicular \[–\]: wholly of bodies that have met; of facing
    /// ends it grows from 0 at a corner, whose normal is that of a face, to 1 at [`slide`](Self::slide) from there, so that the answer is
    /// continuous in where the ends are.
    fn follow(&self, crossing: &Crossing) -> f64 {
        if self.is_of_met() {
            return 1.0;
        }
        let inside = |at: f64, length: f64| at.min(length - at);
        let corner = inside(crossing.part * self.length(), self.length()).min(inside(crossing.along, self.length));
        let part = (corner / self.slide).clamp(0.0, 1.0);
        part * part * (3.0 - 2.0 * part)
    }

    /// A node in the coordinates of the face that the edge bounds \[m\].
    pub(in crate::dynamics) fn own_place(&self, place: &NodePlace) -> DVec2 {
        self.own[0].lerp(self.own[1], 0.5 + place.shift.dot(self.span) / self.span.length_squared())
    }
}
