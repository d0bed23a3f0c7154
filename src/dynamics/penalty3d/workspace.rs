//! Workspace of an evaluation of the equations of motion: poses, wrenches and rates that outlive it only to save memory.

use crate::contact::Frame;
use crate::dynamics::model::wrench::Wrench;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::sliding::Sliding;

/// Workspace of an evaluation of the equations of motion.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Workspace {
    /// Poses of the sections of the bodies relative to their reference poses.
    pub frames: Vec<Frame>,
    /// Wrenches on the sections of the bodies.
    pub wrenches: Vec<Wrench>,
    /// Diagonal of the Jacobian: `∂φ̇/∂φ` of each slip angle φ, then `∂ṁ/∂m` of each device's memory m \[1/s\]; negative.
    pub rates: Vec<f64>,
    /// Contacts that slide in two directions, and devices whose memory evolves.
    pub sliding: Sliding,
}

impl Workspace {
    /// For these closed contacts.
    pub(in crate::dynamics) fn of(active: &[ActiveContact]) -> Self {
        Self { sliding: Sliding::of(active), ..Self::default() }
    }

    /// Removes the results of the last evaluation.
    pub(super) fn clear(&mut self) {
        self.frames.clear();
        self.wrenches.clear();
        self.rates.clear();
        self.sliding.clear();
    }
}
