//! A viscous damper with a brace in series: `Ḟ = K_b (v − sgn F (|F|/c)^(1/α))` with the rate v of its length. With α = 1 and a
//! large c it is a lock-up device of the relaxation time `c/K_b`.
//!
//! With α < 1 the law is smooth only while F keeps its sign: a zero of F ends a phase.

use glam::DVec3;

use super::line::Line;
use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Evolution, Excursion, Phase, Separation, SeparationBounds, Switch,
    acts_or_open,
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

/// Branches: F in tension, and in compression.
const TENSION: u32 = 0;
const COMPRESSION: u32 = 1;

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

    fn switches(&self, _: &Phase) -> usize {
        usize::from(self.exponent < 1.0)
    }

    /// Force against the sign of its branch, as a length of the brace \[m\].
    fn switch(&self, _: usize, phase: &Phase, _: &Separation) -> f64 {
        let length = phase.memory[0] / self.stiffness;
        if phase.branch == TENSION { -length } else { length }
    }

    /// The dashpot only takes force off: the brace's length changes by no more than the points are displaced.
    fn stays_below(&self, number: usize, phase: &Phase, motion: &Separation, within: Excursion) -> bool {
        self.switch(number, phase, motion) + within.way < 0.0
    }

    fn next(&self, event: Switch, phase: &Phase, _: &Separation) -> (Phase, f64) {
        let branch = match event {
            Switch::Closing => phase.branch,
            Switch::Function(_) => COMPRESSION - phase.branch,
        };
        (Phase { branch, ..*phase }, 0.0)
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a line of 3 m along Y.
    fn at(rate: f64) -> Separation {
        Separation { placed: DVec3::Y * 3.0, moved: DVec3::ZERO, rate: DVec3::Y * rate }
    }

    fn damper(exponent: f64) -> MaxwellDamper {
        MaxwellDamper { coefficient: 400.0, exponent, stiffness: 2000.0 }
    }

    /// Under a force in tension.
    fn under(force: f64) -> Phase {
        Phase { branch: 0, memory: [force, 0.0, 0.0] }
    }

    #[test]
    fn it_begins_without_force_and_pulls_with_what_it_remembers() {
        let device = damper(0.5);
        assert_eq!(device.force(&device.initial(&at(1.0)), &at(1.0)).length(), 0.0);
        assert_eq!(device.force(&under(30.0), &at(1.0)), DVec3::Y * -30.0, "a tension draws its first point in");
    }

    #[test]
    fn held_at_its_length_a_linear_one_relaxes_with_the_time_of_dashpot_over_brace() {
        let evolution = damper(1.0).evolution(&under(30.0), &at(0.0));
        assert!((evolution.rate + 30.0 / 0.2).abs() < 1e-12 * 150.0, "Ḟ = −F K_b/c, got {} N/s", evolution.rate);
        assert!((evolution.decay + 5.0).abs() < 1e-14, "−1/(0.2 s), got {}", evolution.decay);
    }

    #[test]
    fn drawn_out_steadily_it_keeps_the_force_of_its_dashpot() {
        for (exponent, rate, force) in [(1.0, 0.5, 200.0), (0.5, 0.25, 200.0), (0.5, -0.25, -200.0)] {
            let evolution = damper(exponent).evolution(&under(force), &at(rate));
            assert!(evolution.rate.abs() < 1e-10, "F = c v^α at α = {exponent}: {} N/s", evolution.rate);
        }
        assert_eq!(damper(0.5).evolution(&under(0.0), &at(0.25)).rate, 500.0, "K_b v before the dashpot creeps");
    }

    #[test]
    fn the_power_that_it_takes_is_stored_in_the_brace_or_lost_in_the_dashpot() {
        for (exponent, force, rate) in [(0.4, 300.0, 0.6), (0.4, -300.0, 0.6), (1.0, 50.0, -0.3)] {
            let (device, phase) = (damper(exponent), under(force));
            // d/dt of F²/(2 K_b).
            let gained = force / device.stiffness * device.evolution(&phase, &at(rate)).rate;
            let lost = device.dissipated_power(&phase, &at(rate));
            assert!(
                lost > 0.0 && (gained + lost - force * rate).abs() < 1e-12 * lost.max(gained.abs()),
                "α {exponent}"
            );
            assert_eq!(device.stored_energy(&phase, &at(rate)), force * force / 4000.0);
        }
    }

    #[test]
    fn its_evolution_changes_with_force_and_rate_as_differences_say() {
        let device = damper(0.4);
        for force in [-300.0, 120.0] {
            let rate_under = |force: f64, rate: f64| device.evolution(&under(force), &at(rate)).rate;
            let evolution = device.evolution(&under(force), &at(0.2));
            let decay = (rate_under(force + 1e-3, 0.2) - rate_under(force - 1e-3, 0.2)) / 2e-3;
            assert!((decay / evolution.decay - 1.0).abs() < 1e-7, "{decay} against {}", evolution.decay);
            let drive = (rate_under(force, 0.3) - rate_under(force, 0.1)) / 0.2;
            assert!((drive - evolution.drive.y).abs() < 1e-9 * drive, "{drive} against {}", evolution.drive);
            assert_eq!(device.force(&under(force), &at(0.2)), evolution.force * force, "linear in what it remembers");
        }
    }

    const DAMPER: MaxwellDamper = MaxwellDamper { coefficient: 2e6, exponent: 0.7, stiffness: 8.5e6 };

    fn in_branch(force: f64, branch: u32) -> Phase {
        Phase { branch, memory: [force, 0.0, 0.0] }
    }

    #[test]
    fn a_zero_of_the_force_ends_a_phase_where_the_law_has_a_kink() {
        let motion = Separation::default();
        assert_eq!(MaxwellDamper { exponent: 1.0, ..DAMPER }.switches(&in_branch(1.0, TENSION)), 0, "linear");
        for (branch, sign) in [(TENSION, 1.0), (COMPRESSION, -1.0)] {
            let (lasts, over) = (in_branch(sign * 850.0, branch), in_branch(-sign * 850.0, branch));
            assert!((DAMPER.switch(0, &lasts, &motion) + 1e-4).abs() < 1e-18, "0.1 mm of the brace");
            assert!(DAMPER.switch(0, &over, &motion) > 0.0);
            let within = |way: f64| Excursion { way, rate: f64::INFINITY };
            assert!(DAMPER.stays_below(0, &lasts, &motion, within(0.9e-4)));
            assert!(!DAMPER.stays_below(0, &lasts, &motion, within(1.1e-4)));
            let (next, released) = DAMPER.next(Switch::Function(0), &in_branch(0.0, branch), &motion);
            assert_eq!((next.branch, released), (COMPRESSION - branch, 0.0), "the other sign, no energy");
        }
    }
}
