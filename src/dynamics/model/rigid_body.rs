//! Forces on a rigid body in space, and its accelerations: bearings at their attachment points, given pushes, inertia.

use glam::{DMat3, DVec2, DVec3};

use crate::contact::Frame;
use crate::dynamics::connection::{Connection, Separation};
use crate::dynamics::model::bearing::Bearing;
use crate::dynamics::model::body::{Body, Point};
use crate::dynamics::model::wrench::Wrench;

/// Acceleration of G and rate of spin of a body in this pose since it was placed: contact, bearings, what these leave of the
/// weight, pushes and ground; Euler's equations.
pub(in crate::dynamics) fn accelerations(body: &Body, here: &Frame, contact: &Wrench, ground: DVec3) -> [DVec3; 2] {
    let mut wrench = on_bearings(body, here);
    wrench.force += contact.force + body.push + DVec3::Z * body.unbalanced.force;
    wrench.moment += contact.moment + first_moment(body, here).cross(DVec3::Z);
    wrench.moment.z += body.moment.z;
    // A sum with 0 would change the sign of a zero.
    if body.moment.truncate() != DVec2::ZERO {
        wrench.moment += body.moment.with_z(0.0);
    }
    newton_euler(body, here, &wrench, ground)
}

/// Accelerations by all loads on the body.
#[inline]
pub(in crate::dynamics) fn newton_euler(body: &Body, here: &Frame, all: &Wrench, ground: DVec3) -> [DVec3; 2] {
    [all.force / body.mass - ground, spin_rate(body, here, all.moment)]
}

/// Resultant of a rigid body's weight and the preloads of its bearings.
pub(in crate::dynamics) fn standing(body: &Body, here: &Frame) -> Wrench {
    Wrench { force: DVec3::Z * body.unbalanced.force, moment: first_moment(body, here).cross(DVec3::Z) }
}

/// `Σ f l` of the preloads where the body is now, in the world: across the upward vertical it is their moment \[N·m\].
fn first_moment(body: &Body, here: &Frame) -> DVec3 {
    let placed = body.axes * body.unbalanced.first_moment;
    placed + here.turned * placed
}

/// Wrench of all bearings without the preloads, `−K (p − p0) − C ṗ`, summed in the girder's axes as placed.
fn on_bearings(body: &Body, here: &Frame) -> Wrench {
    // Axes along the world's: the products with 0 and 1 left out, not a bit differs.
    if body.axes == DMat3::IDENTITY {
        return in_axes(body, &here.turned, [here.shift, here.velocity, here.spin]);
    }
    let into_axes = body.axes.transpose();
    let motion = [here.shift, here.velocity, here.spin].map(|v| into_axes * v);
    let sum = in_axes(body, &(into_axes * here.turned * body.axes), motion);
    Wrench { force: body.axes * sum.force, moment: body.axes * sum.moment }
}

#[inline]
fn in_axes(body: &Body, turned: &DMat3, [shift, velocity, spin]: [DVec3; 3]) -> Wrench {
    let mut sum = Wrench::default();
    for b in &body.bearings {
        let swung = *turned * b.place;
        let arm = b.place + swung;
        let motion = Separation { moved: shift + swung, rate: velocity + spin.cross(arm), ..Separation::default() };
        sum.push(b.force(&(), &motion), arm);
    }
    sum
}

/// Motion of the point at which a bearing acts.
pub struct BearingMotion<'a> {
    /// The bearing.
    pub bearing: &'a Bearing,
    /// Motion relative to its foot, in the girder's axes as placed.
    pub motion: Separation,
    /// From G to the point, world axes \[m\].
    pub arm: DVec3,
}

/// Motion of every bearing of a girder.
pub fn bearing_motions<'a>(body: &'a Body, here: &'a Frame) -> impl Iterator<Item = BearingMotion<'a>> + 'a {
    let into_axes = body.axes.transpose();
    body.bearings.iter().map(move |b| {
        let placed = body.axes * b.place;
        let swung = here.turned * placed;
        let arm = placed + swung;
        let moved = into_axes * (here.shift + swung);
        let rate = into_axes * here.velocity_at(arm);
        BearingMotion { bearing: b, motion: Separation { moved, rate, ..Separation::default() }, arm }
    })
}

/// Acceleration of a rigid body, world axes.
pub struct RigidAcceleration {
    /// Of G \[m/s²\].
    pub linear: DVec3,
    /// Rate of spin \[rad/s²\].
    pub angular: DVec3,
}

/// Acceleration of a body by a force that acts at `arm` from G.
pub fn response(body: &Body, rotation: &DMat3, force: DVec3, arm: DVec3) -> RigidAcceleration {
    let free = DVec3::from_array(std::array::from_fn(|i| f64::from(u8::from(body.free[i]))));
    RigidAcceleration { linear: force * free / body.mass, angular: free_inverse(body, rotation, arm.cross(force)) }
}

/// Acceleration of a point by a force that acts there \[m/s²\].
pub(in crate::dynamics) fn acceleration(body: &Body, point: &Point<'_>, force: DVec3) -> DVec3 {
    let RigidAcceleration { linear, angular } = response(body, &point.frame.rotation(&body.axes), force, point.arm);
    linear + angular.cross(point.arm)
}

/// `I ω̇ = M − ω × I ω`, solved in the directions that the body is free to turn in.
fn spin_rate(body: &Body, here: &Frame, moment: DVec3) -> DVec3 {
    if body.free[3..] == [true; 3] {
        // In the body frame, where the inertia is constant.
        let rotation = here.rotation(&body.axes);
        let into_body = rotation.transpose();
        let spin = into_body * here.spin;
        return rotation * (body.inverse_inertia * (into_body * moment - spin.cross(body.inertia * spin)));
    }
    let rotation = here.rotation(&body.axes);
    let inertia = world_inertia(body, &rotation);
    free_inverse(body, &rotation, moment - here.spin.cross(inertia * here.spin))
}

/// `I⁻¹ M` in the directions that the body is free to turn in.
fn free_inverse(body: &Body, rotation: &DMat3, moment: DVec3) -> DVec3 {
    let mut matrix = world_inertia(body, rotation);
    let mut right = moment;
    // The row and column of a held direction are replaced by those of the identity: its rate is 0.
    for i in 0..3 {
        if !body.free[3 + i] {
            for j in 0..3 {
                matrix.col_mut(j)[i] = 0.0;
                matrix.col_mut(i)[j] = 0.0;
            }
            matrix.col_mut(i)[i] = 1.0;
            right[i] = 0.0;
        }
    }
    matrix.inverse() * right
}

/// Fastest circular frequency or decay rate of a body on its bearings, direction by direction \[rad/s\].
pub(in crate::dynamics) fn fastest(body: &Body) -> f64 {
    let inertia = [body.mass, body.mass, body.mass * body.gyration2];
    let decay = (0..3).map(|i| body.planar.damping.col(i)[i] / inertia[i]);
    body.quantities().omega.into_iter().chain(decay).fold(0.0, f64::max)
}

/// Kinetic energy \[J\].
pub(in crate::dynamics) fn kinetic_energy(body: &Body, here: &Frame) -> f64 {
    let spin = here.spin.dot(world_inertia(body, &here.rotation(&body.axes)) * here.spin);
    0.5 * (body.mass * here.velocity.length_squared() + spin)
}

/// Strain energy of the bearings \[J\]. The preloads are constant vertical forces, whose work is taken off; `weight` is in \[N\].
pub(in crate::dynamics) fn strain_energy(body: &Body, here: &Frame, weight: f64) -> f64 {
    let stored: f64 = bearing_motions(body, here).map(|of| of.bearing.stored_energy(&(), &of.motion)).sum();
    stored - preload_work(body, here, weight)
}

/// Work of the preloads of a rigid body since it was placed \[J\].
pub(in crate::dynamics) fn preload_work(body: &Body, here: &Frame, weight: f64) -> f64 {
    let turned = here.turned * (body.axes * body.unbalanced.first_moment);
    (weight + body.unbalanced.force) * here.shift.z + turned.z
}

/// Power lost in the bearings \[W\].
pub(in crate::dynamics) fn bearing_loss(body: &Body, here: &Frame) -> f64 {
    bearing_motions(body, here).map(|of| of.bearing.dissipated_power(&(), &of.motion)).sum()
}

/// Inertia about G in world axes \[kg·m²\].
pub fn world_inertia(body: &Body, rotation: &DMat3) -> DMat3 {
    *rotation * body.inertia * rotation.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::scene::presets;

    #[test]
    fn a_force_at_g_turns_nothing_and_a_couple_moves_nothing() {
        let model = Model::compile(&presets::load("deck-30m").expect("a preset")).expect("a scene");
        let body = &model.bodies[0];
        let RigidAcceleration { linear, angular } = response(body, &body.axes, DVec3::X * body.mass, DVec3::ZERO);
        assert_eq!((linear, angular), (DVec3::X, DVec3::ZERO), "through G");
        let (arm, force) = (DVec3::Y, DVec3::X);
        let [one, other] = [(force, arm), (-force, -arm)].map(|(force, arm)| response(body, &body.axes, force, arm));
        assert_eq!(one.linear + other.linear, DVec3::ZERO, "a couple");
        let moment = world_inertia(body, &body.axes) * (one.angular + other.angular);
        assert!((moment - 2.0 * arm.cross(force)).length() < 1e-14, "its moment: {moment}");
    }
}
