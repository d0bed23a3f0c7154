//! A wall-clock watch over runs: what takes too long is ended and said so. The physics itself knows no clock.

use crate::scene::{Scene, SceneErrors};
use crate::sim::{History, Session};

/// Seconds since some start; who may look at a clock passes it in.
pub type Clock<'a> = &'a (dyn Fn() -> f64 + Sync);

/// Portions after which a run looks at the clock; [`Session::advance`] divides each by 200 more.
const PORTIONS: u32 = 50;

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

    /// Runs a scene while there is patience.
    ///
    /// # Errors
    /// A scene that validation refuses, or a run that took too long.
    pub fn run(&self, scene: &Scene) -> Result<History, NoAnswer> {
        let mut session = Session::new(scene).map_err(NoAnswer::Refused)?;
        let mut slow = None;
        for portion in 1..=PORTIONS {
            let until = scene.duration * f64::from(portion) / f64::from(PORTIONS);
            session.advance(until, &mut |reached| {
                if self.is_over() {
                    slow = Some(reached);
                }
                slow.is_none()
            });
            if let Some(reached) = slow {
                return Err(NoAnswer::Slow(reached));
            }
        }
        Ok(session.finish())
    }
}
