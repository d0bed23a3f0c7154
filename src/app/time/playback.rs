//! Time of the answer that is shown, and the stretch of it on timeline and plots.

use crate::app::command::TimeCommand;
use crate::app::run::answer::Answer;
use crate::app::time::clock::Clock;

/// A step of the arrow keys in seconds of the answer at speed 1: a frame of a film at 60 Hz \[s\].
const STEP: f64 = 1.0 / 60.0;

/// The playing clock, and the window of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Playback {
    /// The time shown.
    pub clock: Clock,
    /// The stretch of time that timeline and plots show; all of it when none \[s\].
    pub window: Option<[f64; 2]>,
}

impl Playback {
    /// Does a command; `end` is the end of what is shown \[s\].
    pub(in crate::app) fn apply(&mut self, command: TimeCommand, end: f64, answer: Option<&Answer>) {
        let t = self.clock.t;
        match command {
            TimeCommand::TogglePlay => self.toggle(end),
            TimeCommand::Step(steps) => self.seek(t + steps * STEP * self.clock.speed, end),
            TimeCommand::StepEvent(way) => {
                if let Some(event) = answer.and_then(|a| a.neighbour_event(t, way)) {
                    self.clock.playing = false;
                    self.seek(event, end);
                }
            }
            TimeCommand::Seek(t) => self.seek(t, end),
            TimeCommand::StandAt(t) => {
                self.clock.playing = false;
                self.seek(t, end);
            }
            TimeCommand::Speed(speed) => self.clock.speed = speed.clamp(0.001, 10.0),
            TimeCommand::StepSpeed(by) => self.clock.step_speed(by),
            TimeCommand::Loop(on) => self.clock.looping = on,
            TimeCommand::SlowAtHits(on) => self.clock.slow_at_hits = on,
            TimeCommand::PlaySpan(span) => self.clock.span = span.filter(|s| s[0] < s[1]),
            TimeCommand::SpanFrom => self.play_span([t, self.clock.span.map_or(end, |s| s[1])], end),
            TimeCommand::SpanTo => self.play_span([self.clock.span.map_or(0.0, |s| s[0]), t], end),
            TimeCommand::Window(window) => self.window = window,
        }
    }

    /// Stands at the start of another scene, everything in view.
    pub(in crate::app) fn rewind(&mut self) {
        self.window = None;
        self.clock.t = 0.0;
        self.clock.playing = false;
    }

    /// Keeps inside an answer that ends at `end` \[s\].
    pub(in crate::app) fn keep_inside(&mut self, end: f64) {
        self.clock.t = self.clock.t.min(end);
        self.window = self.window.filter(|w| w[1] <= end);
    }

    fn toggle(&mut self, end: f64) {
        self.clock.playing = !self.clock.playing;
        if self.clock.playing && self.clock.t >= end {
            self.clock.t = 0.0;
        }
    }

    /// A stretch whose ends have passed one another begins or ends with the run.
    fn play_span(&mut self, [from, to]: [f64; 2], end: f64) {
        let span = match from < to {
            true => [from, to],
            false if from == self.clock.t => [from, end],
            false => [0.0, to],
        };
        self.clock.span = Some(span).filter(|s| s[0] < s[1]);
    }

    fn seek(&mut self, t: f64, end: f64) {
        self.clock.t = t.clamp(0.0, end);
        self.follow(end);
    }

    /// Moves the window of time so that the playhead is in it.
    fn follow(&mut self, end: f64) {
        if let Some([from, to]) = self.window
            && !(from..=to).contains(&self.clock.t)
        {
            let span = to - from;
            let start = (self.clock.t - span / 2.0).clamp(0.0, (end - span).max(0.0));
            self.window = Some([start, start + span]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// End of the run in these tests \[s\].
    const END: f64 = 10.0;

    fn after(commands: &[TimeCommand]) -> Playback {
        let mut playback = Playback::default();
        for command in commands {
            playback.apply(*command, END, None);
        }
        playback
    }

    #[test]
    fn the_playhead_stays_in_the_run_and_takes_the_window_along() {
        assert_eq!(after(&[TimeCommand::Seek(f64::INFINITY)]).clock.t, END, "no further than its end");
        let moved = after(&[TimeCommand::Window(Some([0.0, 2.0])), TimeCommand::Seek(5.0)]);
        assert_eq!(moved.window, Some([4.0, 6.0]), "as long as before, about the playhead");
        let last = after(&[TimeCommand::Window(Some([0.0, 2.0])), TimeCommand::Seek(END)]);
        assert_eq!(last.window, Some([8.0, 10.0]), "not beyond the end");
    }

    #[test]
    fn a_step_is_a_frame_at_the_playing_speed() {
        let stepped = after(&[TimeCommand::Speed(0.5), TimeCommand::Step(3.0)]);
        assert!((stepped.clock.t - 0.025).abs() < 1e-15, "3/60 s at a half, got {}", stepped.clock.t);
    }

    #[test]
    fn ends_of_a_stretch_that_pass_one_another_begin_or_end_with_the_run() {
        let late = [TimeCommand::PlaySpan(Some([1.0, 2.0])), TimeCommand::Seek(5.0), TimeCommand::SpanFrom];
        assert_eq!(after(&late).clock.span, Some([5.0, END]), "begun behind its end");
        let early = [TimeCommand::PlaySpan(Some([4.0, 6.0])), TimeCommand::Seek(3.0), TimeCommand::SpanTo];
        assert_eq!(after(&early).clock.span, Some([0.0, 3.0]), "ended before its start");
    }

    #[test]
    fn playing_at_the_end_begins_anew_and_a_shorter_run_is_kept_to() {
        let again = after(&[TimeCommand::Seek(END), TimeCommand::TogglePlay]);
        assert_eq!((again.clock.t, again.clock.playing), (0.0, true), "from the start");
        let mut shorter = after(&[TimeCommand::Seek(9.0), TimeCommand::Window(Some([8.0, 10.0]))]);
        shorter.keep_inside(5.0);
        assert_eq!((shorter.clock.t, shorter.window), (5.0, None), "inside it");
    }
}
