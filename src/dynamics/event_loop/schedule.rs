//! How far a run has come: what is due next, what was spent, and why it stopped early.

use crate::dynamics::event_loop::effort::Effort;
use crate::dynamics::event_loop::event_queue::EventQueue;
use crate::dynamics::record::event::Stop;

/// Progress of the run of one group of bodies.
#[derive(Debug, Default)]
pub struct Schedule {
    /// What is due when.
    pub queue: EventQueue,
    /// Time of the last event that was handled \[s\].
    pub now: f64,
    /// Handled events and searches that were cut short, held against the bound on work.
    pub work: usize,
    /// What was done, counted.
    pub effort: Effort,
    /// Why the run stopped early.
    stop: Option<Stop>,
}

impl Schedule {
    /// The time of the next event; infinite when nothing is due or the run has stopped \[s\].
    pub fn next_time(&self) -> f64 {
        if self.stop.is_some() { f64::INFINITY } else { self.queue.first_time() }
    }

    /// How far the run has come, of its `duration` \[s\].
    pub fn reached(&self, duration: f64) -> f64 {
        if self.stop.is_none() && self.queue.first_time() > duration { duration } else { self.now }
    }

    /// Stops the run at `t`; of several reasons the first is kept.
    pub fn give_up(&mut self, t: f64, place: String, reason: String) {
        if self.stop.is_none() {
            self.stop = Some(Stop { t, place, reason });
        }
    }

    /// Why the run stopped early.
    pub fn stop(&self) -> Option<&Stop> {
        self.stop.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::event_loop::event_queue::Source;

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
