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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_exerts_no_force_and_ends_the_run_once_its_point_has_dropped_by_the_depth() {
        let (watch, up) = (DropWatch(0.25), Phase::default());
        let sinking = Separation { moved: DVec3::new(3.0, 2.0, -0.1), rate: DVec3::Z * -0.4, ..Separation::default() };
        let [left, rate] = watch.gap(&up, &sinking);
        assert!((left - 0.15).abs() < 1e-15, "of 0.25 m 0.1 are used up, got {left}");
        assert_eq!(rate, -0.4, "as fast as it sinks, whatever it does in plan");
        assert_eq!(watch.initial(&sinking), up);
        assert_eq!((watch.activity(&up), watch.ends_run(&up)), (Activity::Idle, false));
        let (dropped, released) = watch.next(Switch::Closing, &up, &sinking);
        assert_eq!((watch.activity(&dropped), watch.ends_run(&dropped), released), (Activity::Ended, true, 0.0));
        for phase in [up, dropped] {
            assert_eq!(watch.force(&phase, &sinking), DVec3::ZERO);
            assert_eq!([watch.stored_energy(&phase, &sinking), watch.dissipated_power(&phase, &sinking)], [0.0; 2]);
        }
    }

    #[test]
    fn in_free_fall_the_second_derivative_of_its_gap_is_the_bound() {
        let (watch, up) = (DropWatch(0.25), Phase::default());
        let fallen = |t: f64| Separation { moved: DVec3::Z * (-0.5 * 9.81 * t * t), ..Separation::default() };
        let gap = |t: f64| watch.gap(&up, &fallen(t))[0];
        let second = (gap(0.2) - 2.0 * gap(0.1) + gap(0.0)) / 0.01;
        let bound = watch.gap_curvature(&up, &SeparationBounds { distance: 9.0, speed: 9.0, acceleration: 9.81 });
        assert!((second + bound).abs() < 1e-12, "{second} m/s² against {bound}");
    }
}
