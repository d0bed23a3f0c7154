//! Transitions between the states open, stick and slip of a contact at an event (`docs/physics.md#contact-events`).

use glam::DVec2;

use crate::contact::{FrictionLaw, Mode, NormalLaw};
use crate::dynamics::contact_model::at_instant::{AtInstant, EventInstant};
use crate::dynamics::contact_model::constants::{CONTACT_EVENTS_PER_INSTANT, CONTACT_EVENTS_PER_TOUCH};
use crate::dynamics::contact_model::contact_law;
use crate::dynamics::contact_model::least_overlap::ShortestWay;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::model::edge_node::NodePlace;
use crate::dynamics::model::reference_pose;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::penalty3d::due::Reason;
use crate::dynamics::record::event::{Event, EventKind};
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{ChangeCount, ContactTrack};
use crate::language::message;

/// Contacts of a group of bodies during an event.
pub(in crate::dynamics) struct Transitions<'a> {
    /// Constant data and present states of the group.
    pub world: &'a mut World,
    /// Events of the run, to which those of this instant are added.
    pub events: &'a mut Vec<Event>,
    /// Progress of the run, stopped where a contact exceeds its number of events.
    pub schedule: &'a mut Schedule,
    /// States of the bodies that the event concerns.
    pub now: &'a EventInstant,
}

impl Transitions<'_> {
    /// The contacts as they are now.
    pub(super) fn at(&self) -> AtInstant<'_> {
        AtInstant { world: self.world, now: self.now }
    }

    pub(super) fn log(&mut self, contact: usize, state: Contact, kind: EventKind, released: f64) {
        self.enter_state(contact, state);
        self.events.push(Event::new(self.now.t, self.world.contacts[contact].site, kind, released));
        self.count(contact);
    }

    /// Enters a change within a state, which is logged and is no event.
    fn enter_without_event(&mut self, contact: usize, closed: ClosedContact) {
        self.enter_state(contact, Contact::Closed(closed));
        self.count(contact);
    }

    /// Enters a contact's state from the time of the event on in its track and its log, with the origin of its anchor:
    /// the displacement of the node along the face from the placed to the reference poses.
    fn enter_state(&mut self, contact: usize, state: Contact) {
        let track = &mut self.world.contacts[contact];
        let way = match state {
            // The origin is kept as long as the node is the same.
            Contact::Closed(now) if track.state.closed().is_some_and(|before| before.place == now.place) => {
                track.log.way()
            }
            // Without friction there is no tangential spring and no anchor.
            Contact::Closed(now) if now.law.has_friction() => {
                let bases = track.slots.map(|slot| self.now.base(slot));
                reference_pose::way_to(&self.world.model.contacts[track.site], &track.place, bases)
            }
            _ => DVec2::ZERO,
        };
        (track.state, track.rearmed_at) = (state, None);
        track.log.push(self.now.t, state, way);
    }

    /// Counts a change of a contact; ends the run above [`CONTACT_EVENTS_PER_INSTANT`] or [`CONTACT_EVENTS_PER_TOUCH`].
    fn count(&mut self, contact: usize) {
        let t = self.now.t;
        let track = &mut self.world.contacts[contact];
        track.changes.count(t);
        let ChangeCount { of_touch: touch, at_instant: same, .. } = track.changes;
        if same > CONTACT_EVENTS_PER_INSTANT || touch > CONTACT_EVENTS_PER_TOUCH {
            let place = self.world.model.contacts[track.site].node.clone();
            self.schedule.give_up(t, place, message!("stop-alternates", "touch" => touch, "same" => same));
        }
    }

    /// Whether the projection of a node that has crossed the plane of a face is inside its polygon. Otherwise a miss is
    /// recorded and the contact is disarmed until its gap is positive again (`docs/physics.md#closing`).
    pub(in crate::dynamics) fn is_entry(&mut self, contact: usize) -> bool {
        if self.at().is_over(contact) {
            return true;
        }
        self.world.contacts[contact].closing = None;
        if self.at().edge(contact).is_some() {
            return false;
        }
        let (pair, disarmed) = (self.world.contacts[contact].pair, Contact::Open { armed: false });
        if self.world.model.pairs[self.world.pairs[pair].pair].met {
            // Between all faces of two bodies most crossings of a plane are beside the face.
            self.enter_state(contact, disarmed);
            self.count(contact);
        } else {
            self.log(contact, disarmed, EventKind::Missed, 0.0);
        }
        self.world.contacts[contact].changes.of_touch = 0;
        false
    }

    /// Places an edge node at the present crossing, up to `beyond` beyond the ends of the edges, where it may go on as far
    /// again \[m\].
    pub(super) fn place(&mut self, contact: usize, beyond: f64) {
        let place = self.crossing(contact, beyond).unwrap_or_default();
        self.world.contacts[contact].place = NodePlace { overhang: place.overhang + beyond, ..place };
    }

    /// Place of an edge node at the present crossing; `None` for a corner and where the edges cross more than `beyond` beyond
    /// their ends \[m\].
    pub(super) fn crossing(&self, contact: usize, beyond: f64) -> Option<NodePlace> {
        let edge = self.at().edge(contact)?;
        let [node, face] = self.at().sides(contact);
        Some(edge.place(&edge.crossing([&node, &face], edge.tolerance() + beyond)?))
    }

    /// Closing of a contact in stick or slip (`docs/physics.md#closing`); of bodies that have met, by the face of their least
    /// overlap.
    pub(in crate::dynamics) fn close(&mut self, contact: usize) {
        let by = self.at().entered_by(contact);
        if by == Some(contact) {
            self.close_at_face(contact);
            return;
        }
        self.world.contacts[contact].closing = None;
        self.enter_state(contact, Contact::Open { armed: false });
        if let Some(by) = by
            && self.world.contacts[by].state.closed().is_none()
            && !self.at().touches_elsewhere(by)
        {
            self.close_inside(by, 0.0);
        }
    }

    /// Closing of a contact whose node is at its face.
    fn close_at_face(&mut self, contact: usize) {
        self.place(contact, 0.0);
        let (.., here) = self.at().since(contact, &self.now.since);
        let law = contact_law::of(self.world, contact, self.now);
        let (mut tangential, mut normal) = here.relative_velocity(DVec2::ZERO);
        if normal == 0.0 && tangential == DVec2::ZERO {
            (tangential, normal) = self.at().relative_acceleration(contact, &here);
        }
        let law = law.begun(&here);
        let mode = law.on_closing(&here, tangential, normal);
        let regularisation = self.at().regularisation_length(contact, &law, &here);
        let place = self.world.contacts[contact].place;
        let closed = ClosedContact { place, ..ClosedContact::new(law, mode, regularisation) };
        let kind = match mode {
            Mode::Stick { .. } => EventKind::OpenToStick,
            Mode::Slip { .. } => EventKind::OpenToSlip,
        };
        self.world.contacts[contact].closing = None;
        self.world.contacts[contact].changes.of_touch = 0;
        // Round-off leaves an overlap at the crossing; its strain energy enters the ledger as a negative release.
        let appeared = -law.entry_energy(&here);
        self.log(contact, Contact::Closed(closed), kind, appeared);
    }

    /// Closing of a contact whose node is inside already, kept up to `kept` beyond the edges of its face \[m\]: the energy of
    /// its spring enters the ledger as a negative release.
    fn close_inside(&mut self, contact: usize, kept: f64) {
        let mut closed = self.closed_inside(contact);
        closed.solver.kept = kept;
        let (.., here) = self.at().since(contact, &self.now.since);
        let kind = match closed.mode {
            Mode::Stick { .. } => EventKind::OpenToStick,
            Mode::Slip { .. } => EventKind::OpenToSlip,
        };
        let track = &mut self.world.contacts[contact];
        (track.closing, track.changes.of_touch) = (None, 0);
        self.log(contact, Contact::Closed(closed), kind, -closed.law.entry_energy(&here));
    }

    /// State of a contact whose node is inside already: stick with the anchor at the projection, slip where `μ_s = 0`.
    fn closed_inside(&mut self, contact: usize) -> ClosedContact {
        let (.., here) = self.at().since(contact, &self.now.since);
        let law = contact_law::of(self.world, contact, self.now).begun(&here);
        let regularisation = self.at().regularisation_length(contact, &law, &here);
        let mode = if law.has_friction() {
            Mode::Stick { anchor: here.way }
        } else {
            let (sliding, _) = here.relative_velocity(DVec2::ZERO);
            Mode::Slip { direction: sliding.try_normalize().unwrap_or(DVec2::X) }
        };
        let place = self.world.contacts[contact].place;
        let mut closed = ClosedContact { place, ..ClosedContact::new(law, mode, regularisation) };
        closed.held_at_zero = law.clamp && law.normal.can_pull() && closed.kink(&here) > 0.0;
        closed
    }

    /// States at t = 0 of nodes behind the plane of their face: stick with the anchor at the projection where that is
    /// inside the polygon (slip where `μ_s = 0`), disarmed otherwise (`docs/physics.md#closing`).
    pub(in crate::dynamics) fn close_overlapping(&mut self) {
        let now = self.now;
        let as_placed: Vec<bool> = now.frames.iter().map(|frame| self.at().is_as_placed(frame)).collect();
        for contact in 0..self.world.contacts.len() {
            let ContactTrack { slots, sections, geometry, .. } = &self.world.contacts[contact];
            let mut sides = slots.iter().zip(sections).filter_map(|(slot, &own)| Some(((*slot)?, own)));
            if geometry.home_gap >= 0.0
                && sides.all(|(slot, own)| now.section(slot, own).is_some_and(|section| as_placed[section]))
            {
                continue;
            }
            if self.at().edge(contact).is_some() {
                if !self.at().is_over(contact) {
                    continue;
                }
                self.place(contact, 0.0);
            }
            let here = self.at().local(contact);
            let site = &self.world.model.contacts[self.world.contacts[contact].site];
            if here.gap >= 0.0 {
                continue;
            }
            // An edge node is at its crossing.
            let inside = site.beyond(&self.world.contacts[contact].place, &here) < 0.0;
            let inside = inside && self.at().is_opposed_most(contact) && !self.at().touches_elsewhere(contact);
            let state = if inside && self.at().begins_inside_by(contact) {
                Contact::Closed(self.closed_inside(contact))
            } else {
                Contact::Open { armed: false }
            };
            self.enter_state(contact, state);
        }
    }

    /// Breakaway, stop, opening and edge of a closed contact (`docs/physics.md#contact-events`).
    pub(in crate::dynamics) fn change(&mut self, contact: usize, reason: Reason) {
        let Some(closed) = self.world.contacts[contact].state.closed().copied() else { return };
        match reason {
            Reason::Opening => self.open(contact, &closed, EventKind::Opened),
            Reason::Edge if self.follow(contact, closed) => {}
            Reason::Edge => self.leave(contact, closed),
            Reason::Overlap => self.hand_over(contact, &closed),
            Reason::Switching => self.switch(contact, closed),
            Reason::Kink => {
                let (.., here) = self.at().since(contact, &self.now.since);
                self.enter_without_event(contact, closed.after_kink(&here));
            }
        }
    }

    /// A node leaves its face over an edge. Where the two bodies have met, still overlap, and no other contact carries that, the
    /// contact of their least overlap takes over: another one, or this one beyond the edge, for as much again.
    fn leave(&mut self, contact: usize, mut closed: ClosedContact) {
        let Some(least) = self.at().takes_over(contact) else {
            self.open(contact, &closed, EventKind::LeftFace);
            return;
        };
        if least.contact == contact {
            let site = &self.world.model.contacts[self.world.contacts[contact].site];
            closed.solver.kept = 2.0 * site.beyond(&closed.place, &self.at().local(contact)).max(least.depth);
            self.enter_without_event(contact, closed);
            return;
        }
        self.open(contact, &closed, EventKind::LeftFace);
        let open = self.world.contacts[least.contact].state.closed().is_none();
        // Where the pair faces each other, the vertex may have another node by now.
        let open = open && !self.at().is_carried_beside(contact, least.depth);
        if open && !self.at().touches_elsewhere(least.contact) {
            self.place(least.contact, 0.0);
            self.close_inside(least.contact, 2.0 * least.depth);
        }
    }

    /// The bodies of a contact, the deepest between them, come to overlap by more than its penetration: the contact of the least overlap
    /// takes over, at the same depth. Where there is none, or it is closed already, as much again is granted.
    fn hand_over(&mut self, contact: usize, closed: &ClosedContact) {
        let here = self.at().local(contact).penetration();
        let Some(ShortestWay { least, counts, contact: to }) = self.at().shortest_way(contact) else {
            self.world.contacts[contact].granted = f64::INFINITY;
            return;
        };
        let Some(to) = to.filter(|&to| self.world.contacts[to].state.closed().is_none()) else {
            self.world.contacts[contact].granted = 2.0 * (least - here).max(counts);
            return;
        };
        self.open(contact, closed, EventKind::LeftFace);
        for rival in self.world.contacts[to].rivals.clone() {
            if let Some(state) = self.world.contacts[rival].state.closed().copied() {
                self.open(rival, &state, EventKind::LeftFace);
            }
        }
        if self.world.contacts[to].state.closed().is_none() {
            self.place(to, 0.0);
            self.close_inside(to, 2.0 * least);
        }
    }

    pub(super) fn open(&mut self, contact: usize, closed: &ClosedContact, kind: EventKind) {
        self.world.contacts[contact].place = closed.place;
        let (.., here) = self.at().since(contact, &self.now.since);
        let released = closed.law.strain(&here, &closed.forces(&here));
        self.world.contacts[contact].granted = 0.0;
        self.log(contact, Contact::Open { armed: kind == EventKind::Opened }, kind, released);
        if kind == EventKind::LeftFace {
            self.pass_on(contact, closed);
        }
        let pair = self.world.contacts[contact].pair;
        let touching = self.world.pairs[pair].contacts.clone().any(|c| self.world.contacts[c].state.closed().is_some());
        if !touching {
            self.world.pairs[pair].sharers = 0;
        }
    }

    fn switch(&mut self, contact: usize, mut closed: ClosedContact) {
        let (.., here) = self.at().since(contact, &self.now.since);
        match closed.mode {
            Mode::Stick { anchor } => {
                let breakaway = closed.law.on_breakaway(anchor, &here);
                closed.mode = breakaway.mode;
                let ChangeCount { t, at_instant, .. } = self.world.contacts[contact].changes;
                closed.solver.retries = if t == self.now.t { u32::try_from(at_instant).unwrap_or(u32::MAX) } else { 0 };
                self.log(contact, Contact::Closed(closed), EventKind::StickToSlip, breakaway.released);
            }
            Mode::Slip { direction } => {
                if closed.law.v_stick > 0.0
                    && closed.law.friction == FrictionLaw::Paper
                    && !self.at().can_hold(contact, &closed)
                {
                    closed.solver.passing_stop = true;
                    self.enter_without_event(contact, closed);
                    return;
                }
                closed.solver.passing_stop = false;
                closed.mode = closed.law.on_stopping(direction, &here);
                closed.solver.retries = 0;
                self.log(contact, Contact::Closed(closed), EventKind::SlipToStick, 0.0);
            }
        }
    }
}
