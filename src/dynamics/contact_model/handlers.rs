//! What an event does: a planned step ends, a contact changes within it, a pair closes.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::dynamics::connection::Switch;
use crate::dynamics::contact_model::at_instant::{AtInstant, EventInstant};
use crate::dynamics::contact_model::run::ContactRun;
use crate::dynamics::contact_model::transitions;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::due::Due;
use crate::dynamics::penalty3d::island::{Distance, Island};
use crate::dynamics::world::tracks::Trajectory;

/// Changes of a contact at one instant from which on it alternates.
const ALTERNATES: usize = 2;

impl ContactRun {
    /// An island's planned step has come to its end, or to an event.
    pub(in crate::dynamics) fn end_step(&mut self, number: usize, t: f64) {
        let Some(mut island) = self.world.islands[number].take() else { return };
        self.commit_island(&mut island, t);
        if island.due.is_empty() && island.link_due.is_none() {
            self.go_on(number, island, t);
            return;
        }
        let states = (0..island.slots.len()).map(|index| island.state_at(&self.world.model, index, t)).collect();
        let now = EventInstant::of(&self.world, island.slots.clone(), island.bases.clone(), states, t);
        for (number, &contact) in island.contacts.iter().enumerate() {
            self.world.contacts[contact].state = Contact::Closed(island.closed_at(number, t));
        }
        let mut alternates = false;
        for Due { number, reason } in std::mem::take(&mut island.due) {
            let contact = island.contacts[number];
            self.transitions(&now).change(contact, reason);
            alternates |= self.world.contacts[contact].counted.2 > ALTERNATES;
        }
        if let Some(due) = island.link_due.take() {
            self.change_link(island.links[due.index].track, Switch::Function(due.switch), &now);
        }
        self.islands.take_back(number, &mut island);
        // Where neither stick nor slip lasts over a long step, the step follows from the contact's own period.
        self.form(now, if alternates { ControllerState::default() } else { island.pace() });
    }

    /// Plans the next step of an island whose step ended without an event.
    fn go_on(&mut self, number: usize, mut island: Box<Island>, t: f64) {
        let model = Arc::clone(&self.world.model);
        // At the end of the run no step would follow to be counted from there.
        if island.distance == Distance::Strayed && t < model.duration {
            self.rebase(&mut island, t);
        } else if model.ground.next_kink(island.from) <= t {
            island.rewind(&model, t);
        }
        let slots = island.slots.clone();
        self.world.islands[number] = Some(island);
        self.plan(number);
        self.search_around(&slots, t);
    }

    /// Counts an island's motion from the present poses of its bodies.
    fn rebase(&mut self, island: &mut Island, t: f64) {
        let model = Arc::clone(&self.world.model);
        island.rebase(&model);
        for (active, &contact) in island.active.iter().zip(&island.contacts) {
            let bases = [active.node, active.face].map(|side| island.bases.get(side?));
            transitions::enter(&mut self.world, contact, Contact::Closed(active.closed), bases, t);
        }
    }

    /// A pair's next closing is due, or its search has to go on.
    pub(in crate::dynamics) fn meet(&mut self, pair: usize, t: f64) {
        let limit = t + self.world.pairs[pair].together;
        let closes = |&c: &usize| self.world.contacts[c].closing.is_some_and(|at| at <= limit);
        let mut entered: Vec<usize> = self.world.pairs[pair].contacts.clone().filter(closes).collect();
        if entered.is_empty() {
            self.search(pair, t);
            return;
        }
        let mut slots: Vec<usize> = self.world.pairs[pair].slots.into_iter().flatten().collect();
        slots.sort_unstable();
        let seen = EventInstant::poses(&self.world, slots, t);
        // A node that comes within that of the others enters with them, but goes by at its own time.
        entered.retain(|&contact| {
            let due = self.world.contacts[contact].closing.is_some_and(|at| at <= t);
            if due {
                self.transitions(&seen).enters(contact)
            } else {
                AtInstant { world: &self.world, now: &seen }.is_over(contact)
            }
        });
        if entered.is_empty() {
            self.search(pair, t);
            return;
        }
        let (now, pace) = self.release(&seen.slots, t);
        for contact in entered {
            self.transitions(&now).close(contact);
        }
        // A blow is over within a radian of its contact. The error estimate of an implicit step does not see what decays
        // within the step: one as long as those of a lasting contact would end at rest behind the blow.
        self.form(now, if pace.stiff { ControllerState { step: 0.0, ..pace } } else { pace });
    }

    /// Ends the trajectories of bodies, and of all in an island with them, at `t`: the bodies as they are then, and the step
    /// that their integrators would have taken.
    pub(in crate::dynamics) fn release(&mut self, slots: &[usize], t: f64) -> (EventInstant, ControllerState) {
        let mut all = BTreeSet::new();
        let mut pace = ControllerState::default();
        for &slot in slots {
            match self.world.bodies[slot].now {
                Trajectory::Placed | Trajectory::Flight(_) => {
                    all.insert(slot);
                }
                Trajectory::Island { island, .. } => {
                    if let Some(island) = &self.world.islands[island] {
                        all.extend(island.slots.iter().copied());
                        pace = pace.with(island.pace());
                    }
                }
            }
        }
        let slots: Vec<usize> = all.into_iter().collect();
        let (bases, states) = slots.iter().map(|&slot| self.world.caught(slot, t)).unzip();
        self.retire_islands(&slots, t);
        (EventInstant::of(&self.world, slots, bases, states, t), pace)
    }

    fn retire_islands(&mut self, slots: &[usize], t: f64) {
        let mut numbers = BTreeSet::new();
        for &slot in slots {
            if let Trajectory::Island { island, .. } = self.world.bodies[slot].now {
                numbers.insert(island);
            }
        }
        for number in numbers {
            self.schedule.queue.remove(Self::island(number));
            if let Some(mut island) = self.world.islands[number].take() {
                self.commit_island(&mut island, t);
                for n in 0..island.contacts.len() {
                    self.world.contacts[island.contacts[n]].state = Contact::Closed(island.closed_at(n, t));
                }
                self.islands.take_back(number, &mut island);
            }
        }
    }
}
