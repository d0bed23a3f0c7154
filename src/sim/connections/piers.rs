//! Piers at any instant, and what a run did to them.

use glam::{DVec2, DVec3};

use crate::dynamics::model::compiled_model::Pier;
use crate::scene::{BaseYield, ResolvedPier};
use crate::sim::connections::view::Connections;
use crate::sim::report::Extreme;
use crate::sim::{looks, peaks};

/// A pier at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PierNow {
    /// Displacement of its cap against the ground of reference, world \[m\].
    pub place: DVec3,
    /// Displacement of its cap against its foot, world \[m\].
    pub displacement: DVec3,
    /// Rotation of its cap in plan \[rad\].
    pub theta: f64,
    /// Force of its foot on the ground: springs, dashpots and what yields, world \[N\].
    pub shear: DVec3,
}

/// Largest drift, shear and moment of a pier over a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PierReading {
    /// Its number in the scene.
    pub pier: usize,
    /// Undamped periods of the pier alone along and across \[s\].
    pub periods: [f64; 2],
    /// Largest drift: displacement of its cap against its foot, in plan \[m\].
    pub drift: Extreme,
    /// Largest base shear, in plan \[N\].
    pub shear: Extreme,
    /// Largest moment at its feet, of all its columns: base shear times the height, or half the height where a cap holds the tops of
    /// its columns from turning \[N·m\].
    pub moment: Extreme,
    /// Largest |θ| of its cap \[rad\].
    pub turn: f64,
    /// Yielding of its base; `None` where that does not yield.
    pub base: Option<BaseReading>,
    /// Second-order moment `P Δ` of the weight on it in its largest drift, in parts of the moment of its largest base shear at its height;
    /// nothing of a pier without a given height. The model leaves this moment out \[–\].
    pub second_order: Option<f64>,
}

/// Ductility and residual drift of the base of a pier that yields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseReading {
    /// Time at which it first yielded \[s\].
    pub yielded_at: Option<f64>,
    /// Largest drift in parts of that at yield, along and across; on one yield circle that in any direction, twice \[–\].
    pub ductility: [f64; 2],
    /// Drift along and across that stays when the base is unloaded from the end of the run, `u − F/k` \[m\].
    pub residual: [f64; 2],
}

impl Connections<'_> {
    /// A pier at `t`, clamped to what was computed; `None` where the scene has no such pier.
    pub fn pier(self, number: usize, t: f64) -> Option<PierNow> {
        let Pier { body, yielding, column: ref links } = *self.history.model().piers.get(number)?;
        let (own, motion) = (&self.history.model().bodies[body], self.history.motion(body, t));
        let (place, rate) = (motion.displacement.with_z(motion.theta), motion.velocity.with_z(motion.spin.z));
        let column = (own.planar.stiffness * place + own.planar.damping * rate).with_z(0.0);
        // What yields, and the column on a foot that moves, act on the cap first.
        let linked = yielding.into_iter().chain(links.clone()).filter_map(|link| self.link(link, t));
        let linked: DVec3 = linked.map(|link| -link.force).sum();
        let place = place.with_z(0.0);
        let displacement = place - self.foot(number, t).with_z(0.0);
        Some(PierNow { place, displacement, theta: motion.theta, shear: column + linked.with_z(0.0) })
    }

    /// Displacement of a pier's foot against the ground of reference \[m\].
    fn foot(self, number: usize, t: f64) -> DVec3 {
        let foot = self.history.model().piers[number].column.clone().next();
        let foot = foot.and_then(|link| self.history.model().links[link].bodies[1]);
        foot.map_or(DVec3::ZERO, |body| self.history.motion(body, t).displacement)
    }

    /// Readings of every pier, in the order of their numbers.
    pub fn piers(self) -> Vec<PierReading> {
        (0..self.history.model().piers.len()).map(|number| self.pier_reading(number)).collect()
    }

    /// Reading of the pier of this number in the model.
    pub fn pier_reading(self, number: usize) -> PierReading {
        let Pier { body, yielding, .. } = self.history.model().piers[number];
        let resolved: ResolvedPier = self.history.scene().pier(number);
        let times = looks::of_body(self.history, body);
        let largest = |of: &dyn Fn(&PierNow) -> f64| {
            peaks::largest(&times, &|t| self.pier(number, t).map_or(0.0, |now| of(&now)))
        };
        let plan = |vector: DVec3| DVec2::length(vector.truncate());
        let shear = largest(&|now| plan(now.shear));
        let [along, across, _] = resolved.frequencies();
        let drift = largest(&|now| plan(now.displacement));
        let height = self.history.scene().piers[number].height;
        let push = self.history.scene().weight_on(number) * drift.value;
        PierReading {
            pier: number,
            periods: [along, across].map(|omega| std::f64::consts::TAU / omega),
            drift,
            shear,
            moment: largest(&|now| {
                let along = resolved.axes.mul_transpose_vec3(now.shear).truncate();
                (along * DVec2::from(resolved.arm)).length()
            }),
            turn: largest(&|now| now.theta.abs()).value,
            base: yielding.zip(resolved.yielding).map(|(link, base)| self.base_reading(number, (link, base), &times)),
            second_order: height.filter(|_| shear.value > 0.0).map(|height| push / (shear.value * height)),
        }
    }

    /// Ductility and residual drift of the base of a pier, of which this link is the part that yields.
    fn base_reading(self, number: usize, (link, base): (usize, BaseYield), times: &[f64]) -> BaseReading {
        let resolved = self.history.scene().pier(number);
        let at_yield = [0, 1].map(|axis| base.force[axis] / resolved.stiffness[axis]);
        let drift = |t: f64| {
            let drift = self.pier(number, t).map_or(DVec3::ZERO, |now| now.displacement);
            resolved.axes.mul_transpose_vec3(drift).truncate()
        };
        let most = |part: &dyn Fn(DVec2) -> f64| peaks::largest(times, &|t| part(drift(t))).value;
        let [part_along, part_across] = base.part(resolved.stiffness);
        let ductility = if part_along == part_across {
            [most(&|u| u.length()) / at_yield[0]; 2]
        } else {
            [most(&|u| u.x.abs()) / at_yield[0], most(&|u| u.y.abs()) / at_yield[1]]
        };
        // The force of the part that yields is (1 − α) F beyond α k u: u − F/k = (1 − α) u − z/k.
        let (end, hysteretic) =
            (drift(self.history.end()), self.link(link, self.history.end()).map_or(DVec3::ZERO, |now| -now.force));
        let hysteretic = resolved.axes.mul_transpose_vec3(hysteretic);
        BaseReading {
            yielded_at: self.link_phases(link).iter().find(|(_, phase)| phase.branch != 0).map(|(t, _)| *t),
            ductility,
            residual: [0, 1].map(|axis| (1.0 - base.ratio) * end[axis] - hysteretic[axis] / resolved.stiffness[axis]),
        }
    }
}
