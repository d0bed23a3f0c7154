//! A group of bodies at an event, for the unit tests of the contact model.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::contact_model::contact_states::ContactStates;
use crate::dynamics::contact_model::event_poses::ContactPoses;
use crate::dynamics::contact_model::event_state::EventBodies;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::model::coordinates::planar::PlanarState;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::record::event::{Event, EventKind};
use crate::dynamics::world::World;

/// Time of the event \[s\].
pub(super) const TIME: f64 = 0.5;

/// A group of bodies at [`TIME`], with what the handling of the event adds.
pub(super) struct AtEvent {
    pub(super) world: World,
    pub(super) now: EventBodies,
    pub(super) events: Vec<Event>,
    pub(super) schedule: Schedule,
}

impl AtEvent {
    /// With these contacts closed, and all bodies of the model in these states `x, y, θ, ẋ, ẏ, θ̇` since they were placed; in space
    /// without rotation.
    pub(super) fn of(model: Model, active: &[ActiveContact], states: &[PlanarState]) -> Self {
        let mut world = World::of(&Arc::new(model), 0);
        for contact in active {
            let track = world.contacts.iter_mut().find(|track| track.site == contact.site).expect("a contact");
            track.state = Contact::Closed(contact.closed);
        }
        let state = |(slot, &[x, y, angle, u, v, spin]): (usize, &PlanarState)| {
            let body = world.model_body(slot);
            let (mut state, rates) = (body.initial(), body.positions());
            (state[0], state[1], state[rates], state[rates + 1]) = (x, y, u, v);
            if state.len() == states[slot].len() {
                (state[2], state[5]) = (angle, spin);
            }
            state
        };
        let all: Vec<Vec<f64>> = states.iter().enumerate().map(state).collect();
        let slots: Vec<usize> = (0..all.len()).collect();
        let bases = slots.iter().map(|&slot| world.model_body(slot).placed()).collect();
        let now = EventBodies::of(&world, slots, bases, all, TIME);
        Self { world, now, events: Vec::new(), schedule: Schedule::default() }
    }

    pub(super) fn states(&mut self) -> ContactStates<'_> {
        let Self { world, now, events, schedule } = self;
        ContactStates { world, events, schedule, now }
    }

    pub(super) fn poses(&self) -> ContactPoses<'_> {
        ContactPoses { world: &self.world, now: &self.now.poses }
    }

    /// The closed state of a contact; `None` of an open one.
    pub(super) fn closed(&self, contact: usize) -> Option<ClosedContact> {
        self.world.contacts[contact].state.closed().copied()
    }

    /// Contacts and kinds of the events so far.
    pub(super) fn kinds(&self) -> Vec<(usize, EventKind)> {
        let contact = |event: &Event| self.world.contacts.iter().position(|track| track.site == event.site());
        self.events.iter().filter_map(|event| Some((contact(event)?, event.kind))).collect()
    }

    /// Energy that was released by the events so far \[J\].
    pub(super) fn released(&self) -> f64 {
        self.events.iter().map(|event| event.released).sum()
    }
}
