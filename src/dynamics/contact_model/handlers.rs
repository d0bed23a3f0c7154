//! Event handlers: end of a planned step, transition of a contact within it, closing of a pair, beginning of a
//! link's force or end of its phase in flight.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::dynamics::connection::Switch;
use crate::dynamics::contact_model::constants::ALTERNATING_EVENTS;
use crate::dynamics::contact_model::contact_closing::ContactClosing;
use crate::dynamics::contact_model::contact_states;
use crate::dynamics::contact_model::event_poses::{ContactPoses, EventPoses};
use crate::dynamics::contact_model::event_source::EventSource;
use crate::dynamics::contact_model::event_state::EventBodies;
use crate::dynamics::contact_model::run::ContactRun;
use crate::dynamics::contact_model::step_planning;
use crate::dynamics::contact_model::transitions::Transitions;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::due::Due;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::world::tracks::Trajectory;

impl ContactRun {
    /// Handles the end of an island's planned step or the event within it: the step is committed as far as `t`,
    /// contacts and devices change state, and trajectories are rebuilt.
    pub(in crate::dynamics) fn end_step(&mut self, number: usize, t: f64) {
        let Some(mut island) = self.world.islands[number].take() else { return };
        self.store.commit(&mut self.world, &mut island, t);
        if island.step.due.is_empty() && island.step.link_due.is_none() {
            self.continue_island(number, island, t);
            return;
        }
        let states = (0..island.slots.len()).map(|index| island.state_at(&self.world.model, index, t)).collect();
        let now = EventBodies::of(&self.world, island.slots.clone(), island.system.bases.clone(), states, t);
        self.note_states(&island, t);
        let mut alternates = false;
        for Due { index: number, reason } in std::mem::take(&mut island.step.due) {
            let contact = island.contacts[number];
            Transitions { states: &mut self.contact_states(&now) }.change(contact, reason);
            alternates |= self.world.contacts[contact].changes.at_instant > ALTERNATING_EVENTS;
        }
        if let Some(due) = island.step.link_due.take() {
            let link = island.system.links[due.index].track;
            self.link_transitions(&now).change(link, Switch::Function(due.switch));
        }
        self.island_stock.take_back(number, &mut island);
        // Under alternating stick and slip the next step length follows from the island's frequency.
        self.rebuild(now, if alternates { ControllerState::default() } else { island.stepper.controller_state() });
    }

    /// Plans the next step of an island whose step ended without an event, and searches the pairs of its bodies again.
    fn continue_island(&mut self, number: usize, mut island: Box<Island>, t: f64) {
        let model = Arc::clone(&self.world.model);
        if model.next_kink(island.step.from) <= t {
            island.rewind(&model, t);
        }
        let slots = island.slots.clone();
        self.world.islands[number] = Some(island);
        step_planning::plan(&mut self.world, &mut self.schedule, number);
        self.search().around(&slots, t);
    }

    /// Handles the closing of a pair at `t` with all contacts that close within its simultaneity interval; continues
    /// the search where none is due.
    pub(in crate::dynamics) fn close_pair(&mut self, pair: usize, t: f64) {
        let limit = t + self.world.pairs[pair].simultaneity;
        let closes = |&c: &usize| self.world.contacts[c].found.closing.is_some_and(|at| at <= limit);
        let mut entered: Vec<usize> = self.world.pairs[pair].contacts.clone().filter(closes).collect();
        if entered.is_empty() {
            self.search().pair(pair, t);
            return;
        }
        let seen = EventPoses::of(&self.world, ascending(self.world.pairs[pair].slots), t);
        // A node that closes within the interval after `t` closes at `t`; a miss is recorded at its own time only.
        entered.retain(|&contact| {
            let over = ContactPoses { world: &self.world, now: &seen }.is_over(contact);
            if !over && self.world.contacts[contact].found.closing.is_some_and(|at| at <= t) {
                contact_states::miss(&mut self.world, &mut self.schedule, &mut self.events, contact, t);
            }
            over
        });
        if entered.is_empty() {
            self.search().pair(pair, t);
            return;
        }
        let (now, controller) = self.end_trajectories(&seen.slots, t);
        for contact in entered {
            ContactClosing { states: &mut self.contact_states(&now) }.close(contact);
        }
        self.rebuild(now, first_of_touch(controller));
    }

    /// Handles the beginning of a link's force at `t`, or the end of its phase on a body in flight; continues the search where
    /// none is due.
    pub(in crate::dynamics) fn change_phase(&mut self, number: usize, t: f64) {
        let Some((_, event)) = self.world.links[number].ends.filter(|(at, _)| *at <= t) else {
            self.search().link(number, t);
            return;
        };
        let (now, controller) = self.end_trajectories(&ascending(self.world.links[number].slots), t);
        self.link_transitions(&now).change(number, event);
        self.rebuild(now, first_of_touch(controller));
    }

    /// Ends at `t` the trajectories of bodies and of all bodies in an island or a block with them: their states, and the method
    /// and length of their integrators' next steps.
    pub(in crate::dynamics) fn end_trajectories(&mut self, slots: &[usize], t: f64) -> (EventBodies, ControllerState) {
        let mut all = BTreeSet::new();
        let mut controller = ControllerState::default();
        for &slot in slots {
            match self.world.bodies[slot].now {
                Trajectory::Placed | Trajectory::Flight(_) => all.extend(self.world.flies_with(slot)),
                Trajectory::Island { island, .. } => {
                    if let Some(island) = &self.world.islands[island] {
                        all.extend(island.slots.iter().copied());
                        controller = controller.with(island.stepper.controller_state());
                    }
                }
            }
        }
        let slots: Vec<usize> = all.into_iter().collect();
        let (bases, states) = slots.iter().map(|&slot| self.world.state_from_reference(slot, t)).unzip();
        self.end_islands(&slots, t);
        (EventBodies::of(&self.world, slots, bases, states, t), controller)
    }

    /// Stores in the tracks the states at `t` of an island's contacts, and the phases and memories of its devices.
    fn note_states(&mut self, island: &Island, t: f64) {
        for (number, &contact) in island.contacts.iter().enumerate() {
            self.world.contacts[contact].state = Contact::Closed(island.closed_at(number, t));
        }
        for (index, link) in island.system.links.iter().enumerate().filter(|(_, link)| link.evolving.is_some()) {
            self.world.links[link.track].phase = island.phase_at(index, t);
        }
    }

    /// Ends at `t` the islands of these bodies, within their planned steps.
    fn end_islands(&mut self, slots: &[usize], t: f64) {
        let island_of = |&slot: &usize| match self.world.bodies[slot].now {
            Trajectory::Island { island, .. } => Some(island),
            Trajectory::Placed | Trajectory::Flight(_) => None,
        };
        let numbers: BTreeSet<usize> = slots.iter().filter_map(island_of).collect();
        for number in numbers {
            self.schedule.queue.remove(EventSource::Island(number).into());
            if let Some(mut island) = self.world.islands[number].take() {
                self.store.commit(&mut self.world, &mut island, t);
                self.note_states(&island, t);
                self.island_stock.take_back(number, &mut island);
            }
        }
    }
}

/// Slots of the bodies of a pair or a link, ascending; ground and abutments have none.
fn ascending(slots: [Option<usize>; 2]) -> Vec<usize> {
    let mut slots: Vec<usize> = slots.into_iter().flatten().collect();
    slots.sort_unstable();
    slots
}

/// Method and length of the first step after a closing from those before it. An impact lasts about a radian of the
/// contact's oscillation, and the error estimate of an implicit step is blind to a motion that decays within the step:
/// the length of an implicit one follows from the island's frequency.
fn first_of_touch(controller: ControllerState) -> ControllerState {
    if controller.stiff { ControllerState { step: 0.0, ..controller } } else { controller }
}
