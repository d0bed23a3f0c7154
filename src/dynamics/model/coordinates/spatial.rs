//! A rigid girder in space: displacement of G (3), what the girder has turned since it was placed as a quaternion x, y, z, w
//! (world axes), velocity of G (3), angular velocity in the world (3).

use std::ops::Range;

use glam::{DQuat, DVec2, DVec3};

use crate::contact::{Frame, turned_by};
use crate::dynamics::model::body::{Body, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::rigid_body::{self, RigidAcceleration};
use crate::dynamics::model::rotation;
use crate::dynamics::model::wrench::Wrench;

/// Components of a state.
pub const WIDTH: usize = 13;
/// Components that are positions.
const POSITIONS: usize = 7;
/// Positions where the body was placed.
const PLACED: [f64; POSITIONS] = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
/// The quaternion.
const TURN: Range<usize> = 3..POSITIONS;
/// Velocity of G.
const VELOCITY: Range<usize> = 7..10;
/// Angular velocity.
const SPIN: Range<usize> = 10..WIDTH;

/// The degrees of freedom of a rigid body in space.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Spatial;

/// Rotation of a body since it was placed.
pub fn turn(state: &[f64]) -> DQuat {
    let q = quaternion(state);
    // Kept near 1 by every accepted step; never 0.
    q * (1.0 / q.length())
}

fn quaternion(state: &[f64]) -> DQuat {
    DQuat::from_slice(&state[TURN])
}

/// Writes a quaternion to a state or to the rate of one.
pub(super) fn set_quaternion(state: &mut [f64], q: DQuat) {
    state[TURN].copy_from_slice(&q.to_array());
}

/// Rate of the state of a body, whose pose since it was placed is `here`, from wherever the state is counted.
pub fn slope(body: &Body, here: &Frame, state: &[f64], contact: &Wrench, ground: DVec3, out: &mut [f64]) {
    let [acceleration, spin_rate] = rigid_body::accelerations(body, here, contact, ground);
    for i in 0..3 {
        out[i] = if body.free[i] { state[VELOCITY.start + i] } else { 0.0 };
        out[VELOCITY.start + i] = if body.free[i] { acceleration[i] } else { 0.0 };
        out[SPIN.start + i] = spin_rate[i];
    }
    set_quaternion(out, turn_rate(state, here.spin));
}

/// `q̇ = ½ ω q`, ω in the world.
#[inline]
pub(super) fn turn_rate(state: &[f64], w: DVec3) -> DQuat {
    DQuat::from_xyzw(w.x, w.y, w.z, 0.0) * turn(state) * 0.5
}

/// Restores the length of the quaternion.
pub(super) fn normalise_turn(state: &mut [f64]) {
    let q = &mut state[TURN];
    let length = square(q).sqrt();
    for x in q {
        *x /= length;
    }
}

/// Adds to the quaternion what it gains in `dt` by the rate of the angular velocity.
pub(super) fn bend_turn(state: &mut [f64], spin_rate: DVec3, dt: f64) {
    let more = DQuat::from_vec4(spin_rate.extend(0.0)) * quaternion(state) * (0.25 * dt * dt);
    state[TURN].iter_mut().zip(more.to_array()).for_each(|(component, more)| *component += more);
}

/// Horizontal part of a body's axis, along and across the axis as placed \[–\].
fn heading(body: &Body, state: &[f64]) -> DVec2 {
    let placed = body.axes.x_axis;
    let axis = placed + turned_by(turn(state)) * placed;
    DVec2::new(axis.dot(placed), axis.dot(body.axes.y_axis))
}

/// The product of two quaternions, which need not be of length 1.
fn product(a: DQuat, b: DQuat) -> DQuat {
    let (u, v) = (a.xyz(), b.xyz());
    DQuat::from_vec4((u * b.w + v * a.w + u.cross(v)).extend(a.w * b.w - u.dot(v)))
}

fn square(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum()
}

impl Coordinates for Spatial {
    #[inline]
    fn width(&self) -> usize {
        WIDTH
    }

    #[inline]
    fn positions(&self) -> usize {
        POSITIONS
    }

    #[inline]
    fn displacements(&self) -> Option<Range<usize>> {
        Some(0..3)
    }

    fn initial(&self, body: &Body) -> Vec<f64> {
        let [x, y, z, angles @ ..] = body.start;
        let q = rotation::turned(body.axes, angles);
        let mut state = vec![x, y, z, q.x, q.y, q.z, q.w];
        state.extend(body.start_rate);
        state
    }

    #[inline]
    fn frame(&self, body: &Body, _: usize, state: &[f64]) -> Frame {
        Frame {
            home: body.home,
            shift: DVec3::new(state[0], state[1], state[2]),
            turned: turned_by(turn(state)),
            heading: 0.0,
            velocity: DVec3::from_slice(&state[VELOCITY]),
            spin: DVec3::from_slice(&state[SPIN]),
            level: false,
        }
    }

    #[inline]
    fn frame_since(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        self.frame(body, section, state)
    }

    fn attitude(&self, body: &Body, state: &[f64]) -> (f64, DQuat) {
        let heading = heading(body, state);
        (heading.y.atan2(heading.x), turn(state))
    }

    fn has_heading(&self) -> bool {
        true
    }

    fn heading(&self, body: &Body, state: &[f64]) -> Option<DVec2> {
        Some(heading(body, state))
    }

    fn reference(&self, _: &Body, numbers: &[f64]) -> ReferencePose {
        match *numbers {
            [x, y, z, i, j, k, w] if numbers != PLACED => {
                ReferencePose::spatial(DVec3::new(x, y, z), DQuat::from_xyzw(i, j, k, w))
            }
            _ => ReferencePose::spatial(DVec3::ZERO, DQuat::IDENTITY),
        }
    }

    fn rebase(&self, _: &Body, state: &mut [f64]) -> ReferencePose {
        let base = ReferencePose::spatial(DVec3::new(state[0], state[1], state[2]), turn(state));
        state[..3].fill(0.0);
        set_quaternion(state, DQuat::IDENTITY);
        base
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        if numbers.is_empty() {
            return;
        }
        (0..3).for_each(|i| state[i] += numbers[i]);
        // Linear in the components: a state between two steps has no length of exactly 1.
        set_quaternion(state, product(quaternion(state), quaternion(numbers)));
    }

    #[inline]
    fn slope(&self, body: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        slope(body, &now.base.whole(&now.frames[0]), now.state, &contact[0], ground.acceleration, out);
    }

    fn has_unit_parts(&self) -> bool {
        true
    }

    fn normalise(&self, state: &mut [f64]) {
        normalise_turn(state);
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        (0..3).for_each(|i| state[i] += 0.5 * dt * dt * slope[VELOCITY.start + i]);
        bend_turn(state, DVec3::from_slice(&slope[SPIN]), dt);
    }

    #[inline]
    fn size2(&self, body: &Body, d: &[f64]) -> [f64; 2] {
        let arm2 = body.gyration2;
        // A quaternion turns half the angle.
        [square(&d[..3]) + 4.0 * arm2 * square(&d[TURN]), square(&d[VELOCITY]) + arm2 * square(&d[SPIN])]
    }

    fn hold(&self, body: &Body, difference: &mut [f64]) {
        let (positions, velocities) = difference.split_at_mut(POSITIONS);
        for (i, free) in body.free.into_iter().enumerate() {
            if !free {
                velocities[i] = 0.0;
                if i < 3 {
                    positions[i] = 0.0;
                }
            }
        }
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        let length = if i % POSITIONS < 3 { place } else { 1.0 };
        (if i < POSITIONS { 1.0 } else { omega }) * length
    }

    #[inline]
    fn excursion(&self, arm: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        // A quaternion turns half the angle; the chord is not longer than the arc.
        way(0..3) + 2.0 * arm * way(TURN)
    }

    #[inline]
    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let ([speed, acceleration], [turning, bending]) = (rates(0..3), rates(TURN));
        // ω = 2 q̇ q⁻¹ and |ω̇| ≤ 2 |q̈|/|q| + 2 |q̇|²/|q|²: 2.2 for 2/|q| holds from a length of q of 0.91 on, and steps err by less. 8 for 2.5
        // leaves room.
        let (spin, spin_rate) = (2.2 * turning, 2.2 * bending + 8.0 * turning * turning);
        MotionBounds { speed, spin, acceleration, spin_rate, ..MotionBounds::still(f64::INFINITY) }
    }

    fn acceleration(&self, body: &Body, point: Point<'_>, force: DVec3) -> DVec3 {
        rigid_body::acceleration(body, &point, force)
    }

    fn port(&self, body: &Body, point: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let RigidAcceleration { linear, angular } =
            rigid_body::response(body, &point.frame.rotation(&body.axes), force, point.arm);
        response[VELOCITY].copy_from_slice(&linear.to_array());
        response[SPIN].copy_from_slice(&angular.to_array());
        load[VELOCITY].copy_from_slice(&force.to_array());
        load[SPIN].copy_from_slice(&point.arm.cross(force).to_array());
    }

    fn fastest(&self, body: &Body) -> f64 {
        rigid_body::fastest(body)
    }

    fn energies(&self, body: &Body, state: &[f64], gravity: f64) -> BodyEnergies {
        let (here, weight) = (self.frame(body, 0, state), body.mass * gravity);
        let strain = rigid_body::strain_energy(body, &here, weight);
        BodyEnergies {
            kinetic: rigid_body::kinetic_energy(body, &here),
            bearings: strain,
            gravity: weight * here.shift.z,
        }
    }

    fn powers(&self, body: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        let here = self.frame(body, 0, state);
        let push = body.push.dot(here.velocity) + body.moment.dot(here.spin);
        BodyPowers {
            ground: -body.mass * ground.acceleration.dot(here.velocity),
            push,
            bearings: rigid_body::bearing_loss(body, &here),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::model::bearing::UnbalancedWeight;
    use crate::dynamics::model::rigid_body::world_inertia;
    use crate::scene::presets;

    /// A deck of three different inertias that nothing acts on.
    fn free_top() -> Body {
        let model = Model::compile(&presets::load("deck-30m").expect("a preset")).expect("a scene");
        let mut body = model.bodies[0].clone();
        body.bearings.clear();
        (body.unbalanced, body.push, body.moment) = (UnbalancedWeight::default(), DVec3::ZERO, DVec3::ZERO);
        body.free = [true; 6];
        body
    }

    #[test]
    fn a_free_top_keeps_energy_momentum_and_the_length_of_its_quaternion() {
        let body = free_top();
        let q = DQuat::from_scaled_axis(DVec3::new(0.3, -0.8, 0.5));
        let state = [1.0, 2.0, 3.0, q.x, q.y, q.z, q.w, 0.4, -0.1, 0.2, 0.7, -1.1, 0.4];
        let mut rate = [0.0; WIDTH];
        let here = body.frame(0, &state);
        slope(&body, &here, &state, &Wrench::default(), DVec3::ZERO, &mut rate);
        let inertia = world_inertia(&body, &here.rotation(&body.axes));
        let (spin, spin_rate) = (here.spin, DVec3::from_slice(&rate[10..]));
        let momentum = inertia * spin;
        let size = momentum.length() * spin.length();
        assert!(spin_rate.length() > 1e-2, "it does tumble: {spin_rate}");
        // d(Iω)/dt = I ω̇ + ω × Iω, and the rate of the energy is ω · I ω̇.
        let lost = inertia * spin_rate + spin.cross(momentum);
        assert!(lost.length() < 1e-13 * size, "angular momentum: {lost}");
        assert!((spin.dot(inertia * spin_rate)).abs() < 1e-13 * size * spin.length(), "energy");
        assert_eq!(rate[7..10], [0.0; 3], "momentum");
        assert_eq!(rate[..3], state[7..10], "velocity");
        let along: f64 = (3..7).map(|i| state[i] * rate[i]).sum();
        assert!(along.abs() < 1e-16, "the quaternion turns without growing: {along}");
        // q̇ is what turning by ω dt does.
        let dt = 1e-6;
        let turned = DQuat::from_scaled_axis(spin * dt) * q;
        let by_rate = DQuat::from_xyzw(rate[3], rate[4], rate[5], rate[6]) * dt + q;
        assert!((turned - by_rate).length() < 1e-11, "{turned} against {by_rate}");
    }

    #[test]
    fn a_port_is_what_the_slope_gives_by_the_force_and_its_point_moves_by_the_acceleration() {
        let body = free_top();
        let mut state = [0.0; WIDTH];
        state[6] = 1.0;
        let (force, arm) = (DVec3::new(3.0, -1.0, 2.0), DVec3::new(4.0, 1.0, -0.5));
        let (mut wrench, mut rate) = (Wrench::default(), [0.0; WIDTH]);
        wrench.push(force, arm);
        let here = body.frame(0, &state);
        slope(&body, &here, &state, &wrench, DVec3::ZERO, &mut rate);
        let (mut response, mut load) = ([0.0; WIDTH], [0.0; WIDTH]);
        let point = Point { section: 0, frame: &here, arm };
        body.port(point, force, [&mut response, &mut load]);
        let [linear, turning] = [&response[VELOCITY], &response[SPIN]].map(DVec3::from_slice);
        assert!((linear - DVec3::from_slice(&rate[7..])).length() < 1e-15 * force.length(), "linear");
        assert!((turning - DVec3::from_slice(&rate[10..])).length() < 1e-14 * turning.length(), "angular");
        let there = linear + turning.cross(arm);
        assert!((body.acceleration(point, force) - there).length() < 1e-15 * there.length(), "its point");
        // Power of the force by the velocity of its point, and by the generalised force.
        state[7..].copy_from_slice(&[0.4, -0.1, 0.2, 0.7, -1.1, 0.3]);
        let power = force.dot(body.frame(0, &state).velocity_at(arm));
        let by_load: f64 = load.iter().zip(&state).map(|(load, rate)| load * rate).sum();
        assert!((power - by_load).abs() < 1e-14 * force.length(), "{by_load} W against {power}");
    }
}
