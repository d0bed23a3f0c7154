//! A device whose force acts between two bodies of one island, or between one of them and the ground.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::connection::{Link, Phase, Separation};
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;

/// A link whose force acts.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct ActiveLink {
    /// Number of the link in the model.
    pub number: usize,
    /// Number of the link in the group.
    pub track: usize,
    /// Indices in the island of the bodies at its ends; `None` for the ground.
    pub ends: [Option<usize>; 2],
    /// The first sections of these bodies among those of the island's bodies; 0 for the ground.
    pub sections: [usize; 2],
    /// Present phase of the device.
    pub phase: Phase,
}

impl ActiveLink {
    /// Finds its sections among those of the island's bodies.
    pub(in crate::dynamics) fn find_sections(&mut self, layout: &StateLayout) {
        self.sections = self.ends.map(|body| body.map_or(0, |i| layout.sections(i).start));
    }

    pub(in crate::dynamics) fn of<'a>(&self, model: &'a Model) -> &'a Link {
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
        let link = self.of(model);
        let whole = |end: usize| self.ends[end].map(|body| bases[body].whole(&frames[self.sections[end]]));
        let frames = link.frames(whole);
        link.motion([&frames[0], &frames[1]])
    }

    /// Adds its force to the wrenches of the island's bodies.
    pub(in crate::dynamics) fn push(
        &self,
        model: &Model,
        bases: &[ReferencePose],
        frames: &[Frame],
        wrenches: &mut [Wrench],
    ) {
        let (link, (motion, arms)) = (self.of(model), self.motion(model, bases, frames));
        let force = link.axes * link.device.force(&self.phase, &motion);
        for (end, force) in [force, -force].into_iter().enumerate() {
            if self.ends[end].is_some() {
                wrenches[self.sections[end]].push(force, arms[end]);
            }
        }
    }

    /// Upper bound of the relative acceleration of its points per unit force, summed over its bodies \[1/kg\]. A point at a
    /// distance p beyond the corners' r has at most `(p/r)²` times their mobility: `1 + p²/i² ≤ (1 + r²/i²) (p/r)²`.
    pub(in crate::dynamics) fn mobility(&self, model: &Model) -> f64 {
        let link = self.of(model);
        link.bodies.iter().zip(link.arms).filter_map(|(body, arm)| Some((&model.bodies[(*body)?], arm))).fold(
            0.0,
            |sum, (body, arm)| {
                let beyond = (arm.length() / body.radius).max(1.0);
                sum + body.rate_bounds.mobility * (beyond * beyond)
            },
        )
    }
}
