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
