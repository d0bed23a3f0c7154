//! New trajectories after something happened: bodies that touch are integrated together, the others fly.

use std::sync::Arc;

use crate::dynamics::closing::next_closing;
use crate::dynamics::event_loop::contact_engine::{Engine, Trajectory};
use crate::dynamics::event_loop::event_queue::Item;
use crate::dynamics::event_loop::transitions::Juncture;
use crate::dynamics::integrator::step_control::{Pace, WORTHWHILE};
use crate::dynamics::model::reference_pose::Base;
use crate::dynamics::model::{reference_pose, rigid_body};
use crate::dynamics::penalty3d::equations_of_motion::Active;
use crate::dynamics::penalty3d::event_forecast::soonest;
use crate::dynamics::penalty3d::event_location;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::trajectory::segment::{Path, Segment};

impl Engine {
    /// Gives bodies at `t` their new trajectories: those that touch form islands, the others fly (planar) or go alone.
    pub(in crate::dynamics) fn form(&mut self, now: Juncture, pace: Pace) {
        let Juncture { t, slots, bases, mut states, .. } = now;
        let mut new_islands = Vec::new();
        for members in self.touching(&slots) {
            let first = slots[members[0]];
            let alone = members.len() == 1 && !self.is_touching(first);
            if alone {
                let state = &mut states[members[0]];
                bases[members[0]].add(state);
                if self.bodies[first].system.is_some() {
                    self.fly(first, state, t);
                } else {
                    let placed = Base::placed(self.model.kind, &self.model.bodies[self.bodies[first].body]);
                    new_islands.push(self.found(&[first], vec![placed], state.clone(), t, Pace::default()));
                }
            } else {
                let y: Vec<f64> = members.iter().flat_map(|&i| states[i].iter().copied()).collect();
                let bases = members.iter().map(|&i| bases[i]).collect();
                let members: Vec<usize> = members.into_iter().map(|i| slots[i]).collect();
                new_islands.push(self.found(&members, bases, y, t, pace));
            }
        }
        for island in new_islands {
            self.plan(island);
        }
        self.predict_around(&slots, t);
    }

    pub(in crate::dynamics) fn fly(&mut self, slot: usize, state: &[f64], t: f64) {
        self.end_flight(slot, t);
        let track = &mut self.bodies[slot];
        let mut planar = [0.0; 6];
        planar.copy_from_slice(&state[..6]);
        if let Some(system) = &track.system {
            track.now = Trajectory::Flight(system.fly(t, planar));
        }
    }

    /// Puts the flight that a body was on into its path.
    pub(in crate::dynamics) fn end_flight(&mut self, slot: usize, t: f64) {
        let track = &mut self.bodies[slot];
        if let Trajectory::Flight(flight) = &mut track.now
            && t > flight.start
        {
            let mut flight = flight.clone();
            if let Some(system) = &track.system {
                system.remember(&mut flight, t);
            }
            track.path.push(Segment { from: flight.start, until: t, path: Path::Flight(Box::new(flight)) });
        }
    }

    /// Founds an island of bodies at `t`, with what their states in `y` are counted from; returns its number.
    pub(in crate::dynamics) fn found(
        &mut self,
        members: &[usize],
        mut bases: Vec<Base>,
        y: Vec<f64>,
        t: f64,
        pace: Pace,
    ) -> usize {
        let number = self.vacant.pop().unwrap_or_else(|| {
            self.islands.push(None);
            self.islands.len() - 1
        });
        for (index, &slot) in members.iter().enumerate() {
            self.end_flight(slot, t);
            self.bodies[slot].now = Trajectory::Island { island: number, index };
            if self.keeps_starts() && bases[index].kept.is_none() && bases[index].flown.is_none() {
                let width = rigid_body::width(self.model.kind);
                bases[index].flown = self.landing(slot, &bases[index], &y[index * width..(index + 1) * width], t);
            }
        }
        let mut island = Box::new(self.assemble(members, bases, y, t, pace));
        island.borrow(self.spare.pop());
        self.islands[number] = Some(island);
        number
    }

    /// An island of bodies with the closed contacts between them.
    pub(in crate::dynamics) fn assemble(
        &self,
        members: &[usize],
        bases: Vec<Base>,
        y: Vec<f64>,
        t: f64,
        pace: Pace,
    ) -> Island {
        let index = |slot: Option<usize>| slot.and_then(|s| members.binary_search(&s).ok());
        let active: Vec<(usize, Active)> = self
            .pairs_of(members)
            .into_iter()
            .flat_map(|pair| self.pairs[pair].contacts.clone())
            .filter_map(|contact| {
                let track = &self.contacts[contact];
                let closed = *track.state.closed()?;
                let [node, face] = track.slots.map(index);
                let sides = [node, face].map(|i| bases.get(i?));
                let home = reference_pose::seen_from(&self.model.contacts[track.site], sides, closed.at);
                Some((contact, Active { site: track.site, node, face, closed, home, angle: None }))
            })
            .collect();
        let bodies = members.iter().map(|&slot| self.bodies[slot].body).collect();
        let mut island = Island::new(&self.model, members.to_vec(), (bodies, bases), active, y, t, pace);
        island.taken = members.iter().map(|&slot| self.bodies[slot].path.len()).max().unwrap_or(0);
        island
    }

    /// Plans an island's next step and what is due in it.
    pub(in crate::dynamics) fn plan(&mut self, number: usize) {
        let model = Arc::clone(&self.model);
        let Some(mut island) = self.islands[number].take() else { return };
        let from = island.until;
        if from >= model.duration {
            island.from = from;
            self.islands[number] = Some(island);
            return;
        }
        let cap = model.duration.min(model.ground.next_kink(from));
        self.effort.steps += 1;
        let pace = island.pace();
        let going_on = pace.stiff && pace.step > 0.0;
        let soon = if going_on { soonest(self, &island, WORTHWHILE * pace.step) } else { f64::INFINITY };
        let outcome = island.plan(&model, cap, soon);
        if let Err(error) = outcome {
            let names: Vec<&str> =
                island.slots.iter().map(|&s| model.bodies[self.bodies[s].body].name.as_str()).collect();
            self.give_up(
                from,
                names.join(", "),
                format!(
                    "the step fell to {:.1e} s; a lower stiffness or a larger tolerance would be followed",
                    error.step
                ),
            );
        } else if let Some((t, due)) = self.first_due(&mut island) {
            island.due = due;
            self.agenda.set(Item::Island(number), t.max(from));
            self.islands[number] = Some(island);
            return;
        }
        self.agenda.set(Item::Island(number), island.until);
        self.islands[number] = Some(island);
    }

    /// What is due first within an island's planned step, and when.
    fn first_due(&mut self, island: &mut Island) -> Option<(f64, Vec<event_location::Due>)> {
        let (model, together) = (Arc::clone(&self.model), 1e-9 / island.omega());
        let (t, due) = event_location::first_due(&model, island, together)?;
        if !island.end_beyond(&model, t, &due) {
            return Some((t, due));
        }
        self.effort.steps += 1;
        event_location::first_due(&model, island, together)
    }

    /// The pairs that bodies are in, rising.
    pub(in crate::dynamics) fn pairs_of(&self, slots: &[usize]) -> Vec<usize> {
        let mut pairs: Vec<usize> = slots.iter().flat_map(|&slot| self.bodies[slot].pairs.iter().copied()).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    pub(in crate::dynamics) fn predict_around(&mut self, slots: &[usize], t: f64) {
        for pair in self.pairs_of(slots) {
            next_closing::pair(self, pair, t);
        }
    }

    /// Groups of positions in `slots` whose bodies a chain of closed contacts joins.
    pub(in crate::dynamics) fn touching(&self, slots: &[usize]) -> Vec<Vec<usize>> {
        let mut label: Vec<usize> = (0..slots.len()).collect();
        let position = |slot: usize| slots.binary_search(&slot).ok();
        for &slot in slots {
            for &pair in &self.bodies[slot].pairs {
                let track = &self.pairs[pair];
                let closed = track.contacts.clone().any(|c| self.contacts[c].state.closed().is_some());
                if let (true, [Some(a), Some(b)]) = (closed, track.slots.map(|s| s.and_then(position))) {
                    let (low, high) = (label[a].min(label[b]), label[a].max(label[b]));
                    label.iter_mut().filter(|l| **l == high).for_each(|l| *l = low);
                }
            }
        }
        let mut groups: Vec<Vec<usize>> = vec![Vec::new(); slots.len()];
        for (i, &l) in label.iter().enumerate() {
            groups[l].push(i);
        }
        groups.retain(|g| !g.is_empty());
        groups
    }

    pub(in crate::dynamics) fn is_touching(&self, slot: usize) -> bool {
        self.bodies[slot]
            .pairs
            .iter()
            .any(|&pair| self.pairs[pair].contacts.clone().any(|c| self.contacts[c].state.closed().is_some()))
    }
}
