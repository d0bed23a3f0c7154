//! Runs the scene that is shown: at once when it is quick, beside the window with progress and cancel when it is not.
//!
//! Beside the window a coarse pass comes first: its answer is shown until that of the full pass is there, and is never exported or
//! pinned. A scene that arrives during a coarse pass waits for that pass, so that a drag of a large scene shows answers instead of
//! cancelling each. The last answer stays in view until the next; a scene that cannot be run leaves its errors in `problems`.
//! When the window is idle, a thread estimates the error of the answer.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::Duration;

use crate::app::host::{Instant, THREADS, Wake, now, spawn};
use crate::app::run::answer::Answer;
use crate::app::run::job::{self, Job};
use crate::scene::{Limits, Scene, SceneErrors};
use crate::sim::readings::Passed;
use crate::sim::{ErrorEstimate, History, Session};

/// How long a run may hold up a frame before it goes on on a thread.
const FRAME_BUDGET: Duration = Duration::from_millis(30);

/// How long a newer scene waits for the coarse pass of the one before it: as long as an answer still seems to follow the hand.
/// Chosen, not measured.
const COARSE_WAIT: Duration = Duration::from_secs(1);

/// Longest run whose error is estimated where the window stands still meanwhile.
const STANDSTILL: Duration = Duration::from_millis(100);

/// How long the window must be left alone before the error is estimated.
pub(in crate::app) const IDLE_BEFORE_ESTIMATE: Duration = Duration::from_millis(400);

/// An answer that is shown.
struct Shown {
    answer: Arc<Answer>,
    /// Revision of the scene that it is of.
    revision: u64,
    /// Whether it is of a coarse pass, and the full one follows.
    coarse: bool,
}

/// A scene that is to be run.
struct Next {
    session: Session,
    revision: u64,
}

/// An estimate on a thread.
struct Estimate {
    of: u64,
    done: Receiver<ErrorEstimate>,
}

/// Answer of the scene, and the state of its computation.
pub struct Runner {
    shown: Option<Shown>,
    /// Revision of the scene that was started last.
    revision: u64,
    /// That scene, where it could be run.
    asked: Option<Scene>,
    /// The newest scene, while the coarse pass of an older one is computed.
    waiting: Option<Next>,
    problems: Option<SceneErrors>,
    job: Option<Job>,
    estimate: Option<Estimate>,
    estimates_wanted: bool,
    changed: Instant,
    slow: bool,
    given_up: bool,
    count: u64,
    /// Duration of the scene that was started last \[s\].
    wanted: f64,
    wake: Wake,
}

impl Default for Runner {
    fn default() -> Self {
        Self {
            shown: None,
            revision: 0,
            asked: None,
            waiting: None,
            problems: None,
            job: None,
            estimate: None,
            estimates_wanted: true,
            changed: now(),
            slow: false,
            given_up: false,
            count: 0,
            wanted: 0.0,
            wake: Arc::new(|| ()),
        }
    }
}

impl Runner {
    /// Who is to be told when a thread has news.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// Whether the error is estimated when the window is idle (it is unless told otherwise).
    pub fn set_estimates(&mut self, wanted: bool) {
        self.estimates_wanted = wanted;
    }

    /// The last good answer.
    pub fn answer(&self) -> Option<&Arc<Answer>> {
        self.shown.as_ref().map(|shown| &shown.answer)
    }

    /// The last good answer, if it is the scene's as it is now and not of a coarse pass.
    pub(in crate::app) fn fresh_answer(&self) -> Option<&Arc<Answer>> {
        self.full_answer().filter(|_| !self.is_stale())
    }

    /// The last good answer, unless it is of a coarse pass: what is kept and written is computed in full.
    pub(in crate::app) fn full_answer(&self) -> Option<&Arc<Answer>> {
        self.answer().filter(|_| !self.is_coarse())
    }

    /// Whether the answer is of a coarse pass.
    pub fn is_coarse(&self) -> bool {
        self.shown.as_ref().is_some_and(|shown| shown.coarse)
    }

    /// Revision of the scene whose answer is shown.
    pub(in crate::app) fn answered(&self) -> Option<u64> {
        self.shown.as_ref().map(|shown| shown.revision)
    }

    /// Complaints about the scene as it is now; the answer is an older one then.
    pub fn problems(&self) -> Option<&SceneErrors> {
        self.problems.as_ref()
    }

    /// Whether the answer shown belongs to an older scene.
    pub fn is_stale(&self) -> bool {
        self.problems.is_some() || self.given_up || self.answered().is_none_or(|revision| revision != self.revision)
    }

    /// Whether an answer is shown, and that of the scene before its last edit.
    pub(in crate::app) fn shows_older(&self) -> bool {
        self.is_stale() && self.answer().is_some()
    }

    /// End of what is shown: of the answer, or what the scene asks for \[s\].
    pub fn end(&self) -> f64 {
        self.answer().map_or(self.wanted, |a| a.history.end())
    }

    /// Which of a scene's limits its answer passes, the earliest first; `None` without limits, and while the answer is an
    /// older scene's.
    pub(in crate::app) fn passed(&self, limits: Limits) -> Option<&[Passed]> {
        self.fresh_answer().filter(|_| limits != Limits::default()).map(|answer| answer.passed())
    }

    /// Scene and history to show: an old answer is shown with its own scene, so that the two belong together.
    pub(in crate::app) fn shown<'a>(&'a self, scene: &'a Scene) -> (&'a Scene, Option<&'a History>) {
        let history = self.answer().map(|a| &a.history);
        match history {
            Some(old) if self.is_stale() => (old.scene(), Some(old)),
            _ => (scene, history),
        }
    }

    /// How far the run on a thread has come, 0 to 1.
    pub fn progress(&self) -> Option<f64> {
        self.job.as_ref().map(Job::part)
    }

    /// Runs a scene of this revision; whatever ran before is cancelled, but for a coarse pass that is about to come in. A scene that
    /// only shows otherwise what the one before it computes has that one's answer.
    pub(in crate::app) fn start(&mut self, scene: &Scene, revision: u64) {
        if !self.given_up && self.asked.as_ref().is_some_and(|asked| only_shows_otherwise(asked, scene)) {
            self.go_on_as(revision);
            self.asked = Some(scene.clone());
            return;
        }
        self.asked = None;
        (self.revision, self.given_up, self.waiting) = (revision, false, None);
        self.changed = now();
        self.wanted = scene.duration;
        match Session::new(scene) {
            Ok(session) => {
                self.problems = None;
                self.asked = Some(scene.clone());
                self.waiting = Some(Next { session, revision });
                self.begin_waiting();
            }
            Err(errors) => {
                (self.problems, self.job) = (Some(errors), None);
                // There is nothing that the answer before could be compared with.
                self.shown = self.shown.take().filter(|_| !scene.girders.is_empty());
            }
        }
    }

    /// Sets this revision for the shown, computed and waiting answers of the scene that was started last.
    fn go_on_as(&mut self, revision: u64) {
        let before = std::mem::replace(&mut self.revision, revision);
        let shown = self.shown.as_mut().map(|shown| &mut shown.revision);
        let job = self.job.as_mut().map(|job| &mut job.revision);
        let waiting = self.waiting.as_mut().map(|next| &mut next.revision);
        shown.into_iter().chain(job).chain(waiting).filter(|own| **own == before).for_each(|own| *own = revision);
    }

    /// Begins the scene that waits, unless a coarse pass is to come in first.
    fn begin_waiting(&mut self) {
        if self.job.as_ref().is_some_and(|job| job.is_coarse_still() && job.begun.elapsed() < COARSE_WAIT) {
            return;
        }
        if let Some(next) = self.waiting.take() {
            self.job = None;
            self.begin(next);
        }
    }

    fn begin(&mut self, Next { mut session, revision }: Next) {
        let (start, duration) = (now(), session.scene().duration);
        let budget = if self.slow { Duration::ZERO } else { FRAME_BUDGET };
        let mut in_time = true;
        session.advance(duration, &mut |_| {
            in_time = start.elapsed() < budget;
            in_time
        });
        if in_time {
            self.slow = start.elapsed() > FRAME_BUDGET;
            let answer = Answer::new(session.finish(), start.elapsed(), self.next_number());
            self.take(answer, revision, false);
        } else {
            let numbers = [self.next_number(), self.next_number()];
            self.job = Some(job::spawn((session, start.elapsed()), revision, numbers, self.wake.clone()));
        }
    }

    fn next_number(&mut self) -> u64 {
        self.count += 1;
        self.count
    }

    fn take(&mut self, answer: Answer, revision: u64, coarse: bool) {
        self.shown = Some(Shown { answer: Arc::new(answer), revision, coarse });
    }

    /// Lets go of the answer: another scene is about to be run.
    pub(in crate::app) fn forget(&mut self) {
        (self.shown, self.job, self.waiting, self.given_up) = (None, None, None, false);
        self.asked = None;
    }

    /// Stops the run on a thread; the last good answer stays, and is an older scene's or coarse.
    pub(in crate::app) fn cancel(&mut self) {
        self.waiting = None;
        self.given_up = self.job.take().is_some();
    }

    /// Takes what threads have finished; `true` when there is a new answer.
    pub(in crate::app) fn poll(&mut self) -> bool {
        self.poll_estimate();
        let mut news = false;
        while let Some(job) = &mut self.job {
            let (revision, brought) = (job.revision, job.take());
            match brought {
                Ok(job::Brought { answer, coarse }) => {
                    if !coarse {
                        self.slow = answer.took > FRAME_BUDGET;
                        self.job = None;
                    }
                    self.take(answer, revision, coarse);
                    self.changed = now();
                    news = true;
                }
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => {
                    self.job = None;
                    self.given_up = self.waiting.is_none();
                }
            }
        }
        self.begin_waiting();
        news
    }

    fn poll_estimate(&mut self) {
        let Some(estimate) = &self.estimate else { return };
        let error = match estimate.done.try_recv() {
            Ok(error) => error,
            Err(TryRecvError::Empty) => return,
            // Not to be tried again and again.
            Err(TryRecvError::Disconnected) => ErrorEstimate::UNKNOWN,
        };
        if let Some(answer) = self.answer().filter(|a| a.number == estimate.of) {
            answer.set_error(error);
        }
        self.estimate = None;
    }

    /// Starts the estimate of the error when all is quiet; says when to ask again, if it should be asked again.
    pub(in crate::app) fn when_idle(&mut self) -> Option<Duration> {
        let answer = self.fresh_answer()?;
        if !self.estimates_wanted || answer.error().is_some() || self.estimate.is_some() {
            return None;
        }
        let quiet = self.changed.elapsed();
        if quiet < IDLE_BEFORE_ESTIMATE {
            return Some(IDLE_BEFORE_ESTIMATE.saturating_sub(quiet));
        }
        if !THREADS && answer.took > STANDSTILL {
            // It takes a few times as long as the run.
            answer.set_error(ErrorEstimate::UNKNOWN);
            return None;
        }
        let (send, done) = channel();
        let (asked, wake) = (answer.clone(), self.wake.clone());
        // It ends by itself.
        let _ = spawn(move || {
            // Nobody listens any more when the window has closed: nothing to do then.
            let _ = send.send(ErrorEstimate::of(&asked.history).of_whole().unwrap_or(ErrorEstimate::UNKNOWN));
            wake();
        });
        self.estimate = Some(Estimate { of: answer.number, done });
        None
    }

    /// Waits until the run on a thread has ended (tests).
    pub fn wait(&mut self) {
        while self.job.is_some() {
            if !self.poll() {
                std::thread::sleep(Duration::from_millis(1));
            }
        }
    }
}

/// Whether two scenes differ, and in how they are shown alone.
fn only_shows_otherwise(before: &Scene, after: &Scene) -> bool {
    before.view != after.view && Scene { view: after.view.clone(), ..before.clone() } == *after
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn another_view_of_a_scene_asks_for_no_run() {
        let scene = presets::load("deck-30m").expect("ships");
        let mut other = scene.clone();
        other.view.plots.push(crate::scene::PlotSettings::over_time(vec!["deck.x".to_owned()]));
        let mut runner = Runner::default();
        runner.start(&scene, 1);
        runner.start(&other, 2);
        runner.wait();
        let number = runner.fresh_answer().expect("of the second, computed for the first").number;
        runner.start(&scene, 3);
        assert_eq!(runner.fresh_answer().map(|answer| answer.number), Some(number), "at once");
        runner.start(&Scene { duration: 4.0, ..other }, 4);
        assert!(runner.is_stale(), "another run is another answer");
    }

    #[test]
    fn edits_of_a_large_scene_are_followed_coarsely_and_the_last_in_full() {
        let scene = presets::load("deck-30m").expect("ships");
        let mut runner = Runner::default();
        for revision in 1..=3 {
            // Each a little longer: which answer is whose is seen by its end. None is computed within a frame.
            let scene = Scene { duration: 40.0 + revision as f64, ..scene.clone() };
            runner.start(&scene, revision);
            assert!(runner.is_stale(), "its answer is not there yet");
        }
        let mut seen = Vec::new();
        while runner.progress().is_some() {
            if runner.poll() {
                let answered = runner.answered().expect("an answer");
                seen.push(answered);
                assert_eq!(runner.end(), 40.0 + answered as f64, "the run of its own scene");
                assert_eq!(runner.full_answer().is_none(), runner.is_coarse(), "a coarse one is kept for nothing");
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        assert_eq!(seen.last(), Some(&3), "the last one comes in: {seen:?}");
        assert!(!seen.contains(&2), "the second was overtaken while it waited: {seen:?}");
        assert!(!runner.is_stale() && !runner.is_coarse() && runner.fresh_answer().is_some(), "in full");
        let tolerance = runner.answer().map(|answer| answer.history.scene().solver.tolerance);
        assert_eq!(tolerance, Some(scene.solver.tolerance), "at the scene's own tolerance");
    }
}
