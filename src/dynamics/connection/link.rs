//! A link: a device between two points of a model.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::contact::Frame;
use crate::dynamics::connection::{Device, Kinematics, Phase, Separation};

/// One end of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anchor {
    /// A point of a body, in its own axes from G \[m\].
    Body {
        /// Number of the body in the model.
        body: usize,
        /// The point.
        point: DVec3,
    },
    /// A point of the ground, world axes \[m\].
    Ground(DVec3),
}

impl Anchor {
    /// The body; nothing for the ground.
    pub fn body(&self) -> Option<usize> {
        match self {
            Self::Body { body, .. } => Some(*body),
            Self::Ground(_) => None,
        }
    }
}

/// A device between two points of a model, which has its bodies' places.
#[derive(Clone, Debug)]
pub struct Link {
    /// Name in tables.
    pub name: String,
    /// Bodies of its ends; nothing for the ground.
    pub bodies: [Option<usize>; 2],
    /// Arms of its points from G as placed, world axes; 0 for the ground \[m\].
    pub arms: [DVec3; 2],
    /// Sections of its bodies that its points are on; those of the bodies' G where the link is put into a model, which finds them.
    pub sections: [usize; 2],
    /// Origins of its ends as placed: G, or the point of the ground \[m\].
    pub homes: [DVec3; 2],
    /// Axes that the device sees its motion in, in the columns, in the world as placed.
    pub axes: DMat3,
    /// Measure of the relative motion of its points.
    pub kinematics: Kinematics,
    /// Law of the force.
    pub device: Arc<dyn Device>,
}

impl Link {
    /// Vector from the second point to the first as placed, in the link's axes \[m\].
    pub fn placed(&self) -> DVec3 {
        let [first, second] = [0, 1].map(|i| self.homes[i] + self.arms[i]);
        self.axes.mul_transpose_vec3(first - second)
    }

    /// Poses of the sections at its ends, the ground's where an end is fixed; `frame` gives that of an end, by its number and section.
    pub fn frames(&self, frame: impl Fn(usize, usize) -> Option<Frame>) -> [Frame; 2] {
        [0, 1].map(|i| frame(i, self.sections[i]).unwrap_or_else(|| Frame::fixed(self.homes[i])))
    }

    /// Motion of its points with its ends in these poses since they were placed, and the arms of its force from both G, world
    /// axes.
    pub fn motion(&self, frames: [&Frame; 2]) -> (Separation, [DVec3; 2]) {
        self.kinematics.motion(frames, self.arms, self.placed(), &self.axes)
    }

    /// Motion of a planar bearing's point against the ground, linear in the rotation, of a body with this displacement and
    /// rotation about the vertical, and their rates; `placed` is [`placed`](Self::placed).
    #[inline]
    pub(in crate::dynamics) fn motion_on_ground(
        &self,
        placed: DVec3,
        [shift, velocity]: [DVec3; 2],
        [turn, spin]: [f64; 2],
    ) -> Separation {
        let (arm, along, across) = (self.arms[0], self.axes.x_axis, self.axes.y_axis);
        let [moved, rate] = [(shift, turn), (velocity, spin)].map(|(of_g, turned)| {
            let (x, y) = (of_g.x - arm.y * turned, of_g.y + arm.x * turned);
            DVec3::new(along.x * x + along.y * y, across.x * x + across.y * y, 0.0)
        });
        Separation { placed, moved, rate }
    }

    /// Force of its device on the first point, world axes \[N\].
    pub fn force(&self, phase: &Phase, motion: &Separation, second: &Frame) -> DVec3 {
        self.kinematics.in_world(&self.axes, second, self.device.force(phase, motion))
    }

    /// Force of what its device is a part of on the first point, world axes \[N\].
    pub fn reaction(&self, phase: &Phase, motion: &Separation, second: &Frame) -> DVec3 {
        self.kinematics.in_world(&self.axes, second, self.device.reaction(phase, motion))
    }

    /// Size that its coordinates round with \[m\].
    pub(in crate::dynamics) fn size(&self) -> f64 {
        self.placed().length() + self.arms.iter().map(|arm| arm.length()).sum::<f64>()
    }
}
