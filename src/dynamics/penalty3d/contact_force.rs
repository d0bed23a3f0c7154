//! Forces of the contact-friction model on two bodies (paper, section 4).
//!
//! `R_k` acts at the node `X_k` and `−R_k` at the anchor `X_p` (`docs/physics.md#contact-kinematics`), of laws whose two springs
//! differ at `X_k` too. The momentum of the pair is kept exactly, its angular momentum up to the couple `(X_k − X_p) × R_k`.

use glam::{DMat3, DVec2, DVec3};

use crate::contact::{ContactGeometry, Crossed, Forces, Frame, Local, Measured, Mode, NormalLaw, measure};
use crate::dynamics::ContactSite;
use crate::dynamics::penalty3d::contact_state::ClosedContact;

/// Forces of a contact and their points of action, world axes.
#[derive(Clone, Copy, Debug)]
pub struct Action {
    /// Position and velocity of the node relative to the face.
    pub here: Local,
    /// Forces of the law in the face's axes \[N\].
    pub forces: Forces,
    /// `R_k` on the node's body \[N\].
    pub force: DVec3,
    /// `X_k` from the node body's G \[m\].
    pub node_arm: DVec3,
    /// Point of action on the face's body from its G \[m\].
    pub face_arm: DVec3,
    /// Couple on the node's body besides, the opposite one on the face's: of two edges across each other \[N·m\].
    pub couple: DVec3,
    /// Turn of the axes of [`here`](Self::here) and [`forces`](Self::forces) from the face's.
    pub crossed: Crossed,
}

impl Action {
    /// The two tangents that the tangential force is along, world axes.
    pub fn tangents(&self, geometry: &ContactGeometry, face: &Frame) -> [DVec3; 2] {
        [DVec3::X, DVec3::Y].map(|axis| face.turn(geometry.axes * self.crossed.in_axes(axis)))
    }
}

/// Forces of a closed contact, poses relative to the placed poses.
#[inline]
pub fn act(site: &ContactSite, closed: &ClosedContact, node: &Frame, face: &Frame) -> Action {
    act_in(&site.geometry_at(&closed.place), closed, &closed.mode, node, face)
}

/// Forces of a closed contact in the mode `mode`, poses relative to those of `geometry`.
#[inline]
pub fn act_in(geometry: &ContactGeometry, closed: &ClosedContact, mode: &Mode, node: &Frame, face: &Frame) -> Action {
    let measured = measure(geometry, node, face);
    let Measured { here, arm, lever, crossed } = measured;
    let forces = closed.forces_in(mode, &here);
    if geometry.edge != DVec3::ZERO {
        let offset = closed.law.normal.is_along_stretch().then(|| geometry.anchor_part());
        return act_across(geometry, face, measured, forces, offset.unwrap_or(0.0));
    }
    let force = to_world(geometry, face, forces.tangential_total(), forces.normal_total());
    let offset = if closed.law.normal.is_along_stretch() {
        to_world(geometry, face, forces.stretch, here.gap)
    } else {
        DVec3::ZERO
    };
    Action { here, forces, force, node_arm: arm, face_arm: lever - offset, couple: DVec3::ZERO, crossed }
}

/// Forces of two edges across each other: at the node, on the face's body by the part `anchor_part` of the way from there to the anchor,
/// with the couple by which the normal force acts along the common perpendicular.
fn act_across(
    geometry: &ContactGeometry,
    face: &Frame,
    Measured { here, arm: node_arm, lever, crossed }: Measured,
    forces: Forces,
    anchor_part: f64,
) -> Action {
    let total = forces.tangential_total().extend(forces.normal_total());
    let in_world = |v: DVec3| to_world(geometry, face, v.truncate(), v.z);
    let force = in_world(crossed.in_axes(total));
    let couple = in_world(crossed.couple(here.at.extend(here.gap), total));
    let face_arm = match anchor_part {
        0.0 => lever,
        part => lever - part * in_world(crossed.in_axes(forces.stretch.extend(here.gap))),
    };
    Action { here, forces, force, node_arm, face_arm, couple, crossed }
}

/// World components of a vector given by its components along and normal to the face.
#[inline]
pub fn to_world(geometry: &ContactGeometry, face: &Frame, along: DVec2, normal: f64) -> DVec3 {
    let axes = &geometry.axes;
    if face.level && geometry.upright {
        // Rotation about Z and a vertical face: the terms that are 0 are left out.
        let [x, y] =
            [axes.x_axis.x * along.x + axes.z_axis.x * normal, axes.x_axis.y * along.x + axes.z_axis.y * normal];
        let [first, second] = [face.turned.x_axis, face.turned.y_axis];
        let [more_x, more_y] = [first.x * x + second.x * y, first.y * x + second.y * y];
        return DVec3::new(x + more_x, y + more_y, axes.y_axis.z * along.y);
    }
    let placed = axes.x_axis * along.x + axes.y_axis * along.y + axes.z_axis * normal;
    if face.turned == DMat3::ZERO { placed } else { face.turn(placed) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::penalty3d::example::{closed, stick, wall};

    /// A contact of a girder pressed in, moved along the wall and rotated.
    fn turned(level: bool) -> (Model, Action, [Frame; 2], ContactGeometry) {
        let (model, active) = closed(&wall(), stick);
        let site = &model.sites[active[0].site];
        let node = Frame { level, ..model.bodies[0].planar_frame(&[1e-3, 2e-4, 1e-3, 0.3, 0.1, 0.5]) };
        let (geometry, face) = (site.geometry, Frame { level, ..site.stand });
        let action = act(site, &active[0].closed, &node, &face);
        (model, action, [node, face], geometry)
    }

    #[test]
    fn the_couple_of_action_and_reaction_is_that_of_the_stretch() {
        let (_, action, [node, face], geometry) = turned(true);
        let [at_node, at_face] = [node.origin() + action.node_arm, face.origin() + action.face_arm];
        let couple = at_node.cross(action.force) - at_face.cross(action.force);
        let offset = to_world(&geometry, &face, action.forces.stretch, 0.0);
        let expected =
            offset.cross(action.force) + to_world(&geometry, &face, DVec2::ZERO, action.here.gap).cross(action.force);
        assert!(action.forces.stretch.length() > 1e-5, "the spring is stretched");
        assert!((couple - expected).length() < 1e-12 * action.force.length(), "{couple} is not {expected}");
    }

    #[test]
    fn the_force_in_the_world_has_the_components_of_the_law() {
        let (_, action, [_, face], geometry) = turned(true);
        let normal = face.turn(geometry.axes.z_axis);
        let forces = action.forces;
        assert!((action.force.dot(normal) - forces.normal_total()).abs() < 1e-11 * action.force.length(), "normal");
        let square = forces.normal_total().powi(2) + forces.tangential_total().length_squared();
        assert!((action.force.length_squared() / square - 1.0).abs() < 1e-12, "length");
    }

    #[test]
    fn the_sums_in_plan_are_those_in_space() {
        let [(_, plan, ..), (_, space, ..)] = [turned(true), turned(false)];
        assert!((plan.force - space.force).length() < 1e-11 * space.force.length(), "{} N", plan.force);
        assert!((plan.node_arm - space.node_arm).length() < 1e-15, "node");
        assert!((plan.face_arm - space.face_arm).length() < 1e-15, "face");
    }
}
