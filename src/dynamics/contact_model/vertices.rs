//! Contact points in space whose nodes change during a touch (`docs/physics.md#edge-nodes`): an edge node follows its
//! crossing, a corner that slides out over a side leaves a crossing behind, a crossing that passes a corner leaves the
//! corner. Nodes keep the penetration and the stretch of those before them, so that no energy appears.

use glam::{DVec2, DVec3};

use crate::contact::{Local, Mode};
use crate::dynamics::contact_model::contact_law;
use crate::dynamics::contact_model::transitions::Transitions;
use crate::dynamics::penalty3d::contact_force::to_world;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::record::event::EventKind;
use crate::dynamics::world::contact_points;
use crate::scene::Sharing;

/// What the nodes of a vertex have together.
struct Carried {
    /// Penetration \[m\].
    depth: f64,
    /// Length of the tangential stretch in stick \[m\].
    stretch: f64,
}

impl Transitions<'_> {
    /// Moves an edge node that the slide has parted from the crossing to the present one; whether there is a crossing.
    pub(super) fn follow(&mut self, contact: usize, closed: ClosedContact) -> bool {
        let here = self.here(contact);
        let track = &self.world.contacts[contact];
        let depth = self.world.model.contacts[track.site].face.depth;
        let slid = self.at().edge(contact).is_some_and(|edge| edge.has_slid(here.at)) && here.penetration() < depth;
        let Some(shift) = self.crossing(contact).filter(|_| slid) else { return false };
        let before = closed.law.strain(&here, &closed.forces(&here));
        self.enter(contact, (closed, EventKind::Moved), (shift, here.penetration(), stretch(&closed, &here)), before);
        true
    }

    /// Hands the part of a vertex in K and C that a node has left over an edge, in state `closed`, to the nodes that
    /// are there now; other nodes of the vertex that are there no more leave with it.
    pub(super) fn pass_on(&mut self, contact: usize, closed: &ClosedContact) {
        let pair = &self.world.model.pairs[self.world.pairs[self.world.contacts[contact].pair].pair];
        if pair.edges.is_empty() {
            return;
        }
        let [mut nodes, gone] = contact_points::at_vertex_of(self.world, contact, &|c| self.at().sides(c));
        nodes.retain(|&node| self.world.contacts[node].state.closed().is_some() || self.can_enter(node));
        if nodes.is_empty() {
            return;
        }
        let sharers = self.world.contacts[contact].sharers;
        let kept = nodes.iter().filter_map(|&node| Some((node, *self.world.contacts[node].state.closed()?)));
        let left = gone.iter().filter_map(|&node| Some((node, *self.world.contacts[node].state.closed()?)));
        let before: Vec<_> = kept.chain(left).chain([(contact, *closed)]).collect();
        let pair = &self.world.pairs[self.world.contacts[contact].pair];
        let divisor = match self.world.model.pairs[pair.pair].contact.sharing {
            Sharing::Tributary => pair.sharers * nodes.len(),
            Sharing::PerNode => sharers,
        };
        let carried = self.carried(&before, nodes.len() as f64 / divisor as f64);
        for gone in gone {
            let Some(state) = self.world.contacts[gone].state.closed().copied() else { continue };
            let released = self.strain(gone, &state);
            self.log(gone, Contact::Open { armed: false }, EventKind::LeftFace, released);
        }
        for node in nodes {
            self.world.contacts[node].sharers = divisor;
            self.carry(node, (contact, closed), &carried);
        }
    }

    /// Penetration and stretch at which nodes of `parts` in K together have the strain energy of those in `before`, of
    /// a linear law.
    fn carried(&self, before: &[(usize, ClosedContact)], parts: f64) -> Carried {
        let (mut depth, mut length) = (0.0, 0.0);
        for (node, closed) in before {
            let (here, part) = (self.here(*node), 1.0 / self.world.contacts[*node].sharers as f64);
            depth += part * here.penetration() * here.penetration();
            length += part * stretch(closed, &here).length_squared();
        }
        Carried { depth: (depth / parts).sqrt(), stretch: (length / parts).sqrt() }
    }

    /// Gives a node its part of a vertex after the node `left`, which was in state `before`: a closed one its law, an
    /// open one its state too.
    fn carry(&mut self, node: usize, (left, before): (usize, &ClosedContact), carried: &Carried) {
        let law = contact_law::of(self.world, node, self.now);
        let at = |stretch: DVec2| stretch.normalize_or_zero() * carried.stretch;
        if let Some(own) = self.world.contacts[node].state.closed().copied() {
            let (shift, stretch) = (self.world.contacts[node].shift, stretch(&own, &self.here(node)));
            let energy = self.strain(node, &own);
            let closed = ClosedContact { law, ..own };
            self.enter(node, (closed, EventKind::Moved), (shift, carried.depth, at(stretch)), energy);
            return;
        }
        let along = match before.mode {
            Mode::Stick { .. } => stretch(before, &self.here(left)),
            Mode::Slip { direction } => direction,
        };
        let along = self.on_face_of(node, along, left);
        let (mode, kind) = match before.mode {
            Mode::Stick { .. } => (Mode::Stick { anchor: DVec2::ZERO }, EventKind::OpenToStick),
            Mode::Slip { .. } => {
                (Mode::Slip { direction: along.try_normalize().unwrap_or(DVec2::X) }, EventKind::OpenToSlip)
            }
        };
        self.place(node);
        let regularisation = self.at().regularisation_length(node, &law, &self.here(node));
        let closed = ClosedContact::new(law, mode, regularisation);
        self.world.contacts[node].closing = None;
        let shift = self.world.contacts[node].shift;
        self.enter(node, (closed, kind), (shift, carried.depth, at(along)), 0.0);
    }

    /// Enters a closed state of a node at `shift`, displaced along the normal to a penetration \[m\], in stick with a
    /// stretch \[m\]; its springs had the energy `before` \[J\].
    fn enter(
        &mut self,
        contact: usize,
        (closed, kind): (ClosedContact, EventKind),
        (shift, depth, stretch): (DVec3, f64, DVec2),
        before: f64,
    ) {
        self.world.contacts[contact].shift = shift;
        let [node, face] = self.at().sides(contact);
        let axes = self.world.model.contacts[self.world.contacts[contact].site].home.axes;
        let outwards = face.turn(axes.z_axis) * (self.here(contact).penetration() - depth);
        let shift = shift + outwards + node.turned.transpose() * outwards;
        self.world.contacts[contact].shift = shift;
        let here = self.here(contact);
        let mode = match closed.mode {
            Mode::Stick { .. } => Mode::Stick { anchor: here.way - stretch },
            slip @ Mode::Slip { .. } => slip,
        };
        let closed = ClosedContact { mode, shift, ..closed };
        let released = before - self.strain(contact, &closed);
        self.log(contact, Contact::Closed(closed), kind, released);
    }

    /// Node relative to face, from the reference poses.
    fn here(&self, contact: usize) -> Local {
        self.at().since(contact, &self.now.since).2
    }

    /// Whether an open node, an edge node at the present crossing, is behind its face and not behind the body.
    fn can_enter(&mut self, contact: usize) -> bool {
        self.place(contact);
        let depth = self.world.model.contacts[self.world.contacts[contact].site].face.depth;
        (0.0..depth).contains(&self.here(contact).penetration())
    }

    /// Strain energy in the springs of a contact in state `closed` \[J\].
    fn strain(&self, contact: usize, closed: &ClosedContact) -> f64 {
        let here = self.here(contact);
        closed.law.strain(&here, &closed.forces(&here))
    }

    /// A stretch or a direction of sliding of the contact `of`, in the axes of its face, as one of the contact `to` of
    /// the same pair in the axes of that one's face.
    fn on_face_of(&self, to: usize, vector: DVec2, of: usize) -> DVec2 {
        let world = |contact: usize, along: DVec2| {
            let (home, [_, face], _) = self.at().since(contact, &self.now.since);
            to_world(&home, &face, along, 0.0)
        };
        // Of a node on the other body it is the opposite.
        let is_same = self.world.contacts[of].slots[0] == self.world.contacts[to].slots[0];
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
