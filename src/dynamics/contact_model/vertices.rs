//! Contact points whose nodes change during a touch (`docs/physics.md#edge-nodes`): in space an edge node follows its crossing, a corner
//! that slides out over a side leaves a crossing behind, a crossing that passes a corner leaves the corner; in plan a corner that slides
//! past a corner of the other body leaves that one. Nodes keep the penetration and the stretch of those before them, so that no energy
//! appears.

use glam::DVec2;

use crate::contact::{Local, Mode, NormalLaw};
use crate::dynamics::contact_model::constants::FLUSH_SINE;
use crate::dynamics::contact_model::contact_law;
use crate::dynamics::contact_model::contact_states::ContactStates;
use crate::dynamics::model::edge_node::LEAST_SINE;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::penalty3d::contact_force::to_world;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::record::event::EventKind;
use crate::dynamics::world::contact_points::{self, NodesAtVertex};
use crate::scene::Kind;

/// State that all nodes of a vertex share.
struct Carried {
    /// Penetration \[m\].
    depth: f64,
    /// Length of the tangential stretch in stick \[m\].
    stretch: f64,
    /// Distance beyond the edges of its face up to which a corner is kept \[m\].
    kept_beyond_edge: f64,
}

/// A node at a vertex.
#[derive(Clone, Copy)]
struct NodeAtVertex {
    place: NodePlace,
    /// Penetration \[m\].
    depth: f64,
    /// Tangential stretch in stick \[m\].
    stretch: DVec2,
}

/// Nodes of the vertices of a touch.
pub(super) struct VertexNodes<'s, 'a> {
    /// The contacts of the group.
    pub(super) states: &'s mut ContactStates<'a>,
}

impl VertexNodes<'_, '_> {
    /// Moves an edge node that the slide has parted from the crossing to the present one; whether there is a crossing, of bodies that
    /// have met one along whose normal they part.
    pub(super) fn follow(&mut self, contact: usize, closed: ClosedContact) -> bool {
        let here = self.states.here(contact);
        let depth = self.states.site(contact).face.depth;
        let slid =
            self.states.poses().edge(contact).is_some_and(|edge| edge.has_slid(here.at)) && here.penetration() < depth;
        if !slid {
            return false;
        }
        let kept = closed.place.overhang;
        let Some(place) = self.states.crossing(contact, kept) else { return false };
        let (place, depth) = (NodePlace { overhang: place.overhang.max(kept), ..place }, here.penetration());
        if !self.states.poses().parts_along(contact, &place, depth) {
            return false;
        }
        let before = self.states.strain(contact, &closed);
        let node = NodeAtVertex { place, depth, stretch: stretch(&closed, &here) };
        self.enter(contact, EventKind::Moved, closed, node, before);
        true
    }

    /// Whether there are nodes to which a node in state `closed` that leaves its face over an edge hands its part of a vertex.
    pub(super) fn has_successors(&mut self, contact: usize, closed: &ClosedContact) -> bool {
        self.successors(contact, closed).is_some()
    }

    /// The nodes of the vertex which a node has left, and how far those present may be beside their faces \[m\]; `None` where none is.
    fn successors(&mut self, contact: usize, closed: &ClosedContact) -> Option<(NodesAtVertex, f64)> {
        if !self.states.world.model_pair(self.states.world.contacts[contact].pair).passes_on {
            return None;
        }
        // Faces of bodies that have met may stand at any angle. Those that are not flush have no vertex in common: every node has a
        // penetration of its own.
        let tilt = self.tilt(contact);
        let have_met = self.states.world.pair_of(contact).meeting.is_some();
        if have_met && tilt > FLUSH_SINE {
            return None;
        }
        // With an angle θ between the faces, the projections of one vertex on them are δ sin θ apart, plus the distance by which the corner
        // was beside its face when it took over. Measured along an edge that is as much over the sine of the angle between the two edges.
        let beside = self.states.here(contact).penetration().max(0.0) * tilt;
        let apart = (beside + closed.solver.beside) / LEAST_SINE;
        let reaches = [[0.0, 0.0], [apart, 0.0], [apart, apart]].into_iter();
        reaches.map(|reach| (self.at_vertex_of(contact, reach), reach[1])).find(|(nodes, _)| !nodes.present.is_empty())
    }

    /// Hands the part of a vertex in K and C that a node has left over an edge, in state `closed`, to the nodes that
    /// are there now; other nodes of the vertex that are there no more leave with it. Whether there is such a node.
    pub(super) fn pass_on(&mut self, contact: usize, closed: &ClosedContact) -> bool {
        let Some((NodesAtVertex { present: nodes, gone }, beside)) = self.successors(contact, closed) else {
            return false;
        };
        let kept = nodes.iter().filter_map(|&node| Some((node, self.states.closed(node)?)));
        let left = gone.iter().filter_map(|&node| Some((node, self.states.closed(node)?)));
        let before: Vec<_> = kept.chain(left).chain([(contact, *closed)]).collect();
        let at_vertex: Vec<usize> = before.iter().map(|(node, _)| *node).collect();
        let divisor = contact_law::divisor_taken_over(self.states.world, &nodes, &at_vertex, contact);
        let parts = nodes.len() as f64 / divisor;
        // Where a node is beside its face, it may go on as far again.
        let carried = Carried { kept_beyond_edge: 2.0 * beside, ..self.carried(&before, parts) };
        // No contact at a penetration of at least the depth of the face's body.
        if nodes.iter().any(|&node| self.states.site(node).face.depth <= carried.depth) {
            return false;
        }
        self.states.world.contacts[contact].has_part = false;
        for gone in gone {
            self.states.world.contacts[gone].has_part = false;
            if let Some(state) = self.states.closed(gone) {
                self.states.open(gone, &state, EventKind::LeftFace);
            }
        }
        for node in nodes {
            // A corner is in contact with one face of a body at a time.
            for other in self.states.world.contacts[node].other_faces.clone() {
                if let Some(state) = self.states.closed(other) {
                    self.states.open(other, &state, EventKind::LeftFace);
                    self.states.forget_sharers_of_open(other);
                }
            }
            (self.states.world.contacts[node].divisor, self.states.world.contacts[node].has_part) = (divisor, true);
            self.carry(node, contact, closed, &carried);
        }
        true
    }

    /// Whether the vertex of an open corner inside a flush face has a node in contact, which passes its part on to this corner when it
    /// reaches the edge of its own face.
    pub(super) fn is_held(&self, contact: usize) -> bool {
        let (pair, tilt) = (self.states.world.contacts[contact].pair, self.tilt(contact));
        let passes_on = self.states.world.model_pair(pair).passes_on;
        let apart = self.states.poses().local(contact).penetration().max(0.0) * tilt;
        let poses = |c: usize| self.states.poses().sides(c);
        passes_on && tilt <= FLUSH_SINE && contact_points::is_held(self.states.world, contact, apart, &poses)
    }

    /// The nodes of the vertex that a node has left, of those present the closed ones and those behind their face; see
    /// [`contact_points::at_vertex_of`].
    fn at_vertex_of(&mut self, contact: usize, [extra, beyond]: [f64; 2]) -> NodesAtVertex {
        let poses = |c: usize| self.states.poses().sides(c);
        let mut nodes = contact_points::at_vertex_of(self.states.world, contact, [extra, beyond], &poses);
        nodes.present.retain(|&node| self.states.world.is_closed(node) || self.place_if_behind_face(node, beyond));
        nodes.present.retain(|&node| !self.leaves_with(node));
        nodes
    }

    /// Whether the projection of a corner, at a vertex that another one has left, moves out over the edge of its own face. In plan the two
    /// faces then no longer overlap at this vertex; where it moves in, they still do.
    fn leaves_with(&self, node: usize) -> bool {
        let (here, face) = (self.states.here(node), &self.states.site(node).face);
        let middle = face.coordinates(face.corners[0]).midpoint(face.coordinates(face.corners[1]));
        self.states.world.model.kind == Kind::Planar && (here.at.x - middle.x) * here.rate.x > 0.0
    }

    /// Sine of the angle between the two faces of a contact's pair \[–\]; 0 where one of the two has no nodes.
    fn tilt(&self, contact: usize) -> f64 {
        let mut contacts = self.states.world.pair_of(contact).contacts.clone();
        let (at, body) = (self.states.poses(), self.states.site(contact).face_body);
        let tilt = |c: usize| {
            let [node, face] = at.sides(c);
            Some(at.edge(c)?.tilt([&node, &face]))
        };
        let by_edges = contacts.clone().rev().find_map(tilt);
        // In plan the other side's nodes are against the other face.
        let mut facing = || contacts.find(|&c| self.states.site(c).face_body != body);
        by_edges.or_else(|| Some(at.normal(contact).cross(at.normal(facing()?)).length())).unwrap_or(0.0)
    }

    /// Penetration and stretch at which nodes of `parts` in K together have the strain energy of those in `before`, as springs that have
    /// not yielded; of one that has, the rest is released.
    fn carried(&self, before: &[(usize, ClosedContact)], parts: f64) -> Carried {
        let (mut energy, mut length) = (0.0, 0.0);
        for (node, closed) in before {
            let (here, part) = (self.states.here(*node), 1.0 / self.states.world.contacts[*node].divisor);
            energy += part * closed.law.normal.relative_energy(here.penetration());
            length += part * stretch(closed, &here).length_squared();
        }
        let depth_of =
            |(_, closed): &(usize, ClosedContact)| closed.law.normal.depth_of_relative_energy(energy / parts);
        let depth = before.first().map_or(0.0, depth_of);
        Carried { depth, stretch: (length / parts).sqrt(), kept_beyond_edge: 0.0 }
    }

    /// Gives a node its part of a vertex after the node `left`, which was in state `before`: a closed one its law, an
    /// open one its state too.
    fn carry(&mut self, node: usize, left: usize, before: &ClosedContact, carried: &Carried) {
        let law = self.states.law_at_closing(node).resumed(&before.law, carried.depth);
        let at = |stretch: DVec2| stretch.normalize_or_zero() * carried.stretch;
        if let Some(own) = self.states.closed(node) {
            let (place, own_stretch) = (self.states.world.contacts[node].place, stretch(&own, &self.states.here(node)));
            let energy = self.states.strain(node, &own);
            let closed = ClosedContact { law: law.resumed(&own.law, carried.depth), ..own };
            let at_vertex = NodeAtVertex { place, depth: carried.depth, stretch: at(own_stretch) };
            self.enter(node, EventKind::Moved, closed, at_vertex, energy);
            return;
        }
        let along = match before.mode {
            Mode::Stick { .. } => stretch(before, &self.states.here(left)),
            Mode::Slip { direction } => direction,
        };
        let along = self.on_face_of(node, along, left);
        let mode = match before.mode {
            Mode::Stick { .. } => Mode::Stick { anchor: DVec2::ZERO },
            Mode::Slip { .. } => Mode::Slip { direction: along.try_normalize().unwrap_or(DVec2::X) },
        };
        let kind = EventKind::of_closing(&mode);
        let regularisation = self.states.at().regularisation_length(node, &law, &self.states.here(node));
        let mut closed = ClosedContact::new(law, mode, regularisation);
        closed.solver.kept_beyond_edge =
            if self.states.poses().edge(node).is_some() { 0.0 } else { carried.kept_beyond_edge };
        // A node that takes over may be beside its face by as much as its predecessor's projection (`successors`).
        (closed.solver.handover_distance, closed.solver.beside) =
            (Some(carried.kept_beyond_edge), carried.kept_beyond_edge);
        self.states.world.contacts[node].found.closing = None;
        let place = self.states.world.contacts[node].place;
        self.enter(node, kind, closed, NodeAtVertex { place, depth: carried.depth, stretch: at(along) }, 0.0);
    }

    /// Enters a closed state of a node, displaced along the normal to its penetration; its springs had the energy `before` \[J\].
    fn enter(&mut self, contact: usize, kind: EventKind, closed: ClosedContact, node: NodeAtVertex, before: f64) {
        let NodeAtVertex { place, depth, stretch } = node;
        self.states.world.contacts[contact].place = place;
        let [node, _] = self.states.poses().sides(contact);
        let outwards = self.states.poses().normal(contact) * (self.states.here(contact).penetration() - depth);
        let shift = place.shift + outwards + node.turned.transpose() * outwards;
        let place = NodePlace { shift, ..place };
        self.states.world.contacts[contact].place = place;
        let here = self.states.here(contact);
        let mode = match closed.mode {
            Mode::Stick { .. } => Mode::Stick { anchor: here.way - stretch },
            slip @ Mode::Slip { .. } => slip,
        };
        let closed = ClosedContact { mode, place, ..closed };
        let released = before - self.states.strain(contact, &closed);
        self.states.log(contact, Contact::Closed(closed), kind, released);
    }

    /// Whether an open node, an edge node at the crossing up to `beyond` beyond the ends of the edges \[m\], is behind its
    /// face and not behind the body.
    fn place_if_behind_face(&mut self, contact: usize, beyond: f64) -> bool {
        self.states.set_place(contact, beyond);
        let depth = self.states.site(contact).face.depth;
        (0.0..depth).contains(&self.states.here(contact).penetration())
    }

    /// A stretch or a direction of sliding of the contact `of`, in the axes of its face, as one of the contact `to` of
    /// the same pair in the axes of that one's face.
    fn on_face_of(&self, to: usize, vector: DVec2, of: usize) -> DVec2 {
        let world = |contact: usize, along: DVec2| {
            let here = self.states.at().relative(contact, &self.states.now.since);
            to_world(&here.geometry, &here.poses[1], along, 0.0)
        };
        // Of a node on the other body it is the opposite.
        let is_same = self.states.world.contacts[of].slots[0] == self.states.world.contacts[to].slots[0];
        let vector = world(of, vector) * if is_same { 1.0 } else { -1.0 };
        DVec2::new(vector.dot(world(to, DVec2::X)), vector.dot(world(to, DVec2::Y)))
    }
}

/// Tangential stretch of a contact in stick; 0 in slip, where the law has it from the penetration \[m\].
fn stretch(closed: &ClosedContact, here: &Local) -> DVec2 {
    match closed.mode {
        Mode::Stick { anchor } => here.way - anchor,
        Mode::Slip { .. } => DVec2::ZERO,
    }
}

#[cfg(test)]
mod tests;
