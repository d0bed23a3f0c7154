//! Runs the scene that is shown: at once when it is quick, on a thread with progress and cancel when it is not.
//!
//! The last good answer stays in view until a better one is there; a scene that cannot be run leaves its complaints.
//! When the window is idle, a thread estimates the error of the answer.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::{Duration, Instant};

use crate::app::host::{Wake, now};
use crate::app::run::answer::Answer;
use crate::scene::{Limits, Scene, SceneErrors};
use crate::sim::readings::Passed;
use crate::sim::{History, Session};

/// How long a run may hold up a frame before it goes on on a thread.
const AT_ONCE: Duration = Duration::from_millis(30);

/// How long the window must be left alone before the error is estimated.
pub(in crate::app) const IDLE_BEFORE_ESTIMATE: Duration = Duration::from_millis(400);

/// A run on a thread.
struct Job {
    cancel: Arc<AtomicBool>,
    /// Time reached, as the bits of an `f64` \[s\].
    reached: Arc<AtomicU64>,
    duration: f64,
    done: Receiver<Option<Answer>>,
}

impl Drop for Job {
    fn drop(&mut self) {
        self.cancel.store(true, Ordering::Relaxed);
    }
}

/// An estimate on a thread.
struct Estimate {
    of: u64,
    done: Receiver<f64>,
}

/// What the scene's answer is, or what became of it.
pub struct Runner {
    answer: Option<Arc<Answer>>,
    problems: Option<SceneErrors>,
    job: Option<Job>,
    estimate: Option<Estimate>,
    estimates_wanted: bool,
    changed: Instant,
    slow: bool,
    given_up: bool,
    count: u64,
    /// What the scene that was started last asks for \[s\].
    wanted: f64,
    wake: Wake,
}

impl Default for Runner {
    fn default() -> Self {
        Self {
            answer: None,
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
        self.answer.as_ref()
    }

    /// The last good answer, if it is the scene's as it is now.
    pub(in crate::app) fn fresh_answer(&self) -> Option<&Arc<Answer>> {
        self.answer().filter(|_| !self.is_stale())
    }

    /// Complaints about the scene as it is now; the answer is an older one then.
    pub fn problems(&self) -> Option<&SceneErrors> {
        self.problems.as_ref()
    }

    /// Whether the answer shown belongs to an older scene.
    pub fn is_stale(&self) -> bool {
        self.problems.is_some() || self.job.is_some() || self.given_up
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

    /// What is to be shown of a scene: an old answer is shown with its own scene, so that the two belong together.
    pub(in crate::app) fn shown<'a>(&'a self, scene: &'a Scene) -> (&'a Scene, Option<&'a History>) {
        let history = self.answer().map(|a| &a.history);
        match history {
            Some(old) if self.is_stale() => (old.scene(), Some(old)),
            _ => (scene, history),
        }
    }

    /// How far the run on a thread has come, 0 to 1.
    pub fn progress(&self) -> Option<f64> {
        let job = self.job.as_ref()?;
        let reached = f64::from_bits(job.reached.load(Ordering::Relaxed));
        Some(if job.duration > 0.0 { (reached / job.duration).clamp(0.0, 1.0) } else { 0.0 })
    }

    /// Runs a scene; whatever ran before is cancelled.
    pub(in crate::app) fn start(&mut self, scene: &Scene) {
        self.job = None;
        self.given_up = false;
        self.changed = now();
        self.wanted = scene.duration;
        match Session::new(scene) {
            Ok(session) => {
                self.problems = None;
                self.begin(session, scene);
            }
            Err(errors) => self.problems = Some(errors),
        }
    }

    fn begin(&mut self, mut session: Session, scene: &Scene) {
        let start = now();
        let budget = if self.slow { Duration::ZERO } else { AT_ONCE };
        let mut in_time = true;
        session.advance(scene.duration, &mut |_| {
            in_time = start.elapsed() < budget;
            in_time
        });
        self.count += 1;
        if in_time {
            self.slow = start.elapsed() > AT_ONCE;
            self.answer = Some(Arc::new(Answer::new(session.finish(), start.elapsed(), self.count)));
        } else {
            self.job = Some(self.spawn(session, scene.duration, start));
        }
    }

    fn spawn(&self, mut session: Session, duration: f64, start: Instant) -> Job {
        let (send, done) = channel();
        let cancel = Arc::new(AtomicBool::new(false));
        let reached = Arc::new(AtomicU64::new(0));
        let (cancelled, told, wake, number) = (cancel.clone(), reached.clone(), self.wake.clone(), self.count);
        std::thread::spawn(move || {
            session.advance(duration, &mut |reached| {
                told.store(reached.t.to_bits(), Ordering::Relaxed);
                !cancelled.load(Ordering::Relaxed)
            });
            if !cancelled.load(Ordering::Relaxed) {
                // Nobody listens any more when the window has closed: nothing to do then.
                let _ = send.send(Some(Answer::new(session.finish(), start.elapsed(), number)));
                wake();
            }
        });
        Job { cancel, reached, duration, done }
    }

    /// Lets go of the answer: another scene is about to be run.
    pub(in crate::app) fn forget(&mut self) {
        (self.answer, self.job, self.given_up) = (None, None, false);
    }

    /// Stops the run on a thread; the last good answer stays, and is an older scene's.
    pub(in crate::app) fn cancel(&mut self) {
        self.given_up = self.job.take().is_some();
    }

    /// Takes what threads have finished; `true` when there is a new answer.
    pub(in crate::app) fn poll(&mut self) -> bool {
        self.poll_estimate();
        let Some(job) = &self.job else { return false };
        match job.done.try_recv() {
            Ok(answer) => {
                self.slow = answer.as_ref().is_some_and(|a| a.took > AT_ONCE);
                self.answer = answer.map(Arc::new);
                self.changed = now();
                self.job = None;
                true
            }
            Err(TryRecvError::Empty) => false,
            Err(TryRecvError::Disconnected) => {
                self.job = None;
                self.given_up = true;
                false
            }
        }
    }

    fn poll_estimate(&mut self) {
        let Some(estimate) = &self.estimate else { return };
        let error = match estimate.done.try_recv() {
            Ok(error) => error,
            Err(TryRecvError::Empty) => return,
            // Not to be tried again and again.
            Err(TryRecvError::Disconnected) => f64::NAN,
        };
        if let Some(answer) = self.answer.as_ref().filter(|a| a.number == estimate.of) {
            answer.set_error(error);
        }
        self.estimate = None;
    }

    /// Starts the estimate of the error when all is quiet; says when to ask again, if it should be asked again.
    pub(in crate::app) fn when_idle(&mut self) -> Option<Duration> {
        let answer = self.answer.as_ref()?;
        if !self.estimates_wanted || self.is_stale() || answer.error().is_some() || self.estimate.is_some() {
            return None;
        }
        let quiet = self.changed.elapsed();
        if quiet < IDLE_BEFORE_ESTIMATE {
            return Some(IDLE_BEFORE_ESTIMATE.saturating_sub(quiet));
        }
        let (send, done) = channel();
        let (asked, wake) = (answer.clone(), self.wake.clone());
        std::thread::spawn(move || {
            // Nobody listens any more when the window has closed: nothing to do then.
            let _ = send.send(asked.history.estimate_error());
            wake();
        });
        self.estimate = Some(Estimate { of: answer.number, done });
        None
    }

    /// Waits for the run on a thread (tests, export).
    pub fn wait(&mut self) {
        while self.job.is_some() {
            if !self.poll() {
                std::thread::sleep(Duration::from_millis(1));
            }
        }
    }
}
