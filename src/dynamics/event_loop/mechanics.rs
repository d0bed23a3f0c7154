//! The event loop, and the interface of the models that it runs.
//!
//! Every source of events (an island, a facing pair, a link) is in the queue with the time of its next event. The
//! earliest source is handled; handling it enters new times for the sources that it concerns and for no others.

use crate::dynamics::event_loop::event_queue::Source;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::language::{Message, Text};

/// A model of contact: one group of bodies, advanced from event to event.
pub trait Mechanics {
    /// Progress of the run.
    fn schedule(&self) -> &Schedule;

    /// Progress of the run, to be changed.
    fn schedule_mut(&mut self) -> &mut Schedule;

    /// Length of the run \[s\].
    fn duration(&self) -> f64;

    /// What a stop says where the event at `t` exceeds a bound on the work of a run or of one instant: the bound, and a change of the scene
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
}

/// Handles all events up to `until` \[s\]. The run stops where the time of an event or, at its end, the state of a body is no number.
pub fn advance(run: &mut impl Mechanics, until: f64) {
    let until = until.min(run.duration());
    while run.schedule().next_time() <= until {
        let Some((t, source)) = run.schedule_mut().queue.pop() else { return };
        let schedule = run.schedule_mut();
        schedule.now = t;
        schedule.work += 1;
        if let Some(reason) = run.exceeded(t) {
            let place = run.place(source);
            run.schedule_mut().give_up(t, place, reason);
            return;
        }
        run.handle(source, t);
        if run.schedule().queue.undefined().is_some() {
            break;
        }
    }
    // Also a time that was entered before the first event.
    if let Some(source) = run.schedule().queue.undefined() {
        let (t, place) = (run.schedule().now, run.place(source));
        run.schedule_mut().give_up(t, place, Text::new("stop-undefined").into());
    } else if run.schedule().stop().is_none() {
        let undefined = run.states(until).into_iter().find(|(_, state)| state.iter().any(|number| !number.is_finite()));
        if let Some((body, _)) = undefined {
            let (t, place) = (run.schedule().now, run.name(body));
            run.schedule_mut().give_up(t, place, Text::new("stop-undefined").into());
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

    impl Mechanics for Clocks {
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
        advance(&mut model, 0.55);
        assert_eq!(model.struck, [(0.3, 0), (0.5, 1)], "what is due until then");
        advance(&mut model, 5.0);
        let order: Vec<usize> = model.struck.iter().map(|(_, number)| *number).collect();
        assert_eq!(order, [0, 1, 0, 0, 1], "no further than the run is long");
        assert_eq!(model.schedule.reached(1.0), 1.0, "to its end");
    }

    #[test]
    fn what_is_no_number_stops_a_run() {
        let mut model = Clocks { hand: f64::NAN, ..clocks(100) };
        advance(&mut model, 0.55);
        let stop = model.schedule.stop().expect("a reason");
        assert_eq!((stop.place.as_str(), stop.t), ("hand 0", 0.5), "where the last event was: {stop:?}");
        let mut model = clocks(100);
        model.schedule.queue.set(Source { rank: 0, number: 1 }, f64::NAN);
        advance(&mut model, 1.0);
        let stop = model.schedule.stop().expect("a reason");
        assert_eq!((stop.place.as_str(), stop.t), ("clock 1", 0.3), "no event is passed over: {stop:?}");
    }

    #[test]
    fn a_run_that_exceeds_its_bound_stops_and_names_who_kept_it_busy() {
        let mut model = clocks(2);
        advance(&mut model, 1.0);
        assert_eq!(model.struck.len(), 2, "what the bound allows");
        let stop = model.schedule.stop().expect("a reason");
        assert_eq!((stop.place.as_str(), stop.t), ("clock 0", 0.6), "{stop:?}");
    }
}
