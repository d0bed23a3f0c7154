//! The answer of the scene, and the time of it that is shown: the time never leaves the answer.

use crate::app::command::TimeCommand;
use crate::app::run::runner::Runner;
use crate::app::time::playback::Playback;
use crate::scene::Scene;

/// The answer, or what became of it, and the time of it that is shown.
#[derive(Default)]
pub struct Replay {
    /// The scene's answer, or what became of it.
    pub runner: Runner,
    /// The time shown, and the window of time.
    pub playback: Playback,
    /// Revision of the scene that was run last, and which scene it is of those that were opened; none was.
    run: Option<(u64, u64)>,
    /// Time played since the clock last ran with the window's time \[s on the wall\].
    ahead: f64,
}

impl Replay {
    /// Runs a scene whose revision is another than the one that was run last, and keeps the time inside its answer. The
    /// answer of another `work` is not shown over it meanwhile.
    pub(in crate::app) fn follow(&mut self, (revision, work): (u64, u64), scene: &Scene) {
        let run = self.run.replace((revision, work));
        if run.is_none_or(|(before, _)| before != revision) {
            if run.is_some_and(|(_, before)| before != work) {
                self.runner.forget();
            }
            self.runner.start(scene, revision);
            self.playback.keep_inside(self.end());
        }
    }

    /// Does a command.
    pub(in crate::app) fn apply(&mut self, command: TimeCommand) {
        self.playback.apply(command, self.runner.end(), self.runner.answer().map(|answer| &**answer));
    }

    /// Lets the clock run for `dt` \[s\] of the window's time, less what it has run ahead.
    pub(in crate::app) fn advance(&mut self, dt: f64) {
        let ahead = std::mem::take(&mut self.ahead);
        self.run_clock((dt - ahead).max(0.0));
    }

    /// Lets the clock run for `dt` \[s\] between two layouts of the window, whose time does not go on meanwhile.
    pub(in crate::app) fn advance_between(&mut self, dt: f64) {
        self.ahead += dt;
        self.run_clock(dt);
    }

    /// Lets the clock run, where there is an answer to be played.
    fn run_clock(&mut self, dt: f64) {
        if let Some(answer) = self.runner.answer() {
            self.playback.clock.advance(dt, answer.history.end(), &answer.touches);
        }
    }

    /// End of what is shown \[s\].
    pub fn end(&self) -> f64 {
        self.runner.end()
    }

    /// Time shown \[s\].
    pub(in crate::app) fn t(&self) -> f64 {
        self.playback.clock.t
    }

    /// The stretch of the answer that timeline and plots show \[s\].
    pub(in crate::app) fn stretch(&self) -> [f64; 2] {
        self.playback.window.unwrap_or([0.0, self.end()])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn a_scene_is_run_once_for_a_revision_and_the_time_stays_in_its_answer() {
        let scene = presets::load(presets::OPENING).expect("ships");
        let mut replay = Replay::default();
        replay.follow((0, 0), &scene);
        replay.runner.wait();
        let first = replay.runner.answer().expect("it runs").number;
        replay.follow((0, 0), &scene);
        assert_eq!(replay.runner.answer().map(|a| a.number), Some(first), "run already");
        replay.apply(TimeCommand::Seek(f64::INFINITY));
        assert_eq!(replay.t(), scene.duration, "no further than its end");
        let shorter = Scene { duration: 0.5 * scene.duration, ..scene };
        replay.follow((1, 0), &shorter);
        replay.runner.wait();
        replay.follow((2, 0), &shorter);
        assert_eq!((replay.end(), replay.t()), (shorter.duration, shorter.duration), "inside the shorter run");
        assert_eq!(replay.stretch(), [0.0, shorter.duration], "all of it");
    }

    #[test]
    fn what_is_played_between_two_layouts_is_not_played_again() {
        let scene = presets::load(presets::OPENING).expect("ships");
        let mut replay = Replay::default();
        replay.follow((0, 0), &scene);
        replay.runner.wait();
        replay.playback.clock.playing = true;
        let speed = replay.playback.clock.speed;
        replay.advance_between(0.03);
        replay.advance_between(0.03);
        assert!((replay.t() - 0.06 * speed).abs() < 1e-12, "two frames between: {} s", replay.t());
        replay.advance(0.1);
        assert!((replay.t() - 0.1 * speed).abs() < 1e-12, "0.1 s on the wall in all: {} s", replay.t());
        replay.advance(0.1);
        assert!((replay.t() - 0.2 * speed).abs() < 1e-12, "and all of the next: {} s", replay.t());
    }

    #[test]
    fn without_an_answer_the_scene_says_how_long_it_is() {
        let scene = Scene { girders: Vec::new(), duration: 7.0, ..presets::load(presets::OPENING).expect("ships") };
        let mut replay = Replay::default();
        replay.follow((0, 0), &scene);
        assert!(replay.runner.answer().is_none() && replay.runner.problems().is_some(), "an abutment before nothing");
        assert_eq!(replay.end(), 7.0, "what the scene asks for");
        replay.advance(1.0);
        assert_eq!(replay.t(), 0.0, "nothing to play");
    }
}
