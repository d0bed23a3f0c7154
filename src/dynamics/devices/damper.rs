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

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a line of 3 m along Y.
    fn at(rate: f64) -> Separation {
        Separation { placed: DVec3::Y * 3.0, moved: DVec3::ZERO, rate: DVec3::Y * rate }
    }

    fn damper(exponent: f64) -> ViscousDamper {
        ViscousDamper { coefficient: 400.0, exponent, regularisation: 1e-3 }
    }

    fn phase(branch: u32) -> Phase {
        Phase { branch, ..Phase::default() }
    }

    #[test]
    fn far_from_rest_it_is_the_power_law_and_near_rest_a_dashpot() {
        let root = damper(0.5);
        let force = |rate: f64| -root.force(&phase(LENGTHENS), &at(rate)).y;
        // (1 + v_r²/v²)^(-1/4) differs from 1 by a quarter of (v_r/v)².
        assert!((force(4.0) / (400.0 * 2.0) - 1.0).abs() < 1e-7, "c √v: {}", force(4.0));
        assert!((force(-4.0) + force(4.0)).abs() == 0.0, "odd in the rate");
        let slope = 400.0 / 1e-3_f64.sqrt();
        assert!((force(1e-9) / 1e-9 / slope - 1.0).abs() < 1e-9, "c v_r^(α−1) at rest");
        assert!((root.damping_bound(&phase(LENGTHENS)) / slope - 1.0).abs() < 1e-12);
        let dashpot = damper(1.0);
        assert_eq!(dashpot.force(&phase(LENGTHENS), &at(-0.25)).y, 100.0, "against the shortening");
    }

    #[test]
    fn the_power_of_its_force_is_lost() {
        for (exponent, rate) in [(0.3, 0.7), (0.3, -0.7), (1.0, 0.2), (0.5, 0.0)] {
            let (damper, motion) = (damper(exponent), at(rate));
            let lost = damper.dissipated_power(&phase(LENGTHENS), &motion);
            assert_eq!(lost, -damper.force(&phase(LENGTHENS), &motion).dot(motion.rate), "α {exponent}, {rate} m/s");
            assert!(lost >= 0.0 && damper.stored_energy(&phase(LENGTHENS), &motion) == 0.0);
        }
    }

    #[test]
    fn of_a_power_below_one_the_turn_of_the_motion_is_an_event() {
        let root = damper(0.5);
        assert_eq!([0.2, 0.0, -0.2].map(|rate| root.initial(&at(rate)).branch), [LENGTHENS, LENGTHENS, SHORTENS]);
        for (branch, along) in [(LENGTHENS, 1.0), (SHORTENS, -1.0)] {
            assert!(root.switch(0, &phase(branch), &at(0.1 * along)) < 0.0);
            assert!(root.switch(0, &phase(branch), &at(-0.1 * along)) > 0.0);
            let (next, released) = root.next(Switch::Function(0), &phase(branch), &at(0.0));
            assert_eq!((next.branch, released), (LENGTHENS + SHORTENS - branch, 0.0));
        }
        assert_eq!([damper(0.5), damper(1.0)].map(|damper| damper.switches(&phase(LENGTHENS))), [1, 0]);
        assert_eq!(damper(1.0).initial(&at(-0.2)).branch, LENGTHENS, "a dashpot has one law for both signs");
    }

    #[test]
    fn the_turn_is_out_of_reach_unless_speed_or_line_change_too_much() {
        let (root, lengthens) = (damper(0.5), phase(LENGTHENS));
        let stays = |motion: &Separation, way, rate| root.stays_below(0, &lengthens, motion, Excursion { way, rate });
        assert!(stays(&at(0.1), 0.0, 0.09) && !stays(&at(0.1), 0.0, 0.11));
        // A motion across the line at 6 m/s: turned by 0.05/2.95 of a radian, it is one along it at 0.1 m/s.
        let across = Separation { rate: DVec3::new(6.0, 0.1, 0.0), ..at(0.0) };
        assert!(stays(&across, 0.04, 0.0) && !stays(&across, 0.05, 0.0));
        assert!(!stays(&at(9.0), 3.0, 0.0), "where its points may meet the line has any direction");
    }

    #[test]
    fn its_series_converges_up_to_the_singular_rates_beside_the_real_axis() {
        let near = Separation { rate: DVec3::Y * 3e-3, ..at(0.0) };
        let regular = ViscousDamper { regularisation: 4e-3, ..damper(0.5) };
        assert!((regular.smooth_within(&phase(LENGTHENS), &near) - 5e-3).abs() < 1e-15, "|3 ± 4i| mm/s");
        assert_eq!(damper(1.0).smooth_within(&phase(LENGTHENS), &near), f64::INFINITY);
    }
}
