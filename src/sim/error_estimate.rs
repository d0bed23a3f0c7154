//! The estimated error of a run: its difference from a run at a hundredth of the tolerance.

use super::{Cause, History, Session};
use crate::scene::{FINEST_TOLERANCE, ModelKind};

/// The estimated error of displacements and attitudes, and until when it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorEstimate {
    /// Largest difference in displacement of G from the finer run \[m\]; NaN where there is none.
    pub error: f64,
    /// Largest difference in attitude \[rad\].
    pub rotation: f64,
    /// Where the finer run gave up before the end of this one: until when they were compared \[s\].
    pub until: Option<f64>,
}

impl ErrorEstimate {
    /// Of a run without a finer one to compare it with.
    pub const UNKNOWN: Self = Self { error: f64::NAN, rotation: f64::NAN, until: None };

    /// The error where it is one of the whole run.
    pub fn of_whole(self) -> Option<Self> {
        self.until.is_none().then_some(self)
    }
}

impl History {
    /// Largest differences in displacement and attitude from a run at a hundredth of the tolerance.
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
            return ErrorEstimate::UNKNOWN;
        };
        let finer = session.complete();
        let [error, rotation] = self.differences(&finer);
        ErrorEstimate { error, rotation, until: finer.ends_before(self) }
    }

    /// Largest distance of a corner of a girder from its G, by which rotations move it \[m\].
    pub fn farthest_corner(&self) -> f64 {
        self.model().girders().iter().map(|body| body.radius).fold(0.0, f64::max)
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
    use crate::scene::format;
    use crate::scene::presets;

    #[test]
    fn a_girder_that_only_tumbles_errs_in_its_attitude() {
        let scene = format::parse(
            "name = \"spin\"\nkind = \"spatial\"\nduration_s = 2.0\ngravity_m_s2 = 0.0\n[[girder]]\nname = \"deck\"\n\
             length_m = 10.0\nwidth_m = 3.0\nthickness_m = 1.0\nmass_kg = 2e4\n\
             initial = { spin_deg_s = 1.0, roll_deg_s = 2.0, pitch_deg_s = 600.0 }\n[solver]\ntolerance = 1e-6\n",
            "spin",
        );
        let (rough, mut finest) = (scene.clone().expect("a scene"), scene.expect("a scene"));
        finest.solver.tolerance = 1e-12;
        let [rough, finest] = [rough, finest].map(|scene| History::of(&scene).expect("runs"));
        let corner = |run: &History, t| run.motion(0, t).attitude * glam::DVec3::new(5.0, 1.5, 0.5);
        let times = (0..=100).map(|i| 0.02 * f64::from(i));
        let off = times.map(|t| (corner(&rough, t) - corner(&finest, t)).length()).fold(0.0, f64::max);
        let ErrorEstimate { error, rotation, .. } = rough.estimate_error();
        let told = error + rough.model().bodies[0].radius * rotation;
        assert!(off > 1e-8, "it errs: {off} m");
        assert!((off..4.0 * off).contains(&told), "a corner is {off} m off, told {error} m and {rotation} rad");
    }

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
        assert_eq!(ErrorEstimate { error: 1e-9, rotation: 1e-10, until }.of_whole(), None);
    }
}
