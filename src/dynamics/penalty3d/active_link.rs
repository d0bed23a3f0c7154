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
