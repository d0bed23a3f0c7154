//! The run of one group of bodies under the contact model: setup at t = 0, planning of steps, searches, and the end
//! of the run.
//!
//! Every body has a trajectory beyond the present time: a flight in closed form, or the planned step of its island.
//! Every pair has the time of its next closing on these trajectories. An event changes the trajectories of the bodies
//! that it concerns and the searches of their pairs, and no others.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::closing::{link_closing, next_closing};
use crate::dynamics::contact_model::at_instant::EventInstant;
use crate::dynamics::contact_model::constants::WORK_BOUND_PER_BODY;
use crate::dynamics::contact_model::event_forecast::earliest_change;
use crate::dynamics::contact_model::islands::{IslandStock, Start, end_flight};
use crate::dynamics::contact_model::step_store::StepStore;
use crate::dynamics::contact_model::transitions::Transitions;
use crate::dynamics::event_loop::event_queue::Source;
use crate::dynamics::event_loop::mechanics::Mechanics;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::integrator::constants::WORTHWHILE_CUT;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::penalty3d::constants::SIMULTANEOUS_PHASE;
use crate::dynamics::penalty3d::due::Due;
use crate::dynamics::penalty3d::event_location;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::penalty3d::link_events;
use crate::dynamics::record::event::Event;
use crate::dynamics::trajectory::segment::{Segment, SegmentMotion};
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{BodyTrack, Trajectory};

/// Ranks of the sources of events: at equal times an island's event precedes a pair's, a pair's precedes a link's.
const ISLAND: usize = 0;
const PAIR: usize = 1;
const LINK: usize = 2;

/// The run of one group of bodies under the contact model.
#[derive(Debug)]
pub struct ContactRun {
    pub(in crate::dynamics) world: World,
    pub(in crate::dynamics) schedule: Schedule,
    pub(in crate::dynamics) events: Vec<Event>,
    pub(in crate::dynamics) islands: IslandStock,
    pub(in crate::dynamics) store: StepStore,
}

impl ContactRun {
    /// An island as a source of events: the end of its planned step, or an event within it.
    pub(in crate::dynamics) fn island(number: usize) -> Source {
        Source { rank: ISLAND, number }
    }

    /// A pair as a source of events: its closing, or the end of its search.
    pub(in crate::dynamics) fn pair(number: usize) -> Source {
        Source { rank: PAIR, number }
    }

    /// A link as a source of events: the beginning of its force, or the end of its search.
    pub(in crate::dynamics) fn link(number: usize) -> Source {
        Source { rank: LINK, number }
    }

    /// Sets up a group of bodies, by its number in the model, at t = 0.
    pub fn new(model: &Arc<Model>, group: usize) -> Self {
        let mut run = Self {
            world: World::of(model, group),
            schedule: Schedule::default(),
            events: Vec::new(),
            islands: IslandStock::default(),
            store: StepStore::default(),
        };
        run.begin();
        run
    }

    /// A run that stops at t = 0 for `reason`.
    pub(in crate::dynamics) fn refused(model: &Arc<Model>, group: usize, reason: &str) -> Self {
        let mut run = Self::new(model, group);
        let slots: Vec<usize> = (0..run.world.bodies.len()).collect();
        let names = run.names(&slots);
        run.schedule.give_up(0.0, names, reason.to_owned());
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
        let now = EventInstant::of(&self.world, slots, bases, states, 0.0);
        self.begin_links(&now);
        self.transitions(&now).close_overlapping();
        self.rebuild(now, ControllerState::default());
    }

    /// Ends all trajectories at the time that the run has reached; that time \[s\].
    pub(in crate::dynamics) fn end(&mut self) -> f64 {
        let end = self.schedule.reached(self.world.model.duration);
        self.commit_all(end);
        self.world.bodies.iter_mut().for_each(|track| track.path.shrink());
        self.world.contacts.iter_mut().for_each(|track| track.log.shrink());
        self.store.replay.shrink();
        self.events.shrink_to_fit();
        end
    }

    /// Access to the contacts for transitions at the time of an event.
    pub(in crate::dynamics) fn transitions<'a>(&'a mut self, now: &'a EventInstant) -> Transitions<'a> {
        Transitions { world: &mut self.world, events: &mut self.events, schedule: &mut self.schedule, now }
    }

    /// Gives bodies their new trajectories from the time of the event on: bodies joined by closed contacts or acting
    /// devices form islands; of the others planar ones fly in closed form and spatial ones are integrated alone.
    /// `pace` is the method and the length of the islands' first steps.
    pub(in crate::dynamics) fn rebuild(&mut self, now: EventInstant, pace: ControllerState) {
        let EventInstant { t, slots, bases, mut states, .. } = now;
        let mut new_islands = Vec::new();
        for members in self.world.joined(&slots) {
            let first = slots[members[0]];
            let alone = members.len() == 1 && !self.world.is_joined(first);
            let start = if alone {
                let state = &mut states[members[0]];
                let body = &self.world.model.bodies[self.world.bodies[first].body];
                body.restore(&bases[members[0]].numbers(), state);
                if self.world.bodies[first].system.is_some() {
                    self.start_flight(first, state, t);
                    continue;
                }
                Start { members: &[first], bases: vec![body.placed()], y: state.clone(), t }
            } else {
                let y: Vec<f64> = members.iter().flat_map(|&i| states[i].iter().copied()).collect();
                let bases = members.iter().map(|&i| bases[i]).collect();
                Start { members: &members.iter().map(|&i| slots[i]).collect::<Vec<_>>(), bases, y, t }
            };
            let pace = if alone { ControllerState::default() } else { pace };
            new_islands.push(self.islands.create(&mut self.world, &self.store, start, pace));
        }
        for island in new_islands {
            self.plan(island);
        }
        self.search_around(&slots, t);
    }

    fn start_flight(&mut self, slot: usize, state: &[f64], t: f64) {
        end_flight(&mut self.world, slot, t);
        let track = &mut self.world.bodies[slot];
        if let Some(system) = &track.system {
            track.now = Trajectory::Flight(system.fly(t, state));
        }
    }

    /// Plans an island's next step and locates the first event within it.
    pub(in crate::dynamics) fn plan(&mut self, number: usize) {
        let model = Arc::clone(&self.world.model);
        let Some(mut island) = self.world.islands[number].take() else { return };
        let from = island.until;
        if from >= model.duration {
            island.from = from;
            self.world.islands[number] = Some(island);
            return;
        }
        let cap = model.duration.min(model.ground.next_kink(from));
        self.schedule.effort.steps += 1;
        let pace = island.pace();
        let going_on = pace.stiff && pace.step > 0.0;
        let forecast =
            if going_on { earliest_change(&self.world, &island, WORTHWHILE_CUT * pace.step) } else { f64::INFINITY };
        let due = match island.plan(&model, cap, forecast) {
            Err(error) => {
                let reason = format!(
                    "the step fell to {:.1e} s; a lower stiffness or a larger tolerance would be followed",
                    error.step
                );
                self.schedule.give_up(from, self.names(&island.slots), reason);
                island.until
            }
            Ok(()) => self.find_due(&mut island).map_or(island.until, |t| t.max(from)),
        };
        self.schedule.queue.set(Self::island(number), due);
        self.world.islands[number] = Some(island);
    }

    /// Enters in the island the first event within its planned step; its time. Of events of a contact and a device at
    /// equal times the contact's comes first; the device's is located at the start of the next step.
    fn find_due(&mut self, island: &mut Island) -> Option<f64> {
        let contacts = self.first_due(island);
        let link = link_events::first_due(&self.world.model, island);
        match (contacts, link) {
            (Some((t, _)), Some((earlier, due))) if earlier < t => {
                island.link_due = Some(due);
                Some(earlier)
            }
            (Some((t, due)), _) => {
                island.due = due;
                Some(t)
            }
            (None, Some((t, due))) => {
                island.link_due = Some(due);
                Some(t)
            }
            (None, None) => None,
        }
    }

    /// The first events of an island's contacts within its planned step, and their time. An event well inside the
    /// step has the step retaken to end at it.
    fn first_due(&mut self, island: &mut Island) -> Option<(f64, Vec<Due>)> {
        let (model, simultaneity) = (Arc::clone(&self.world.model), SIMULTANEOUS_PHASE / island.omega());
        let (t, due) = event_location::first_due(&model, island, simultaneity)?;
        if !island.end_beyond(&model, t) {
            return Some((t, due));
        }
        self.schedule.effort.steps += 1;
        event_location::first_due(&model, island, simultaneity)
    }

    /// Searches the next closing of every pair and the next beginning of every link's force of these bodies.
    pub(in crate::dynamics) fn search_around(&mut self, slots: &[usize], t: f64) {
        for pair in self.world.pairs_of(slots) {
            self.search(pair, t);
        }
        // A device whose force acts is not in the queue: its island finds the end of the phase.
        for link in self.world.links_of(slots) {
            if !self.world.link_acts(link) {
                self.search_link(link, t);
            }
        }
    }

    /// Searches the next closing of a pair from `t` on and enters it in the queue.
    pub(in crate::dynamics) fn search(&mut self, pair: usize, t: f64) {
        let found = next_closing::search(&mut self.world, pair, t);
        self.enter(Self::pair(pair), found);
    }

    /// Searches the beginning of a link's force from `t` on and enters it in the queue.
    pub(in crate::dynamics) fn search_link(&mut self, link: usize, t: f64) {
        let found = link_closing::search(&mut self.world, link, t);
        self.enter(Self::link(link), found);
    }

    /// Enters the result of a search in the queue and counts its work.
    fn enter(&mut self, source: Source, found: NextClosing) {
        self.schedule.effort.searches += 1;
        self.schedule.effort.looks += found.evaluations;
        self.schedule.work += found.work;
        if found.due.is_finite() {
            self.schedule.queue.set(source, found.due);
        } else {
            self.schedule.queue.remove(source);
        }
    }

    /// Writes all trajectories up to `t` into the paths of their bodies.
    fn commit_all(&mut self, t: f64) {
        for track in &mut self.world.bodies {
            if let Trajectory::Flight(flight) = &track.now {
                let segment = track.flown(flight, t);
                if track.path.is_empty() { track.path.push_only(segment) } else { track.path.push(segment) }
            }
        }
        for island in 0..self.world.islands.len() {
            if let Some(mut island) = self.world.islands[island].take() {
                self.commit_island(&mut island, t);
            }
        }
    }

    /// Writes an island's planned step up to `until` into the paths of its bodies.
    pub(in crate::dynamics) fn commit_island(&mut self, island: &mut Island, until: f64) {
        if until <= island.from {
            return;
        }
        let world = &mut self.world;
        if let Some(number) = self.store.keep_start(world, island) {
            for &slot in &island.slots {
                world.bodies[slot].path.push(Segment {
                    from: island.from,
                    until,
                    path: SegmentMotion::Recomputed(number),
                });
            }
            return;
        }
        for (index, &slot) in island.slots.iter().enumerate() {
            if let Some(piece) = island.path(index) {
                self.store.polynomials += piece.bytes();
                let path = SegmentMotion::Step(piece);
                world.bodies[slot].path.push(Segment { from: island.from, until, path });
            }
        }
        for (number, &contact) in island.contacts.iter().enumerate() {
            if let Some(angle) = island.angle_path(number) {
                world.contacts[contact].log.angles.push((island.from, angle));
            }
        }
    }

    /// Names of bodies by their slots.
    pub(in crate::dynamics) fn names(&self, slots: &[usize]) -> String {
        let name = |&slot: &usize| self.world.model.bodies[self.world.bodies[slot].body].name.as_str();
        slots.iter().map(name).collect::<Vec<_>>().join(", ")
    }
}

impl Mechanics for ContactRun {
    fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    fn schedule_mut(&mut self) -> &mut Schedule {
        &mut self.schedule
    }

    fn duration(&self) -> f64 {
        self.world.model.duration
    }

    fn exceeds_bounds(&mut self, _: f64) -> bool {
        self.schedule.work > WORK_BOUND_PER_BODY * self.world.bodies.len()
    }

    fn excess(&self, source: Source) -> (String, String) {
        let slots: Vec<usize> = match source {
            Source { rank: ISLAND, number } => {
                self.world.islands[number].as_ref().map(|island| island.slots.clone()).unwrap_or_default()
            }
            Source { rank: PAIR, number } => self.world.pairs[number].slots.into_iter().flatten().collect(),
            Source { number, .. } => self.world.links[number].slots.into_iter().flatten().collect(),
        };
        let reason = format!(
            "{} steps and evaluations exceed the bound on the work of a run: a contact, a bearing or the ground is far too fast for \
             the duration; lower its stiffness or frequency, or shorten the run",
            self.schedule.work
        );
        (self.names(&slots), reason)
    }

    fn handle(&mut self, source: Source, t: f64) {
        match source {
            Source { rank: ISLAND, number } => self.end_step(number, t),
            Source { rank: PAIR, number } => self.close_pair(number, t),
            Source { number, .. } => self.begin_force(number, t),
        }
    }

    fn states(&self, t: f64) -> Vec<(usize, Vec<f64>)> {
        self.world.bodies.iter().enumerate().map(|(slot, track)| (track.body, self.world.state(slot, t))).collect()
    }
}
