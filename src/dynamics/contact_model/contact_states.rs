//! States of the contacts of a group of bodies at an event: what they are, how another one is entered, logged and counted
//! (`docs/physics.md#contact-events`). What changes them are parts of their own: `ContactClosing`, `Transitions` of closed ones,
//! `VertexNodes`.

use glam::{DVec2, DVec3};

use crate::contact::{Law, Local, locate};
use crate::dynamics::ContactSite;
use crate::dynamics::contact_model::constants::{CONTACT_EVENTS_PER_INSTANT, CONTACT_EVENTS_PER_TOUCH};
use crate::dynamics::contact_model::contact_law;
use crate::dynamics::contact_model::event_poses::ContactPoses;
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
    /// The contacts with the states of their bodies.
    pub(super) fn at(&self) -> EventContacts<'_> {
        EventContacts { world: self.world, now: self.now }
    }

    /// The contacts in the poses of their bodies.
    pub(super) fn poses(&self) -> ContactPoses<'_> {
        ContactPoses { world: self.world, now: &self.now.poses }
    }

    /// Enters a contact's state with its event and the energy that is released with it \[J\].
    pub(super) fn log(&mut self, contact: usize, state: Contact, kind: EventKind, released: f64) {
        self.enter_state(contact, state);
        self.events.push(Event::new(self.now.poses.t, self.world.contacts[contact].site, kind, released));
        count(self.world, self.schedule, contact, self.now.poses.t);
    }

    /// Opens a contact in this state by itself.
    pub(super) fn open(&mut self, contact: usize, closed: &ClosedContact, kind: EventKind) {
        let track = &mut self.world.contacts[contact];
        (track.place, track.tolerated) = (closed.place, 0.0);
        let released = self.strain(contact, closed);
        let armed = kind == EventKind::Opened && !self.is_displaced_behind(contact);
        self.log(contact, Contact::Open { armed }, kind, released);
    }

    /// Whether a corner that was displaced along the normal when it took over, so that the energy of its spring was that of the node
    /// before it, has a negative gap without that displacement. Armed, it would close at once at that gap, and its spring would gain energy
    /// that no other spring released.
    fn is_displaced_behind(&self, contact: usize) -> bool {
        let (site, [node, face]) = (self.site(contact), self.poses().sides(contact));
        let is_displaced = site.edge.is_none() && self.world.contacts[contact].place.shift != DVec3::ZERO;
        is_displaced && locate(&site.geometry, &node, &face).gap < 0.0
    }

    /// Law with which a contact closes: with its part of K and C, which the first contact of a pair that closes divides.
    pub(super) fn law_at_closing(&mut self, contact: usize) -> Law {
        contact_law::divide(self.world, self.world.contacts[contact].pair, &self.now.poses);
        contact_law::of(self.world, contact)
    }

    /// Resets the shares of K and C of a contact's pair once all its contacts are open: the next touch divides them anew.
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
        count(self.world, self.schedule, contact, self.now.poses.t);
    }

    /// Enters a contact's state from the time of the event on in its track and its log, with the origin of its anchor:
    /// the displacement of the node along the face from the placed to the reference poses.
    pub(super) fn enter_state(&mut self, contact: usize, mut state: Contact) {
        if let (Contact::Closed(now), None) = (&mut state, self.world.contacts[contact].state.closed()) {
            let site = self.site(contact);
            let (beyond, over) =
                (now.solver.handover_distance.unwrap_or(0.0), site.over_edge(&self.poses().local(contact)));
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
        track.enter(self.now.poses.t, state, way);
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
        let edge = self.poses().edge(contact)?;
        let [node, face] = self.poses().sides(contact);
        Some(edge.place(&edge.crossing([&node, &face], edge.tolerance + beyond)?))
    }

    /// State of a closed contact; `None` of an open one.
    pub(super) fn closed(&self, contact: usize) -> Option<ClosedContact> {
        self.world.contacts[contact].state.closed().copied()
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

/// Counts a change of a contact at `t`; ends the run above [`CONTACT_EVENTS_PER_INSTANT`] or [`CONTACT_EVENTS_PER_TOUCH`].
fn count(world: &mut World, schedule: &mut Schedule, contact: usize, t: f64) {
    let track = &mut world.contacts[contact];
    track.changes.count(t);
    let ChangeCount { of_touch: touch, at_instant: same, .. } = track.changes;
    if same > CONTACT_EVENTS_PER_INSTANT || touch > CONTACT_EVENTS_PER_TOUCH {
        let node = world.model.sites[track.site].node.clone();
        schedule.give_up(t, node, message!("stop-alternates", "touch" => touch, "same" => same));
    }
}

/// Disarms at `t` a contact whose node has crossed the plane of its face beside the polygon, until its gap is positive again
/// (`docs/physics.md#closing`). What two bodies declared to face each other miss is an event.
pub(super) fn miss(world: &mut World, schedule: &mut Schedule, events: &mut Vec<Event>, contact: usize, t: f64) {
    let declared = !world.model_pair(world.contacts[contact].pair).met;
    world.contacts[contact].found.closing = None;
    if world.edge(contact).is_some() {
        return;
    }
    let track = &mut world.contacts[contact];
    track.enter(t, Contact::Open { armed: false }, DVec2::ZERO);
    if declared {
        events.push(Event::new(t, track.site, EventKind::Missed, 0.0));
    }
    count(world, schedule, contact, t);
    world.contacts[contact].changes.of_touch = 0;
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::penalty3d::example::{closed, stick, wall};

    /// A girder flush at its wall with both corners in stick, at 0.5 s, under a model that is changed so.
    fn at_wall(change: fn(&mut Model)) -> (World, EventBodies) {
        let (mut model, active) = closed(&wall(), stick);
        change(&mut model);
        let mut world = World::of(&Arc::new(model), 0);
        for contact in active {
            let track = world.contacts.iter_mut().find(|track| track.site == contact.site).expect("a contact");
            track.state = Contact::Closed(contact.closed);
        }
        let body = &world.model.bodies[0];
        let (state, base) = (body.initial(), body.placed());
        let now = EventBodies::of(&world, vec![0], vec![base], vec![state], 0.5);
        (world, now)
    }

    #[test]
    fn an_opened_contact_forgets_the_overlap_that_was_tolerated_while_it_was_closed() {
        for (kind, armed) in [(EventKind::Opened, true), (EventKind::LeftFace, false)] {
            let (mut world, now) = at_wall(|_| ());
            world.contacts[0].tolerated = f64::INFINITY;
            let (mut events, mut schedule) = (Vec::new(), Schedule::default());
            let mut states =
                ContactStates { world: &mut world, events: &mut events, schedule: &mut schedule, now: &now };
            let state = states.closed(0).expect("a closed contact");
            states.open(0, &state, kind);
            assert!(states.closed(0).is_none() && states.closed(1).is_some(), "by itself");
            let track = &world.contacts[0];
            assert!(matches!(track.state, Contact::Open { armed: is } if is == armed), "{:?}", track.state);
            assert_eq!((track.tolerated, track.place), (0.0, state.place));
            assert_eq!((events.len(), events[0].kind, events[0].t), (1, kind, 0.5));
        }
    }

    #[test]
    fn a_miss_of_declared_faces_is_an_event_and_one_between_all_faces_is_not() {
        for (change, logged) in [((|_| ()) as fn(&mut Model), 1), (|model| model.pairs[0].met = true, 0)] {
            let (mut world, _) = at_wall(change);
            (world.contacts[0].state, world.contacts[0].found.closing) = (Contact::Open { armed: true }, Some(0.5));
            let (mut events, mut schedule) = (Vec::new(), Schedule::default());
            miss(&mut world, &mut schedule, &mut events, 0, 0.5);
            let track = &world.contacts[0];
            assert!(
                matches!(track.state, Contact::Open { armed: false }) && track.found.closing.is_none(),
                "{track:?}"
            );
            assert_eq!((events.len(), track.changes.of_touch, track.changes.at_instant), (logged, 0, 1));
        }
    }
}
