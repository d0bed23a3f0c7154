//! A run beside the window: a coarse pass first where the scene asks for a finer one, then the full one; progress and cancel.

use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::time::Duration;

use crate::app::host::{Instant, Slices, Wake, in_slices, now};
use crate::app::run::answer::Answer;
use crate::scene::{Scene, SolverSettings};
use crate::sim::Session;

/// Tolerance of the coarse pass: the coarsest of the domain (docs/stability.md). Measured on deck-30m: 0.2 µm from the exact run, at a sixth
/// of the full pass's instructions.
const COARSE: f64 = 1e-4;

/// An answer, and which pass it is of.
pub(super) struct Brought {
    pub(super) answer: Answer,
    pub(super) coarse: bool,
}

/// A run beside the window; dropped, it ends.
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
    work: Slices,
}

/// Messages between the run and the window.
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

    /// Next message.
    ///
    /// # Errors
    /// Nothing yet, or nothing more.
    pub(super) fn take(&mut self) -> Result<Brought, TryRecvError> {
        self.work.go_on();
        let brought = self.done.try_recv()?;
        self.coarse = false;
        Ok(brought)
    }
}

/// Begins a run that has taken some time already; its answers have these numbers.
pub(super) fn spawn((session, took): (Session, Duration), revision: u64, numbers: [u64; 2], wake: Wake) -> Job {
    let (send, done) = channel();
    let (reached, duration) = (Arc::new(Reached::default()), session.scene().duration);
    let first = coarse(session.scene());
    let coarse = first.is_some();
    let mut passes: VecDeque<Pass> = first
        .map(|session| Pass { session, took: Duration::ZERO, number: numbers[0], coarse: true })
        .into_iter()
        .chain([Pass { session, took, number: numbers[1], coarse: false }])
        .collect();
    let tell = Tell { reached: reached.clone(), send, wake: wake.clone() };
    let work = in_slices(move |portion| tell.go_on(&mut passes, portion), wake);
    Job { begun: now(), revision, coarse, reached, duration, done, work }
}

/// The coarse pass of a scene; none where the scene asks for no finer one.
fn coarse(scene: &Scene) -> Option<Session> {
    let solver = SolverSettings { tolerance: COARSE, ..scene.solver };
    let coarser = scene.solver.tolerance < COARSE;
    coarser.then(|| Session::new(&Scene { solver, ..scene.clone() }).ok()).flatten()
}

/// A run at one tolerance, as far as it has come.
struct Pass {
    session: Session,
    took: Duration,
    number: u64,
    coarse: bool,
}

/// The run's end of a job.
struct Tell {
    reached: Arc<Reached>,
    send: Sender<Brought>,
    wake: Wake,
}

impl Tell {
    /// Computes for a while; whether there is more to be computed.
    fn go_on(&self, passes: &mut VecDeque<Pass>, portion: Duration) -> bool {
        let Some(pass) = passes.front_mut() else { return false };
        let (begun, duration) = (now(), pass.session.scene().duration);
        let mut whole = true;
        pass.session.advance(duration, &mut |reached| {
            self.reached.t.store(reached.t.to_bits(), Ordering::Relaxed);
            whole = !self.reached.is_cancelled() && begun.elapsed() < portion;
            whole
        });
        pass.took += begun.elapsed();
        if self.reached.is_cancelled() {
            return false;
        }
        if whole && let Some(pass) = passes.pop_front() {
            self.bring(pass);
        }
        !passes.is_empty()
    }

    fn bring(&self, Pass { session, took, number, coarse }: Pass) {
        let begun = now();
        let history = session.finish();
        let answer = Answer::new(history, took + begun.elapsed(), number);
        // Nobody listens any more when the window has closed: nothing to do then.
        let _ = self.send.send(Brought { answer, coarse });
        (self.wake)();
    }
}
