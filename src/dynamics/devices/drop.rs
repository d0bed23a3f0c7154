//! A watch without force on how far a corner of a girder in space drops: the first point along the third axis of its link
//! (`docs/physics.md#loss-of-support`). Pier tops are no bodies, so that a girder off its supports would fall for ever.

use glam::DVec3;

use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Phase, Separation, SeparationBounds, Switch,
};
use crate::language::Text;

/// Ends the run where its point has dropped by this depth \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DropWatch(pub f64);

const DROPPED: u32 = 1;

impl Connection for DropWatch {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, _: &Phase, _: &Separation) -> DVec3 {
        DVec3::ZERO
    }

    fn stored_energy(&self, _: &Phase, _: &Separation) -> f64 {
        0.0
    }

    fn dissipated_power(&self, _: &Phase, _: &Separation) -> f64 {
        0.0
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        0.0
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        0.0
    }
}

impl Device for DropWatch {
    fn initial(&self, _: &Separation) -> Phase {
        Phase::default()
    }

    fn activity(&self, phase: &Phase) -> Activity {
        if phase.branch == DROPPED { Activity::Ended } else { Activity::Idle }
    }

    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        [self.0 + motion.moved.z, motion.rate.z]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }

    fn ends_run(&self, phase: &Phase) -> bool {
        phase.branch == DROPPED
    }

    fn next(&self, _: Switch, _: &Phase, _: &Separation) -> (Phase, f64) {
        (Phase { branch: DROPPED, ..Phase::default() }, 0.0)
    }
}

impl DeviceReadings for DropWatch {
    fn state(&self, phase: &Phase) -> Text {
        if phase.branch == DROPPED { Text::new("state-dropped") } else { Text::new("state-up") }
    }

    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.gap(phase, motion)[0]
    }

    /// Empty: it has no line in a drawing.
    fn centre_line(&self, _: &Phase, _: [DVec3; 2]) -> Vec<DVec3> {
        Vec::new()
    }
}
