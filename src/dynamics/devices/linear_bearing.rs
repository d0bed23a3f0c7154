//! A bearing between two bodies that move: a girder and the pier that it stands on. Spring and dashpot per axis, always acting,
//! `F = −K u − C u̇` with the displacement u of the girder's point against the pier's.

use glam::DVec3;

use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Phase, Separation, SeparationBounds, acts_or_open,
};
use crate::language::Text;

/// Springs and dashpots along three axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearBearing {
    /// `k` along the axes of the link \[N/m\].
    pub stiffness: DVec3,
    /// `c` along the axes of the link \[N·s/m\].
    pub damping: DVec3,
}

impl Connection for LinearBearing {
    type State = Phase;
    type Motion = Separation;

    #[inline]
    fn force(&self, _: &Phase, motion: &Separation) -> DVec3 {
        -self.stiffness * motion.moved - self.damping * motion.rate
    }

    fn stored_energy(&self, _: &Phase, motion: &Separation) -> f64 {
        0.5 * motion.moved.dot(self.stiffness * motion.moved)
    }

    fn dissipated_power(&self, _: &Phase, motion: &Separation) -> f64 {
        motion.rate.dot(self.damping * motion.rate)
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        self.stiffness.max_element()
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        self.damping.max_element()
    }
}

impl Device for LinearBearing {
    fn initial(&self, _: &Separation) -> Phase {
        Phase::default()
    }

    fn activity(&self, _: &Phase) -> Activity {
        Activity::Acts
    }

    fn linear(&self) -> Option<[DVec3; 2]> {
        Some([self.stiffness, self.damping])
    }

    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        [-motion.moved.length(), -motion.rate.length()]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }
}

impl DeviceReadings for LinearBearing {
    fn state(&self, phase: &Phase) -> Text {
        acts_or_open(self.acts(phase))
    }

    fn distance_left(&self, _: &Phase, _: &Separation) -> f64 {
        f64::NAN
    }

    /// No line: the bearing itself is drawn.
    fn centre_line(&self, _: &Phase, _: [DVec3; 2]) -> Vec<DVec3> {
        Vec::new()
    }
}
