//! Bodies of the second formulation: where their points are, what their bearings do, how forces move them.

use glam::{DMat3, DVec3};

use crate::dynamics::connection::Link;
use crate::dynamics::{Body, Model};
use crate::scene::Kind;
use crate::study::accuracy::answer::Place;

/// Pose and twist: displacement of G, attitude, velocity, angular velocity.
#[derive(Clone, Copy)]
pub(super) struct Pose {
    pub(super) home: DVec3,
    pub(super) shift: DVec3,
    pub(super) attitude: DMat3,
    pub(super) velocity: DVec3,
    pub(super) spin: DVec3,
}

impl Pose {
    /// A body at rest.
    pub(super) fn fixed(home: DVec3) -> Self {
        Self { home, shift: DVec3::ZERO, attitude: DMat3::IDENTITY, velocity: DVec3::ZERO, spin: DVec3::ZERO }
    }

    /// Velocity of what is at `arm` from G and turns with the body.
    pub(super) fn velocity_at(&self, arm: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(arm)
    }
}

/// Force at G and moment about it.
#[derive(Clone, Copy, Default)]
pub(super) struct Load {
    pub(super) force: DVec3,
    pub(super) moment: DVec3,
}

impl Load {
    pub(super) fn add(&mut self, force: DVec3, arm: DVec3) {
        self.force += force;
        self.moment += arm.cross(force);
    }
}

/// Numbers of a body in the vector: x, y, θ and rates; or displacement, attitude by columns, velocity, spin.
pub(super) fn size(kind: Kind) -> usize {
    match kind {
        Kind::Planar => 6,
        Kind::Spatial => 18,
    }
}

fn vector(part: &[f64]) -> DVec3 {
    DVec3::new(part[0], part[1], part[2])
}

/// State at the start.
pub(super) fn start(kind: Kind, body: &Body) -> Vec<f64> {
    let ([x, y, z, roll, pitch, turn], [vx, vy, .., spin]) = (body.start, body.start_rate);
    match kind {
        Kind::Planar => vec![x, y, turn, vx, vy, spin],
        Kind::Spatial => {
            let tilt = DMat3::from_rotation_y(pitch) * DMat3::from_rotation_x(roll);
            let attitude = DMat3::from_rotation_z(turn) * body.axes * tilt;
            let mut state = vec![x, y, z];
            state.extend(attitude.to_cols_array());
            state.extend(body.start_rate);
            state
        }
    }
}

/// Pose and twist in a state.
pub(super) fn pose(kind: Kind, body: &Body, state: &[f64]) -> Pose {
    match kind {
        Kind::Planar => Pose {
            home: body.home,
            shift: DVec3::new(state[0], state[1], body.start[2]),
            attitude: DMat3::from_rotation_z(state[2]) * body.axes,
            velocity: DVec3::new(state[3], state[4], 0.0),
            spin: DVec3::Z * state[5],
        },
        Kind::Spatial => Pose {
            home: body.home,
            shift: vector(state),
            attitude: DMat3::from_cols(vector(&state[3..]), vector(&state[6..]), vector(&state[9..])),
            velocity: vector(&state[12..]),
            spin: vector(&state[15..]),
        },
    }
}

/// Displacement and rotation.
pub(super) fn place(kind: Kind, body: &Body, state: &[f64]) -> Place {
    match kind {
        Kind::Planar => [state[0], state[1], body.start[2], state[2]],
        Kind::Spatial => {
            let axis = pose(kind, body, state).attitude * (body.axes.transpose() * DVec3::X);
            [state[0], state[1], state[2], axis.y.atan2(axis.x)]
        }
    }
}

/// Makes the attitude's columns orthonormal again, to first order in what they are off.
pub(super) fn tidy(kind: Kind, state: &mut [f64]) {
    if kind == Kind::Spatial {
        let r = pose_columns(state);
        let better = r * (DMat3::IDENTITY * 1.5 - (r.transpose() * r) * 0.5);
        state[3..12].copy_from_slice(&better.to_cols_array());
    }
}

fn pose_columns(state: &[f64]) -> DMat3 {
    DMat3::from_cols(vector(&state[3..]), vector(&state[6..]), vector(&state[9..]))
}

/// Rate of a state under a load from contacts.
pub(super) fn rate(model: &Model, body: &Body, state: &[f64], load: &Load, ground: DVec3, out: &mut [f64]) {
    let here = pose(model.kind, body, state);
    let mut load = *load;
    load.force += body.push - body.mass * (ground + DVec3::Z * model.gravity);
    load.moment += body.moment;
    match model.kind {
        Kind::Planar => planar(body, state, load, out),
        Kind::Spatial => spatial(body, &here, load, out),
    }
}

/// Force of a linear bearing between two bodies in plan on the first, and the levers of both as placed: linear in the rotations.
pub(super) fn between(link: &Link, ends: [&[f64]; 2]) -> Option<(DVec3, [DVec3; 2])> {
    let [stiffness, damping] = link.device.linear()?;
    let point = |state: &[f64], lever: DVec3| {
        [0, 3].map(|i| {
            let [x, y, turn] = [state[i], state[i + 1], state[i + 2]];
            DVec3::new(x - lever.y * turn, y + lever.x * turn, 0.0)
        })
    };
    let [[a, va], [b, vb]] = [0, 1].map(|end| point(ends[end], link.arms[end]));
    let local = |v: DVec3| link.axes.transpose() * v;
    let mut force = link.axes * -(stiffness * local(a - b) + damping * local(va - vb));
    force.z = 0.0;
    Some((force, link.arms))
}

/// (1): each leg is a Voigt element at its lever as placed, small rotation.
fn planar(body: &Body, state: &[f64], mut load: Load, out: &mut [f64]) {
    for leg in &body.bearings {
        let lever = body.axes * leg.place;
        let moved = DVec3::new(state[0] - lever.y * state[2], state[1] + lever.x * state[2], 0.0);
        let speed = DVec3::new(state[3] - lever.y * state[5], state[4] + lever.x * state[5], 0.0);
        let local = leg.stiffness * (body.axes.transpose() * moved) + leg.damping * (body.axes.transpose() * speed);
        let mut force = body.axes * -local;
        force.z = 0.0;
        load.force += force;
        load.moment.z += lever.x * force.y - lever.y * force.x;
    }
    let inertia = body.mass * body.gyration2;
    let rates = [load.force.x / body.mass, load.force.y / body.mass, load.moment.z / inertia];
    for (i, free) in [body.free[0], body.free[1], body.free[5]].into_iter().enumerate() {
        out[i] = if free { state[3 + i] } else { 0.0 };
        out[3 + i] = if free { rates[i] } else { 0.0 };
    }
}

/// Bearings at their true attachment points, axes fixed in the ground; Euler's equations in world axes.
fn spatial(body: &Body, here: &Pose, mut load: Load, out: &mut [f64]) {
    for leg in &body.bearings {
        let arm = here.attitude * leg.place;
        let moved = here.shift + (arm - body.axes * leg.place);
        let speed = here.velocity_at(arm);
        let local = leg.stiffness * (body.axes.transpose() * moved) + leg.damping * (body.axes.transpose() * speed);
        load.add(leg.preload - body.axes * local, arm);
    }
    let inertia = here.attitude * (body.prism.inertia_per_mass() * body.mass) * here.attitude.transpose();
    let turning = inertia.inverse() * (load.moment - here.spin.cross(inertia * here.spin));
    let acceleration = load.force / body.mass;
    let columns = here.attitude.to_cols_array();
    for i in 0..3 {
        out[i] = if body.free[i] { here.velocity[i] } else { 0.0 };
        out[12 + i] = if body.free[i] { acceleration[i] } else { 0.0 };
        out[15 + i] = if body.free[3 + i] { turning[i] } else { 0.0 };
        let column = here.spin.cross(vector(&columns[3 * i..]));
        out[3 + 3 * i..6 + 3 * i].copy_from_slice(&column.to_array());
    }
}
