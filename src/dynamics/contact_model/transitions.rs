//! Transitions of a closed contact at an event: breakaway, stop, opening, leaving its face (`docs/physics.md#contact-events`).

use crate::contact::Mode;
use crate::dynamics::contact_model::contact_closing::ContactClosing;
use crate::dynamics::contact_model::contact_states::ContactStates;
use crate::dynamics::contact_model::least_overlap::ShortestWay;
use crate::dynamics::contact_model::vertices::VertexNodes;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::penalty3d::due::Reason;
use crate::dynamics::record::event::EventKind;
use crate::dynamics::world::contact_points;
use crate::dynamics::world::tracks::ChangeCount;

/// Changes closed contacts.
pub(in crate::dynamics) struct Transitions<'s, 'a> {
    /// The contacts of the group.
    pub states: &'s mut ContactStates<'a>,
}

impl<'a> Transitions<'_, 'a> {
    fn closing(&mut self) -> ContactClosing<'_, 'a> {
        ContactClosing { states: self.states }
    }

    fn vertices(&mut self) -> VertexNodes<'_, 'a> {
        VertexNodes { states: self.states }
    }

    /// Breakaway, stop, opening and edge of a closed contact (`docs/physics.md#contact-events`).
    pub(in crate::dynamics) fn change(&mut self, contact: usize, reason: Reason) {
        let Some(closed) = self.states.closed(contact) else { return };
        match reason {
            Reason::Opening => {
                self.open(contact, &closed, EventKind::Opened);
            }
            Reason::Edge if self.vertices().follow(contact, closed) => {}
            Reason::Edge if closed.solver.handover_distance.is_some() => self.pass_edge(contact, closed),
            Reason::Edge => self.leave(contact, closed),
            Reason::Overlap => self.hand_over(contact, &closed),
            Reason::Switching => self.switch(contact, closed),
            Reason::Kink => {
                let here = self.states.here(contact);
                self.states.enter_without_event(contact, Contact::Closed(closed.after_kink(&here)));
            }
        }
    }

    /// Handles a corner whose projection leaves the polygon of its face, of bodies that have met: the other nodes at its vertex take the
    /// contact over; if there are none, it stays closed until the corner comes out of the body.
    fn pass_edge(&mut self, contact: usize, mut closed: ClosedContact) {
        if self.vertices().has_successors(contact, &closed) {
            self.open(contact, &closed, EventKind::LeftFace);
            return;
        }
        closed.solver.handover_distance = None;
        let site = self.states.site(contact);
        if site.beyond(&closed.place, &self.states.poses().local(contact)) < closed.solver.kept_beyond_edge {
            self.states.enter_without_event(contact, Contact::Closed(closed));
        } else {
            self.leave(contact, closed);
        }
    }

    /// A node leaves its face over an edge. Where the two bodies have met, still overlap, and no other contact carries the overlap, the
    /// contact of their least overlap takes over: another one, or this one beyond the edge, up to the same distance again.
    fn leave(&mut self, contact: usize, mut closed: ClosedContact) {
        let Some(least) = self.states.poses().contact_taking_over(contact) else {
            self.open(contact, &closed, EventKind::LeftFace);
            return;
        };
        if least.contact == contact {
            let site = self.states.site(contact);
            closed.solver.kept_beyond_edge =
                2.0 * site.beyond(&closed.place, &self.states.poses().local(contact)).max(least.depth);
            self.states.enter_without_event(contact, Contact::Closed(closed));
            return;
        }
        let passed_on = self.open(contact, &closed, EventKind::LeftFace);
        let open = !self.states.world.is_closed(least.contact);
        let carried = passed_on || self.states.poses().is_carried_beside(contact, least.depth);
        if open && !carried && !self.states.poses().touches_elsewhere(least.contact) {
            self.closing().close_in_place_of(&[(contact, closed)], least.contact, 2.0 * least.depth);
        }
    }

    /// The overlap of two bodies exceeds the penetration of their deepest contact: the contact of the least overlap takes over, at the same
    /// depth. Where there is none, or it is closed already, the tolerated overlap is doubled.
    fn hand_over(&mut self, contact: usize, closed: &ClosedContact) {
        let here = self.states.poses().local(contact).penetration();
        let Some(ShortestWay { overlap, tolerated, contact: to }) = self.states.poses().shortest_way(contact) else {
            self.states.world.contacts[contact].tolerated = f64::INFINITY;
            return;
        };
        let Some(to) = to.filter(|&to| !self.states.world.is_closed(to)) else {
            self.states.world.contacts[contact].tolerated = 2.0 * (overlap - here).max(tolerated);
            return;
        };
        // The nodes at its vertex have the same penetration and are passed over. Of a crossing of two edges both nodes open together.
        let mut left = vec![(contact, *closed)];
        let other = contact_points::other_of_crossing(self.states.world, contact).filter(|&other| other != to);
        left.extend(other.and_then(|other| Some((other, self.states.closed(other)?))));
        for (leaving, closed) in &left {
            self.states.open(*leaving, closed, EventKind::LeftFace);
        }
        self.states.forget_sharers_of_open(contact);
        for other in self.states.world.contacts[to].other_faces.clone() {
            if let Some(state) = self.states.closed(other) {
                self.open(other, &state, EventKind::LeftFace);
            }
        }
        if !self.states.world.is_closed(to) {
            self.closing().close_in_place_of(&left, to, 2.0 * overlap);
        }
    }

    /// Opens a contact. Where it left its face over an edge, its part of K and C is passed to the other nodes at its vertex; returns
    /// whether there was such a node.
    fn open(&mut self, contact: usize, closed: &ClosedContact, kind: EventKind) -> bool {
        self.states.open(contact, closed, kind);
        let passed_on = kind == EventKind::LeftFace && self.vertices().pass_on(contact, closed);
        self.states.forget_sharers_of_open(contact);
        passed_on
    }

    /// From stick to slip, or back.
    fn switch(&mut self, contact: usize, mut closed: ClosedContact) {
        let here = self.states.here(contact);
        match closed.mode {
            Mode::Stick { anchor } => {
                let breakaway = closed.law.on_breakaway(anchor, &here);
                closed.mode = breakaway.mode;
                let ChangeCount { t, at_instant, .. } = self.states.world.contacts[contact].changes;
                closed.solver.retries =
                    if t == self.states.now.poses.t { u32::try_from(at_instant).unwrap_or(u32::MAX) } else { 0 };
                self.states.log(contact, Contact::Closed(closed), EventKind::StickToSlip, breakaway.released);
            }
            Mode::Slip { direction } => {
                if closed.law.may_pass_stop() && !self.states.at().can_hold(contact, &closed) {
                    closed.solver.passing_stop = true;
                    self.states.enter_without_event(contact, Contact::Closed(closed));
                    return;
                }
                closed.solver.passing_stop = false;
                closed.mode = closed.law.on_stopping(direction, &here);
                closed.solver.retries = 0;
                self.states.log(contact, Contact::Closed(closed), EventKind::SlipToStick, 0.0);
            }
        }
    }
}
