//! States of the contacts of a group of bodies at an event: what they are, how another one is entered, logged and counted
//! (`docs/physics.md#contact-events`). What changes them are parts of their own: `ContactClosing`, `Transitions` of closed ones,
//! `VertexNodes`.

use glam::DVec2;

use crate::contact::Local;
use crate::dynamics::ContactSite;
use crate::dynamics::contact_model::constants::{CONTACT_EVENTS_PER_INSTANT, CONTACT_EVENTS_PER_TOUCH};
use crate::dynamics::contact_model::event_state::{EventBodies, EventContacts};
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::model::reference_pose;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::record::event::{Event, EventKind};
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::ChangeCount;
use crate::language::message;

/// Contacts of a group of bodies during an event.
pub(in crate::dynamics) struct ContactStates<'a> {
    /// Constant data and present states of the group.
    pub world: &'a mut World,
    /// Events of the run, to which those of this instant are added.
    pub events: &'a mut Vec<Event>,
    /// Progress of the run, stopped where a contact exceeds its number of events.
    pub schedule: &'a mut Schedule,
    /// States of the bodies that the event concerns.
    pub now: &'a EventBodies,
}

impl ContactStates<'_> {
    /// The contacts as they are now.
    pub(super) fn at(&self) -> EventContacts<'_> {
        EventContacts { world: self.world, now: self.now }
    }

    /// Enters a contact's state with its event and the energy that is released with it \[J\].
    pub(super) fn log(&mut self, contact: usize, state: Contact, kind: EventKind, released: f64) {
        self.enter_state(contact, state);
        self.events.push(Event::new(self.now.t, self.world.contacts[contact].site, kind, released));
        self.count(contact);
    }

    /// Forgets how K and C are divided in a contact's pair once none of its contacts is closed: the next touch divides them anew.
    pub(super) fn forget_sharers_of_open(&mut self, contact: usize) {
        let pair = self.world.contacts[contact].pair;
        let mut contacts = self.world.pairs[pair].contacts.clone();
        if !contacts.any(|c| self.world.is_closed(c)) {
            self.world.pairs[pair].sharers = 0;
        }
    }

    /// Enters a state, or a change within one, that is logged and counted and is no event.
    pub(super) fn enter_without_event(&mut self, contact: usize, state: Contact) {
        self.enter_state(contact, state);
        self.count(contact);
    }

    /// Enters a contact's state from the time of the event on in its track and its log, with the origin of its anchor:
    /// the displacement of the node along the face from the placed to the reference poses.
    pub(super) fn enter_state(&mut self, contact: usize, mut state: Contact) {
        if let (Contact::Closed(now), None) = (&mut state, self.world.contacts[contact].state.closed()) {
            let site = self.site(contact);
            let (beyond, over) =
                (now.solver.handover_distance.unwrap_or(0.0), site.over_edge(&self.at().local(contact)));
            now.solver.handover_distance = (site.around.is_some() && over < beyond).then_some(beyond);
        }
        let track = &mut self.world.contacts[contact];
        let way = match state {
            // The origin is kept as long as the node is the same.
            Contact::Closed(now) if track.state.closed().is_some_and(|before| before.place == now.place) => {
                track.log.way()
            }
            // Without friction there is no tangential spring and no anchor.
            Contact::Closed(now) if now.law.has_friction() => {
                let bases = track.slots.map(|slot| self.now.base(slot));
                reference_pose::way_to(&self.world.model.sites[track.site], &track.place, bases)
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
            let node = self.world.model.sites[track.site].node.clone();
            self.schedule.give_up(t, node, message!("stop-alternates", "touch" => touch, "same" => same));
        }
    }

    /// Places an edge node at the present crossing, up to `beyond` beyond the ends of the edges, where it may go on as far
    /// again \[m\].
    pub(super) fn set_place(&mut self, contact: usize, beyond: f64) {
        let place = self.crossing(contact, beyond).unwrap_or_default();
        self.world.contacts[contact].place = NodePlace { overhang: place.overhang + beyond, ..place };
    }

    /// Place of an edge node at the present crossing; `None` for a corner and where the edges cross more than `beyond` beyond
    /// their ends \[m\].
    pub(super) fn crossing(&self, contact: usize, beyond: f64) -> Option<NodePlace> {
        let edge = self.at().edge(contact)?;
        let [node, face] = self.at().sides(contact);
        Some(edge.place(&edge.crossing([&node, &face], edge.tolerance + beyond)?))
    }

    /// The site of a contact in the model.
    pub(super) fn site(&self, contact: usize) -> &ContactSite {
        self.world.site(contact)
    }

    /// Node relative to face, from the reference poses.
    pub(super) fn here(&self, contact: usize) -> Local {
        self.at().relative(contact, &self.now.since).local
    }

    /// Strain energy in the springs of a contact in state `closed` \[J\].
    pub(super) fn strain(&self, contact: usize, closed: &ClosedContact) -> f64 {
        let here = self.here(contact);
        closed.law.strain(&here, &closed.forces(&here))
    }
}
