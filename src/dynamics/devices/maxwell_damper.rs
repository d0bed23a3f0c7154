//! A viscous damper with a brace in series: `Ḟ = K_b (v − sgn F (|F|/c)^(1/α))` with the rate v of its length. With α = 1 and a
//! large c it is a lock-up device of the relaxation time `c/K_b`.

use glam::DVec3;

use super::line::Line;
use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Evolution, Phase, Separation, SeparationBounds, acts_or_open,
};
use crate::language::Text;

/// A viscous damper and a spring in series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxwellDamper {
    /// c \[N (s/m)^α\].
    pub coefficient: f64,
    /// α \[–\], in (0, 1\].
    pub exponent: f64,
    /// `K_b` of the brace \[N/m\].
    pub stiffness: f64,
}

impl MaxwellDamper {
    /// Rate of the dashpot's length under a force \[m/s\].
    fn creep(&self, force: f64) -> f64 {
        (force.abs() / self.coefficient).powf(1.0 / self.exponent).copysign(force)
    }
}

impl Connection for MaxwellDamper {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        Line::of(motion).direction * -phase.memory[0]
    }

    fn stored_energy(&self, phase: &Phase, _: &Separation) -> f64 {
        phase.memory[0] * phase.memory[0] / (2.0 * self.stiffness)
    }

    fn dissipated_power(&self, phase: &Phase, _: &Separation) -> f64 {
        phase.memory[0] * self.creep(phase.memory[0])
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        self.stiffness
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        0.0
    }
}

impl Device for MaxwellDamper {
    /// Without force; the memory is the force \[N\], in tension positive.
    fn initial(&self, _: &Separation) -> Phase {
        Phase::default()
    }

    fn activity(&self, _: &Phase) -> Activity {
        Activity::Acts
    }

    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        Line::of(motion).gap()
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }

    fn evolves(&self, _: &Phase) -> bool {
        true
    }

    fn evolution(&self, phase: &Phase, motion: &Separation) -> Evolution {
        let (line, force) = (Line::of(motion), phase.memory[0]);
        let slope = (force.abs() / self.coefficient).powf(1.0 / self.exponent - 1.0);
        Evolution {
            rate: self.stiffness * (line.rate - self.creep(force)),
            decay: -self.stiffness * slope / (self.exponent * self.coefficient),
            force: -line.direction,
            drive: line.direction * self.stiffness,
        }
    }
}

impl DeviceReadings for MaxwellDamper {
    fn state(&self, phase: &Phase) -> Text {
        acts_or_open(self.acts(phase))
    }

    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.gap(phase, motion)[0]
    }
}
