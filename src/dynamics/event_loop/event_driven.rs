//! The event loop, and the interface of the models that it runs.
//!
//! Every source of events (an island, a facing pair, a link) is in the queue with the time of its next event. The
//! earliest source is handled; handling it enters new times for the sources that it concerns and for no others.

use crate::dynamics::event_loop::event_queue::Source;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::language::{Message, Text};

/// The motion of one group of bodies under a model of contact, advanced from event to event.
pub trait EventDriven {
    /// Progress of the run.
    fn schedule(&self) -> &Schedule;

    /// Progress of the run, to be changed.
    fn schedule_mut(&mut self) -> &mut Schedule;

    /// Length of the run \[s\].
    fn duration(&self) -> f64;

    /// Text of a stop where the event at `t` exceeds a bound on the work of a run or of one instant: the bound, and a change of the scene
    /// that would avoid it.
    fn exceeded(&mut self, t: f64) -> Option<Message>;

    /// Names of the bodies of a source.
    fn place(&self, source: Source) -> String;

    /// Handles the event of a source at `t`.
    fn handle(&mut self, source: Source, t: f64);

    /// Number in the model and state at `t` of every body; all events up to `t` are handled.
    fn states(&self, t: f64) -> Vec<(usize, Vec<f64>)>;

    /// Name of a body of the model.
    fn name(&self, body: usize) -> String;

    /// Handles all events up to `until` \[s\]. The run stops where the time of an event or, at its end, the state of a body is no number.
    fn advance(&mut self, until: f64) {
        let until = until.min(self.duration());
        while self.schedule().next_time() <= until {
            let Some((t, source)) = self.schedule_mut().queue.pop() else { return };
            let schedule = self.schedule_mut();
            schedule.now = t;
            schedule.work += 1;
            if let Some(reason) = self.exceeded(t) {
                let place = self.place(source);
                self.schedule_mut().give_up(t, place, reason);
                return;
            }
            self.handle(source, t);
            if self.schedule().queue.undefined().is_some() {
                break;
            }
        }
        // Also a time that was entered before the first event.
        let undefined = if let Some(source) = self.schedule().queue.undefined() {
            Some(self.place(source))
        } else if self.schedule().stop().is_none() {
            let undefined = |(_, state): &(usize, Vec<f64>)| state.iter().any(|number| !number.is_finite());
            self.states(until).into_iter().find(undefined).map(|(body, _)| self.name(body))
        } else {
            None
        };
        if let Some(place) = undefined {
            let t = self.schedule().now;
            self.schedule_mut().give_up(t, place, Text::new("stop-undefined").into());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two periodic sources of events, stopped above `most` events.
    struct Clocks {
        schedule: Schedule,
        struck: Vec<(f64, usize)>,
        most: usize,
        hand: f64,
    }

    const INTERVALS: [f64; 2] = [0.3, 0.5];

    impl EventDriven for Clocks {
        fn schedule(&self) -> &Schedule {
            &self.schedule
        }

        fn schedule_mut(&mut self) -> &mut Schedule {
            &mut self.schedule
        }

        fn duration(&self) -> f64 {
            1.0
        }

        fn exceeded(&mut self, _: f64) -> Option<Message> {
            (self.schedule.work > self.most).then(|| "it strikes too often".into())
        }

        fn place(&self, source: Source) -> String {
            format!("clock {}", source.number)
        }

        fn handle(&mut self, source: Source, t: f64) {
            self.struck.push((t, source.number));
            self.schedule.queue.set(source, t + INTERVALS[source.number]);
        }

        fn states(&self, _: f64) -> Vec<(usize, Vec<f64>)> {
            vec![(0, vec![self.hand])]
        }

        fn name(&self, body: usize) -> String {
            format!("hand {body}")
        }
    }

    fn clocks(most: usize) -> Clocks {
        let mut clocks = Clocks { schedule: Schedule::default(), struck: Vec::new(), most, hand: 0.0 };
        for (number, first) in INTERVALS.into_iter().enumerate() {
            clocks.schedule.queue.set(Source { rank: 0, number }, first);
        }
        clocks
    }

    #[test]
    fn the_earliest_is_handled_first_up_to_the_time_asked_for() {
        let mut model = clocks(100);
        model.advance(0.55);
        assert_eq!(model.struck, [(0.3, 0), (0.5, 1)], "what is due until then");
        model.advance(5.0);
        let order: Vec<usize> = model.struck.iter().map(|(_, number)| *number).collect();
        assert_eq!(order, [0, 1, 0, 0, 1], "no further than the run is long");
        assert_eq!(model.schedule.reached(1.0), 1.0, "to its end");
    }

    #[test]
    fn what_is_no_number_stops_a_run() {
        let mut model = Clocks { hand: f64::NAN, ..clocks(100) };
        model.advance(0.55);
        let stop = model.schedule.stop().expect("a reason");
        assert_eq!((stop.place.as_str(), stop.t), ("hand 0", 0.5), "where the last event was: {stop:?}");
        let mut model = clocks(100);
        model.schedule.queue.set(Source { rank: 0, number: 1 }, f64::NAN);
        model.advance(1.0);
        let stop = model.schedule.stop().expect("a reason");
        assert_eq!((stop.place.as_str(), stop.t), ("clock 1", 0.3), "no event is passed over: {stop:?}");
    }

    #[test]
    fn a_run_that_exceeds_its_bound_stops_and_names_who_kept_it_busy() {
        let mut model = clocks(2);
        model.advance(1.0);
        assert_eq!(model.struck.len(), 2, "what the bound allows");
        let stop = model.schedule.stop().expect("a reason");
        assert_eq!((stop.place.as_str(), stop.t), ("clock 0", 0.6), "{stop:?}");
    }
}
