//! A watch over runs: what takes too long is ended and said so, and what has seen enough is cut. The physics itself
//! knows no clock.

use crate::scene::{Scene, SceneErrors};
use crate::sim::{History, Session};

/// Seconds since some start; who may look at a clock passes it in.
pub type Clock<'a> = &'a (dyn Fn() -> f64 + Sync);

/// What the runs of one seed may take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Seconds of the clock.
    pub patience: f64,
    /// Events after which a run is long enough.
    pub events: usize,
}

/// Portions of a run, each [`GROWTH`] times the one before it: whatever its pace, few more events come up than are
/// asked for. [`Session::advance`] asks 200 times in each.
const PORTIONS: i32 = 100;
/// How fast portions grow: the first is 1e-8 of the run.
const GROWTH: f64 = 1.2;

/// A clock and the time until which there is patience.
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

/// Why a run has no whole answer.
#[derive(Clone, Debug, PartialEq)]
pub enum NoAnswer {
    /// Validation refused the scene.
    Refused(SceneErrors),
    /// It took too long; the time that it came to \[s\].
    Slow(f64),
}

impl<'a> Watch<'a> {
    /// Patience for so many seconds from now.
    pub fn new(clock: Clock<'a>, patience: f64) -> Self {
        Self { clock, until: clock() + patience }
    }

    /// Whether patience is at its end.
    pub fn is_over(&self) -> bool {
        (self.clock)() > self.until
    }

    /// Runs a scene while there is patience, and no further than a little beyond so many events.
    ///
    /// # Errors
    /// A scene that validation refuses, or a run that took too long.
    pub fn run(&self, scene: &Scene, events: usize) -> Result<History, NoAnswer> {
        let mut session = Session::new(scene).map_err(NoAnswer::Refused)?;
        for portion in 1..=PORTIONS {
            let until = scene.duration * GROWTH.powi(portion - PORTIONS);
            if !self.advance(&mut session, until, events)? {
                break;
            }
        }
        Ok(session.finish())
    }

    /// Brings a run on to `until` \[s\] while there is patience, or to a little beyond so many events; whether it came to
    /// `until`.
    ///
    /// # Errors
    /// It took too long.
    pub fn advance(&self, session: &mut Session, until: f64, events: usize) -> Result<bool, NoAnswer> {
        let (mut slow, mut fewer) = (None, true);
        session.advance(until, &mut |reached| {
            slow = self.is_over().then_some(reached.t);
            fewer = reached.events <= events;
            slow.is_none() && fewer
        });
        slow.map_or(Ok(fewer), |reached| Err(NoAnswer::Slow(reached)))
    }
}
