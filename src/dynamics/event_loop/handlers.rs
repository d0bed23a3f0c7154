//! What happens when something is due: a planned step ends, a contact changes, a pair meets.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::contact::Frame;
use crate::dynamics::closing::next_closing;
use crate::dynamics::event_loop::contact_engine::{Engine, Trajectory};
use crate::dynamics::event_loop::event_queue::Item;
use crate::dynamics::event_loop::transitions::Juncture;
use crate::dynamics::integrator::step_control::Pace;
use crate::dynamics::model::reference_pose::Base;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::event_location::Due;
use crate::dynamics::penalty3d::island::{Distance, Island};
use crate::dynamics::trajectory::segment::{Path, Segment};

/// Changes of a contact at one instant from which on it alternates.
const ALTERNATES: usize = 2;

impl Engine {
    pub(in crate::dynamics) fn commit_all(&mut self, t: f64) {
        for slot in 0..self.bodies.len() {
            if let Trajectory::Flight(flight) = &mut self.bodies[slot].now {
                let mut flight = flight.clone();
                let track = &mut self.bodies[slot];
                if let Some(system) = &track.system {
                    system.remember(&mut flight, t);
                }
                let segment = Segment { from: flight.start, until: t, path: Path::Flight(Box::new(flight)) };
                if track.path.is_empty() { track.path.push_only(segment) } else { track.path.push(segment) }
            }
        }
        for island in 0..self.islands.len() {
            if let Some(mut island) = self.islands[island].take() {
                self.commit_island(&mut island, t);
            }
        }
    }

    /// Writes an island's planned step into the paths of its bodies, as far as `until`.
    pub(in crate::dynamics) fn commit_island(&mut self, island: &mut Island, until: f64) {
        if until <= island.from {
            return;
        }
        if let Some(number) = self.keep_again(island) {
            for &slot in &island.slots {
                self.bodies[slot].path.push(Segment { from: island.from, until, path: Path::Again(number) });
            }
            return;
        }
        for (index, &slot) in island.slots.iter().enumerate() {
            if let Some(piece) = island.path(&self.model, index) {
                self.polynomials += piece.bytes();
                let path = Path::Step(piece);
                self.bodies[slot].path.push(Segment { from: island.from, until, path });
            }
        }
        for (number, &contact) in island.contacts.iter().enumerate() {
            if let Some(angle) = island.angle_path(number) {
                self.contacts[contact].log.angles.push((island.from, angle));
            }
        }
    }

    /// An island's planned step has come to its end, or to an event.
    pub(in crate::dynamics) fn commit_step(&mut self, number: usize, t: f64) {
        let Some(mut island) = self.islands[number].take() else { return };
        self.commit_island(&mut island, t);
        if island.due.is_empty() {
            let model = Arc::clone(&self.model);
            // At the very end no step would follow to be counted so.
            if island.distance == Distance::Strayed && t < model.duration {
                self.rebase(&mut island, t);
            } else if model.ground.next_kink(island.from) <= t {
                island.rewind(&model, t);
            }
            let slots = island.slots.clone();
            self.islands[number] = Some(island);
            self.plan(number);
            self.predict_around(&slots, t);
            return;
        }
        self.vacant.push(number);
        let states = (0..island.slots.len()).map(|index| island.state_at(&self.model, index, t)).collect();
        let now = self.instant(island.slots.clone(), island.bases.clone(), states, t);
        for (number, &contact) in island.contacts.iter().enumerate() {
            self.contacts[contact].state = Contact::Closed(island.closed_at(number, t));
        }
        let mut alternates = false;
        for Due { number, reason } in std::mem::take(&mut island.due) {
            let contact = island.contacts[number];
            self.change(contact, reason, &now);
            alternates |= self.contacts[contact].counted.2 > ALTERNATES;
        }
        self.spare.extend(island.give_back());
        // Where neither stick nor slip lasts over a long step, the contact's own swing decides.
        self.form(now, if alternates { Pace::default() } else { island.pace() });
    }

    /// Counts an island's motion from where its bodies are.
    fn rebase(&mut self, island: &mut Island, t: f64) {
        let model = Arc::clone(&self.model);
        island.rebase(&model);
        for (active, &contact) in island.active.iter().zip(&island.contacts) {
            let bases = [active.node, active.face].map(|side| island.bases.get(side?));
            self.enter(contact, Contact::Closed(active.closed), bases, t);
        }
    }

    /// Bodies at an instant, with what their states are counted from.
    pub(in crate::dynamics) fn instant(
        &self,
        slots: Vec<usize>,
        bases: Vec<Base>,
        states: Vec<Vec<f64>>,
        t: f64,
    ) -> Juncture {
        let body = |slot: usize| &self.model.bodies[self.bodies[slot].body];
        let since = |((&slot, base), state): ((&usize, &Base), &Vec<f64>)| base.since(body(slot), state);
        let since: Vec<Frame> = slots.iter().zip(&bases).zip(&states).map(since).collect();
        let frames = bases.iter().zip(&since).map(|(base, since)| base.whole(since)).collect();
        Juncture { t, slots, bases, states, frames, since }
    }

    /// A pair's next crossing is due, or its search has to go on.
    pub(in crate::dynamics) fn meet(&mut self, pair: usize, t: f64) {
        let limit = t + self.pairs[pair].together;
        let due: Vec<usize> = self.pairs[pair]
            .contacts
            .clone()
            .filter(|&c| self.contacts[c].closing.is_some_and(|at| at <= limit))
            .collect();
        if due.is_empty() {
            next_closing::pair(self, pair, t);
            return;
        }
        let mut slots: Vec<usize> = self.pairs[pair].slots.into_iter().flatten().collect();
        slots.sort_unstable();
        let frames = slots.iter().map(|&slot| self.frame(slot, t)).collect();
        let seen = Juncture { t, slots, bases: Vec::new(), states: Vec::new(), frames, since: Vec::new() };
        let mut entered = due;
        // A node that comes within that of the others enters with them, but goes by at its own time.
        entered.retain(|&contact| {
            let due = self.contacts[contact].closing.is_some_and(|at| at <= t);
            if due { self.enters(contact, &seen) } else { self.is_over(contact, &seen) }
        });
        if entered.is_empty() {
            next_closing::pair(self, pair, t);
            return;
        }
        let (now, pace) = self.release(&seen.slots, t);
        for contact in entered {
            self.close(contact, &now);
        }
        // A blow is over within a radian of its contact. An implicit step as long as those of a contact that lasts would
        // end at rest behind it, as if it were right: what decays at once does not count in its estimate.
        self.form(now, if pace.stiff { Pace { step: 0.0, ..pace } } else { pace });
    }

    /// Ends the trajectories of bodies, and of everyone in an island with them, at `t`: how they are then, and the step
    /// that their integrators would have taken.
    pub(in crate::dynamics) fn release(&mut self, slots: &[usize], t: f64) -> (Juncture, Pace) {
        let mut all = BTreeSet::new();
        let mut pace = Pace::default();
        for &slot in slots {
            match self.bodies[slot].now {
                Trajectory::Flight(_) => {
                    all.insert(slot);
                }
                Trajectory::Island { island, .. } => {
                    if let Some(island) = &self.islands[island] {
                        all.extend(island.slots.iter().copied());
                        pace = pace.with(island.pace());
                    }
                }
            }
        }
        let slots: Vec<usize> = all.into_iter().collect();
        let (bases, states) = slots.iter().map(|&slot| self.caught(slot, t)).unzip();
        self.retire_islands(&slots, t);
        (self.instant(slots, bases, states, t), pace)
    }

    pub(in crate::dynamics) fn retire_islands(&mut self, slots: &[usize], t: f64) {
        let mut numbers = BTreeSet::new();
        for &slot in slots {
            if let Trajectory::Island { island, .. } = self.bodies[slot].now {
                numbers.insert(island);
            }
        }
        for number in numbers {
            self.agenda.remove(Item::Island(number));
            if let Some(mut island) = self.islands[number].take() {
                self.vacant.push(number);
                self.commit_island(&mut island, t);
                for n in 0..island.contacts.len() {
                    self.contacts[island.contacts[n]].state = Contact::Closed(island.closed_at(n, t));
                }
                self.spare.extend(island.give_back());
            }
        }
    }
}
