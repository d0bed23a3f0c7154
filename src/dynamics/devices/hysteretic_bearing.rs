//! The hysteretic part of a bearing under a girder: lead rubber, a slider, a friction pendulum. Its link has the ground as its
//! second end and the girder's axes as placed; spring and dashpot `k₂, c` are the girder's bearing.
//!
//! Horizontal force `−z`. Elastic `ż = k_t u̇`; plastic, per axis, `z = ±Q`, until the velocity turns; coupled,
//! `z = Q (cos φ, sin φ)` with `φ̇ = (k_t/Q)(−sin φ u̇_x + cos φ u̇_y)`, the return map in continuous time, until `n·u̇` turns.

use glam::{DVec2, DVec3};

use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Evolution, Excursion, Linearity, Phase, Separation, SeparationBounds,
    Switch, SwitchUnit,
};
use crate::language::Text;

/// The hysteretic part of a bearing: a spring `k_t` up to the force `Q`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElastoPlastic {
    /// `k_t` = k₁ − k₂ \[N/m\].
    pub stiffness: f64,
    /// Q, the force at u = 0 of the upper line \[N\].
    pub force: f64,
}

impl ElastoPlastic {
    /// Equation of motion of the angle of the force on the circle, where that points `outwards`.
    fn turn(self, outwards: DVec2, motion: &Separation) -> Evolution {
        let (along, rate, per_length) = (outwards.perp(), motion.rate.truncate(), self.stiffness / self.force);
        Evolution {
            rate: per_length * along.dot(rate),
            decay: -per_length * outwards.dot(rate),
            force: (along * -self.force).extend(0.0),
            drive: (along * per_length).extend(0.0),
        }
    }
}

/// Interaction of the hysteretic parts along the two horizontal axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hysteresis {
    /// One yield circle `|z| ≤ Q`: round rubber, sliders.
    Circle(ElastoPlastic),
    /// Each axis for itself.
    PerAxis([ElastoPlastic; 2]),
}

/// Branch of a yield circle in yield; the other one is [`ELASTIC`].
const YIELDING: u32 = 1;
/// Branches of one axis.
const BRANCHES: u32 = 3;
const ELASTIC: u32 = 0;
const AT_PLUS_Q: u32 = 1;
const AT_MINUS_Q: u32 = 2;

impl Hysteresis {
    /// Branch of an axis.
    fn axis_branch(phase: &Phase, axis: usize) -> u32 {
        if axis == 0 { phase.branch % BRANCHES } else { phase.branch / BRANCHES }
    }

    /// z \[N\]. Elastic, the memory is `z − k_t u`; on the circle in yield, the angle φ \[rad\].
    fn hysteretic_force(&self, phase: &Phase, motion: &Separation) -> DVec2 {
        let moved = motion.moved.truncate();
        let remembered = DVec2::new(phase.memory[0], phase.memory[1]);
        match *self {
            Hysteresis::Circle(element) if phase.branch == YIELDING => {
                DVec2::from_angle(phase.memory[0]) * element.force
            }
            Hysteresis::Circle(element) => remembered + moved * element.stiffness,
            Hysteresis::PerAxis(elements) => DVec2::from(std::array::from_fn::<f64, 2, _>(|axis| {
                let ElastoPlastic { stiffness, force } = elements[axis];
                match Self::axis_branch(phase, axis) {
                    ELASTIC => remembered[axis] + stiffness * moved[axis],
                    AT_PLUS_Q => force,
                    _ => -force,
                }
            })),
        }
    }

    fn elements(&self) -> [ElastoPlastic; 2] {
        match *self {
            Hysteresis::Circle(element) => [element; 2],
            Hysteresis::PerAxis(elements) => elements,
        }
    }

    /// Phase of this law with z as it is now.
    fn going_on(&self, branch: u32, z: DVec2, motion: &Separation) -> Phase {
        let elements = self.elements();
        if matches!(self, Hysteresis::Circle(_)) && branch == YIELDING {
            return Phase { branch, memory: [z.to_angle(), 0.0, 0.0] };
        }
        let elastic = [0, 1].map(|axis| z[axis] - elements[axis].stiffness * motion.moved[axis]);
        Phase { branch, memory: [elastic[0], elastic[1], 0.0] }
    }
}

impl Connection for Hysteresis {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        -self.hysteretic_force(phase, motion).extend(0.0)
    }

    /// `z²/(2 k_t)`.
    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        let (z, elements) = (self.hysteretic_force(phase, motion), self.elements());
        let stiffness = DVec2::new(elements[0].stiffness, elements[1].stiffness);
        0.5 * z.dot(z / stiffness)
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        let (rate, z) = (motion.rate.truncate(), self.hysteretic_force(phase, motion));
        match *self {
            Hysteresis::Circle(_) if phase.branch == YIELDING => z.dot(rate),
            Hysteresis::Circle(_) => 0.0,
            Hysteresis::PerAxis(_) => {
                (0..2).filter(|&axis| Self::axis_branch(phase, axis) != ELASTIC).map(|axis| z[axis] * rate[axis]).sum()
            }
        }
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        self.elements().map(|element| element.stiffness).into_iter().fold(0.0, f64::max)
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        0.0
    }
}

impl Device for Hysteresis {
    fn linearity(&self, phase: &Phase) -> Linearity {
        match self {
            Hysteresis::PerAxis(_) => Linearity::Whole,
            Hysteresis::Circle(_) if self.evolves(phase) => Linearity::None,
            Hysteresis::Circle(_) => Linearity::Force,
        }
    }

    /// Its hysteretic part at rest as placed, and displaced from there in a straight line: elastic, with no more than Q.
    fn initial(&self, motion: &Separation) -> Phase {
        let moved = motion.moved.truncate();
        let z = match *self {
            Hysteresis::Circle(ElastoPlastic { stiffness, force }) => (moved * stiffness).clamp_length_max(force),
            Hysteresis::PerAxis([x, y]) => DVec2::new(
                (moved.x * x.stiffness).clamp(-x.force, x.force),
                (moved.y * y.stiffness).clamp(-y.force, y.force),
            ),
        };
        self.going_on(0, z, motion)
    }

    fn activity(&self, _: &Phase) -> Activity {
        Activity::Acts
    }

    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        [-motion.moved.truncate().length(), -motion.rate.truncate().length()]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }

    fn evolves(&self, phase: &Phase) -> bool {
        matches!(self, Hysteresis::Circle(_)) && phase.branch == YIELDING
    }

    fn evolution(&self, phase: &Phase, motion: &Separation) -> Evolution {
        let [element, _] = self.elements();
        element.turn(DVec2::from_angle(phase.memory[0]), motion)
    }

    /// In yield on the circle one direction gives both.
    fn force_and_evolution(&self, phase: &Phase, motion: &Separation) -> (DVec3, Evolution) {
        match *self {
            Hysteresis::Circle(element) if phase.branch == YIELDING => {
                let outwards = DVec2::from_angle(phase.memory[0]);
                ((outwards * -element.force).extend(0.0), element.turn(outwards, motion))
            }
            _ => (self.force(phase, motion), self.evolution(phase, motion)),
        }
    }

    fn switches(&self, _: &Phase) -> usize {
        match *self {
            Hysteresis::Circle(_) => 1,
            Hysteresis::PerAxis(_) => 4,
        }
    }

    fn switch_unit(&self, number: usize, phase: &Phase) -> SwitchUnit {
        let yields = match *self {
            Hysteresis::Circle(_) => phase.branch == YIELDING,
            Hysteresis::PerAxis(_) => Self::axis_branch(phase, number / 2) != ELASTIC,
        };
        if yields { SwitchUnit::Speed } else { SwitchUnit::Length }
    }

    /// Circle: yield `(z² − Q²)/(2 Q k_t)`, or its end `−n·u̇`. Per axis two: yield on either side, or its end.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        let (z, rate) = (self.hysteretic_force(phase, motion), motion.rate.truncate());
        match *self {
            Hysteresis::Circle(_) if phase.branch == YIELDING => -DVec2::from_angle(phase.memory[0]).dot(rate),
            Hysteresis::Circle(ElastoPlastic { stiffness, force }) => {
                (z.length_squared() - force * force) / (2.0 * force * stiffness)
            }
            Hysteresis::PerAxis(elements) => {
                let (axis, side) = (number / 2, if number.is_multiple_of(2) { 1.0 } else { -1.0 });
                match (Self::axis_branch(phase, axis), number % 2) {
                    (0, _) => (side * z[axis] - elements[axis].force) / elements[axis].stiffness,
                    (1, 0) | (2, 1) => -side * rate[axis],
                    _ => -1.0,
                }
            }
        }
    }

    /// Elastic, `|z|` grows by no more than `k_t` times the way. In yield on the circle, with the rate `w` across n,
    /// `d(n·u̇)/dt = (k_t/Q) w² + n·ü ≥ −|ü|`: the turn of n never brings the end nearer.
    fn stays_below(&self, number: usize, phase: &Phase, motion: &Separation, within: Excursion) -> bool {
        match *self {
            Hysteresis::Circle(ElastoPlastic { stiffness, force }) if phase.branch != YIELDING => {
                self.hysteretic_force(phase, motion).length() + stiffness * within.way < force
            }
            Hysteresis::Circle(_) => self.switch(number, phase, motion) + within.rate < 0.0,
            Hysteresis::PerAxis(_) => {
                let change = if Self::axis_branch(phase, number / 2) == ELASTIC { within.way } else { within.rate };
                self.switch(number, phase, motion) + change < 0.0
            }
        }
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        let Switch::Function(number) = event else { return (*phase, 0.0) };
        let z = self.hysteretic_force(phase, motion);
        let branch = match *self {
            Hysteresis::Circle(_) => YIELDING - phase.branch,
            Hysteresis::PerAxis(_) => {
                let mut branches = [0, 1].map(|axis| Self::axis_branch(phase, axis));
                let yielding = if number.is_multiple_of(2) { AT_PLUS_Q } else { AT_MINUS_Q };
                branches[number / 2] = if branches[number / 2] == ELASTIC { yielding } else { ELASTIC };
                branches[0] + BRANCHES * branches[1]
            }
        };
        let next = self.going_on(branch, z, motion);
        // Yield is noticed a rounding of the place beyond Q.
        let released = self.stored_energy(phase, motion) - self.stored_energy(&next, motion);
        (next, released)
    }
}

impl DeviceReadings for Hysteresis {
    fn state(&self, phase: &Phase) -> Text {
        if phase.branch == 0 { Text::new("state-elastic") } else { Text::new("state-yields") }
    }

    fn distance_left(&self, _: &Phase, _: &Separation) -> f64 {
        f64::NAN
    }

    fn strength(&self) -> Option<f64> {
        Some(self.elements().map(|element| element.force).into_iter().fold(f64::INFINITY, f64::min))
    }

    /// No line: the bearing itself is drawn.
    fn centre_line(&self, _: &Phase, _: [DVec3; 2]) -> Vec<DVec3> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn yield_ends_no_earlier_than_the_change_of_the_rate_allows() {
        let law = Hysteresis::Circle(ElastoPlastic { stiffness: 5e6, force: 6e4 });
        let mut random = uniform(7);
        let (mut claimed, mut near) = (0, f64::INFINITY);
        for _ in 0..400 {
            let [angle, across, along, turn, size] = std::array::from_fn(|_| random());
            let phase = Phase { branch: YIELDING, memory: [7.0 * angle, 0.0, 0.0] };
            let n = DVec2::from_angle(phase.memory[0]);
            let start = n * along + n.perp() * (2.0 * across - 1.0);
            let acceleration = DVec2::from_angle(7.0 * turn) * (20.0 * size);
            let (steps, h) = (400, 0.05 / 400.0);
            let begins = Separation { rate: start.extend(0.0), ..Separation::default() };
            let within = Excursion { way: f64::INFINITY, rate: 0.05 * acceleration.length() };
            if !law.stays_below(0, &phase, &begins, within) {
                continue;
            }
            claimed += 1;
            let at = |t: f64, angle: f64| {
                let motion = Separation { rate: (start + acceleration * t).extend(0.0), ..Separation::default() };
                (Phase { branch: YIELDING, memory: [angle, 0.0, 0.0] }, motion)
            };
            let mut angle = phase.memory[0];
            for step in 0..steps {
                let t = f64::from(step) * h;
                let rate = |t: f64, angle: f64| {
                    let (phase, motion) = at(t, angle);
                    law.evolution(&phase, &motion).rate
                };
                let first = rate(t, angle);
                let second = rate(t + 0.5 * h, angle + 0.5 * h * first);
                angle += h * second;
                let (phase, motion) = at(t + h, angle);
                let switch = law.switch(0, &phase, &motion);
                near = near.min(-switch);
                assert!(switch < 0.0, "{switch} at {t}: {begins:?}, {acceleration}");
            }
        }
        assert!(claimed > 50 && near < 0.05, "{claimed} claims, the nearest {near} m/s from the end");
    }

    /// Numbers between 0 and 1 by a linear congruence.
    fn uniform(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        }
    }
}
