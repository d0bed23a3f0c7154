//! A facing pair and its contact sites as constant data: a site is one node against one face (paper Fig. 24).

use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::contact::parameters::{edge_slack, outside};
use crate::contact::{ContactGeometry, Frame, Law, Local, is_damped_by_65, returned_restitution};
use crate::dynamics::model::edge_node::Edge;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::model::face_choice::FaceChoice;
use crate::geometry::{End, Face, Prism};
use crate::language::{Text, values};
use crate::scene::facing::{Flank, PairContact, Side, SolidId};

/// A facing pair, compiled.
#[derive(Clone, Debug)]
pub struct Pair {
    /// `deck+x|wall`.
    pub name: String,
    /// A face of a girder; of facing ends, an end.
    pub first: Side,
    /// A face of a girder or an abutment.
    pub second: Side,
    /// Whether the pair was added because the two bodies met, where they do not face each other as placed.
    pub met: bool,
    /// Numbers of the bodies on both sides; `None` for an abutment that stands.
    pub bodies: [Option<usize>; 2],
    /// The numbers in force.
    pub contact: PairContact,
    /// The law of the whole pair, which its nodes share.
    pub law: Law,
    /// Reduced mass `M₁M₂/(M₁+M₂)` of the bodies \[kg\].
    pub mass: f64,
    /// Gap along the first girder's axis as placed \[m\].
    pub gap: f64,
    /// Sites of its corners, numbers in [`Model::sites`](crate::dynamics::Model::sites).
    pub sites: std::ops::Range<usize>,
    /// Its edge nodes, behind the contacts of all pairs in the same list; none in plan.
    pub edges: std::ops::Range<usize>,
    /// Of contact between all faces, nodes of the second side that are no contacts, since they lie far beside the first side's face as placed.
    /// While they are over it they share K and C, as they do once the two bodies have met and they are contacts.
    pub beside: Vec<NodeBeside>,
    /// Whether sliding has one direction only: the faces are vertical and no body can move vertically, roll or pitch.
    pub one_way: bool,
    /// Whether the part in K and C of a node that leaves its face over an edge passes to the nodes that are at its place then: in space,
    /// and in plan between all faces. Between ends alone it is released there, as in the paper.
    pub passes_on: bool,
}

/// A node of a pair that is no contact.
#[derive(Clone, Debug)]
pub struct NodeBeside {
    /// The node against the face.
    pub geometry: ContactGeometry,
    /// The face that it is beside.
    pub face: Face,
}

impl Pair {
    /// Coefficient of restitution that a flush free head-on hit returns at the design speed of the pair \[–\].
    pub fn returned_restitution(&self) -> f64 {
        returned_restitution(&self.contact.law(self.mass, self.one_way), self.contact.design_speed)
    }

    /// Whether its normal dashpot is that of (65), from `e_n` and K.
    pub fn is_damped_by_65(&self) -> bool {
        is_damped_by_65(&self.contact.law(self.mass, self.one_way))
    }

    /// Its two bodies, in the same order whichever has the nodes.
    pub fn solids(&self) -> [SolidId; 2] {
        let mut solids = [self.first.solid(), self.second.solid()];
        solids.sort_unstable();
        solids
    }

    /// Whether it is between these two bodies, in either order.
    pub fn is_between(&self, mut solids: [SolidId; 2]) -> bool {
        solids.sort_unstable();
        self.solids() == solids
    }

    /// Its two sides.
    pub fn sides(&self) -> [Side; 2] {
        [self.first, self.second]
    }

    /// Numbers of all its contact sites: corners, then edge nodes.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + use<> {
        self.sites.clone().chain(self.edges.clone())
    }
}

/// Part of a body to which a node or a face belongs: those of an elastic girder move relative to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// An end of a girder.
    End(End),
    /// A face along it.
    Flank(Flank),
    /// An abutment.
    Abutment,
}

impl Carrier {
    /// Of a face.
    pub fn of_face(side: Side) -> Self {
        match side {
            Side::Girder(_, end) => Self::End(end),
            Side::Flank(_, flank) => Self::Flank(flank),
            Side::Abutment(_) | Side::Rear(..) => Self::Abutment,
        }
    }

    /// Of a corner of a body, by its number among the eight: of a girder its end.
    pub fn of_corner(solid: SolidId, corner: usize) -> Self {
        let is_of = |end: &End| Prism::end_corners(*end).contains(&(corner % 4));
        let end = End::BOTH.into_iter().find(is_of).filter(|_| matches!(solid, SolidId::Girder(_)));
        end.map_or(Self::Abutment, Self::End)
    }
}

/// A declared node and face (Fig. 24).
#[derive(Clone, Debug)]
pub struct ContactSite {
    /// `deck.corner1`, as tables call the node.
    pub node: String,
    /// Name of the face, `wall` or `deck-x`.
    pub face_name: Arc<str>,
    /// Its pair.
    pub pair: usize,
    /// Parts of the bodies with node and face.
    pub carriers: [Carrier; 2],
    /// The faces around the face, where contact lasts until the node comes out of its body; else it ends where the projection
    /// leaves the polygon.
    pub around: Option<[DVec3; 4]>,
    /// The faces of its body that meet in the node, where the node is in pairs of several of them.
    pub corner: Option<FaceChoice>,
    /// The body that owns the node; nothing for an abutment's corner.
    pub node_body: Option<usize>,
    /// The node in its body's frame (about `fixed`, for an abutment) \[m\].
    pub point: DVec3,
    /// The body that owns the face; nothing for an abutment.
    pub face_body: Option<usize>,
    /// The face in its body's frame (about `fixed`, for an abutment).
    pub face: Face,
    /// Node and face as placed.
    pub geometry: ContactGeometry,
    /// Origin of the abutment's frame in this contact, if there is one \[m\].
    pub fixed: DVec3,
    /// That frame.
    pub stand: Frame,
    /// For an edge node its edge and the side of the face across it; `point` and `geometry` are then those of the edge's
    /// middle. Nothing for a corner.
    pub edge: Option<Box<Edge>>,
}

impl ContactSite {
    /// Name of the node in texts: a corner of a girder by its number in plan, from 1 on, as in readings and seats.
    pub fn node_in_words(&self) -> String {
        node_in_words(&self.node)
    }

    /// Node and face as placed, the node at a place of its own.
    #[inline]
    pub fn geometry_at(&self, place: &NodePlace) -> ContactGeometry {
        match &self.edge {
            Some(edge) => edge.geometry(&self.geometry, place),
            None if place.shift == DVec3::ZERO => self.geometry,
            None => self.geometry.shifted(place.shift),
        }
    }

    /// Projection of a node at its place in the coordinates of the face \[m\].
    pub fn on_face(&self, place: &NodePlace, here: &Local) -> DVec2 {
        match &self.edge {
            Some(edge) if place.normal != DVec3::ZERO => edge.to_face(here.at),
            _ => here.at,
        }
    }

    /// Half the length of the edge that the node is on; 0 for a corner \[m\].
    pub(in crate::dynamics) fn half_edge(&self) -> f64 {
        self.edge.as_ref().map_or(0.0, |edge| 0.5 * edge.length())
    }

    /// Distance of a node at its place beyond the edges of its face, or beyond the face's body behind; negative within \[m\]; of an edge
    /// node, its distance from the crossing less the distance at which it is moved.
    ///
    /// Without [`around`](Self::around) the polygon's edges count, for the projection; with it the planes of the neighbouring
    /// faces, for the node itself: at the end of a skewed girder a node that is over the edge may still be in the girder.
    pub fn beyond(&self, place: &NodePlace, here: &Local) -> f64 {
        if let Some(edge) = &self.edge {
            return edge.left(place, here.at).max(here.penetration() - self.face.depth);
        }
        let Some(normals) = &self.around else {
            return outside(&self.face, here.at).max(here.penetration() - self.face.depth);
        };
        let beyond = |(normal, corner): (&DVec3, DVec3)| {
            (here.at - self.face.coordinates(corner)).dot(normal.truncate()) + here.gap * normal.z
        };
        let farthest = normals.iter().zip(self.face.corners).map(beyond).fold(f64::NEG_INFINITY, f64::max);
        (farthest - edge_slack(&self.face)).max(here.penetration() - self.face.depth)
    }

    /// Distance of the projection of a corner outside of the polygon; negative inside \[m\].
    pub fn over_edge(&self, here: &Local) -> f64 {
        outside(&self.face, here.at)
    }

    /// Size that the node's coordinates on the face round with: of the face, and of either lever from G \[m\].
    pub fn reach(&self) -> f64 {
        self.face.size().max(self.point.length() + self.half_edge()).max(self.face.corners[0].length())
    }
    /// Distances of the node from G of its own body, and of the same point from G of the face's body, as an upper bound \[m\].
    pub(in crate::dynamics) fn levers(&self, here: &Local) -> [f64; 2] {
        [self.point.length() + self.half_edge(), self.face.corners[0].length() + here.gap.abs() + here.at.length()]
    }
}

/// A corner of a girder, `deck.corner1-top` in tables, in words; any other node by its name.
fn node_in_words(node: &str) -> String {
    let found = node.rsplit_once(".corner").and_then(|(girder, rest)| {
        let (number, key) = match rest.split_once('-') {
            None => (rest, "node-corner"),
            Some((number, "bottom")) => (number, "node-corner-bottom"),
            Some((number, "top")) => (number, "node-corner-top"),
            Some(_) => return None,
        };
        let corner = number.parse::<usize>().ok()? + 1;
        Some(Text::new(key).with(&values!["girder" => girder, "corner" => corner]))
    });
    found.unwrap_or_else(|| node.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_told_by_their_numbers_in_plan() {
        assert_eq!(node_in_words("deck.corner1"), "deck corner 2");
        assert_eq!(node_in_words("a.corner9.corner0-top"), "a.corner9 corner 1, top", "the last part alone");
        for other in ["wall.edge", "deck.corner1-side", "deck.cornerx"] {
            assert_eq!(node_in_words(other), other);
        }
    }
}
