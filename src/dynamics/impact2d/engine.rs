//! The event loop of the impact model for one group of bodies: flights in closed form, hits found to rounding, lasting
//! contact in steps.

use std::sync::Arc;

use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::event_loop::event_queue::Source;
use crate::dynamics::event_loop::mechanics::Mechanics;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::free_flight::flight::{Planar, System};
use crate::dynamics::impact2d::Few;
use crate::dynamics::impact2d::closing::gap_derivatives::Aim;
use crate::dynamics::impact2d::closing::next_impact;
use crate::dynamics::impact2d::lasting::lasting_contact::{Ending, Grip};
use crate::dynamics::impact2d::record::{Record, Stay};
use crate::dynamics::impact2d::tracks::{BodyTrack, Going, PairTrack, SiteTrack};
use crate::dynamics::model::rigid_body;
use crate::dynamics::trajectory::segment::{Path, Segment};
use crate::dynamics::world::site_geometry::SiteGeometry;

/// Hits, searches and steps per body after which a run gives up.
const WORK: usize = 3_000_000;
/// Changes at one instant after which a run gives up.
const SAME_INSTANT: usize = 200;
/// Changes at one instant after which lasting contact lasts for a moment: pushes that are rounding may change sides for ever.
const RESTLESS: usize = 50;
/// That moment, in parts of the run.
const MOMENT: f64 = 1e-3;
/// A point that has lifted off without speed is met again this much behind the face, in parts of its size: nearer is
/// rounding.
pub(in crate::dynamics::impact2d) const SINK: f64 = 1e-12;

/// The run of one group of bodies under the impact model.
#[derive(Debug)]
pub struct Engine {
    pub(in crate::dynamics::impact2d) model: Arc<Model>,
    pub(in crate::dynamics) bodies: Vec<BodyTrack>,
    pub(in crate::dynamics::impact2d) pairs: Vec<PairTrack>,
    pub(in crate::dynamics::impact2d) sites: Vec<SiteTrack>,
    pub(in crate::dynamics::impact2d) grips: Vec<Option<Grip>>,
    pub(in crate::dynamics) schedule: Schedule,
    pub(in crate::dynamics) record: Record,
    /// Fastest that anybody has been, and farthest from home, corners included \[m/s\], \[m\].
    pub(in crate::dynamics::impact2d) largest: [f64; 2],
    same: (f64, usize),
}

impl Engine {
    /// Lasting contact as a source of events: its planned step ends.
    pub(super) fn lasting(number: usize) -> Source {
        Source { rank: 0, number }
    }

    /// A pair as a source of events: it meets, or its search goes on.
    pub(super) fn pair(number: usize) -> Source {
        Source { rank: 1, number }
    }

    /// Sets up a group of bodies, by its number in the model, at t = 0.
    pub fn new(model: &Arc<Model>, group: usize) -> Self {
        let mut engine = Self {
            model: Arc::clone(model),
            bodies: Vec::new(),
            pairs: Vec::new(),
            sites: Vec::new(),
            grips: Vec::new(),
            schedule: Schedule::default(),
            record: Record::default(),
            largest: [0.0; 2],
            same: (-1.0, 0),
        };
        engine.gather(group);
        engine.begin();
        engine
    }

    fn gather(&mut self, number: usize) {
        let model = Arc::clone(&self.model);
        let group = &model.groups[number];
        for &body in group {
            let system = System::new(&model.bodies[body], &model.ground, model.duration);
            let initial = rigid_body::initial(model.kind, &model.bodies[body]);
            let state: Planar = std::array::from_fn(|i| initial[i]);
            let now = Going::Flight(system.fly(0.0, state));
            let (segments, pairs) = (Vec::new(), Vec::new());
            self.bodies.push(BodyTrack {
                body,
                system,
                now,
                segments,
                since: 0.0,
                state: crate::dynamics::impact2d::State::Free,
                pairs,
            });
        }
        for &number in &model.group_pairs[number] {
            let pair = &model.pairs[number];
            let slots = pair.bodies.map(|side| side.and_then(|b| group.binary_search(&b).ok()));
            let from = self.sites.len();
            for site in pair.contacts.clone() {
                let contact = &model.contacts[site];
                let side = |owner: Option<usize>| owner.map(|b| usize::from(pair.bodies[0] != Some(b)));
                let spot = SiteGeometry::of(&model, site);
                self.sites.push(SiteTrack {
                    number: site,
                    sides: [side(contact.node_body), side(contact.face_body)],
                    sink: SINK * spot.size,
                    spot,
                    aim: Aim::of(&model, site),
                    kept: false,
                    armed: true,
                    lifted: false,
                    left: false,
                    out: None,
                });
            }
            for slot in slots.into_iter().flatten() {
                self.bodies[slot].pairs.push(self.pairs.len());
            }
            self.pairs.push(PairTrack { number, slots, sites: from..self.sites.len(), meets: false });
        }
    }

    fn too_many_at(&mut self, t: f64) -> bool {
        self.same = if self.same.0 == t { (t, self.same.1 + 1) } else { (t, 1) };
        self.same.1 > SAME_INSTANT + 4 * self.pairs.len() + 2 * self.bodies.len()
    }

    /// Names of bodies by their numbers in the model.
    pub(in crate::dynamics::impact2d) fn names(&self, bodies: &[usize]) -> String {
        bodies.iter().map(|&b| self.model.bodies[b].name.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// Looks for a pair's next meeting from `t` and enters it.
    pub(in crate::dynamics::impact2d) fn seek(&mut self, pair: usize, t: f64) {
        for site in self.pairs[pair].sites.clone() {
            let track = &mut self.sites[site];
            if track.out.take().is_some_and(|at| at <= t) {
                track.arm();
            }
        }
        let found = next_impact::pair(self, pair, t);
        self.pairs[pair].meets = found.meets;
        if found.due.is_finite() {
            self.schedule.queue.set(Self::pair(pair), found.due);
        } else {
            self.schedule.queue.remove(Self::pair(pair));
        }
    }

    /// A grip's planned step ends.
    fn end_of_step(&mut self, number: usize, t: f64) {
        let Some(grip) = &self.grips[number] else { return };
        let slots = self.slots(&grip.bodies);
        if let Some(ending) = grip.ending {
            if let Ending::Leaves(number) = ending {
                let first = self.sites.partition_point(|site| site.number < number);
                self.sites[first].left = true;
                (self.sites[first].armed, self.sites[first].kept) = (false, false);
            }
            self.meet(t, &slots, Some(ending));
            return;
        }
        if grip.is_makeshift() {
            self.meet(t, &slots, None);
            return;
        }
        for &slot in &slots {
            self.close_segment(slot, t);
        }
        if let Some(grip) = &mut self.grips[number] {
            grip.commit();
        }
        for &slot in &slots {
            self.bodies[slot].since = t;
        }
        self.plan(number);
        self.seek_around(&slots, t);
    }

    /// Plans a grip's next step.
    pub(in crate::dynamics::impact2d) fn plan(&mut self, number: usize) {
        let Some(mut grip) = self.grips[number].take() else { return };
        self.schedule.effort.steps += 1;
        let [speed, reach] = self.largest;
        let size = grip.bodies.iter().map(|&b| self.model.bodies[b].radius).fold(0.0, f64::max);
        let tolerance = self.model.tolerance;
        let allowed =
            [tolerance * reach.max(1e-6 * size), tolerance * speed.max(1e-6 * size / self.model.duration.min(1.0))];
        let duration = self.model.duration;
        let numbers = self.model.impact;
        // Where the run ends the last step may end, too; one that begins there has no length.
        let cap = if grip.until < duration { duration } else { duration + 1.0 };
        let restless = self.same.0 == grip.until && self.same.1 > RESTLESS;
        let least = if restless { MOMENT * duration } else { 0.0 };
        match grip.plan(&self.model, &numbers, allowed, [least, cap]) {
            Ok(()) => {
                self.schedule.queue.set(Self::lasting(number), grip.until);
                self.grips[number] = Some(grip);
            }
            Err(reason) => {
                let (t, place) = (grip.until, self.names(&grip.bodies));
                self.grips[number] = Some(grip);
                self.schedule.give_up(t, place, reason);
            }
        }
    }

    /// Looks for the next meetings of everybody who is in a pair with these bodies.
    pub(in crate::dynamics::impact2d) fn seek_around(&mut self, slots: &[usize], t: f64) {
        for pair in self.pairs_of(slots) {
            self.seek(pair, t);
        }
    }

    /// Pairs that these bodies are in, each once, rising.
    pub(in crate::dynamics::impact2d) fn pairs_of(&self, slots: &[usize]) -> Few<usize> {
        let mut pairs: Few<usize> = slots.iter().flat_map(|&slot| self.bodies[slot].pairs.iter().copied()).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// Slots of bodies by their numbers in the model.
    pub(in crate::dynamics::impact2d) fn slots(&self, bodies: &[usize]) -> Few<usize> {
        bodies.iter().filter_map(|b| self.bodies.binary_search_by_key(b, |track| track.body).ok()).collect()
    }

    /// Where a body's planned step ends; nothing in flight \[s\].
    pub(in crate::dynamics::impact2d) fn planned(&self, slot: usize) -> Option<f64> {
        match self.bodies[slot].now {
            Going::Grip(grip, _) => self.grips[grip].as_ref().map(|grip| grip.until),
            Going::Flight(_) => None,
        }
    }

    /// Lets a flight under a record keep the states that looks up to `until` start from.
    pub(in crate::dynamics::impact2d) fn remember(&mut self, slot: usize, until: f64) {
        let track = &mut self.bodies[slot];
        if let Going::Flight(flight) = &mut track.now {
            track.system.remember(flight, until);
        }
    }

    /// State of a body on its trajectory.
    pub(in crate::dynamics::impact2d) fn state(&self, slot: usize, t: f64) -> Planar {
        let track = &self.bodies[slot];
        match &track.now {
            Going::Flight(flight) => track.system.state(flight, t),
            Going::Grip(grip, place) => self.grips[*grip].as_ref().map_or([0.0; 6], |grip| grip.state(*place, t)),
        }
    }

    /// Pose of a body on its trajectory.
    pub(in crate::dynamics::impact2d) fn frame(&self, slot: usize, t: f64) -> Frame {
        self.model.bodies[self.bodies[slot].body].planar_frame(&self.state(slot, t))
    }

    /// Notes how fast and how far a body is.
    pub(in crate::dynamics::impact2d) fn note(&mut self, slot: usize, state: &Planar) {
        let radius = self.model.bodies[self.bodies[slot].body].radius;
        self.largest[0] = self.largest[0].max(state[3].hypot(state[4]) + radius * state[5].abs());
        self.largest[1] = self.largest[1].max(state[0].hypot(state[1]) + radius * state[2].abs());
    }

    /// Keeps what a body did until `t`.
    pub(in crate::dynamics::impact2d) fn close_segment(&mut self, slot: usize, t: f64) {
        if let Going::Grip(..) = self.bodies[slot].now {
            // A slide may begin and end at rest.
            for part in [0.25, 0.5, 0.75, 1.0] {
                let state = self.state(slot, self.bodies[slot].since + part * (t - self.bodies[slot].since));
                self.note(slot, &state);
            }
        }
        let track = &mut self.bodies[slot];
        if t <= track.since {
            return;
        }
        let path = match &mut track.now {
            Going::Flight(flight) => {
                track.system.remember(flight, t);
                Path::Flight(Box::new(flight.clone()))
            }
            Going::Grip(grip, place) => {
                let Some(path) = self.grips[*grip].as_ref().and_then(|grip| grip.path(*place)) else { return };
                path
            }
        };
        track.segments.push(Segment { from: track.since, until: t, path });
    }

    /// Ends a grip at `t` and keeps what it was.
    pub(in crate::dynamics::impact2d) fn end_grip(&mut self, number: usize, t: f64) {
        self.schedule.queue.remove(Self::lasting(number));
        if let Some(grip) = self.grips[number].take()
            && t > grip.since
        {
            self.record.stays.push(Stay { from: grip.since, until: t, bodies: grip.bodies, seats: grip.seats });
        }
    }

    /// Ends all trajectories and lasting contacts where the run has come to, and says where that is \[s\].
    pub(in crate::dynamics) fn end(&mut self) -> f64 {
        let end = self.schedule.reached(self.model.duration);
        for slot in 0..self.bodies.len() {
            self.close_segment(slot, end);
        }
        for number in 0..self.grips.len() {
            self.end_grip(number, end);
        }
        end
    }
}

impl Mechanics for Engine {
    fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    fn schedule_mut(&mut self) -> &mut Schedule {
        &mut self.schedule
    }

    fn duration(&self) -> f64 {
        self.model.duration
    }

    fn exceeds_bounds(&mut self, t: f64) -> bool {
        self.schedule.work > WORK.saturating_mul(self.bodies.len()) || self.too_many_at(t)
    }

    fn excess(&self, source: Source) -> (String, String) {
        let place = if source.rank == Self::pair(0).rank {
            self.model.pairs[self.pairs[source.number].number].name.clone()
        } else {
            self.grips[source.number].as_ref().map_or(String::new(), |grip| self.names(&grip.bodies))
        };
        let reason = format!(
            "{} hits, searches and steps, {} of them at this instant, lead nowhere; a larger stop_speed_m_s or a lower \
             restitution_normal would end it, or the contact model",
            self.schedule.work, self.same.1
        );
        (place, reason)
    }

    fn handle(&mut self, source: Source, t: f64) {
        if source.rank != Self::pair(0).rank {
            self.end_of_step(source.number, t);
        } else if self.pairs[source.number].meets {
            let slots: Few<usize> = self.pairs[source.number].slots.into_iter().flatten().collect();
            self.meet(t, &slots, None);
        } else {
            self.seek(source.number, t);
        }
    }

    fn states(&self, t: f64) -> Vec<(usize, Vec<f64>)> {
        self.bodies.iter().enumerate().map(|(slot, track)| (track.body, self.state(slot, t).to_vec())).collect()
    }
}
