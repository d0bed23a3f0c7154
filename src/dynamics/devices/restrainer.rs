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

#[cfg(test)]
mod tests {
    use super::*;

    /// 2 m long with 10 mm of slack, 1000 N/m; yields at 20 N, at 20 mm beyond the slack, with 100 N/m from there; breaks at 50 mm.
    fn cable() -> Restrainer {
        let yielding = Some(Yielding { force: 20.0, stiffness: 100.0 });
        Restrainer { length: 2.0, slack: 0.01, stiffness: 1000.0, yielding, break_elongation: 0.05 }
    }

    /// Stretched beyond the slack by `elongation`, along its own line.
    fn at(elongation: f64, rate: f64) -> Separation {
        Separation { placed: DVec3::Y * 2.0, moved: DVec3::Y * (0.01 + elongation), rate: DVec3::Y * rate }
    }

    fn phase(branch: u32, plastic: f64, from: f64) -> Phase {
        Phase { branch, memory: [plastic, from, 0.0] }
    }

    fn close(got: f64, expected: f64, what: &str) {
        assert!((got - expected).abs() <= 1e-11 * expected.abs().max(1e-3), "{what}: {got} is not {expected}");
    }

    #[test]
    fn taut_it_pulls_along_its_line_and_slack_or_broken_it_does_not() {
        let cable = cable();
        let force = cable.force(&phase(TAUT, 0.0, 0.0), &at(0.01, 0.0));
        close(force.y, -10.0, "its first point is pulled towards the second");
        assert_eq!((force.x, force.z), (0.0, 0.0));
        close(cable.stored_energy(&phase(TAUT, 0.0, 0.0), &at(0.01, 0.0)), 0.5 * 10.0 * 0.01, "the triangle");
        for idle in [SLACK, BROKEN] {
            assert_eq!(cable.force(&phase(idle, 0.0, 0.0), &at(0.01, 1.0)).length(), 0.0);
            assert_eq!(cable.stored_energy(&phase(idle, 0.0, 0.0), &at(0.01, 1.0)), 0.0);
        }
    }

    #[test]
    fn in_yield_the_force_rises_by_the_second_stiffness_and_stays_on_the_yield_surface() {
        let cable = cable();
        let (yielding, released) = cable.next(Switch::Function(1), &phase(TAUT, 0.0, 0.0), &at(0.02, 0.1));
        assert_eq!((yielding.branch, released), (YIELD, 0.0));
        for elongation in [0.02, 0.03, 0.05] {
            let expected = 20.0 + 100.0 * (elongation - 0.02);
            close(-cable.force(&yielding, &at(elongation, 0.1)).y, expected, "T_y + K2 (e - e0)");
            let plastic = cable.plastic(&yielding, elongation);
            close(cable.yield_force(plastic), expected, "T_y + H e_p");
        }
    }

    #[test]
    fn the_work_up_to_the_break_in_yield_is_lost_or_released() {
        let cable = cable();
        let (yielding, _) = cable.next(Switch::Function(1), &phase(TAUT, 0.0, 0.0), &at(0.02, 0.1));
        let (broken, released) = cable.next(Switch::Function(2), &yielding, &at(0.05, 0.1));
        assert_eq!((broken.branch, cable.activity(&broken)), (BROKEN, Activity::Ended));
        // Under the two straight lines of the force, from 0 to 20 N and from 20 to 23 N.
        let work = 0.5 * 20.0 * 0.02 + 0.5 * (20.0 + 23.0) * 0.03;
        // The power is linear in time at a constant rate: its mean is that of its ends, for 0.3 s.
        let [first, last] = [0.02, 0.05].map(|elongation| cable.dissipated_power(&yielding, &at(elongation, 0.1)));
        close(released + 0.5 * (first + last) * 0.3, work, "the whole work");
        close(released, 23.0 * 23.0 / 2000.0, "what the elastic stiffness has stored");
    }

    #[test]
    fn a_cable_that_breaks_before_it_yields_releases_the_triangle() {
        let cable = Restrainer { yielding: None, break_elongation: 0.015, ..cable() };
        let (broken, released) = cable.next(Switch::Function(2), &phase(TAUT, 0.0, 0.0), &at(0.015, 0.1));
        assert_eq!(broken.branch, BROKEN);
        close(released, 0.5 * 15.0 * 0.015, "15 N at 15 mm");
        close(cable.strength().expect("it breaks"), 15.0, "the force of its break");
    }

    #[test]
    fn unloaded_after_yield_it_is_slack_and_taut_again_where_its_plastic_elongation_is_used_up() {
        let cable = cable();
        // From 20 to 40 mm nine tenths of the elongation are plastic.
        let (elastic, released) = cable.next(Switch::Function(1), &phase(YIELD, 0.0, 0.02), &at(0.04, 0.0));
        assert_eq!((elastic.branch, released), (TAUT, 0.0));
        close(elastic.memory[0], 0.018, "plastic elongation");
        close(-cable.force(&elastic, &at(0.04, 0.0)).y, 22.0, "continuous at the turn");
        close(-cable.force(&elastic, &at(0.03, 0.0)).y, 12.0, "10 mm less by the elastic stiffness");
        assert!(
            cable.switch(0, &elastic, &at(0.0181, -0.1)) < 0.0 && cable.switch(0, &elastic, &at(0.0179, -0.1)) > 0.0
        );
        let (slack, released) = cable.next(Switch::Function(0), &elastic, &at(0.018, -0.1));
        assert_eq!((slack.branch, released), (SLACK, 0.0));
        close(cable.gap(&slack, &at(0.018, 0.1))[0], 0.0, "there it is taut again");
        close(cable.gap(&slack, &at(0.018, 0.1))[1], -0.1, "and there its gap falls by the stretch");
        let (taut, released) = cable.next(Switch::Closing, &slack, &at(0.018, 0.1));
        assert_eq!((taut.branch, released), (TAUT, 0.0));
        // The surface has risen with the yield: 22 N.
        assert!(cable.switch(1, &taut, &at(0.0399, 0.1)) < 0.0 && cable.switch(1, &taut, &at(0.0401, 0.1)) > 0.0);
    }

    #[test]
    fn at_the_start_it_is_as_if_pulled_there_once() {
        let cable = cable();
        assert_eq!(cable.initial(&at(-1e-9, 1.0)).branch, SLACK);
        assert_eq!(cable.initial(&at(0.01, 1.0)), phase(TAUT, 0.0, 0.0));
        assert_eq!(cable.initial(&at(0.051, 1.0)).branch, BROKEN, "1 mm beyond its break");
        for (rate, branch) in [(1.0, YIELD), (-1.0, TAUT)] {
            let phase = cable.initial(&at(0.04, rate));
            assert_eq!(phase.branch, branch, "at {rate} m/s");
            close(-cable.force(&phase, &at(0.04, rate)).y, 22.0, "on the yield surface");
        }
        let drawn_in = cable.initial(&at(0.04, -1.0));
        assert!(cable.switch(1, &drawn_in, &at(0.04, -1.0)) < 0.0, "yield does not begin by rounding");
    }

    #[test]
    fn the_gap_is_smooth_where_the_points_meet_and_its_curvature_is_bounded() {
        let (cable, slack) = (Restrainer { slack: 0.0, ..cable() }, phase(SLACK, 0.0, 0.0));
        let met = Separation { placed: DVec3::Y * 2.0, moved: DVec3::Y * -2.0, rate: DVec3::new(0.3, 0.4, 0.0) };
        let [gap, rate] = cable.gap(&slack, &met);
        close(gap, 1.0, "half of its length");
        assert_eq!(rate, 0.0, "the least distance of the points");
        // (l² − r²)/(2l) with r = 0.5 t has the second derivative −0.5²/l.
        let bounds = SeparationBounds { distance: 1.0, speed: 0.5, acceleration: 0.0 };
        close(cable.gap_curvature(&slack, &bounds), 0.25 / 2.0, "v²/l without acceleration");
        assert!(cable.stays_idle(&slack, &SeparationBounds { distance: 1.99, ..bounds }));
        assert!(!cable.stays_idle(&slack, &SeparationBounds { distance: 2.0, ..bounds }), "it can be taut");
    }

    #[test]
    fn what_cannot_yield_or_break_has_no_such_event() {
        let cable = Restrainer { yielding: None, break_elongation: f64::INFINITY, ..cable() };
        let taut = phase(TAUT, 0.0, 0.0);
        assert_eq!([1, 2].map(|number| cable.switch(number, &taut, &at(1.0, 1.0))), [-1.0; 2]);
        assert_eq!(cable.strength(), None);
    }

    #[test]
    fn an_event_is_out_of_reach_of_a_motion_smaller_than_the_distance_to_it() {
        let (cable, taut) = (cable(), phase(TAUT, 0.0, 0.0));
        // Stretched by 5 mm of the 20 to yield and the 50 to the break.
        for (number, distance) in [(0, 0.005), (1, 0.015), (2, 0.045)] {
            let within = |way: f64| Excursion { way, rate: 9.0 };
            assert!(cable.stays_below(number, &taut, &at(0.005, 0.0), within(0.99 * distance)));
            assert!(!cable.stays_below(number, &taut, &at(0.005, 0.0), within(1.01 * distance)));
        }
        let still = Excursion { way: 0.0, rate: 0.0 };
        assert!(
            !cable.stays_below(1, &phase(YIELD, 0.0, 0.02), &at(0.03, 1.0), still),
            "a speed is not bounded by a way"
        );
    }
}
