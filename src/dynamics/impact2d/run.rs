//! Run of one group of bodies under the impact model: bodies, event queue and log; planning of steps and searches. The handling of events
//! is in `handlers`.

use std::sync::Arc;

use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::event_loop::work_bounds::{Spent, WorkBounds};
use crate::dynamics::free_flight::body_flight::{BodyFlight, FlightInPlan};
use crate::dynamics::impact2d::closing::next_impact::next_impact;
use crate::dynamics::impact2d::constants::{
    CONSISTENCY_HALVINGS, EVENTS_BEFORE_LEAST_DURATION, LEAST_DURATION, LEAST_SCALE, SWITCHING_SAMPLES,
};
use crate::dynamics::impact2d::event_source::EventSource;
use crate::dynamics::impact2d::lasting::painleve;
use crate::dynamics::impact2d::lasting::switch::Ending;
use crate::dynamics::impact2d::record::{ImpactRecord, LastingInterval};
use crate::dynamics::impact2d::tracks::Trajectory;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::trajectory::segment::{Segment, SegmentMotion};

/// The run of one group of bodies under the impact model.
#[derive(Debug)]
pub struct ImpactRun {
    /// Bodies, pairs, contact points and lasting contacts at the present time.
    pub(in crate::dynamics::impact2d) world: World,
    /// Queue of events, counted work and early stop.
    pub(in crate::dynamics::impact2d) schedule: Schedule,
    /// Hits, transitions and lasting contacts so far.
    pub(in crate::dynamics::impact2d) record: ImpactRecord,
    /// Bounds that end the run.
    pub(in crate::dynamics::impact2d) bounds: WorkBounds,
    /// Last instant with an event \[s\].
    pub(in crate::dynamics::impact2d) last_instant: f64,
    /// Number of events at that instant.
    pub(in crate::dynamics::impact2d) events_at_instant: usize,
    /// Memory of the stored motion \[bytes\].
    stored: usize,
}

impl ImpactRun {
    /// A run at t = 0 whose bodies have no trajectories yet.
    pub(in crate::dynamics::impact2d) fn before_start(world: World) -> Self {
        Self {
            world,
            schedule: Schedule::default(),
            record: ImpactRecord::default(),
            bounds: WorkBounds::default(),
            last_instant: -1.0,
            events_at_instant: 0,
            stored: 0,
        }
    }

    /// Searches the next impact of a pair from `t` on and enters it in the queue.
    pub(in crate::dynamics::impact2d) fn search(&mut self, pair: usize, t: f64) {
        self.world.arm_in_front(pair, t);
        for site in self.world.pairs[pair].sites.clone() {
            self.world.sites[site].in_front_at = None;
        }
        let found = next_impact(&mut self.world, pair, t);
        self.schedule.count_search(found.looks);
        self.world.pairs[pair].impact_due = found.impact;
        if found.due.is_finite() {
            self.schedule.queue.set(EventSource::Pair(pair).into(), found.due);
        } else {
            self.schedule.queue.remove(EventSource::Pair(pair).into());
        }
    }

    /// Searches all pairs of these bodies.
    pub(in crate::dynamics::impact2d) fn search_around(&mut self, slots: &[usize], t: f64) {
        for pair in self.world.pairs_of(slots) {
            self.search(pair, t);
        }
    }

    /// Plans the next step of a lasting contact.
    pub(in crate::dynamics::impact2d) fn plan(&mut self, number: usize) {
        let Some(mut contact) = self.world.lasting[number].take() else { return };
        self.schedule.effort.steps += 1;
        let model = &self.world.model;
        let size = contact.bodies.iter().map(|&b| model.bodies[b].radius).fold(0.0, f64::max);
        let (tolerance, duration) = (model.tolerance, model.duration);
        let place = tolerance * self.world.peak_displacement.max(LEAST_SCALE * size);
        let speed = tolerance * self.world.peak_speed.max(LEAST_SCALE * size / duration.min(1.0));
        // A step may end with the run; one that begins at its end needs a length.
        let cap = if contact.until < duration { duration } else { duration + 1.0 };
        let repeated = self.last_instant == contact.until && self.events_at_instant > EVENTS_BEFORE_LEAST_DURATION;
        let least = if repeated { LEAST_DURATION * duration } else { 0.0 };
        let planned = contact.plan(model, [place, speed], [least, cap]);
        let mut until = contact.until;
        if let Err(reason) = planned {
            self.schedule.give_up(until, self.world.names(&contact.bodies), reason.into());
            self.world.lasting[number] = Some(contact);
            return;
        }
        let for_want_of_another = contact.is_for_want_of_another();
        self.world.lasting[number] = Some(contact);
        if for_want_of_another
            && let Some(t) = self.superseded(number, least)
            && let Some(contact) = &mut self.world.lasting[number]
        {
            (until, contact.until, contact.ending) = (t, t, Some(Ending::Superseded));
        }
        self.schedule.queue.set(EventSource::Lasting(number).into(), until);
    }

    /// First time in the planned step of a lasting contact, whose modes are for want of others, from which on others agree with Coulomb's law
    /// or its own hold no more \[s\].
    fn superseded(&self, number: usize, least: f64) -> Option<f64> {
        let contact = self.world.lasting[number].as_ref()?;
        let slots = self.world.slots(&contact.bodies);
        let changes = |t: f64| !painleve::must_go_on(&self.world, t, &slots, &contact.modes);
        let (from, until) = ((contact.from + least).min(contact.until), contact.until);
        let sample = |k: usize| from + (until - from) * k as f64 / SWITCHING_SAMPLES as f64;
        let first = (1..SWITCHING_SAMPLES).find(|&k| changes(sample(k)))?;
        let [mut before, mut after] = [sample(first - 1), sample(first)];
        for _ in 0..CONSISTENCY_HALVINGS {
            let middle = before.midpoint(after);
            *if changes(middle) { &mut after } else { &mut before } = middle;
        }
        Some(after)
    }

    /// Stores the motion of a body until `t`.
    pub(in crate::dynamics::impact2d) fn close_segment(&mut self, slot: usize, t: f64) {
        let since = self.world.bodies[slot].since;
        if let Trajectory::Lasting(..) = self.world.bodies[slot].motion {
            // A slide may begin and end at rest, so its peak lies within.
            for part in [0.25, 0.5, 0.75, 1.0] {
                let state = self.world.state(slot, since + part * (t - since));
                self.world.update_peaks(slot, &state);
            }
        }
        if t <= since {
            return;
        }
        self.world.remember(slot, t);
        let path = match &self.world.bodies[slot].motion {
            Trajectory::Flight(flight) => {
                let system = Arc::clone(&self.world.bodies[slot].free_motion);
                let flight = FlightInPlan::on_bearings(system, flight.clone());
                Some(SegmentMotion::Flight(Box::new(BodyFlight::InPlan(flight))))
            }
            Trajectory::Lasting(number, place) => {
                self.world.lasting[*number].as_ref().and_then(|contact| contact.path(*place))
            }
        };
        let segment = path.map(|path| Segment { from: since, until: t, path });
        self.stored += segment.as_ref().map_or(0, Segment::bytes);
        self.world.bodies[slot].segments.extend(segment);
    }

    /// Cost of the run at `t`.
    pub(in crate::dynamics::impact2d) fn spent(&self, t: f64) -> Spent {
        let (world, record) = (&self.world, &self.record);
        Spent {
            work: self.schedule.work,
            bytes: self.stored + record.bytes(),
            memory: world.model.memory_bytes,
            events: record.hits.len() + record.transitions.len(),
            touches: world.lasting.iter().any(Option::is_some),
            t,
            duration: world.model.duration,
            bodies: [world.bodies.len(), world.model.bodies.len()],
        }
    }

    /// Ends a lasting contact at `t` and logs it; the step that it would have taken next, where it took steps \[s\].
    pub(in crate::dynamics::impact2d) fn end_lasting(&mut self, number: usize, t: f64) -> Option<f64> {
        self.schedule.queue.remove(EventSource::Lasting(number).into());
        let contact = self.world.lasting[number].take()?;
        let next = contact.next_step();
        if t > contact.since {
            let (bodies, modes) = (contact.bodies, contact.modes);
            self.record.lasting.push(LastingInterval { from: contact.since, until: t, bodies, modes });
        }
        next
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::impact2d::example;
    use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, FrictionMode};
    use crate::dynamics::impact2d::lasting::lasting_contact::LastingContact;
    use crate::scene::presets;

    /// A girder of 2 kg without bearings 3 mm before a wall, at this velocity \[m/s\].
    fn run(speed: f64) -> ImpactRun {
        ImpactRun::before_start(example::world(example::block(
            &format!("initial = {{ velocity_m_s = [{speed:?}, 0.0] }}"),
            0.003,
        )))
    }

    #[test]
    fn a_search_enters_an_impact_in_the_queue_and_removes_one_that_no_longer_comes() {
        let mut run = run(0.25);
        run.search(0, 0.0);
        assert!(run.world.pairs[0].impact_due, "it approaches");
        assert!((run.schedule.queue.first_time() - 0.012).abs() < 1e-15, "gap over speed");
        let away = run.world.bodies[0].free_motion.fly(0.0, [0.0, 0.0, 0.0, -0.25, 0.0, 0.0]);
        run.world.bodies[0].motion = Trajectory::Flight(away);
        run.search_around(&[0], 0.0);
        assert!(!run.world.pairs[0].impact_due, "it goes away");
        assert_eq!(run.schedule.queue.pop(), None, "no event is left");
        assert_eq!(run.schedule.effort.searches, 2, "both are counted");
    }

    #[test]
    fn a_search_arms_points_that_are_in_front_of_their_face_by_then() {
        for (in_front_at, armed) in [(Some(0.5), true), (Some(1.5), false), (None, false)] {
            let mut run = run(-0.25);
            let site = &mut run.world.sites[0];
            (site.armed, site.lifted, site.in_front_at) = (false, true, in_front_at);
            // Behind the plane of the face, so that the search itself arms no point.
            let behind = run.world.bodies[0].free_motion.fly(1.0, [0.01, 0.0, 0.0, 0.0, 0.0, 0.0]);
            run.world.bodies[0].motion = Trajectory::Flight(behind);
            run.search(0, 1.0);
            assert_eq!(run.world.sites[0].armed, armed, "in front at {in_front_at:?}, searched at 1 s");
        }
    }

    #[test]
    fn a_segment_is_stored_up_to_its_end_and_none_of_no_length() {
        let mut run = run(0.25);
        run.close_segment(0, 0.0);
        assert!(run.world.bodies[0].segments.is_empty(), "no length");
        run.close_segment(0, 0.01);
        let segment = &run.world.bodies[0].segments[0];
        assert_eq!([segment.from, segment.until], [0.0, 0.01], "from the start of the motion in force");
    }

    #[test]
    fn a_lasting_contact_is_planned_logged_at_its_end_and_not_where_it_has_no_length() {
        for (end, logged) in [(0.0, 0), (0.5, 1)] {
            let mut run = ImpactRun::before_start(example::world(example::at_wall(|_| ())));
            let sites = example::touching(&run.world.model, &example::instant(&run.world, [0.0; 2]).kinematics);
            let mode = ContactMode { pair: 0, sites, friction: FrictionMode::Stick };
            run.world.lasting.push(Some(LastingContact::new(vec![0], vec![mode], &[[0.0; 6]], 0.0)));
            run.world.bodies[0].motion = Trajectory::Lasting(0, 0);
            run.plan(0);
            let until = run.world.planned_end(0).expect("a planned step");
            assert_eq!(run.schedule.queue.first_time(), until, "the end of its step is an event");
            run.end_lasting(0, end);
            assert_eq!((run.record.lasting.len(), run.schedule.queue.pop()), (logged, None), "ended at {end} s");
            assert!(run.world.lasting[0].is_none(), "its number is free again");
        }
    }

    /// Work of the first search, of the paper's girder turned by a moment \[N·m\], and its evaluations.
    fn first_search(moment: f64) -> (usize, u64) {
        let mut scene = presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"));
        scene.girders[0].push.moment = moment;
        let model = Arc::new(Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}")));
        let mut run = ImpactRun::before_start(World::new(&model, 0));
        run.search(0, 0.0);
        (run.schedule.work, run.schedule.effort.looks)
    }

    #[test]
    fn a_search_that_is_cut_short_counts_as_work() {
        let (work, looks) = first_search(0.0);
        assert!(work == 0 && looks < 1000, "{looks} looks");
        // 100,000 looks reach 2e-8 s (601 searches came to 1.1e-5 s in 57 s): 3e6 such searches would take days.
        let (work, looks) = first_search(1e13);
        assert!(work == 5000 && looks > 100_000, "{work} for {looks} looks");
    }
}
