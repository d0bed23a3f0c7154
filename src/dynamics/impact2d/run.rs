//! One run of a group of bodies: event queue, log, and the planning of steps and searches.

use crate::dynamics::event_loop::event_queue::Source;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::free_flight::body_motion::BodyFlight;
use crate::dynamics::impact2d::closing::next_impact::next_impact;
use crate::dynamics::impact2d::constants::{EVENTS_BEFORE_LEAST_DURATION, LEAST_DURATION, LEAST_SCALE};
use crate::dynamics::impact2d::record::{LastingInterval, Record};
use crate::dynamics::impact2d::tracks::Motion;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::trajectory::segment::{Segment, SegmentMotion};

/// State, queue and log of a run.
#[derive(Debug)]
pub(in crate::dynamics::impact2d) struct Run {
    pub world: World,
    pub schedule: Schedule,
    pub record: Record,
    /// Last instant with an event \[s\], and the number of events in it.
    pub last: (f64, usize),
}

impl Run {
    /// The end of the planned step of a lasting contact as a source of events.
    pub(in crate::dynamics::impact2d) fn lasting(number: usize) -> Source {
        Source { rank: 0, number }
    }

    /// The next impact of a pair, or the end of its search, as a source of events.
    pub(in crate::dynamics::impact2d) fn pair(number: usize) -> Source {
        Source { rank: 1, number }
    }

    /// A run at t = 0, before its first event.
    pub(in crate::dynamics::impact2d) fn new(world: World) -> Self {
        Self { world, schedule: Schedule::default(), record: Record::default(), last: (-1.0, 0) }
    }

    /// Searches the next impact of a pair from `t` on and enters it in the queue.
    pub(in crate::dynamics::impact2d) fn search(&mut self, pair: usize, t: f64) {
        for site in self.world.pairs[pair].sites.clone() {
            let track = &mut self.world.sites[site];
            if track.in_front_at.take().is_some_and(|at| at <= t) {
                track.arm();
            }
        }
        let found = next_impact(&mut self.world, pair, t);
        self.schedule.effort.searches += 1;
        self.schedule.effort.looks += found.looks;
        self.world.pairs[pair].impact_due = found.impact;
        if found.due.is_finite() {
            self.schedule.queue.set(Self::pair(pair), found.due);
        } else {
            self.schedule.queue.remove(Self::pair(pair));
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
        let repeated = self.last.0 == contact.until && self.last.1 > EVENTS_BEFORE_LEAST_DURATION;
        let least = if repeated { LEAST_DURATION * duration } else { 0.0 };
        let planned = contact.plan(model, [place, speed], [least, cap]);
        let until = contact.until;
        match planned {
            Ok(()) => self.schedule.queue.set(Self::lasting(number), until),
            Err(reason) => self.schedule.give_up(until, self.world.names(&contact.bodies), reason),
        }
        self.world.lasting[number] = Some(contact);
    }

    /// Stores the motion of a body until `t`.
    pub(in crate::dynamics::impact2d) fn close_segment(&mut self, slot: usize, t: f64) {
        let since = self.world.bodies[slot].since;
        if let Motion::Lasting(..) = self.world.bodies[slot].motion {
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
            Motion::Flight(flight) => Some(SegmentMotion::Flight(Box::new(BodyFlight::Girder(flight.clone())))),
            Motion::Lasting(number, place) => {
                self.world.lasting[*number].as_ref().and_then(|contact| contact.path(*place))
            }
        };
        self.world.bodies[slot].segments.extend(path.map(|path| Segment { from: since, until: t, path }));
    }

    /// Ends a lasting contact at `t` and logs it.
    pub(in crate::dynamics::impact2d) fn end_lasting(&mut self, number: usize, t: f64) {
        self.schedule.queue.remove(Self::lasting(number));
        if let Some(contact) = self.world.lasting[number].take()
            && t > contact.since
        {
            let (bodies, modes) = (contact.bodies, contact.modes);
            self.record.lasting.push(LastingInterval { from: contact.since, until: t, bodies, modes });
        }
    }
}
