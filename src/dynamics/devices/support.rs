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
