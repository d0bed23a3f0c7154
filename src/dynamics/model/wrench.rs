//! A force at a body's G and a moment about it.

use glam::DVec3;

/// Force at G and moment about it \[N, N·m\].
#[derive(Clone, Copy, Debug, Default)]
pub struct Wrench {
    /// Force.
    pub force: DVec3,
    /// Moment about G.
    pub moment: DVec3,
}

impl Wrench {
    /// Adds a force that acts at `arm` from G.
    #[inline]
    pub fn push(&mut self, force: DVec3, arm: DVec3) {
        self.force += force;
        self.moment += arm.cross(force);
    }

    /// Adds a force that acts at `arm` from G, and a couple.
    #[inline]
    pub fn push_with(&mut self, force: DVec3, arm: DVec3, couple: DVec3) {
        self.push(force, arm);
        self.moment += couple;
    }
}
