//! A restrainer cable: slack, taut, yielding, broken.
//!
//! With the elongation ε beyond the slack, `T = K (ε − ε_p)` on the first point towards the second; yield surface `T_y + H ε_p`,
//! `H = K K₂/(K − K₂)`; in yield `ε̇_p = (1 − K₂/K) ε̇`, hence `T = T₀ + K₂ (ε − ε₀)` since the yield began at ε₀.

use glam::DVec3;

use super::line::Line;
use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Excursion, IS_BROKEN, Phase, Separation, SeparationBounds, Switch,
    SwitchUnit,
};
use crate::language::Text;

/// A cable that pulls once its slack is used up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restrainer {
    /// Distance of its points as placed \[m\].
    pub length: f64,
    /// Elongation at which it is taut for the first time \[m\].
    pub slack: f64,
    /// K, the axial stiffness EA/ℓ \[N/m\].
    pub stiffness: f64,
    /// Yield; none for an elastic cable.
    pub yielding: Option<Yielding>,
    /// Elongation beyond the slack at which it breaks \[m\]; infinite for one that does not.
    pub break_elongation: f64,
}

/// Yield of a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yielding {
    /// `T_y`, force at the first yield \[N\].
    pub force: f64,
    /// K₂, stiffness in yield, less than K \[N/m\].
    pub stiffness: f64,
}

const SLACK: u32 = 0;
const TAUT: u32 = 1;
const YIELD: u32 = 2;
const BROKEN: u32 = 3;

impl Restrainer {
    /// ε beyond the slack \[m\].
    fn elongation(&self, line: &Line) -> f64 {
        line.elongation - self.slack
    }

    /// Length at which it becomes taut \[m\].
    fn taut_length(&self, phase: &Phase) -> f64 {
        self.length + self.slack + phase.memory[0]
    }

    /// K₂/K; 1 for an elastic cable, which has no plastic elongation.
    fn ratio(&self) -> f64 {
        self.yielding.map_or(1.0, |yielding| yielding.stiffness / self.stiffness)
    }

    /// `ε_p`: `memory` is `ε_p` at the beginning of the phase and, in yield, ε then.
    fn plastic(&self, phase: &Phase, elongation: f64) -> f64 {
        let [plastic, from, _] = phase.memory;
        if phase.branch == YIELD { plastic + (1.0 - self.ratio()) * (elongation - from) } else { plastic }
    }

    fn tension(&self, phase: &Phase, elongation: f64) -> f64 {
        match phase.branch {
            TAUT | YIELD => self.stiffness * (elongation - self.plastic(phase, elongation)),
            _ => 0.0,
        }
    }

    /// Yield force at a plastic elongation \[N\].
    fn yield_force(&self, plastic: f64) -> f64 {
        self.yielding.map_or(f64::INFINITY, |Yielding { force, stiffness }| {
            force + self.stiffness * stiffness / (self.stiffness - stiffness) * plastic
        })
    }
}

impl Connection for Restrainer {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        let line = Line::of(motion);
        line.direction * -self.tension(phase, self.elongation(&line))
    }

    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        let tension = self.tension(phase, self.elongation(&Line::of(motion)));
        tension * tension / (2.0 * self.stiffness)
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        if phase.branch != YIELD {
            return 0.0;
        }
        let line = Line::of(motion);
        self.tension(phase, self.elongation(&line)) * (1.0 - self.ratio()) * line.rate
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        self.stiffness
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        0.0
    }
}

impl Device for Restrainer {
    /// Pulled there once, in a straight line from where it was slack: broken beyond its break, on its yield surface beyond its yield,
    /// `ε_p = (1 − K₂/K)(ε − T_y/K)`.
    fn initial(&self, motion: &Separation) -> Phase {
        let line = Line::of(motion);
        let elongation = self.elongation(&line);
        let elastic = self.yielding.map_or(f64::INFINITY, |yielding| yielding.force / self.stiffness);
        let plastic = (1.0 - self.ratio()) * (elongation - elastic).max(0.0);
        // Not beyond the surface by rounding: yield would begin and end at once.
        let plastic = if plastic > 0.0 { plastic + 4.0 * f64::EPSILON * elongation } else { 0.0 };
        let branch = match elongation {
            e if e <= 0.0 => SLACK,
            e if e >= self.break_elongation => BROKEN,
            e if e >= elastic && line.rate > 0.0 => YIELD,
            _ => TAUT,
        };
        let from = if branch == YIELD { elongation } else { 0.0 };
        Phase { branch, memory: [plastic, from, 0.0] }
    }

    fn activity(&self, phase: &Phase) -> Activity {
        match phase.branch {
            TAUT | YIELD => Activity::Acts,
            BROKEN => Activity::Ended,
            _ => Activity::Idle,
        }
    }

    /// `(ℓ² − r²)/(2ℓ)` with the length ℓ at which it is taut: smooth where its points meet.
    fn gap(&self, phase: &Phase, motion: &Separation) -> [f64; 2] {
        let (length, vector) = (self.taut_length(phase), motion.vector());
        let left = self.distance_left(phase, motion);
        [left * (length + vector.length()) / (2.0 * length), -vector.dot(motion.rate) / length]
    }

    fn gap_curvature(&self, phase: &Phase, bounds: &SeparationBounds) -> f64 {
        (bounds.speed * bounds.speed + bounds.distance * bounds.acceleration) / self.taut_length(phase)
    }

    fn stays_idle(&self, phase: &Phase, bounds: &SeparationBounds) -> bool {
        bounds.distance < self.taut_length(phase)
    }

    fn switches(&self, _: &Phase) -> usize {
        3
    }

    fn switch_unit(&self, number: usize, phase: &Phase) -> SwitchUnit {
        if number == 1 && phase.branch == YIELD { SwitchUnit::Speed } else { SwitchUnit::Length }
    }

    /// 0: slack; 1: start of yield, in yield its end; 2: break.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        let line = Line::of(motion);
        let elongation = self.elongation(&line);
        let plastic = self.plastic(phase, elongation);
        match (number, phase.branch) {
            (0, _) => plastic - elongation,
            (1, YIELD) => -line.rate,
            (1, _) if self.yielding.is_none() => -1.0,
            (1, _) => elongation - plastic - self.yield_force(plastic) / self.stiffness,
            _ if self.break_elongation.is_infinite() => -1.0,
            _ => elongation - self.break_elongation,
        }
    }

    /// A switching function that is a length changes by no more than the elongation, and that by no more than the way.
    fn stays_below(&self, number: usize, phase: &Phase, motion: &Separation, within: Excursion) -> bool {
        let is_length = self.switch_unit(number, phase) == SwitchUnit::Length;
        is_length && self.switch(number, phase, motion) + within.way < 0.0
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        let elongation = self.elongation(&Line::of(motion));
        let plastic = self.plastic(phase, elongation);
        let branch = match (event, phase.branch) {
            (Switch::Closing, _) | (Switch::Function(1), YIELD) => TAUT,
            (Switch::Function(0), _) => SLACK,
            (Switch::Function(1), _) => YIELD,
            (Switch::Function(_), _) => BROKEN,
        };
        let released = if branch == BROKEN { self.stored_energy(phase, motion) } else { 0.0 };
        (Phase { branch, memory: [plastic, elongation, 0.0] }, released)
    }
}

impl DeviceReadings for Restrainer {
    fn state(&self, phase: &Phase) -> Text {
        match phase.branch {
            SLACK => Text::new("state-slack"),
            TAUT => Text::new("state-taut"),
            YIELD => Text::new("state-yields"),
            _ => IS_BROKEN,
        }
    }

    /// ℓ − r.
    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        let elongation = self.elongation(&Line::of(motion));
        self.plastic(phase, elongation) - elongation
    }

    fn strength(&self) -> Option<f64> {
        let breaks = self.stiffness * self.break_elongation;
        let yields = self.yielding.map_or(f64::INFINITY, |yielding| yielding.force);
        Some(yields.min(breaks)).filter(|force| force.is_finite())
    }

    fn yields(&self, phase: &Phase) -> bool {
        phase.branch == YIELD
    }
}
