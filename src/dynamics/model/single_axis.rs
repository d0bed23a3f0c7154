//! Planar motion along one world axis: whether anything but contact leads a body off it, and whether a state is on it.

use glam::DMat3;

use crate::dynamics::model::body::Body;
use crate::motion::Ground;

/// Whether ground, bearings and pushes never drive a body off a world axis, 0 or 1, that it moves along.
pub(in crate::dynamics) fn keeps(body: &Body, ground: &Ground, axis: usize) -> bool {
    let across = 1 - axis;
    let held = [!body.free[across], !body.free[5]];
    let straight = |m: &DMat3| (held[0] || m.col(axis)[across] == 0.0) && (held[1] || m.col(axis)[2] == 0.0);
    let undriven = held[0] || (ground.axis()[across] == 0.0 && body.push[across] == 0.0);
    straight(&body.planar.stiffness) && straight(&body.planar.damping) && undriven && (held[1] || body.moment == 0.0)
}

/// Whether a planar state is in line with an axis.
#[inline]
pub(in crate::dynamics) fn along(state: &[f64], axis: usize) -> bool {
    let across = 1 - axis;
    state[across] == 0.0 && state[2] == 0.0 && state[3 + across] == 0.0 && state[5] == 0.0
}
