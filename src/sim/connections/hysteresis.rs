//! Force against deformation of bearings, devices and soil: what a loop is drawn of.
//!
//! Resistance is the opposite of the force on the first body: deformation and resistance go round a loop clockwise in time, and its area
//! is what is lost.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::connection::{Connection, Kinematics, Separation};
use crate::dynamics::model::bearing::Bearing;
use crate::scene::Kind;
use crate::sim::connections::view::Connections;

/// Deformation and resistance along two axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loop {
    /// Along each axis \[m\].
    pub deformation: [f64; 2],
    /// Along each axis \[N\].
    pub resistance: [f64; 2],
}

impl Loop {
    /// Deformation and resistance by a motion and the force on the first point, both in the axes of a connection. Between points apart the first axis is the
    /// line between them, and the deformation its elongation; the second is square to it.
    pub(in crate::sim) fn of(motion: &Separation, force: DVec3, follows_line: bool) -> Self {
        if !follows_line {
            return Self { deformation: [motion.moved.x, motion.moved.y], resistance: [-force.x, -force.y] };
        }
        let (now, placed) = (motion.vector(), motion.placed);
        // |a + m| − |a| without the cancellation of two lengths.
        let elongation = motion.moved.dot(now + placed) / (now.length() + placed.length());
        let along = now.try_normalize().unwrap_or(DVec3::X);
        let across = DVec3::Z.cross(along);
        Self {
            deformation: [elongation, motion.moved.dot(across)],
            resistance: [-force.dot(along), -force.dot(across)],
        }
    }
}

impl<'a> Connections<'a> {
    /// Deformation and resistance of a bearing of a girder at `t`, along the girder's axes as placed, its hysteretic part with it; `None`
    /// where there is no such bearing.
    pub fn bearing_loop(self, girder: usize, number: usize, t: f64) -> Option<Loop> {
        let t = t.clamp(0.0, self.history.end());
        self.history.model().girders().get(girder)?;
        self.bearing_loop_in((girder, number), t, &|body, section| {
            self.history.trajectories.section_frame(body, section, t)
        })
    }

    /// Deformation and resistance of a bearing by the poses of sections of bodies at `t`, within what was computed.
    pub(in crate::sim) fn bearing_loop_in(
        self,
        (girder, number): (usize, usize),
        t: f64,
        frame: &dyn Fn(usize, usize) -> Frame,
    ) -> Option<Loop> {
        let body = &self.history.model().bodies[girder];
        let bearing = body.bearings.get(number)?;
        let numbers = self.bearing_links(girder, number);
        let parts = || numbers.iter().filter_map(|link| self.link_acting(*link, t, frame));
        if numbers.iter().any(|&link| self.history.model().links[link].bodies[1].is_some()) {
            // Links between girder and pier are all of it.
            let sum = |sum: Loop, part: Loop| Loop {
                deformation: part.deformation,
                resistance: [0, 1].map(|axis| sum.resistance[axis] + part.resistance[axis]),
            };
            return Some(parts().map(|(along, _)| along).fold(Loop::default(), sum));
        }
        let motion = self.bearing_motion((girder, bearing), (t, &frame(girder, 0)));
        let hysteretic: DVec3 = parts().map(|(_, force)| force).sum();
        let force = bearing.force(&(), &motion) + body.axes.transpose() * hysteretic;
        Some(Loop::of(&motion, force, false))
    }

    /// Motion of a bearing's point of its girder against the ground, along the girder's axes as placed, with the girder in a pose at `t`.
    pub(in crate::sim) fn bearing_motion(
        self,
        (girder, bearing): (usize, &Bearing),
        (t, frame): (f64, &Frame),
    ) -> Separation {
        let body = &self.history.model().bodies[girder];
        let kinematics =
            if self.history.model().kind == Kind::Planar { Kinematics::Linear } else { Kinematics::Points };
        let arm = body.axes * bearing.place;
        let ground = Frame::fixed(body.home + arm);
        let (mut motion, _) = kinematics.motion([frame, &ground], [arm, DVec3::ZERO], DVec3::ZERO, &body.axes);
        let [bent, rate] = self.history.sections().displaced(girder, bearing.place, t);
        motion.moved += bent;
        motion.rate += rate;
        motion
    }

    /// Numbers of the links that a girder's bearing has in the model.
    pub(in crate::sim) fn bearing_links(self, girder: usize, number: usize) -> &'a [usize] {
        let supports = self.history.model().supports.get(girder);
        supports.and_then(|supports| supports.get(number)).map_or(&[], Vec::as_slice)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{overrides, presets};
    use crate::sim::History;

    #[test]
    fn a_bearings_resistance_is_its_spring_and_dashpot_at_its_place() {
        let scene = presets::load("skew45-abutment").expect("ships");
        let history = History::of(&overrides::apply(&scene, "duration_s=1").expect("fits")).expect("runs");
        let body = &history.model().girders()[0];
        for t in [0.1, 0.37, 0.8] {
            let motion = history.motion(0, t);
            for (number, bearing) in body.bearings.iter().enumerate() {
                let arm = body.axes * bearing.place;
                let moved = motion.displacement + DVec3::Z.cross(arm) * motion.theta;
                let rate = motion.velocity + DVec3::Z.cross(arm) * motion.spin.z;
                let now = history.connections().bearing_loop(0, number, t).expect("it");
                for axis in 0..2 {
                    let wanted = bearing.stiffness[axis] * moved[axis] + bearing.damping[axis] * rate[axis];
                    let off = (now.resistance[axis] - wanted).abs();
                    assert!(off < 1e-9 * wanted.abs().max(1.0), "bearing {number}, {t} s: {now:?}, {wanted}");
                }
            }
        }
        assert_eq!(history.connections().bearing_loop(0, 99, 0.1), None, "no such bearing");
    }

    #[test]
    fn the_area_of_a_yielding_bearings_loop_is_what_it_loses() {
        let scene = presets::load("flush-free-hit").expect("ships");
        let bearing = "girder.deck.bearings=[{ at_m = [0, 0], stiffness_n_per_m = [100, 100], damping_n_s_per_m = [0, 0], \
                       yield_force_n = 1, yield_displacement_m = 0.002 }]";
        let sets = [bearing, "girder.deck.initial.velocity_m_s=[0, 0.3]", "duration_s=3", "abutment.wall.gap_m=10"];
        let history = History::of(&overrides::apply_all(&scene, &sets).expect("fits")).expect("runs");
        let at = |i: u32| history.connections().bearing_loop(0, 0, 3.0 * f64::from(i) / 60_000.0).expect("it");
        let area: f64 = (0..60_000)
            .map(|i| {
                let (a, b) = (at(i), at(i + 1));
                0.5 * (a.resistance[1] + b.resistance[1]) * (b.deformation[1] - a.deformation[1])
            })
            .sum();
        // The rest at the end is stored, in the spring and in the hysteretic part.
        let ledger = history.energy().ledger(3.0);
        let wanted = ledger.loss_bearing + ledger.bearing;
        assert!(wanted > 0.01 && (area - wanted).abs() < 1e-4 * wanted, "{area} J of {wanted} J");
    }
}
