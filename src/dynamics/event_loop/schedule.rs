//! Progress of a run: queue of events, counted work, and the reason of an early stop.

use crate::dynamics::event_loop::constants::{EVALUATIONS_PER_EVENT, LONG_SEARCH};
use crate::dynamics::event_loop::effort::Effort;
use crate::dynamics::event_loop::event_queue::EventQueue;
use crate::dynamics::record::event::{Cause, Stop};
use crate::language::Message;

/// Progress of the run of one group of bodies.
#[derive(Debug, Default)]
pub struct Schedule {
    /// Times of the next events.
    pub queue: EventQueue,
    /// Time of the last handled event \[s\].
    pub now: f64,
    /// Handled events plus the contributions of long searches; compared with the bound on work.
    pub work: usize,
    /// Counts of the work of the run.
    pub effort: Effort,
    /// Reason of an early stop.
    stop: Option<Stop>,
}

impl Schedule {
    /// Time of the next event; infinite without one or after a stop \[s\].
    pub fn next_time(&self) -> f64 {
        if self.stop.is_some() { f64::INFINITY } else { self.queue.first_time() }
    }

    /// Time that the run has reached: its `duration`, or that of the last handled event \[s\].
    pub fn reached(&self, duration: f64) -> f64 {
        if self.stop.is_none() && self.queue.first_time() > duration { duration } else { self.now }
    }

    /// Counts a search that took this number of evaluations.
    pub fn count_search(&mut self, evaluations: u64) {
        self.effort.searches += 1;
        self.effort.looks += evaluations;
        if evaluations > LONG_SEARCH {
            self.work += usize::try_from(evaluations / EVALUATIONS_PER_EVENT).unwrap_or(usize::MAX);
        }
    }

    /// Stops the run at `t`, where the computation comes to its bounds; the first of several reasons is kept.
    pub fn give_up(&mut self, t: f64, place: String, reason: Message) {
        self.end(t, Cause::Computation, place, reason);
    }

    /// Stops the run at `t`; the first of several reasons is kept.
    pub fn end(&mut self, t: f64, cause: Cause, place: String, reason: Message) {
        if self.stop.is_none() {
            self.stop = Some(Stop { cause, t, place, reason });
        }
    }

    /// Reason of an early stop; `None` for a run that was not stopped.
    pub fn stop(&self) -> Option<&Stop> {
        self.stop.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::event_loop::event_queue::Source;

    #[test]
    fn a_long_search_counts_as_work_in_proportion_to_its_evaluations() {
        let mut schedule = Schedule::default();
        (0..1000).for_each(|_| schedule.count_search(LONG_SEARCH));
        assert_eq!((schedule.work, schedule.effort.looks), (0, 1000 * LONG_SEARCH), "as searches are");
        schedule.count_search(100_000);
        assert_eq!((schedule.work, schedule.effort.searches), (5000, 1001), "as 5000 events");
    }

    #[test]
    fn a_stopped_run_has_nothing_due_and_keeps_its_first_reason() {
        let mut schedule = Schedule::default();
        schedule.queue.set(Source { rank: 0, number: 0 }, 2.0);
        assert_eq!((schedule.next_time(), schedule.reached(1.0)), (2.0, 1.0), "nothing is due before the end");
        schedule.now = 0.5;
        schedule.give_up(0.5, "first".into(), "too stiff".into());
        schedule.give_up(0.7, "second".into(), "too soft".into());
        assert_eq!(schedule.next_time(), f64::INFINITY, "nothing is handled any more");
        assert_eq!(schedule.reached(1.0), 0.5, "it came to where it stopped");
        assert_eq!(schedule.stop().map(|stop| stop.place.as_str()), Some("first"), "the first reason");
    }
}
