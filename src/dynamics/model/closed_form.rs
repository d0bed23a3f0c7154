//! A linear block of coordinates whose free motion has a closed form.

use std::fmt::Debug;

use crate::dynamics::model::motion_bounds::MotionBounds;

/// The free motion of a body: bearings, given pushes and ground, without contact.
pub trait ClosedForm: Debug + Send + Sync {
    /// State at `t`, written to `out`, of what was in state `from` at `start` \[s\]; both since the body was placed.
    fn state(&self, start: f64, from: &[f64], t: f64, out: &mut [f64]);

    /// Bounds on the motion from `t` on, where it is at `state`, for at most `horizon` \[s\].
    fn bounds(&self, t: f64, state: &[f64], horizon: f64) -> MotionBounds;
}
