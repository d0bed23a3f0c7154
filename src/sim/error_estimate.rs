//! The estimated error of a run: its difference from a run at a hundredth of the tolerance.

use super::{Cause, History, Session};
use crate::scene::{FINEST_TOLERANCE, ModelKind};

/// The estimated error of displacements, and until when it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorEstimate {
    /// Largest difference in displacement from the finer run \[m\]; NaN where there is none.
    pub error: f64,
    /// Where the finer run gave up before the end of this one: until when they were compared \[s\].
    pub until: Option<f64>,
}

impl ErrorEstimate {
    /// The error \[m\] where it is one of the whole run.
    pub fn of_whole(&self) -> Option<f64> {
        self.until.is_none().then_some(self.error)
    }
}

impl History {
    /// Largest displacement difference from a run at a hundredth of the tolerance.
    pub fn estimate_error(&self) -> ErrorEstimate {
        let mut finer = self.scene().clone();
        finer.model.kind = if self.impact().is_some() { ModelKind::Impact } else { ModelKind::Contact };
        finer.solver.tolerance = (self.scene().solver.tolerance / 100.0).max(FINEST_TOLERANCE);
        if self.scene().solver.tolerance <= FINEST_TOLERANCE {
            // There is no finer tolerance: the difference from a run at ten times as much estimates the error of that run.
            finer.solver.tolerance = 10.0 * FINEST_TOLERANCE;
        }
        // The scene has been run before: it has no complaint.
        let Ok(session) = Session::with_met(&finer, self.model().bodies_met()) else {
            return ErrorEstimate { error: f64::NAN, until: None };
        };
        let finer = session.complete();
        ErrorEstimate { error: self.difference(&finer), until: finer.ends_before(self) }
    }

    /// Until when it was computed \[s\], where its computation gave up before another run ends.
    pub(super) fn ends_before(&self, other: &Self) -> Option<f64> {
        let stop = self.stop().filter(|stop| stop.cause == Cause::Computation)?;
        (stop.t < other.end()).then_some(stop.t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::scene::presets;

    #[test]
    fn a_run_that_gives_up_is_no_measure_of_what_comes_after() {
        let mut scene = presets::load("deck-30m").expect("a preset");
        scene.duration = 12.0;
        let whole = History::of(&scene).expect("a scene");
        // Memory is looked at every few thousand steps.
        let bounded = Model { memory: 1 << 16, ..Model::compile(&scene).expect("a scene") };
        let mut session = Session::of_model(&scene, bounded);
        session.advance(scene.duration, &mut |_| true);
        let stopped = session.finish();
        let until = stopped.ends_before(&whole);
        assert!(until.is_some_and(|t| 0.0 < t && t == stopped.end() && t < 12.0), "{until:?}");
        assert_eq!((whole.ends_before(&stopped), whole.ends_before(&whole)), (None, None));
        assert_eq!(ErrorEstimate { error: 1e-9, until }.of_whole(), None);
    }
}
