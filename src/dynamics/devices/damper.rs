//! A viscous damper along the line between its points, `F = c |v|^α sgn v` with the rate v of its length, regularised at rest.
//!
//! For α < 1 that force has an infinite slope at v = 0; `F = c v (v² + v_r²)^((α−1)/2)` is smooth, with the slope
//! `c v_r^(α−1)` at 0, and changes the energy of a cycle by a part of the order of `(v_r/v_max)^(1+α)`.

use glam::DVec3;

use super::line::Line;
use crate::dynamics::connection::{Connection, Device, Phase, Separation, SeparationBounds};

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

impl ViscousDamper {
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
    fn initial(&self, _: &Separation) -> Phase {
        Phase::default()
    }

    fn acts(&self, _: &Phase) -> bool {
        true
    }

    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        Line::of(motion).gap()
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }
}
