//! The support of a bearing that can be lost: beyond a free travel, or over the front edge of its seat
//! (`docs/physics.md#loss-of-support`). Its link has the ground as its second end and the girder's axes as placed.
//!
//! While it stands, the law is that of the bearing's own link, if it has one, beside the spring and dashpot that are the girder's.
//! Once lost, for good, the link takes away what the girder's bearing has: `K u + C u̇ − P`.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::LinearBearing;
use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Evolution, Excursion, Linearity, Phase, Separation, SeparationBounds,
    Switch, SwitchUnit,
};
use crate::language::Text;
use crate::scene::seating::Room;

/// A support.
#[derive(Clone, Debug)]
pub struct Support {
    /// Displacements that keep it.
    pub room: Room,
    /// Spring and dashpot of the girder's bearing.
    pub spring: LinearBearing,
    /// P, its share of the weight \[N\].
    pub preload: DVec3,
    /// The law of the bearing's own link, whose force acts at all times.
    pub law: Option<Arc<dyn Device>>,
    /// Whether a run ends where it is lost.
    pub ends_run: bool,
}

/// It is gone; beyond the laws of any bearing.
const LOST: u32 = u32::MAX;

impl Support {
    /// Displacement square to the edges, and its rate.
    fn across(&self, motion: &Separation) -> [f64; 2] {
        let normal = DVec2::from(self.room.normal);
        [motion.moved, motion.rate].map(|v| v.truncate().dot(normal))
    }

    /// The law while it stands.
    fn standing(&self, phase: &Phase) -> Option<&dyn Device> {
        if phase.branch == LOST { None } else { self.law.as_deref() }
    }

    /// Strain energy of the girder's bearing relative to its unloaded state \[J\]: spring energy, less the preload's work, plus the energy
    /// stored by the preload.
    fn of_bearing(&self, motion: &Separation) -> f64 {
        let (stiffness, preload) = (self.spring.stiffness, self.preload);
        let squeezed = if stiffness.z > 0.0 { preload.z * preload.z / (2.0 * stiffness.z) } else { 0.0 };
        self.spring.stored_energy(&Phase::default(), motion) - preload.dot(motion.moved) + squeezed
    }
}

impl Connection for Support {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        match self.standing(phase) {
            Some(law) => law.force(phase, motion),
            None if phase.branch == LOST => -self.spring.force(phase, motion) - self.preload,
            None => DVec3::ZERO,
        }
    }

    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        match self.standing(phase) {
            Some(law) => law.stored_energy(phase, motion),
            None if phase.branch == LOST => -self.of_bearing(motion),
            None => 0.0,
        }
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        match self.standing(phase) {
            Some(law) => law.dissipated_power(phase, motion),
            None if phase.branch == LOST => -self.spring.dissipated_power(phase, motion),
            None => 0.0,
        }
    }

    fn stiffness_bound(&self, phase: &Phase) -> f64 {
        self.standing(phase).map_or_else(|| self.spring.stiffness_bound(phase), |law| law.stiffness_bound(phase))
    }

    fn damping_bound(&self, phase: &Phase) -> f64 {
        self.standing(phase).map_or_else(|| self.spring.damping_bound(phase), |law| law.damping_bound(phase))
    }
}

impl Device for Support {
    fn initial(&self, motion: &Separation) -> Phase {
        if self.room.excess(self.across(motion)[0]) >= 0.0 {
            return Phase { branch: LOST, ..Phase::default() };
        }
        self.law.as_ref().map(|law| law.initial(motion)).unwrap_or_default()
    }

    fn activity(&self, phase: &Phase) -> Activity {
        Activity::of(self.law.is_some() || phase.branch == LOST)
    }

    fn is_lost(&self, phase: &Phase) -> bool {
        phase.branch == LOST
    }

    fn ends_run(&self, phase: &Phase) -> bool {
        self.ends_run && phase.branch == LOST
    }

    /// Whether it stands is no linear function.
    fn linearity(&self, phase: &Phase) -> Linearity {
        self.standing(phase).map_or(Linearity::Force, |law| law.linearity(phase).min(Linearity::Force))
    }

    fn gap(&self, phase: &Phase, motion: &Separation) -> [f64; 2] {
        if let Some(law) = self.standing(phase) {
            return law.gap(phase, motion);
        }
        let [w, rate] = self.across(motion);
        [-self.room.excess(w), -self.room.excess_rate(w, rate)]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        self.room.excess_curvature(bounds.distance, bounds.speed, bounds.acceleration)
    }

    fn evolves(&self, phase: &Phase) -> bool {
        self.standing(phase).is_some_and(|law| law.evolves(phase))
    }

    fn evolution(&self, phase: &Phase, motion: &Separation) -> Evolution {
        self.standing(phase).map(|law| law.evolution(phase, motion)).unwrap_or_default()
    }

    fn force_and_evolution(&self, phase: &Phase, motion: &Separation) -> (DVec3, Evolution) {
        match self.standing(phase) {
            Some(law) => law.force_and_evolution(phase, motion),
            None => (self.force(phase, motion), Evolution::default()),
        }
    }

    fn switches(&self, phase: &Phase) -> usize {
        self.standing(phase).map_or(0, |law| law.switches(phase) + 1)
    }

    fn switch_unit(&self, number: usize, phase: &Phase) -> SwitchUnit {
        match self.standing(phase) {
            Some(law) if number < law.switches(phase) => law.switch_unit(number, phase),
            _ => SwitchUnit::Length,
        }
    }

    /// Those of the bearing's law, then the loss.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        match self.standing(phase) {
            Some(law) if number < law.switches(phase) => law.switch(number, phase, motion),
            _ => self.room.excess(self.across(motion)[0]),
        }
    }

    /// The excess beyond the room is convex in the displacement.
    fn stays_below(&self, number: usize, phase: &Phase, motion: &Separation, within: Excursion) -> bool {
        match self.standing(phase) {
            Some(law) if number < law.switches(phase) => law.stays_below(number, phase, motion, within),
            _ => {
                let [w, _] = self.across(motion);
                self.room.excess(w - within.way) < 0.0 && self.room.excess(w + within.way) < 0.0
            }
        }
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        match (self.standing(phase), event) {
            (Some(law), Switch::Function(number)) if number < law.switches(phase) => law.next(event, phase, motion),
            (law, _) => {
                let own = law.map_or(0.0, |law| law.stored_energy(phase, motion));
                (Phase { branch: LOST, ..Phase::default() }, own + self.of_bearing(motion))
            }
        }
    }
}

impl DeviceReadings for Support {
    fn state(&self, phase: &Phase) -> Text {
        match self.standing(phase) {
            Some(law) => law.state(phase),
            None if phase.branch == LOST => Text::new("state-lost"),
            None => Text::new("state-stands"),
        }
    }

    fn distance_left(&self, _: &Phase, motion: &Separation) -> f64 {
        let [w, _] = self.across(motion);
        (w - self.room.from).min(self.room.to - w)
    }

    /// Zero of a lost bearing.
    fn reaction(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        self.standing(phase).map_or(DVec3::ZERO, |law| law.reaction(phase, motion))
    }

    fn strength(&self) -> Option<f64> {
        self.law.as_ref().and_then(|law| law.strength())
    }

    fn lifts(&self) -> bool {
        self.law.as_ref().is_some_and(|law| law.lifts())
    }

    /// No line: the bearing itself is drawn.
    fn centre_line(&self, _: &Phase, _: [DVec3; 2]) -> Vec<DVec3> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::devices::stopper::{Failure, Stopper};

    /// Carries 400 N on a girder's bearing of 1 kN/m along and 200 kN/m up, between 0.2 m one way and 0.1 m the other; its own link,
    /// where it has one, is a stopper of 500 N/m that touches at 30 mm and breaks at 20 N.
    fn support(law: bool) -> Support {
        let (stiffness, damping) = (DVec3::new(1e3, 2e3, 2e5), DVec3::new(30.0, 40.0, 50.0));
        let stopper = Stopper { gap: 0.03, stiffness: 500.0, failure: Failure::Brittle { force: 20.0 } };
        Support {
            room: Room { normal: [0.6, 0.8], from: -0.2, to: 0.1 },
            spring: LinearBearing { stiffness, damping },
            preload: DVec3::Z * 400.0,
            law: law.then(|| Arc::new(stopper) as Arc<dyn Device>),
            ends_run: false,
        }
    }

    fn moved(moved: DVec3) -> Separation {
        Separation { moved, rate: DVec3::new(0.3, -0.2, 0.1), ..Separation::default() }
    }

    const GONE: Phase = Phase { branch: LOST, memory: [0.0; 3] };
    /// Of a support without a law, or of a stopper that does not touch.
    const STANDS: Phase = Phase { branch: 0, memory: [0.0; 3] };
    /// Of a stopper that touches.
    const PRESSED: Phase = Phase { branch: 1, memory: [0.0; 3] };

    fn close(got: f64, expected: f64, what: &str) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{what}: {got} is not {expected}");
    }

    #[test]
    fn lost_it_takes_away_the_whole_force_of_the_girders_bearing() {
        let (support, motion) = (support(true), moved(DVec3::new(0.05, 0.02, -0.001)));
        let of_bearing = support.spring.force(&STANDS, &motion) + support.preload;
        assert_eq!(support.force(&GONE, &motion) + of_bearing, DVec3::ZERO);
        assert_eq!(support.reaction(&GONE, &motion), DVec3::ZERO, "the bearing as a whole bears nothing");
        close(support.reaction(&PRESSED, &motion).x, -500.0 * 0.02, "standing it shows its law's force");
    }

    #[test]
    fn lost_its_stored_energy_and_losses_are_those_of_its_force() {
        let (support, here, rate) = (support(false), DVec3::new(0.05, 0.02, -0.001), DVec3::new(0.3, -0.2, 0.1));
        let stored = |t: f64| support.stored_energy(&GONE, &moved(here + rate * t));
        // A quadratic function: the difference is exact but for rounding.
        let gained = (stored(0.01) - stored(-0.01)) / 0.02;
        let (lost, force) = (support.dissipated_power(&GONE, &moved(here)), support.force(&GONE, &moved(here)));
        assert!(lost < 0.0, "what the girder's dashpots still count as lost");
        close(gained + lost, -force.dot(rate), "power into the link");
    }

    #[test]
    fn the_loss_releases_the_strain_of_the_bearing_from_its_unloaded_state() {
        let (support, motion) = (support(false), moved(DVec3::new(0.05, 0.02, 0.001)));
        let (gone, released) = support.next(Switch::Closing, &STANDS, &motion);
        assert_eq!(gone, GONE);
        // 400 N press the bearing by 2 mm, of which 1 mm is left.
        close(released, 0.5 * 1e3 * 0.0025 + 0.5 * 2e3 * 0.0004 + 0.5 * 2e5 * 1e-6, "springs along, across and up");
        close(support.stored_energy(&gone, &motion), -released, "the link's energy falls by what it releases");
        let plan = Support {
            spring: LinearBearing { stiffness: DVec3::new(1e3, 0.0, 0.0), ..support.spring },
            preload: DVec3::ZERO,
            ..support
        };
        close(plan.next(Switch::Closing, &STANDS, &motion).1, 1.25, "in plan that along alone, and no 0/0");
    }

    #[test]
    fn an_event_of_its_law_is_the_laws_and_the_one_after_them_is_the_loss() {
        let (support, motion) = (support(true), moved(DVec3::new(0.07, 0.0, 0.002)));
        assert_eq!(support.switches(&PRESSED), 2 + 1, "two of the stopper, and the loss");
        close(support.switch(1, &PRESSED, &motion), 0.04 - 20.0 / 500.0, "the stopper breaks at 40 mm");
        let (opened, released) = support.next(Switch::Function(0), &PRESSED, &motion);
        assert_eq!((opened.branch, support.is_lost(&opened), released), (0, false, 0.0));
        let (broken, released) = support.next(Switch::Function(1), &PRESSED, &motion);
        assert!(!support.is_lost(&broken), "the support stands without its stopper");
        close(released, 0.5 * 20.0 * 0.04, "the stopper's work");
        let (gone, released) = support.next(Switch::Function(2), &PRESSED, &motion);
        assert_eq!(gone, GONE);
        close(released, 0.5 * 20.0 * 0.04 + 0.5 * 1e3 * 0.0049, "the stopper's and the bearing's; unloaded upwards");
        close(support.stored_energy(&PRESSED, &motion) - support.stored_energy(&gone, &motion), released, "as before");
        assert_eq!((support.switches(&gone), support.switches(&STANDS)), (0, 3), "for good");
    }

    #[test]
    fn it_is_lost_where_the_displacement_square_to_the_edge_leaves_the_room() {
        let support = support(true);
        for (along, is_lost) in [(-0.201, true), (-0.199, false), (0.099, false), (0.101, true)] {
            // 0.6 and 0.8 along the normal; what lies along the edge does not count.
            let motion = moved(DVec3::new(0.6, 0.8, 0.0) * along + DVec3::new(0.8, -0.6, 0.0) * 5.0);
            assert_eq!(support.is_lost(&support.initial(&motion)), is_lost, "{along} m");
            assert_eq!(support.switch(2, &STANDS, &motion) > 0.0, is_lost, "{along} m");
        }
        let off = moved(DVec3::new(0.6, 0.8, 0.0) * -0.15);
        close(support.distance_left(&STANDS, &off), 0.05, "to the nearer of the two edges");
    }

    #[test]
    fn without_a_law_it_is_idle_until_its_gap_closes() {
        let support = support(false);
        assert_eq!([STANDS, GONE].map(|phase| support.activity(&phase)), [Activity::Idle, Activity::Acts]);
        let inside = moved(DVec3::new(0.03, 0.04, 0.0));
        assert_eq!(support.force(&STANDS, &inside), DVec3::ZERO);
        assert_eq!([support.stored_energy(&STANDS, &inside), support.dissipated_power(&STANDS, &inside)], [0.0; 2]);
        // w = 0.05 m at 0.02 m/s: 0.25 m · 0.05 m / 0.3 m, whose derivative by w is −(2 w − from − to)/0.3 m.
        let [gap, rate] = support.gap(&STANDS, &inside);
        close(gap, 0.25 * 0.05 / 0.3, "the product of both distances over the room");
        close(rate, -(0.1 + 0.1) / 0.3 * (0.6 * 0.3 - 0.8 * 0.2), "and its rate");
        assert_eq!([support.linearity(&STANDS), support.linearity(&GONE)], [Linearity::Force; 2]);
    }

    #[test]
    fn the_loss_is_out_of_reach_of_a_motion_that_stays_off_both_edges() {
        let (support, within) = (support(true), |way| Excursion { way, rate: 9.0 });
        for (w, nearest) in [(-0.12, 0.08), (0.06, 0.04)] {
            let motion = moved(DVec3::new(0.6, 0.8, 0.0) * w);
            assert!(support.stays_below(2, &STANDS, &motion, within(0.99 * nearest)), "{w} m");
            assert!(!support.stays_below(2, &STANDS, &motion, within(1.01 * nearest)), "{w} m");
        }
        // The stopper's break: pressed in by 10 of 40 mm.
        let pressed = moved(DVec3::X * 0.04);
        assert!(support.stays_below(1, &PRESSED, &pressed, within(0.029)));
        assert!(!support.stays_below(1, &PRESSED, &pressed, within(0.031)));
    }

    #[test]
    fn a_run_ends_by_a_loss_only_where_it_is_asked_to() {
        let stop = Support { ends_run: true, ..support(true) };
        assert_eq!([GONE, PRESSED].map(|phase| stop.ends_run(&phase)), [true, false]);
        assert!(!support(true).ends_run(&GONE));
    }
}
