//! A device whose force acts between two bodies of one island, or between one of them and the ground.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::connection::{Evolution, Kinematics, Link, Phase, Separation};
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;

/// The ground; where it is placed does not matter to a motion.
static STILL: Frame = Frame::fixed(DVec3::ZERO);

/// A link whose force acts.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct ActiveLink {
    /// Number of the link in the model.
    pub number: usize,
    /// Number of the link in the group.
    pub track: usize,
    /// Indices in the island of the bodies at its ends; `None` for the ground.
    pub ends: [Option<usize>; 2],
    /// Sections of these bodies that its points are on, among those of the island's bodies; 0 for the ground.
    pub sections: [usize; 2],
    /// Vector from the second point to the first as placed, in the link's axes \[m\].
    pub placed: DVec3,
    /// Phase of the device, with the memory at the start of the island.
    pub phase: Phase,
    /// Index in the island's vector of the law's first memory; `None` where the memory is constant.
    pub evolving: Option<usize>,
}

impl ActiveLink {
    /// Finds its sections among those of the island's bodies.
    pub(in crate::dynamics) fn find_sections(&mut self, model: &Model, layout: &StateLayout) {
        let own = self.link(model).sections;
        self.sections = [0, 1].map(|end| self.ends[end].map_or(0, |i| layout.sections(i).start + own[end]));
    }

    /// The link in the model.
    pub(in crate::dynamics) fn link<'a>(&self, model: &'a Model) -> &'a Link {
        &model.links[self.number]
    }

    /// Relative motion of its points and their arms from G, with poses `frames` of the island's bodies relative to
    /// the reference poses `bases`.
    pub(in crate::dynamics) fn motion(
        &self,
        model: &Model,
        bases: &[ReferencePose],
        frames: &[Frame],
    ) -> (Separation, [DVec3; 2]) {
        let link = self.link(model);
        if let ([Some(body), None], Kinematics::Linear) = (self.ends, link.kinematics) {
            // Of a planar bearing: no rotation matrix.
            let frame = &frames[self.sections[0]];
            let (shift, turn) = bases[body].whole_in_plan(frame);
            let motion = link.motion_on_ground(self.placed, [shift, frame.velocity], [turn, frame.spin.z]);
            return (motion, link.arms);
        }
        // Poses are borrowed where they are computed: with eight bearings, copies of poses dominated the cost of a step.
        let (first, second);
        let one = match self.ends[0] {
            Some(body) => {
                first = bases[body].whole(&frames[self.sections[0]]);
                &first
            }
            None => &STILL,
        };
        let other = match self.ends[1] {
            Some(body) => {
                second = bases[body].whole(&frames[self.sections[1]]);
                &second
            }
            None => &STILL,
        };
        link.motion([one, other])
    }

    /// Phase with the memory in the island's state `y`.
    pub(in crate::dynamics) fn phase_in(&self, y: &[f64]) -> Phase {
        let mut phase = self.phase;
        if let Some(at) = self.evolving {
            phase.memory[0] = y[at];
        }
        phase
    }

    /// Adds the device's force at the island's state `y` to the wrenches of the bodies. Returns the component of its memory in `y` and how
    /// that changes; `None` where the memory is no state of the island.
    #[inline]
    pub(in crate::dynamics) fn push(
        &self,
        (model, bases): (&Model, &[ReferencePose]),
        y: &[f64],
        frames: &[Frame],
        wrenches: &mut [Wrench],
    ) -> Option<(usize, Evolution)> {
        let (link, (motion, arms), phase) = (self.link(model), self.motion(model, bases, frames), self.phase_in(y));
        let (force, evolution) = match self.evolving {
            Some(_) => link.device.force_and_evolution(&phase, &motion),
            None => (link.device.force(&phase, &motion), Evolution::default()),
        };
        let force = self.in_world(model, bases, frames, force);
        for (end, force) in [force, -force].into_iter().enumerate() {
            if self.ends[end].is_some() {
                wrenches[self.sections[end]].push(force, arms[end]);
            }
        }
        self.evolving.map(|at| (at, evolution))
    }

    /// A vector of the link's axes in the world.
    pub(in crate::dynamics) fn in_world(
        &self,
        model: &Model,
        bases: &[ReferencePose],
        frames: &[Frame],
        vector: DVec3,
    ) -> DVec3 {
        let link = self.link(model);
        match self.ends[1] {
            Some(body) => {
                let second = bases[body].whole(&frames[self.sections[1]]);
                link.kinematics.in_world(&link.axes, &second, vector)
            }
            None => link.kinematics.in_world(&link.axes, &STILL, vector),
        }
    }

    /// Upper bound of the relative acceleration of its points per unit force, summed over its bodies \[1/kg\]. A point at a
    /// distance p beyond the corners' r has at most `(p/r)²` times their mobility: `1 + p²/i² ≤ (1 + r²/i²) (p/r)²`. Ground of given
    /// motion, whose r is 0 under a bearing, no force moves.
    pub(in crate::dynamics) fn mobility(&self, model: &Model) -> f64 {
        let link = self.link(model);
        let moved = |(body, arm): (&Option<usize>, DVec3)| {
            let body = &model.bodies[(*body)?];
            (body.rate_bounds.mobility > 0.0).then_some((body, arm))
        };
        link.bodies.iter().zip(link.arms).filter_map(moved).fold(0.0, |sum, (body, arm)| {
            let beyond = (arm.length() / body.radius).max(1.0);
            sum + body.rate_bounds.mobility * (beyond * beyond)
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DMat3;

    use super::*;
    use crate::dynamics::connection::{Anchor, Device};
    use crate::dynamics::devices::{LinearBearing, MaxwellDamper};
    use crate::dynamics::model::body::Point;
    use crate::dynamics::penalty3d::example::{free_to_turn, row};

    /// Point of the first girder and of the second, each from its G \[m\].
    const POINTS: [DVec3; 2] = [DVec3::new(0.09, 0.02, 0.0), DVec3::new(-0.08, 0.03, 0.0)];

    fn springs() -> Arc<dyn Device> {
        Arc::new(LinearBearing { stiffness: DVec3::new(300.0, 500.0, 0.0), damping: DVec3::ZERO })
    }

    /// A device between two girders in a row, or between the first and the ground, in axes turned by 0.3 rad.
    fn linked(to_ground: bool, kinematics: Kinematics, device: Arc<dyn Device>) -> (Model, ActiveLink) {
        let mut model = Model::compile(&free_to_turn(row())).unwrap_or_else(|errors| panic!("{errors}"));
        let first = Anchor::Body { body: 0, point: POINTS[0] };
        let second = if to_ground {
            Anchor::Ground(DVec3::new(0.5, 0.1, 0.0))
        } else {
            Anchor::Body { body: 1, point: POINTS[1] }
        };
        let axes = DMat3::from_rotation_z(0.3);
        model.link_by("link", [first, second], (axes, kinematics), device).expect("a link in the plane");
        let ends = [Some(0), (!to_ground).then_some(1)];
        let (placed, phase) = (model.links[0].placed(), Phase::default());
        let link = ActiveLink { number: 0, track: 0, ends, sections: [0, 1], placed, phase, evolving: None };
        (model, link)
    }

    /// Displaced in plan and turned about the vertical.
    fn pose(shift: DVec3, angle: f64) -> Frame {
        let turned = DMat3::from_rotation_z(angle) - DMat3::IDENTITY;
        Frame { shift, turned, heading: angle, ..Frame::fixed(DVec3::ZERO) }
    }

    /// The pose as the reference pose that states are counted from.
    fn base(shift: DVec3, angle: f64) -> ReferencePose {
        ReferencePose::level(shift, angle, pose(shift, angle).turned)
    }

    const SHIFTS: [DVec3; 2] = [DVec3::new(0.01, -0.02, 0.0), DVec3::new(-0.03, 0.005, 0.0)];

    #[test]
    fn the_motion_is_the_same_from_any_reference_poses() {
        for kinematics in [Kinematics::Points, Kinematics::Carried, Kinematics::Linear] {
            for to_ground in [false, true] {
                let (model, link) = linked(to_ground, kinematics, springs());
                let placed = [0, 1].map(|_| base(DVec3::ZERO, 0.0));
                let whole = [pose(SHIFTS[0], 0.2), pose(SHIFTS[1], -0.1)];
                let (expected, _) = link.motion(&model, &placed, &whole);
                let bases = [base(0.5 * SHIFTS[0], 0.05), base(2.0 * SHIFTS[1], -0.3)];
                let since = [pose(0.5 * SHIFTS[0], 0.15), pose(-SHIFTS[1], 0.2)];
                let (motion, _) = link.motion(&model, &bases, &since);
                assert!((motion.moved - expected.moved).length() < 1e-15, "{kinematics:?}, to ground {to_ground}");
            }
        }
    }

    #[test]
    fn a_planar_bearing_moves_by_its_arm_times_the_rotation() {
        let (model, link) = linked(true, Kinematics::Linear, springs());
        let bases = [base(DVec3::ZERO, 0.0), base(DVec3::ZERO, 0.0)];
        let (motion, arms) = link.motion(&model, &bases, &[pose(SHIFTS[0], 0.2), pose(DVec3::ZERO, 0.0)]);
        let moved = SHIFTS[0] + 0.2 * DVec3::new(-POINTS[0].y, POINTS[0].x, 0.0);
        let axes = [DVec3::new(0.3_f64.cos(), 0.3_f64.sin(), 0.0), DVec3::new(-0.3_f64.sin(), 0.3_f64.cos(), 0.0)];
        assert!((motion.moved.x - axes[0].dot(moved)).abs() < 1e-16, "{} m along the first axis", motion.moved.x);
        assert!((motion.moved.y - axes[1].dot(moved)).abs() < 1e-16, "{} m along the second", motion.moved.y);
        assert_eq!(arms[0], POINTS[0], "its arm stays as placed");
    }

    #[test]
    fn its_force_and_reaction_balance_in_force_and_moment() {
        let (model, link) = linked(false, Kinematics::Points, springs());
        let frames = [pose(SHIFTS[0], 0.2), pose(SHIFTS[1], -0.1)];
        let bases = [base(DVec3::ZERO, 0.0), base(DVec3::ZERO, 0.0)];
        let mut wrenches = [Wrench::default(); 2];
        let y = [0.0; 12];
        assert!(link.push((&model, &bases), &y, &frames, &mut wrenches).is_none(), "it remembers nothing");
        // Displacements of both points by their rotation matrices, in the link's axes by hand.
        let turned = |angle: f64, p: DVec3| {
            let (sine, cosine) = angle.sin_cos();
            DVec3::new(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y, 0.0)
        };
        let moved =
            (SHIFTS[0] + turned(0.2, POINTS[0]) - POINTS[0]) - (SHIFTS[1] + turned(-0.1, POINTS[1]) - POINTS[1]);
        let force = turned(0.3, -DVec3::new(300.0, 500.0, 0.0) * turned(-0.3, moved));
        assert!((wrenches[0].force - force).length() < 1e-12, "{} N is not {force}", wrenches[0].force);
        assert_eq!(wrenches[0].force, -wrenches[1].force);
        // About the world's origin.
        let about = |i: usize| wrenches[i].moment + (model.bodies[i].home + SHIFTS[i]).cross(wrenches[i].force);
        let left_over = (about(0) + about(1)).length();
        assert!(left_over < 1e-14, "{left_over} N m are left over");
    }

    #[test]
    fn the_ground_takes_its_reaction_without_a_body() {
        let (model, link) = linked(true, Kinematics::Points, springs());
        let bases = [base(DVec3::ZERO, 0.0), base(DVec3::ZERO, 0.0)];
        let mut wrenches = [Wrench::default(); 2];
        let frames = [pose(SHIFTS[0], 0.0), pose(SHIFTS[1], 0.0)];
        link.push((&model, &bases), &[0.0; 12], &frames, &mut wrenches);
        assert!(wrenches[0].force.length() > 1.0, "the girder is pushed");
        assert_eq!(wrenches[1].force, DVec3::ZERO, "the other girder is not");
    }

    #[test]
    fn a_memory_that_is_a_state_is_read_there_and_its_rate_is_returned() {
        let device = MaxwellDamper { coefficient: 400.0, exponent: 1.0, stiffness: 2000.0 };
        let (model, mut link) = linked(true, Kinematics::Points, Arc::new(device));
        link.evolving = Some(3);
        let y = [0.0, 0.0, 0.0, 30.0];
        assert_eq!(link.phase_in(&y).memory[0], 30.0);
        let bases = [base(DVec3::ZERO, 0.0), base(DVec3::ZERO, 0.0)];
        let frames = [pose(DVec3::ZERO, 0.0), pose(DVec3::ZERO, 0.0)];
        let mut wrenches = [Wrench::default(); 2];
        let (at, evolution) = link.push((&model, &bases), &y, &frames, &mut wrenches).expect("a state");
        assert_eq!(at, 3);
        assert!((evolution.rate + 30.0 * 2000.0 / 400.0).abs() < 1e-10, "it relaxes with c/K_b: {}", evolution.rate);
        assert!((wrenches[0].force.length() - 30.0).abs() < 1e-13, "the remembered force pulls");
    }

    #[test]
    fn axes_that_are_carried_turn_with_the_second_body_and_others_stay() {
        let frames = [pose(DVec3::ZERO, 0.9), pose(DVec3::ZERO, 0.4)];
        let bases = [base(DVec3::ZERO, 0.0), base(DVec3::ZERO, 0.1)];
        for (kinematics, to_ground, angle) in [
            (Kinematics::Points, false, 0.3),
            (Kinematics::Carried, false, 0.3 + 0.4 + 0.1),
            (Kinematics::Carried, true, 0.3),
        ] {
            let (model, link) = linked(to_ground, kinematics, springs());
            let vector = link.in_world(&model, &bases, &frames, DVec3::X);
            let expected = DVec3::new(f64::cos(angle), f64::sin(angle), 0.0);
            assert!((vector - expected).length() < 1e-15, "{kinematics:?}: {vector} is not {expected}");
        }
    }

    #[test]
    fn no_force_accelerates_its_points_by_more_than_its_mobility() {
        for beyond in [0.5, 1.0, 40.0] {
            let (mut model, link) = linked(false, Kinematics::Points, springs());
            model.links[0].arms[0] *= beyond;
            let mobility = link.mobility(&model);
            for angle in [0.0, 0.6, 1.2, 1.8, 2.4, 3.0] {
                let force = DVec3::new(f64::cos(angle), f64::sin(angle), 0.0);
                let still = pose(DVec3::ZERO, 0.0);
                let along = |body: usize| {
                    let point = Point { section: 0, frame: &still, arm: model.links[0].arms[body] };
                    model.bodies[body].acceleration(point, force).dot(force)
                };
                let acceleration = along(0) + along(1);
                assert!(acceleration > 0.0 && acceleration <= mobility * (1.0 + 1e-12), "{acceleration} of {mobility}");
            }
        }
    }
}
