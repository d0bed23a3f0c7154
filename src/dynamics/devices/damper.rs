//! A viscous damper along the line between its points, `F = c |v|^α sgn v` with the rate v of its length, regularised at rest.
//!
//! For α < 1 that force has an infinite slope at v = 0; `F = c v (v² + v_r²)^((α−1)/2)` is smooth, with the slope
//! `c v_r^(α−1)` at 0, and changes the energy of a cycle by a part of the order of `(v_r/v_max)^(1+α)`. From one sign to the other the
//! force changes within `v_r` of v = 0, in a small part of a step whose error estimate may not see it: of α < 1 that zero is an event, so that
//! a step ends there and the next begins where the force is steep, and steps are short against the time to that zero
//! ([`Device::smooth_within`]).

use glam::DVec3;

use super::line::Line;
use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Excursion, Phase, Separation, SeparationBounds, Switch, SwitchUnit,
    acts_or_open,
};
use crate::language::Text;

/// A viscous damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViscousDamper {
    /// c \[N (s/m)^α\].
    pub coefficient: f64,
    /// α \[–\], in (0, 1\].
    pub exponent: f64,
    /// `v_r` \[m/s\], above 0.
    pub regularisation: f64,
}

/// The line becomes longer, or stays as long.
const LENGTHENS: u32 = 0;
const SHORTENS: u32 = 1;

impl ViscousDamper {
    /// The branch of a sign of the rate; one for both where the force has a finite slope everywhere.
    fn branch(&self, rate: f64) -> u32 {
        if self.exponent < 1.0 && rate < 0.0 { SHORTENS } else { LENGTHENS }
    }

    fn tension(&self, rate: f64) -> f64 {
        let least = self.regularisation;
        self.coefficient * rate * (rate * rate + least * least).powf(0.5 * (self.exponent - 1.0))
    }
}

impl Connection for ViscousDamper {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, _: &Phase, motion: &Separation) -> DVec3 {
        let line = Line::of(motion);
        line.direction * -self.tension(line.rate)
    }

    fn stored_energy(&self, _: &Phase, _: &Separation) -> f64 {
        0.0
    }

    fn dissipated_power(&self, _: &Phase, motion: &Separation) -> f64 {
        let rate = Line::of(motion).rate;
        self.tension(rate) * rate
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        0.0
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        self.coefficient * self.regularisation.powf(self.exponent - 1.0)
    }
}

impl Device for ViscousDamper {
    fn initial(&self, motion: &Separation) -> Phase {
        Phase { branch: self.branch(Line::of(motion).rate), ..Phase::default() }
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

    fn switches(&self, _: &Phase) -> usize {
        usize::from(self.exponent < 1.0)
    }

    fn switch_unit(&self, _: usize, _: &Phase) -> SwitchUnit {
        SwitchUnit::Speed
    }

    /// The rate of the line changes its sign.
    fn switch(&self, _: usize, phase: &Phase, motion: &Separation) -> f64 {
        let rate = Line::of(motion).rate;
        if phase.branch == SHORTENS { rate } else { -rate }
    }

    /// The rate changes by the change of the velocity and by the turn of the line, whose direction changes by no more than the way over
    /// the length that is left.
    fn stays_below(&self, number: usize, phase: &Phase, motion: &Separation, within: Excursion) -> bool {
        let left = motion.vector().length() - within.way;
        let turned = (motion.rate.length() + within.rate) * within.way / left;
        left > 0.0 && self.switch(number, phase, motion) + within.rate + turned < 0.0
    }

    /// `v (v² + v_r²)^((α−1)/2)` is singular at `v = ±i v_r`.
    fn smooth_within(&self, _: &Phase, motion: &Separation) -> f64 {
        if self.exponent < 1.0 { Line::of(motion).rate.hypot(self.regularisation) } else { f64::INFINITY }
    }

    fn next(&self, _: Switch, phase: &Phase, _: &Separation) -> (Phase, f64) {
        (Phase { branch: if phase.branch == SHORTENS { LENGTHENS } else { SHORTENS }, ..*phase }, 0.0)
    }
}

impl DeviceReadings for ViscousDamper {
    fn state(&self, phase: &Phase) -> Text {
        acts_or_open(self.acts(phase))
    }

    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.gap(phase, motion)[0]
    }
}
