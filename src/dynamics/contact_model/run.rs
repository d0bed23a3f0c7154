//! The run of one group of bodies under the contact model: its parts, setup at t = 0, new trajectories after an event,
//! and the end of the run.
//!
//! Every body has a trajectory beyond the present time: a flight in closed form, or the planned step of its island.
//! Every pair has the time of its next closing on these trajectories. An event changes the trajectories of the bodies
//! that it concerns and the searches of their pairs, and no others.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::contact_model::closing_search::ClosingSearch;
use crate::dynamics::contact_model::contact_closing::ContactClosing;
use crate::dynamics::contact_model::contact_states::ContactStates;
use crate::dynamics::contact_model::event_poses::EventPoses;
use crate::dynamics::contact_model::event_source::EventSource;
use crate::dynamics::contact_model::event_state::EventBodies;
use crate::dynamics::contact_model::islands::{IslandStock, Start, end_flight};
use crate::dynamics::contact_model::link_transitions::LinkTransitions;
use crate::dynamics::contact_model::step_planning;
use crate::dynamics::contact_model::step_store::StepStore;
use crate::dynamics::event_loop::event_driven::EventDriven;
use crate::dynamics::event_loop::event_queue::Source;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::event_loop::work_bounds::{Spent, WorkBounds};
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::record::event::Event;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{BodyTrack, Trajectory};
use crate::language::{Message, Text, message};

/// The run of one group of bodies under the contact model.
#[derive(Debug)]
pub struct ContactRun {
    /// Bodies, pairs, contacts, links and islands at the present time.
    pub(in crate::dynamics) world: World,
    /// Queue of events, counted work and early stop.
    pub(in crate::dynamics) schedule: Schedule,
    /// Events of contacts so far.
    pub(in crate::dynamics) events: Vec<Event>,
    /// Numbers and integrators of ended islands.
    pub(in crate::dynamics) island_stock: IslandStock,
    /// Store of the steps.
    pub(in crate::dynamics) store: StepStore,
    /// Bounds that end the run.
    bounds: WorkBounds,
}

impl ContactRun {
    /// Sets up a group of bodies, by its number in the model, at t = 0.
    pub fn new(model: &Arc<Model>, group: usize) -> Self {
        let mut run = Self {
            world: World::of(model, group),
            schedule: Schedule::default(),
            events: Vec::new(),
            island_stock: IslandStock::default(),
            store: StepStore::default(),
            bounds: WorkBounds::default(),
        };
        run.begin();
        run
    }

    /// A run that stops at t = 0 for `reason`.
    pub(in crate::dynamics) fn refused(model: &Arc<Model>, group: usize, reason: Text) -> Self {
        let mut run = Self::new(model, group);
        let names = run.world.names(0..run.world.bodies.len());
        run.schedule.give_up(0.0, names, reason.into());
        run
    }

    /// Sets the states at t = 0: nodes that overlap start in stick, every body gets a trajectory.
    fn begin(&mut self) {
        let model = Arc::clone(&self.world.model);
        let slots: Vec<usize> = (0..self.world.bodies.len()).collect();
        let start = |track: &BodyTrack| {
            let body = &model.bodies[track.body];
            let mut state = body.initial();
            (body.rebase(&mut state), state)
        };
        let (bases, states) = self.world.bodies.iter().map(start).unzip();
        let now = EventBodies::of(&self.world, slots, bases, states, 0.0);
        self.link_transitions(&now).begin();
        ContactClosing { states: &mut self.contact_states(&now) }.close_overlapping();
        self.rebuild(now, ControllerState::default());
    }

    /// Ends all trajectories at the time that the run has reached; that time \[s\].
    pub(in crate::dynamics) fn end(&mut self) -> f64 {
        let end = self.schedule.reached(self.world.model.duration);
        self.store.commit_all(&mut self.world, end);
        self.world.bodies.iter_mut().for_each(|track| track.path.shrink());
        self.world.contacts.iter_mut().for_each(|track| track.log.shrink());
        self.store.recomputed.shrink();
        self.events.shrink_to_fit();
        end
    }

    /// Access to the states of the contacts at the time of an event.
    pub(in crate::dynamics) fn contact_states<'a>(&'a mut self, now: &'a EventBodies) -> ContactStates<'a> {
        ContactStates { world: &mut self.world, events: &mut self.events, schedule: &mut self.schedule, now }
    }

    /// Access to the devices for changes of phase at the time of an event.
    pub(in crate::dynamics) fn link_transitions<'a>(&'a mut self, now: &'a EventBodies) -> LinkTransitions<'a> {
        LinkTransitions { world: &mut self.world, schedule: &mut self.schedule, now }
    }

    /// Searches on the present trajectories.
    pub(in crate::dynamics) fn search(&mut self) -> ClosingSearch<'_> {
        ClosingSearch { world: &mut self.world, schedule: &mut self.schedule }
    }

    /// Gives bodies their new trajectories from the time of the event on: bodies joined by closed contacts or acting
    /// devices form islands, but for linear blocks with nothing else on them, which fly in closed form; of the others planar
    /// ones fly and spatial ones are integrated alone.
    /// `controller` is the method and the length of the islands' first steps.
    pub(in crate::dynamics) fn rebuild(&mut self, now: EventBodies, controller: ControllerState) {
        let EventBodies { poses: EventPoses { t, slots, .. }, bases, mut states, .. } = now;
        let mut new_islands = Vec::new();
        for members in self.world.joined(&slots) {
            let together: Vec<usize> = members.iter().map(|&i| slots[i]).collect();
            if self.world.moves_as_block(&together) {
                for &i in &members {
                    let body = self.world.model_body(slots[i]);
                    body.restore(&bases[i].numbers(), &mut states[i]);
                }
                let states: Vec<&[f64]> = members.iter().map(|&i| states[i].as_slice()).collect();
                self.start_block(&together, &states, t);
                continue;
            }
            let first = slots[members[0]];
            let alone = members.len() == 1 && !self.world.is_joined(first);
            let may_fly = members.len() == 1 && !alone && self.world.bodies[first].free_motion.is_some();
            let springs = if may_fly { self.world.ground_springs(first) } else { None };
            let start = if alone || springs.is_some() {
                let state = &mut states[members[0]];
                let body = self.world.model_body(first);
                body.restore(&bases[members[0]].numbers(), state);
                let flight = match &springs {
                    Some(springs) => self.world.fly_on(first, state, t, springs),
                    None => self.world.fly(first, state, t),
                };
                if let Some(flight) = flight {
                    end_flight(&mut self.world, first, t);
                    self.world.bodies[first].now = Trajectory::Flight(flight);
                    continue;
                }
                let placed = self.world.model_body(first).placed();
                Start { members: &[first], bases: vec![placed], y: state.clone(), t }
            } else {
                let y: Vec<f64> = members.iter().flat_map(|&i| states[i].iter().copied()).collect();
                let bases = members.iter().map(|&i| bases[i]).collect();
                Start { members: &together, bases, y, t }
            };
            let controller = if alone { ControllerState::default() } else { controller };
            new_islands.push(self.island_stock.create(&mut self.world, &self.store, start, controller));
        }
        for island in new_islands {
            step_planning::plan(&mut self.world, &mut self.schedule, island);
        }
        self.search().around(&slots, t);
    }

    /// Begins the flights of a block's bodies, which are in these states.
    fn start_block(&mut self, slots: &[usize], states: &[&[f64]], t: f64) {
        for (own, &slot) in slots.iter().enumerate() {
            end_flight(&mut self.world, slot, t);
            let track = &mut self.world.bodies[slot];
            let flight = track.free_motion.as_ref().and_then(|free_motion| free_motion.fly_among(t, states, own));
            if let Some(flight) = flight {
                track.now = Trajectory::Flight(flight);
            }
        }
    }

    /// Cost of the run at `t`: work, and memory \[bytes\] of steps, of a time and a code per path segment, and of events.
    fn spent(&self, t: f64) -> Spent {
        let paths: usize = self.world.bodies.iter().map(|track| track.path.len()).sum();
        let steps =
            self.store.polynomial_bytes + self.store.recomputed.bytes() + paths * (size_of::<f64>() + size_of::<u32>());
        Spent {
            work: self.schedule.work,
            bytes: steps + self.events.len() * size_of::<Event>(),
            memory: self.world.model.memory_bytes,
            events: self.events.len(),
            touches: self.world.contacts.iter().any(|track| track.state.closed().is_some()),
            t,
            duration: self.world.model.duration,
            bodies: [self.world.bodies.len(), self.world.model.bodies.len()],
        }
    }
}

impl EventDriven for ContactRun {
    fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    fn schedule_mut(&mut self) -> &mut Schedule {
        &mut self.schedule
    }

    fn duration(&self) -> f64 {
        self.world.model.duration
    }

    fn exceeded(&mut self, t: f64) -> Option<Message> {
        if !self.bounds.is_due(self.schedule.work) {
            return None;
        }
        let spent = self.spent(t);
        self.bounds.exceeded(&spent).map(|bound| message!("stop-too-fast", "spent" => bound.spent()))
    }

    fn place(&self, source: Source) -> String {
        let world = &self.world;
        match source.into() {
            EventSource::Island(number) => {
                world.islands[number].as_ref().map_or(String::new(), |island| world.names(island.slots.iter().copied()))
            }
            EventSource::Pair(number) => world.names(world.pairs[number].slots.into_iter().flatten()),
            EventSource::Link(number) => world.names(world.links[number].slots.into_iter().flatten()),
        }
    }

    fn handle(&mut self, source: Source, t: f64) {
        match source.into() {
            EventSource::Island(number) => self.end_step(number, t),
            EventSource::Pair(number) => self.close_pair(number, t),
            EventSource::Link(number) => self.change_phase(number, t),
        }
    }

    fn states(&self, t: f64) -> Vec<(usize, Vec<f64>)> {
        self.world.bodies.iter().enumerate().map(|(slot, track)| (track.body, self.world.state(slot, t))).collect()
    }

    fn name(&self, body: usize) -> String {
        self.world.model.bodies[body].name.clone()
    }
}
