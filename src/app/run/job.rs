//! A run on a thread: a coarse pass first where the scene asks for a finer one, then the full one; progress and cancel.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::time::{Duration, Instant};

use crate::app::host::{Wake, now};
use crate::app::run::answer::Answer;
use crate::scene::{Scene, SolverSettings};
use crate::sim::Session;

/// Tolerance of the coarse pass. deck-30m is then 0.2 µm from the exact run (docs/cost.md has that at 2e-4) at a sixth of the full
/// pass's instructions.
const COARSE: f64 = 1e-4;

/// An answer, and which pass it is of.
pub(super) struct Brought {
    pub(super) answer: Answer,
    pub(super) coarse: bool,
}

/// A run on a thread; dropped, it ends.
pub(super) struct Job {
    /// When it was begun.
    pub(super) begun: Instant,
    /// Revision of the scene that it is of.
    pub(super) revision: u64,
    /// Whether the coarse pass has not come in.
    coarse: bool,
    reached: Arc<Reached>,
    duration: f64,
    done: Receiver<Brought>,
}

/// What the thread and the window tell each other.
#[derive(Default)]
struct Reached {
    cancelled: AtomicBool,
    /// Time reached, as the bits of an `f64` \[s\].
    t: AtomicU64,
}

impl Reached {
    fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        self.reached.cancelled.store(true, Ordering::Relaxed);
    }
}

impl Job {
    /// How far the pass that is computed has come, 0 to 1.
    pub(super) fn part(&self) -> f64 {
        let reached = f64::from_bits(self.reached.t.load(Ordering::Relaxed));
        if self.duration > 0.0 { (reached / self.duration).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Whether the coarse pass has not come in.
    pub(super) fn is_coarse_still(&self) -> bool {
        self.coarse
    }

    /// What it has brought.
    ///
    /// # Errors
    /// Nothing yet, or nothing more.
    pub(super) fn take(&mut self) -> Result<Brought, TryRecvError> {
        let brought = self.done.try_recv()?;
        self.coarse = false;
        Ok(brought)
    }
}

/// Begins a run that has taken some time already; its answers have these numbers.
pub(super) fn spawn((session, took): (Session, Duration), revision: u64, numbers: [u64; 2], wake: Wake) -> Job {
    let (send, done) = channel();
    let (reached, duration) = (Arc::new(Reached::default()), session.scene().duration);
    let coarse = coarse(session.scene());
    let job = Job { begun: now(), revision, coarse: coarse.is_some(), reached: reached.clone(), duration, done };
    std::thread::spawn(move || {
        let tell = Tell { reached, send, wake };
        if let Some(session) = coarse {
            tell.pass(session, Duration::ZERO, numbers[0], true);
        }
        tell.pass(session, took, numbers[1], false);
    });
    job
}

/// The coarse pass of a scene; none where the scene asks for no finer one.
fn coarse(scene: &Scene) -> Option<Session> {
    let solver = SolverSettings { tolerance: COARSE, ..scene.solver };
    let coarser = scene.solver.tolerance < COARSE;
    coarser.then(|| Session::new(&Scene { solver, ..scene.clone() }).ok()).flatten()
}

/// The thread's end of a job.
struct Tell {
    reached: Arc<Reached>,
    send: Sender<Brought>,
    wake: Wake,
}

impl Tell {
    fn pass(&self, mut session: Session, took: Duration, number: u64, coarse: bool) {
        let (begun, duration) = (now(), session.scene().duration);
        session.advance(duration, &mut |reached| {
            self.reached.t.store(reached.t.to_bits(), Ordering::Relaxed);
            !self.reached.is_cancelled()
        });
        if self.reached.is_cancelled() {
            return;
        }
        let answer = Answer::new(session.finish(), took + begun.elapsed(), number);
        // Nobody listens any more when the window has closed: nothing to do then.
        let _ = self.send.send(Brought { answer, coarse });
        (self.wake)();
    }
}
