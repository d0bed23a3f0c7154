//! One side of a shear key or stopper: along a direction d fixed to the second body, the first axis of its link.
//!
//! With `w = (X_P − X_S)·d`, `p = w − gap − w_p` and the force `−K p d` on the first point while p > 0. A ductile one keeps p at
//! `F_y/K` while w grows, `w_p` growing with it, and breaks at `w_p` = `w_u`; a brittle one breaks at `K p = F_u`.

use glam::DVec3;

use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Excursion, IS_BROKEN, Linearity, Phase, Separation, SeparationBounds,
    Switch, SwitchUnit,
};
use crate::language::Text;

/// One side of a stopper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stopper {
    /// w at which it touches for the first time \[m\].
    pub gap: f64,
    /// K \[N/m\].
    pub stiffness: f64,
    /// Mode of failure.
    pub failure: Failure,
}

/// Mode of failure of a stopper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// It does not.
    Never,
    /// It breaks at a force.
    Brittle {
        /// `F_u` \[N\].
        force: f64,
    },
    /// It yields at a force and breaks at a plastic displacement.
    Ductile {
        /// `F_y` \[N\].
        force: f64,
        /// `w_u` \[m\]; infinite for one that does not break.
        displacement: f64,
    },
}

const OPEN: u32 = 0;
const ON: u32 = 1;
const YIELD: u32 = 2;
const BROKEN: u32 = 3;

impl Stopper {
    /// p at yield or at the break \[m\]; infinite without either.
    fn limit(&self) -> f64 {
        match self.failure {
            Failure::Never => f64::INFINITY,
            Failure::Brittle { force } | Failure::Ductile { force, .. } => force / self.stiffness,
        }
    }

    /// `w_p`: the memory, or in yield the displacement at which p is at its limit \[m\].
    fn plastic(&self, phase: &Phase, motion: &Separation) -> f64 {
        if phase.branch == YIELD { motion.vector().x - self.gap - self.limit() } else { phase.memory[0] }
    }

    /// p \[m\].
    fn press(&self, phase: &Phase, motion: &Separation) -> f64 {
        if phase.branch == YIELD { self.limit() } else { motion.vector().x - self.gap - phase.memory[0] }
    }
}

impl Connection for Stopper {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        if self.acts(phase) { DVec3::X * (-self.stiffness * self.press(phase, motion)) } else { DVec3::ZERO }
    }

    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        if self.acts(phase) { 0.5 * self.stiffness * self.press(phase, motion).powi(2) } else { 0.0 }
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        if phase.branch == YIELD { self.stiffness * self.limit() * motion.rate.x } else { 0.0 }
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        self.stiffness
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        0.0
    }
}

impl Device for Stopper {
    /// Pressed there once: broken beyond its break, a ductile one with the `w_p` that leaves p at its limit.
    fn initial(&self, motion: &Separation) -> Phase {
        let (press, limit) = (motion.vector().x - self.gap, self.limit());
        let plastic = (press - limit).max(0.0);
        // Not beyond the limit by rounding: yield would begin and end at once.
        let plastic = if plastic > 0.0 { plastic + 4.0 * f64::EPSILON * press } else { 0.0 };
        let branch = match self.failure {
            _ if press <= 0.0 => OPEN,
            Failure::Brittle { .. } if press >= limit => BROKEN,
            Failure::Ductile { displacement, .. } if plastic >= displacement => BROKEN,
            Failure::Ductile { .. } if press >= limit && motion.rate.x > 0.0 => YIELD,
            _ => ON,
        };
        Phase { branch, memory: [plastic, 0.0, 0.0] }
    }

    fn activity(&self, phase: &Phase) -> Activity {
        match phase.branch {
            ON | YIELD => Activity::Acts,
            BROKEN => Activity::Ended,
            _ => Activity::Idle,
        }
    }

    fn linearity(&self, _: &Phase) -> Linearity {
        Linearity::Whole
    }

    fn gap(&self, phase: &Phase, motion: &Separation) -> [f64; 2] {
        [-self.press(phase, motion), -motion.rate.x]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }

    fn switches(&self, _: &Phase) -> usize {
        2
    }

    fn switch_unit(&self, number: usize, phase: &Phase) -> SwitchUnit {
        if number == 0 && phase.branch == YIELD { SwitchUnit::Speed } else { SwitchUnit::Length }
    }

    /// 0: opening, in yield the end of yield; 1: yield or break, in yield the break.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        match (number, phase.branch, self.failure) {
            (0, YIELD, _) => -motion.rate.x,
            (0, ..) => -self.press(phase, motion),
            (_, YIELD, Failure::Ductile { displacement, .. }) if displacement.is_finite() => {
                self.plastic(phase, motion) - displacement
            }
            (_, YIELD, _) | (.., Failure::Never) => -1.0,
            _ => self.press(phase, motion) - self.limit(),
        }
    }

    /// Every switching function changes by no more than the displacement or the rate that it is a part of.
    fn stays_below(&self, number: usize, phase: &Phase, motion: &Separation, within: Excursion) -> bool {
        self.switch(number, phase, motion) + self.switch_unit(number, phase).largest_change(within) < 0.0
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        let branch = match (event, phase.branch, self.failure) {
            (Switch::Closing, ..) | (Switch::Function(0), YIELD, _) => ON,
            (Switch::Function(0), ..) => OPEN,
            (Switch::Function(_), ON, Failure::Ductile { .. }) => YIELD,
            (Switch::Function(_), ..) => BROKEN,
        };
        let released = if branch == BROKEN { self.stored_energy(phase, motion) } else { 0.0 };
        (Phase { branch, memory: [self.plastic(phase, motion), 0.0, 0.0] }, released)
    }
}

impl DeviceReadings for Stopper {
    fn state(&self, phase: &Phase) -> Text {
        match phase.branch {
            OPEN => Text::new("state-open"),
            ON => Text::new("state-pressed"),
            YIELD => Text::new("state-yields"),
            _ => IS_BROKEN,
        }
    }

    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.gap(phase, motion)[0]
    }

    fn strength(&self) -> Option<f64> {
        match self.failure {
            Failure::Never => None,
            Failure::Brittle { force } | Failure::Ductile { force, .. } => Some(force),
        }
    }

    fn yields(&self, phase: &Phase) -> bool {
        phase.branch == YIELD
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 1000 N/m behind 10 mm.
    fn stopper(failure: Failure) -> Stopper {
        Stopper { gap: 0.01, stiffness: 1000.0, failure }
    }

    /// Breaks at 50 N, pressed in by 50 mm.
    const BRITTLE: Failure = Failure::Brittle { force: 50.0 };
    /// Yields at 50 N and breaks once 20 mm have stayed.
    const DUCTILE: Failure = Failure::Ductile { force: 50.0, displacement: 0.02 };

    fn at(w: f64, rate: f64) -> Separation {
        Separation { moved: DVec3::X * w, rate: DVec3::X * rate, ..Separation::default() }
    }

    fn phase(branch: u32, plastic: f64) -> Phase {
        Phase { branch, memory: [plastic, 0.0, 0.0] }
    }

    fn close(got: f64, expected: f64, what: &str) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs().max(1e-3), "{what}: {got} is not {expected}");
    }

    #[test]
    fn it_presses_by_its_stiffness_beyond_gap_and_plastic_displacement_and_stores_the_work() {
        let key = stopper(Failure::Never);
        close(key.force(&phase(ON, 0.0), &at(0.03, 0.0)).x, -20.0, "20 mm pressed in");
        close(key.stored_energy(&phase(ON, 0.0), &at(0.03, 0.0)), 0.5 * 20.0 * 0.02, "the triangle under the force");
        close(key.force(&phase(ON, 0.005), &at(0.03, 0.0)).x, -15.0, "of 20 mm 5 have stayed");
        for idle in [OPEN, BROKEN] {
            assert_eq!(key.force(&phase(idle, 0.0), &at(0.03, 1.0)), DVec3::ZERO);
            assert_eq!(key.stored_energy(&phase(idle, 0.0), &at(0.03, 1.0)), 0.0);
        }
        let [gap, rate] = key.gap(&phase(OPEN, 0.005), &at(0.004, 0.3));
        close(gap, 0.01 + 0.005 - 0.004, "what is left to the face that has moved back");
        close(rate, -0.3, "it closes as fast as the points approach");
    }

    #[test]
    fn at_the_start_it_is_as_if_pressed_there_once() {
        let starts = |failure, w, rate| stopper(failure).initial(&at(w, rate));
        for failure in [Failure::Never, BRITTLE, DUCTILE] {
            assert_eq!(starts(failure, 0.01, 1.0).branch, OPEN, "it touches without force: {failure:?}");
            assert_eq!(starts(failure, 0.05, 1.0), phase(ON, 0.0), "40 N are below its strength: {failure:?}");
        }
        assert_eq!(starts(Failure::Never, 5.0, 1.0).branch, ON, "it bears any force");
        assert_eq!(starts(BRITTLE, 0.07, 0.0).branch, BROKEN, "60 N");
        assert_eq!(starts(DUCTILE, 0.07, 1.0).branch, YIELD, "60 N, and the press grows");
        let back = starts(DUCTILE, 0.07, -1.0);
        assert_eq!(back.branch, ON, "on its way out it is elastic");
        close(back.memory[0], 0.01, "what the elastic limit leaves of 60 mm stays");
        assert!(stopper(DUCTILE).switch(1, &back, &at(0.07, -1.0)) < 0.0, "yield does not begin by rounding");
        assert_eq!(starts(DUCTILE, 0.09, -1.0).branch, BROKEN, "30 mm would stay of the 20 that it bears");
    }

    #[test]
    fn it_opens_and_closes_with_the_plastic_displacement_it_has() {
        let key = stopper(DUCTILE);
        let opened = key.next(Switch::Function(0), &phase(ON, 0.003), &at(0.013, -1.0));
        assert_eq!(opened, (phase(OPEN, 0.003), 0.0));
        let closed = key.next(Switch::Closing, &opened.0, &at(0.013, 1.0));
        assert_eq!(closed, (phase(ON, 0.003), 0.0));
    }

    #[test]
    fn a_brittle_one_releases_at_its_break_the_work_that_was_done_on_it() {
        let (key, pressed) = (stopper(BRITTLE), at(0.06, 1.0));
        assert!(key.switch(1, &phase(ON, 0.0), &at(0.0599, 1.0)) < 0.0);
        assert!(key.switch(1, &phase(ON, 0.0), &at(0.0601, 1.0)) > 0.0);
        let (broken, released) = key.next(Switch::Function(1), &phase(ON, 0.0), &pressed);
        assert_eq!((broken.branch, key.activity(&broken)), (BROKEN, Activity::Ended));
        close(released, 0.5 * 50.0 * 0.05, "the triangle up to the break");
        assert_eq!(key.stored_energy(&broken, &pressed), 0.0);
    }

    #[test]
    fn a_ductile_one_loses_in_yield_and_releases_at_its_break_the_work_that_was_done_on_it() {
        let key = stopper(DUCTILE);
        let (yielding, released) = key.next(Switch::Function(1), &phase(ON, 0.0), &at(0.06, 0.2));
        assert_eq!((yielding.branch, released), (YIELD, 0.0));
        for w in [0.06, 0.07, 0.08] {
            close(key.force(&yielding, &at(w, 0.2)).x, -50.0, "F_y at all displacements");
            close(key.dissipated_power(&yielding, &at(w, 0.2)), 50.0 * 0.2, "the whole power is lost");
        }
        assert!(key.switch(1, &yielding, &at(0.0799, 0.2)) < 0.0);
        assert!(key.switch(1, &yielding, &at(0.0801, 0.2)) > 0.0, "20 mm stay at 80 mm");
        let (broken, released) = key.next(Switch::Function(1), &yielding, &at(0.08, 0.2));
        assert_eq!(broken.branch, BROKEN);
        // The triangle up to yield and a rectangle of 20 mm, of which the second is lost at a constant power for 0.1 s.
        let (work, lost) = (0.5 * 50.0 * 0.05 + 50.0 * 0.02, 50.0 * 0.2 * 0.1);
        close(lost + released, work, "all work is accounted for");
    }

    #[test]
    fn yield_ends_where_the_press_turns_back_and_the_force_goes_on_without_a_step() {
        let (key, turned) = (stopper(DUCTILE), at(0.07, 0.0));
        assert!(key.switch(0, &phase(YIELD, 0.0), &at(0.07, 0.1)) < 0.0, "it still grows");
        assert!(key.switch(0, &phase(YIELD, 0.0), &at(0.07, -0.1)) > 0.0);
        let (elastic, released) = key.next(Switch::Function(0), &phase(YIELD, 0.0), &turned);
        assert_eq!((elastic.branch, released), (ON, 0.0));
        close(elastic.memory[0], 0.01, "the yield of 10 mm stays");
        close(key.force(&elastic, &turned).x, -50.0, "F_y at the turn");
        close(key.force(&elastic, &at(0.05, -0.1)).x, -30.0, "20 mm less, by the elastic stiffness");
        assert_eq!(key.dissipated_power(&elastic, &at(0.05, -0.1)), 0.0);
    }

    #[test]
    fn what_cannot_yield_or_break_has_no_such_event() {
        assert_eq!(stopper(Failure::Never).switch(1, &phase(ON, 0.0), &at(10.0, 1.0)), -1.0);
        let endless = Failure::Ductile { force: 50.0, displacement: f64::INFINITY };
        assert_eq!(stopper(endless).switch(1, &phase(YIELD, 0.0), &at(10.0, 1.0)), -1.0);
        assert_eq!([Failure::Never, BRITTLE, DUCTILE].map(|f| stopper(f).strength()), [None, Some(50.0), Some(50.0)]);
    }

    #[test]
    fn an_event_is_out_of_reach_of_a_motion_smaller_than_the_distance_to_it() {
        let key = stopper(DUCTILE);
        let within = |way, rate| Excursion { way, rate };
        // Pressed in by 20 mm, 30 mm before yield.
        let (on, here) = (phase(ON, 0.0), at(0.03, 0.2));
        for (number, distance) in [(0, 0.02), (1, 0.03)] {
            assert!(key.stays_below(number, &on, &here, within(0.99 * distance, 9.0)));
            assert!(!key.stays_below(number, &on, &here, within(1.01 * distance, 0.0)));
        }
        // In yield its end is a matter of the rate.
        let yielding = phase(YIELD, 0.0);
        assert!(key.stays_below(0, &yielding, &at(0.07, 0.2), within(9.0, 0.19)));
        assert!(!key.stays_below(0, &yielding, &at(0.07, 0.2), within(0.0, 0.21)));
    }
}
