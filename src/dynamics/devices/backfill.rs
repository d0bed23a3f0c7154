//! Backfill behind an abutment's backwall: the soil's resistance F to a push y of the first point along the first axis of its
//! link (`docs/physics.md#backfill`).
//!
//! Soil carries no tension and does not recover: on the envelope `F = F_env(y)`; the greatest push there, `y_m`, is the memory. Below it `F
//! = F_env(y_m) − K_ur (y_m − y)` down to 0 at `y_z = y_m − F_env(y_m)/K_ur`, so that a gap `y_z` stays.

use glam::DVec3;

use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Excursion, Linearity, Phase, Separation, SeparationBounds, Switch,
    SwitchUnit,
};
use crate::language::Text;

/// Envelope of the resistance: `F = K₀ y/(1 + D y)` up to a push at which it becomes constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Envelope {
    /// `K₀`, its slope at y = 0 \[N/m\].
    pub stiffness: f64,
    /// D; 0 for a straight line \[1/m\].
    pub curvature: f64,
    /// Push from which F is constant; infinite for one that rises for ever \[m\].
    pub limit: f64,
}

impl Envelope {
    /// `y/(1/K₀ + R_f y/F_ult)` of a slope \[N/m\], a failure ratio and an ultimate force \[N\].
    pub fn hyperbolic(stiffness: f64, failure_ratio: f64, ultimate: f64) -> Self {
        Self { stiffness, curvature: stiffness * failure_ratio / ultimate, limit: f64::INFINITY }
    }

    /// The hyperbola through `F_ult/2` at `F_ult/(2 K₅₀)` and `F_ult` at `y_max`, constant from there (Shamsabadi, Rollins and
    /// Kapuskar 2007), of `F_ult` \[N\], `K₅₀` \[N/m\] and `y_max` \[m\]; `None` unless `K₅₀ y_max > F_ult`.
    pub fn of_mean_stiffness(ultimate: f64, mean_stiffness: f64, limit: f64) -> Option<Self> {
        let stiffness = 2.0 * mean_stiffness - ultimate / limit;
        let curvature = 2.0 * (mean_stiffness / ultimate - 1.0 / limit);
        (mean_stiffness * limit > ultimate).then_some(Self { stiffness, curvature, limit })
    }

    /// A straight line up to a force \[N\], constant from there.
    pub fn bilinear(stiffness: f64, ultimate: f64) -> Self {
        Self { stiffness, curvature: 0.0, limit: ultimate / stiffness }
    }

    /// `F_env(y)` \[N\].
    pub fn force(&self, push: f64) -> f64 {
        self.rising(push.min(self.limit))
    }

    /// The part before the limit, continued beyond \[N\].
    fn rising(&self, push: f64) -> f64 {
        self.stiffness * push / (1.0 + self.curvature * push)
    }

    /// `F_env′(y)` before the limit \[N/m\].
    fn slope(&self, push: f64) -> f64 {
        self.stiffness / (1.0 + self.curvature * push).powi(2)
    }
}

/// Backfill between the backwall and the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Backfill {
    /// Distance as placed to where the soil begins \[m\].
    gap: f64,
    envelope: Envelope,
    /// `K_ur` \[N/m\].
    unloading: f64,
}

/// The wall has no soil at its back.
const APART: u32 = 0;
/// Unloading or reloading with `K_ur`.
const ELASTIC: u32 = 1;
const ENVELOPE: u32 = 2;
/// On the constant part of the envelope.
const FAILED: u32 = 3;

impl Backfill {
    /// Of a distance \[m\], an envelope and an unloading stiffness \[N/m\]; `None` where that is less than the envelope's
    /// first slope, or a number is not positive.
    pub fn new(gap: f64, envelope: Envelope, unloading: f64) -> Option<Self> {
        let Envelope { stiffness, curvature, limit } = envelope;
        let whole = stiffness > 0.0 && curvature >= 0.0 && limit > 0.0 && unloading.is_finite() && gap.is_finite();
        (whole && unloading >= stiffness).then_some(Self { gap, envelope, unloading })
    }

    /// y.
    fn push(&self, motion: &Separation) -> f64 {
        motion.vector().x - self.gap
    }

    /// `y_m`, the memory \[m\].
    fn greatest(phase: &Phase) -> f64 {
        phase.memory[0]
    }

    /// `y_z`, the gap that stays \[m\].
    fn remaining_gap(&self, phase: &Phase) -> f64 {
        let greatest = Self::greatest(phase);
        greatest - self.envelope.force(greatest) / self.unloading
    }

    fn resistance(&self, phase: &Phase, motion: &Separation) -> f64 {
        let push = self.push(motion);
        match phase.branch {
            APART => 0.0,
            // By the distance from y_z, so that F is 0 there to the last bit.
            ELASTIC => self.unloading * (push - self.remaining_gap(phase)),
            ENVELOPE => self.envelope.rising(push),
            _ => self.envelope.force(self.envelope.limit),
        }
    }

    /// State on the envelope at a push.
    fn on_envelope(&self, push: f64) -> u32 {
        if push < self.envelope.limit { ENVELOPE } else { FAILED }
    }
}

impl Connection for Backfill {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        DVec3::X * -self.resistance(phase, motion)
    }

    /// `F²/(2 K_ur)`.
    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.resistance(phase, motion).powi(2) / (2.0 * self.unloading)
    }

    /// On the envelope `F ẏ (1 − F_env′/K_ur)`.
    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        let elastic = match phase.branch {
            ENVELOPE => self.envelope.slope(self.push(motion)) / self.unloading,
            FAILED => 0.0,
            _ => return 0.0,
        };
        self.resistance(phase, motion) * motion.rate.x * (1.0 - elastic)
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        self.unloading
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        0.0
    }
}

impl Device for Backfill {
    /// Pushed at the start as if for the first time.
    fn initial(&self, motion: &Separation) -> Phase {
        let push = self.push(motion);
        Phase { branch: if push > 0.0 { self.on_envelope(push) } else { APART }, ..Phase::default() }
    }

    fn activity(&self, phase: &Phase) -> Activity {
        Activity::of(phase.branch != APART)
    }

    fn linearity(&self, phase: &Phase) -> Linearity {
        if phase.branch != ENVELOPE || self.envelope.curvature == 0.0 { Linearity::Whole } else { Linearity::None }
    }

    fn gap(&self, phase: &Phase, motion: &Separation) -> [f64; 2] {
        [self.remaining_gap(phase) - self.push(motion), -motion.rate.x]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }

    fn switches(&self, _: &Phase) -> usize {
        2
    }

    fn switch_unit(&self, number: usize, phase: &Phase) -> SwitchUnit {
        if number == 0 && phase.branch != ELASTIC { SwitchUnit::Speed } else { SwitchUnit::Length }
    }

    /// On the envelope 0: the push falls, 1: the limit is reached; elastic 0: the envelope is reached, 1: the wall leaves the soil.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        let push = self.push(motion);
        match (number, phase.branch) {
            (0, ELASTIC) => push - Self::greatest(phase),
            (0, _) => -motion.rate.x,
            (_, ELASTIC) => self.remaining_gap(phase) - push,
            (_, ENVELOPE) if self.envelope.limit.is_finite() => push - self.envelope.limit,
            _ => -1.0,
        }
    }

    /// Every switching function changes by no more than the displacement or the rate that it is a part of.
    fn stays_below(&self, number: usize, phase: &Phase, motion: &Separation, within: Excursion) -> bool {
        self.switch(number, phase, motion) + self.switch_unit(number, phase).largest_change(within) < 0.0
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        let (push, greatest) = (self.push(motion), Self::greatest(phase));
        let next = |branch, greatest| Phase { branch, memory: [greatest, 0.0, 0.0] };
        let next = match (event, phase.branch) {
            // Soil that was never pushed begins on its envelope.
            (Switch::Closing, _) if greatest <= 0.0 => next(self.on_envelope(push), 0.0),
            (Switch::Closing, _) => next(ELASTIC, greatest),
            (Switch::Function(0), ELASTIC) => next(self.on_envelope(greatest), greatest),
            (Switch::Function(_), ELASTIC) => next(APART, greatest),
            (Switch::Function(0), _) => next(ELASTIC, push.max(greatest)),
            (Switch::Function(_), _) => next(FAILED, greatest),
        };
        // A change is noticed a rounding of the place late.
        (next, self.stored_energy(phase, motion) - self.stored_energy(&next, motion))
    }
}

impl DeviceReadings for Backfill {
    fn state(&self, phase: &Phase) -> Text {
        match phase.branch {
            APART => Text::new("state-apart"),
            ELASTIC => Text::new("state-elastic"),
            ENVELOPE => Text::new("state-loaded"),
            _ => Text::new("state-fails"),
        }
    }

    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.gap(phase, motion)[0]
    }

    fn strength(&self) -> Option<f64> {
        Some(self.envelope.force(f64::MAX)).filter(|force| force.is_finite())
    }

    /// The soil is drawn behind its wall.
    fn centre_line(&self, _: &Phase, _: [DVec3; 2]) -> Vec<DVec3> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(push: f64, rate: f64) -> Separation {
        Separation { moved: DVec3::X * push, rate: DVec3::X * rate, ..Separation::default() }
    }

    fn close(what: &str, got: f64, expected: f64) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs(), "{what}: {got} is not {expected}");
    }

    #[test]
    fn envelopes_pass_where_their_formulas_say() {
        let mean = Envelope::of_mean_stiffness(4e6, 2.87e8, 0.085).expect("a hyperbola");
        close("half of F_ult at F_ult/(2 K50)", mean.force(4e6 / (2.0 * 2.87e8)), 2e6);
        close("F_ult at y_max", mean.force(0.085), 4e6);
        assert_eq!(mean.force(0.2), mean.force(0.085), "constant beyond");
        let line = Envelope::bilinear(2.87e8, 4.063e6);
        close("a straight line", line.force(0.01), 2.87e6);
        close("up to F_ult", line.force(0.03), 4.063e6);
        assert_eq!(Envelope::of_mean_stiffness(4e6, 1e7, 0.085), None, "F_ult is beyond y_max");
        assert_eq!(Backfill::new(0.0, line, 2.8e8), None, "unloads softer than it loads");
    }

    #[test]
    fn a_gap_stays_and_the_envelope_is_met_again_where_it_was_left() {
        let soil = Backfill::new(0.0, Envelope::hyperbolic(1.5e4, 0.75, 60.0), 1.5e4).expect("a law");
        let virgin = soil.initial(&at(-1e-3, 0.1));
        assert_eq!(virgin.branch, APART);
        let (pushed, _) = soil.next(Switch::Closing, &virgin, &at(0.0, 0.1));
        assert_eq!(pushed.branch, ENVELOPE);
        let deepest = at(4.942_912_219e-3, 0.0);
        let (turned, _) = soil.next(Switch::Function(0), &pushed, &deepest);
        close("continuous at the turn", soil.force(&turned, &deepest).x, soil.force(&pushed, &deepest).x);
        assert!((soil.remaining_gap(&turned) - 2.377_559_108e-3).abs() < 1e-12, "{}", soil.remaining_gap(&turned));
        let (left, _) = soil.next(Switch::Function(1), &turned, &at(2.377_559_108e-3, -0.2));
        assert_eq!((left.branch, soil.acts(&left)), (APART, false), "no tension");
        let (again, _) = soil.next(Switch::Closing, &left, &at(2.377_559_108e-3, 0.2));
        assert_eq!(again.branch, ELASTIC);
        assert!(soil.switch(0, &again, &at(4.9e-3, 0.1)) < 0.0 && soil.switch(0, &again, &at(5e-3, 0.1)) > 0.0);
        assert_eq!(soil.next(Switch::Function(0), &again, &deepest).0.branch, ENVELOPE);
    }

    #[test]
    fn work_on_the_envelope_is_stored_or_lost() {
        let line = Envelope::bilinear(1e4, 30.0);
        for (branch, push) in [(ENVELOPE, 2e-3), (FAILED, 5e-3)] {
            let soil = Backfill::new(0.0, line, 4e4).expect("a law");
            let phase = Phase { branch, ..Phase::default() };
            let stored = |push: f64| soil.stored_energy(&phase, &at(push, 1.0));
            let step = 1e-7;
            let gain = (stored(push + step) - stored(push - step)) / (2.0 * step);
            let lost = soil.dissipated_power(&phase, &at(push, 1.0));
            let work = -soil.force(&phase, &at(push, 1.0)).x;
            assert!((gain + lost - work).abs() < 1e-6 * work, "{gain} + {lost} for {work}");
        }
    }

    #[test]
    fn work_up_to_the_failed_soil_is_what_it_stores_and_loses_and_unloading_gives_back_the_stored_part() {
        let soil = Backfill::new(0.002, Envelope::bilinear(1e4, 30.0), 4e4).expect("a law");
        let placed = |push: f64, rate: f64| at(0.002 + push, rate);
        let loaded = soil.next(Switch::Closing, &soil.initial(&placed(-1e-6, 0.1)), &placed(0.0, 0.1)).0;
        assert_eq!(loaded.branch, ENVELOPE);
        let (failed, released) = soil.next(Switch::Function(1), &loaded, &placed(0.003, 0.1));
        assert_eq!(failed.branch, FAILED, "30 N at 3 mm");
        assert!(released.abs() < 1e-15, "no step of the stored energy: {released} J");
        // A triangle of 3 mm and a rectangle of 2 mm; lost at a power that rises linearly for 30 ms, then at a constant one for 20 ms.
        let work = 0.5 * 30.0 * 0.003 + 30.0 * 0.002;
        let lost = 0.5 * soil.dissipated_power(&loaded, &placed(0.003, 0.1)) * 0.03
            + soil.dissipated_power(&failed, &placed(0.004, 0.1)) * 0.02;
        close("work", soil.stored_energy(&failed, &placed(0.005, 0.0)) + lost, work);
        let (elastic, released) = soil.next(Switch::Function(0), &failed, &placed(0.005, 0.0));
        assert_eq!(elastic.branch, ELASTIC);
        assert!(released.abs() < 1e-15, "{released} J");
        // 30 N / 40 kN/m back from 5 mm.
        close("a gap stays", soil.gap(&elastic, &placed(0.0, 0.0))[0], 0.005 - 0.000_75);
        close(
            "the triangle that it gives back",
            soil.stored_energy(&elastic, &placed(0.005, 0.0)),
            0.5 * 30.0 * 0.000_75,
        );
        assert_eq!(soil.dissipated_power(&elastic, &placed(0.0045, -0.1)), 0.0);
        assert_eq!(soil.next(Switch::Function(0), &elastic, &placed(0.005, 0.1)).0.branch, FAILED, "it bears no more");
    }

    #[test]
    fn pushed_at_the_start_it_is_on_its_envelope() {
        let soil = Backfill::new(0.0, Envelope::bilinear(1e4, 30.0), 4e4).expect("a law");
        let branches = [-1e-9, 0.0, 1e-9, 0.0029, 0.0031].map(|push| soil.initial(&at(push, 0.1)).branch);
        assert_eq!(branches, [APART, APART, ENVELOPE, ENVELOPE, FAILED]);
    }

    #[test]
    fn an_event_is_out_of_reach_of_a_motion_smaller_than_the_distance_to_it() {
        let soil = Backfill::new(0.0, Envelope::bilinear(1e4, 30.0), 4e4).expect("a law");
        let loaded = Phase { branch: ENVELOPE, ..Phase::default() };
        // Unloading from 2 mm and 20 N leaves 1.5 mm.
        let elastic = Phase { branch: ELASTIC, memory: [0.002, 0.0, 0.0] };
        let cases = [
            (0, loaded, at(0.001, 0.2), SwitchUnit::Speed, 0.2),
            (1, loaded, at(0.001, 0.2), SwitchUnit::Length, 0.002),
            (0, elastic, at(0.0018, 0.2), SwitchUnit::Length, 0.0002),
            (1, elastic, at(0.0018, 0.2), SwitchUnit::Length, 0.0003),
        ];
        for (number, phase, motion, unit, distance) in cases {
            let within = |part: f64| match unit {
                SwitchUnit::Length => Excursion { way: part * distance, rate: 9.0 },
                SwitchUnit::Speed => Excursion { way: 9.0, rate: part * distance },
            };
            assert!(soil.stays_below(number, &phase, &motion, within(0.99)), "{number} of {phase:?}");
            assert!(!soil.stays_below(number, &phase, &motion, within(1.01)), "{number} of {phase:?}");
        }
    }
}
