//! The motion of the ground at one time.

use glam::DVec3;

/// Acceleration of the ground of reference at a time of a step, and what the motion of other supports is computed from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundNow {
    /// Acceleration \[m/s²\].
    pub acceleration: DVec3,
    /// Time \[s\].
    pub t: f64,
    /// Beginning of the stretch without a kink that this time belongs to \[s\].
    pub since: f64,
}

impl GroundNow {
    /// Of ground that moves as one and has this acceleration \[m/s²\].
    pub const fn of(acceleration: DVec3) -> Self {
        Self { acceleration, t: 0.0, since: 0.0 }
    }
}
