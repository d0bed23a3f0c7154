//! A rigid girder in plan: `x, y, θ` since it was placed, and their rates.

use std::ops::Range;

use glam::{DMat3, DQuat, DVec3};
use nalgebra::DMatrix;

use crate::contact::Frame;
use crate::dynamics::model::axial_motion::AxialMotion;
use crate::dynamics::model::body::{Body, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::linear_block::part::{LinearPart, SectionShape};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::rigid_body::{self, RigidAcceleration};
use crate::dynamics::model::wrench::Wrench;

/// Components of a state.
pub const WIDTH: usize = 6;
/// Number of positions among the components; the rate of component `i` is component `POSITIONS + i`.
pub const POSITIONS: usize = 3;
/// World directions of [`Body::free`] that the positions are.
const DIRECTIONS: [usize; POSITIONS] = [0, 1, 5];

/// `x, y, θ, ẋ, ẏ, θ̇`, relative to where the girder was placed.
pub type PlanarState = [f64; WIDTH];

/// The degrees of freedom `x, y, θ`.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Planar;

/// One coordinate of a state and its rate.
#[inline]
pub(in crate::dynamics) fn part(state: &PlanarState, i: usize) -> [f64; 2] {
    [state[i], state[POSITIONS + i]]
}

/// A state from its coordinates, each with its rate.
#[inline]
pub(in crate::dynamics) fn of_parts([x, y, turn]: [[f64; 2]; POSITIONS]) -> PlanarState {
    [x[0], y[0], turn[0], x[1], y[1], turn[1]]
}

/// `x, y, θ` of a state.
#[inline]
pub(in crate::dynamics) fn positions(state: &[f64]) -> DVec3 {
    DVec3::new(state[0], state[1], state[2])
}

/// Their rates, in a state or in the rate of one.
#[inline]
pub(in crate::dynamics) fn rates(state: &[f64]) -> DVec3 {
    DVec3::new(state[3], state[4], state[5])
}

/// States of girders in a row.
#[inline]
pub(in crate::dynamics) fn in_a_row(y: &[f64]) -> &[PlanarState] {
    y.as_chunks().0
}

/// Whether a state is in line with a world axis, 0 or 1.
#[inline]
pub(in crate::dynamics) fn is_along(state: &PlanarState, axis: usize) -> bool {
    let across = 1 - axis;
    state[across] == 0.0 && state[2] == 0.0 && state[POSITIONS + across] == 0.0 && state[5] == 0.0
}

/// Whether a reference pose is in line with a world axis.
pub(in crate::dynamics) fn is_base_along(base: &ReferencePose, axis: usize) -> bool {
    let place = base.planar();
    place[1 - axis] == 0.0 && place.z == 0.0
}

/// Directions in which a girder is free.
pub(in crate::dynamics) fn free(body: &Body) -> [bool; POSITIONS] {
    DIRECTIONS.map(|direction| body.free[direction])
}

/// Rotation matrix about the vertical less the identity, R(angle) − 1.
#[inline]
fn turned(angle: f64) -> DMat3 {
    // Most girders of a row never turn. Of half the angle, for the cosine less 1 without loss.
    if angle == 0.0 {
        return DMat3::ZERO;
    }
    let (s, c) = (0.5 * angle).sin_cos();
    let (sine, less) = (2.0 * s * c, -2.0 * s * s);
    DMat3::from_cols(DVec3::new(less, sine, 0.0), DVec3::new(-sine, less, 0.0), DVec3::ZERO)
}

impl Body {
    /// Pose and twist of a planar state `(x, y, θ, ẋ, ẏ, θ̇)`.
    #[inline]
    pub fn planar_frame(&self, state: &[f64]) -> Frame {
        frame(self.home, self.start[2], whole(state))
    }
}

/// A state of which nothing is left out: a slice of other width is no state of a planar girder.
#[inline]
fn whole(state: &[f64]) -> &PlanarState {
    state.first_chunk().unwrap_or(&[f64::NAN; WIDTH])
}

/// Pose and twist at a height.
#[inline]
fn frame(home: DVec3, height: f64, [x, y, angle, u, v, spin]: &PlanarState) -> Frame {
    Frame {
        home,
        shift: DVec3::new(*x, *y, height),
        turned: turned(*angle),
        heading: *angle,
        velocity: DVec3::new(*u, *v, 0.0),
        spin: DVec3::new(0.0, 0.0, *spin),
        level: true,
    }
}

/// Rate of a state since the girder was placed, under bearings, push, ground and contact (1).
#[inline]
pub fn slope(body: &Body, state: &[f64], contact: &Wrench, ground: DVec3, out: &mut [f64]) {
    slope_from(body, DVec3::ZERO, state, contact, ground, out);
}

/// Rate of a state relative to the reference position `x, y, θ`.
#[inline]
fn slope_from(body: &Body, base: DVec3, state: &[f64], contact: &Wrench, ground: DVec3, out: &mut [f64]) {
    let (state, Some(out)) = (whole(state), out.first_chunk_mut::<WIDTH>()) else { return };
    let q = base + positions(state);
    let bearings = body.planar.stiffness * q + body.planar.damping * rates(state);
    let force =
        DVec3::new(contact.force.x + body.push.x, contact.force.y + body.push.y, contact.moment.z + body.moment.z);
    let total = force - bearings;
    let gains =
        [total.x / body.mass - ground.x, total.y / body.mass - ground.y, total.z / (body.mass * body.gyration2)];
    for (i, free) in free(body).into_iter().enumerate() {
        out[i] = if free { state[POSITIONS + i] } else { 0.0 };
        out[POSITIONS + i] = if free { gains[i] } else { 0.0 };
    }
}

impl Coordinates for Planar {
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
        Some(0..2)
    }

    fn initial(&self, body: &Body) -> Vec<f64> {
        let ([x, y, .., turn], [vx, vy, .., spin]) = (body.start, body.start_rate);
        vec![x, y, turn, vx, vy, spin]
    }

    #[inline]
    fn frame(&self, body: &Body, _: usize, state: &[f64]) -> Frame {
        body.planar_frame(state)
    }

    #[inline]
    fn frame_since(&self, body: &Body, _: usize, state: &[f64]) -> Frame {
        // The height is the reference pose's.
        frame(body.home, 0.0, whole(state))
    }

    fn attitude(&self, _: &Body, state: &[f64]) -> (f64, DQuat) {
        (state[2], DQuat::from_rotation_z(state[2]))
    }

    fn reference(&self, body: &Body, numbers: &[f64]) -> ReferencePose {
        match *numbers {
            [x, y, angle] if x != 0.0 || y != 0.0 || angle != 0.0 => {
                ReferencePose::level(DVec3::new(x, y, body.start[2]), angle, turned(angle))
            }
            // A girder keeps the height that it started at.
            _ => ReferencePose::level(DVec3::Z * body.start[2], 0.0, DMat3::ZERO),
        }
    }

    fn rebase(&self, body: &Body, state: &mut [f64]) -> ReferencePose {
        let DVec3 { x, y, z: angle } = positions(state);
        state[..POSITIONS].fill(0.0);
        ReferencePose::level(DVec3::new(x, y, body.start[2]), angle, turned(angle))
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        state.iter_mut().zip(numbers).for_each(|(component, base)| *component += base);
    }

    #[inline]
    fn slope(&self, body: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        slope_from(body, now.base.planar(), now.state, &contact[0], ground.acceleration, out);
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        (0..POSITIONS).for_each(|i| state[i] += 0.5 * dt * dt * slope[POSITIONS + i]);
    }

    #[inline]
    fn size2(&self, body: &Body, d: &[f64]) -> [f64; 2] {
        let arm2 = body.gyration2;
        let [x, y, angle, u, v, spin] = whole(d);
        [x * x + y * y + arm2 * angle * angle, u * u + v * v + arm2 * spin * spin]
    }

    fn hold(&self, body: &Body, difference: &mut [f64]) {
        for (i, free) in free(body).into_iter().enumerate() {
            if !free {
                (difference[i], difference[POSITIONS + i]) = (0.0, 0.0);
            }
        }
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        let length = if i % POSITIONS < 2 { place } else { 1.0 };
        (if i < POSITIONS { 1.0 } else { omega }) * length
    }

    #[inline]
    fn excursion(&self, arm: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        way(0..2) + arm * way(2..3)
    }

    #[inline]
    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let ([speed, acceleration], [spin, spin_rate]) = (rates(0..2), rates(2..3));
        MotionBounds { speed, spin, acceleration, spin_rate, ..MotionBounds::still(f64::INFINITY) }
    }

    fn acceleration(&self, body: &Body, point: Point<'_>, force: DVec3) -> DVec3 {
        rigid_body::acceleration(body, &point, force)
    }

    fn port(&self, body: &Body, point: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let RigidAcceleration { linear, angular } =
            rigid_body::response(body, &point.frame.rotation(&body.axes), force, point.arm);
        response[POSITIONS..].copy_from_slice(&[linear.x, linear.y, angular.z]);
        load[POSITIONS..].copy_from_slice(&[force.x, force.y, point.arm.cross(force).z]);
    }

    fn along(&self, body: &Body, axis: usize) -> Option<AxialMotion> {
        body.keeps_to_axis[axis].then_some(AxialMotion { components: [axis, POSITIONS + axis], modes: None })
    }

    fn linear_part(&self, body: &Body) -> Option<LinearPart> {
        let matrix = |m: &DMat3| DMatrix::from_fn(POSITIONS, POSITIONS, |i, j| m.col(j)[i]);
        let ([x, y, .., turn], Body { mass, push, moment, .. }) = (body.start, body);
        Some(LinearPart {
            masses: vec![*mass, *mass, mass * body.gyration2],
            free: free(body).to_vec(),
            stiffness: matrix(&body.planar.stiffness),
            damping: matrix(&body.planar.damping),
            own_damping: vec![0.0; POSITIONS],
            push: vec![push.x, push.y, moment.z],
            start: vec![x, y, turn],
            lever: 0.0,
            sections: vec![SectionShape::default()],
        })
    }

    fn fastest(&self, body: &Body) -> f64 {
        rigid_body::fastest(body)
    }

    fn energies(&self, body: &Body, state: &[f64], gravity: f64) -> BodyEnergies {
        let here = body.planar_frame(state);
        let inertia = body.mass * body.gyration2 * here.spin.z * here.spin.z;
        let weight = body.mass * gravity;
        let kinetic = 0.5 * (body.mass * here.velocity.length_squared() + inertia);
        let q = positions(state);
        BodyEnergies { kinetic, bearings: 0.5 * q.dot(body.planar.stiffness * q), gravity: weight * here.shift.z }
    }

    fn powers(&self, body: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        let here = body.planar_frame(state);
        let inertia = -body.mass * ground.acceleration.dot(here.velocity);
        let push = body.push.dot(here.velocity) + body.moment.z * here.spin.z;
        let v = rates(state);
        BodyPowers { ground: inertia, push, bearings: v.dot(body.planar.damping * v) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::scene::presets;

    #[test]
    fn a_planar_slope_is_newtons_law_in_the_free_directions() {
        let model = Model::compile(&presets::load("skew45-abutment").expect("a preset")).expect("a scene");
        let mut body = model.bodies[0].clone();
        let state = [0.01, -0.02, 0.03, 0.4, 0.5, -0.6];
        let contact = Wrench { force: DVec3::new(7.0, -3.0, 0.0), moment: DVec3::Z * 0.2 };
        let ground = DVec3::new(1.5, -0.5, 0.0);
        let mut rate = [0.0; WIDTH];
        body.free[5] = false;
        slope(&body, &state, &contact, ground, &mut rate);
        assert_eq!([rate[0], rate[1]], [0.4, 0.5], "velocities");
        assert_eq!([rate[2], rate[5]], [0.0; 2], "a held direction stands still");
        let (k, c) = (&body.planar.stiffness, &body.planar.damping);
        let row = |m: &DMat3, i: usize, from: usize| (0..3).map(|j| m.col(j)[i] * state[from + j]).sum::<f64>();
        for i in 0..2 {
            let wanted = (contact.force[i] + body.push[i] - row(k, i, 0) - row(c, i, 3)) / body.mass - ground[i];
            assert!((rate[3 + i] - wanted).abs() < 1e-12 * wanted.abs().max(1.0), "{} against {wanted}", rate[3 + i]);
        }
    }
    #[test]
    fn a_state_is_in_line_where_all_else_is_zero() {
        assert!(is_along(&[0.1, 0.0, 0.0, 2.0, 0.0, 0.0], 0), "on the axis");
        assert!((0..WIDTH).filter(|i| i % POSITIONS > 0).all(|i| {
            let mut state = [0.0; WIDTH];
            state[i] = 1e-300;
            !is_along(&state, 0)
        }));
    }
}
