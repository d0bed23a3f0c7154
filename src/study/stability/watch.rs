//! Time limits of runs: one that takes too long is ended with a complaint, and one with enough events is cut. The physics itself has no
//! clock.

use crate::scene::{Scene, SceneErrors};
use crate::sim::{History, Session};

/// Seconds since some start; who may look at a clock passes it in.
pub type Clock<'a> = &'a (dyn Fn() -> f64 + Sync);

/// Limits of the runs of one seed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Seconds of the clock.
    pub patience: f64,
    /// Events after which a run is long enough.
    pub events: usize,
    /// Steps of integrators after which it is.
    pub steps: u64,
}

impl Limits {
    /// No time limit, and no limit of events or steps.
    pub const NONE: Self = Self { patience: f64::INFINITY, events: usize::MAX, steps: u64::MAX };
}

/// Portions of a run, each [`GROWTH`] times the one before it: whatever its pace, few more events come up than are
/// asked for. [`Session::advance`] asks 200 times in each.
const PORTIONS: i32 = 100;
/// Growth of the portions \[–\]: the first is 1e-8 of the run.
const GROWTH: f64 = 1.2;

/// A clock and the end of the time limit.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    clock: Clock<'a>,
    until: f64,
}

impl std::fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Watch").field("until", &self.until).finish_non_exhaustive()
    }
}

/// Reasons why a run has no whole answer.
#[derive(Clone, Debug, PartialEq)]
pub enum NoAnswer {
    /// Validation refused the scene.
    Refused(SceneErrors),
    /// It took too long; the time that it came to \[s\].
    Slow(f64),
}

impl<'a> Watch<'a> {
    /// A time limit of `patience` seconds from now.
    pub fn new(clock: Clock<'a>, patience: f64) -> Self {
        Self { clock, until: clock() + patience }
    }

    /// Whether the time limit has passed.
    pub fn is_over(&self) -> bool {
        (self.clock)() > self.until
    }

    /// Runs a scene within the time limit, and not much beyond the given number of events or steps; an answer that was ended there is that
    /// of a scene that ends there.
    ///
    /// # Errors
    /// A scene that validation refuses, or a run that took too long.
    pub fn run(&self, scene: &Scene, limits: Limits) -> Result<History, NoAnswer> {
        let mut session = Session::new(scene).map_err(NoAnswer::Refused)?;
        let mut ended = None;
        for portion in 1..=PORTIONS {
            let until = scene.duration * GROWTH.powi(portion - PORTIONS);
            ended = self.advance(&mut session, until, limits)?;
            if ended.is_some() {
                break;
            }
        }
        let history = session.finish();
        let Some(ended) = ended.filter(|_| history.stop().is_none()) else { return Ok(history) };
        let last_event = history.events().get(limits.events).map(|event| event.t);
        Ok(history.cut(last_event.unwrap_or(ended)))
    }

    /// Runs on to `until` \[s\] within the time limit; returns the time reached \[s\] where the limit of events or steps ended it before.
    ///
    /// # Errors
    /// It took too long.
    pub fn advance(&self, session: &mut Session, until: f64, limits: Limits) -> Result<Option<f64>, NoAnswer> {
        let (mut slow, mut enough) = (None, None);
        session.advance(until, &mut |reached| {
            slow = self.is_over().then_some(reached.t);
            enough = (reached.events > limits.events || reached.steps > limits.steps).then_some(reached.t);
            slow.is_none() && enough.is_none()
        });
        slow.map_or(Ok(enough), |reached| Err(NoAnswer::Slow(reached)))
    }
}
