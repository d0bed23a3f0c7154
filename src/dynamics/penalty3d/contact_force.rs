//! The 3D contact-friction model between bodies (paper section 4): a law's forces, put where they act.
//!
//! `R_k` acts at the node `X_k`, `−R_k` at the point `X_p` that holds it (`docs/physics.md#contact-kinematics`), so a
//! pair keeps its momentum exactly and its angular momentum up to the couple `(X_k − X_p) × R_k,t`.

use glam::{DMat3, DVec2, DVec3};

use crate::contact::{Forces, Frame, Home, Local, Measured, Mode, measure};
use crate::dynamics::ContactSite;
use crate::dynamics::penalty3d::contact_state::Closed;

/// A contact's forces and where they act, world frame.
#[derive(Clone, Copy, Debug)]
pub struct Action {
    /// The node against the face.
    pub here: Local,
    /// The law's forces in the face's axes.
    pub forces: Forces,
    /// `R_k` on the node's body \[N\].
    pub force: DVec3,
    /// `X_k` from the node body's G \[m\].
    pub node_arm: DVec3,
    /// `X_p` from the face body's G \[m\].
    pub face_arm: DVec3,
}

/// Forces of a closed contact.
#[inline]
pub fn act(site: &ContactSite, closed: &Closed, node: &Frame, face: &Frame) -> Action {
    act_in(&site.home, closed, &closed.mode, node, face)
}

/// Forces of a contact that is closed but for its mode, whose sides are counted from that home.
#[inline]
pub fn act_in(home: &Home, closed: &Closed, mode: &Mode, node: &Frame, face: &Frame) -> Action {
    let Measured { here, arm, apart } = measure(home, node, face);
    let forces = closed.forces_in(mode, &here);
    let force = to_world(home, face, forces.tangential_total(), forces.normal_total());
    let offset = to_world(home, face, forces.stretch, here.gap);
    Action { here, forces, force, node_arm: arm, face_arm: apart - offset }
}

/// A vector given in the face's axes, in the world.
#[inline]
pub fn to_world(home: &Home, face: &Frame, along: DVec2, normal: f64) -> DVec3 {
    let axes = &home.axes;
    if face.level && home.upright {
        // The same sum without what is 0.
        let [x, y] =
            [axes.x_axis.x * along.x + axes.z_axis.x * normal, axes.x_axis.y * along.x + axes.z_axis.y * normal];
        let [first, second] = [face.turned.x_axis, face.turned.y_axis];
        let [more_x, more_y] = [first.x * x + second.x * y, first.y * x + second.y * y];
        return DVec3::new(x + more_x, y + more_y, axes.y_axis.z * along.y);
    }
    let placed = axes.x_axis * along.x + axes.y_axis * along.y + axes.z_axis * normal;
    if face.turned == DMat3::ZERO { placed } else { face.turn(placed) }
}
