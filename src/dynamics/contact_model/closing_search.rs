//! Times of the next closings of pairs, of the next beginnings of links' forces and of the ends of their phases in flight, entered in the
//! queue.

use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::closing::shared::Shared;
use crate::dynamics::closing::{link_closing, next_closing};
use crate::dynamics::contact_model::event_source::EventSource;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::SearchState;

/// Searches on the present trajectories of a group of bodies.
pub(in crate::dynamics) struct ClosingSearch<'a> {
    /// Trajectories, and the closings found on them.
    pub world: &'a mut World,
    /// Queue of events, and counted work.
    pub schedule: &'a mut Schedule,
}

impl ClosingSearch<'_> {
    /// Searches from `t` on the next closing of every pair of these bodies, and of every link the next beginning of its force or the end of
    /// its phase in flight.
    pub(in crate::dynamics) fn around(&mut self, slots: &[usize], t: f64) {
        let mut shared = Shared::default();
        for pair in self.world.pairs_of(slots) {
            self.pair_among(pair, t, &mut shared);
        }
        // The links of a girder in flight on springs are searched together, with the first of them.
        let searched: Vec<usize> =
            self.world.links_of(slots).into_iter().filter(|&link| !self.world.is_led(link)).collect();
        for link in searched {
            if !self.world.link_acts(link) || self.world.acts_in_flight(link) {
                self.link(link, t);
            } else {
                // Its island finds the end of the phase.
                self.schedule.queue.remove(EventSource::Link(link).into());
            }
        }
    }

    /// Searches the next closing of a pair from `t` on.
    pub(in crate::dynamics) fn pair(&mut self, number: usize, t: f64) {
        let mut shared = Shared::default();
        // While bodies that have met stand apart their first pair is searched for all.
        let all = if self.world.leads(number) { self.world.meeting_of(number) } else { number..number + 1 };
        let apart = |&other: &usize| other == number || self.world.pairs[other].search_state == SearchState::Idle;
        for pair in all.filter(apart).collect::<Vec<_>>() {
            self.pair_among(pair, t, &mut shared);
        }
    }

    fn pair_among(&mut self, number: usize, t: f64, shared: &mut Shared) {
        let found = next_closing::search(self.world, number, t, shared);
        self.world.pairs[number].due = found.due;
        self.enter(EventSource::Pair(number), found);
    }

    /// Searches the beginning of a link's force, or the end of its phase in flight, from `t` on.
    pub(in crate::dynamics) fn link(&mut self, number: usize, t: f64) {
        let found = link_closing::search(self.world, number, t);
        self.enter(EventSource::Link(number), found);
        for other in self.world.phases_led_by(number).into_iter().flatten().skip(1) {
            let ends = self.world.links[other].ends;
            self.due(EventSource::Link(other), ends.map_or(f64::INFINITY, |(at, _)| at));
        }
    }

    /// Enters the result of a search in the queue and counts its work.
    fn enter(&mut self, source: EventSource, found: NextClosing) {
        self.schedule.count_search(found.evaluations);
        self.due(source, found.due);
    }

    /// Enters a time in the queue; removes the source where that is infinite.
    fn due(&mut self, source: EventSource, t: f64) {
        if t.is_finite() {
            self.schedule.queue.set(source.into(), t);
        } else {
            self.schedule.queue.remove(source.into());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::penalty3d::example::{SPEED, wall};
    use crate::dynamics::world::example::in_flight;

    #[test]
    fn a_pair_is_in_the_queue_while_its_bodies_approach() {
        let gap = 1e-3;
        let mut schedule = Schedule::default();
        for (velocity, due) in [(SPEED, gap / SPEED), (-SPEED, f64::INFINITY)] {
            let mut world = in_flight(&wall(), &[[-gap, 0.0, 0.0, velocity, 0.0, 0.0]]);
            ClosingSearch { world: &mut world, schedule: &mut schedule }.around(&[0], 0.0);
            let first = schedule.queue.first_time();
            assert!(
                first == due || (first / due - 1.0).abs() < 1e-9,
                "at {velocity} m/s it closes at {first} s, not {due} s"
            );
        }
        assert_eq!(schedule.effort.searches, 2, "one pair, twice");
        assert!(schedule.effort.looks > 0, "evaluations are counted");
    }
}
