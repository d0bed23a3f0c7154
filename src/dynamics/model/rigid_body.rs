//! How a body stands in an integrator's vector, and what moves it.
//!
//! Planar: `x, y, θ, ẋ, ẏ, θ̇`. Spatial: displacement (3), what the body has turned since it was placed as a quaternion x, y,
//! z, w (world axes), velocity (3), angular velocity in the world (3).

use glam::{DMat2, DMat3, DQuat, DVec2, DVec3};

use crate::contact::{Frame, turned_by};
use crate::dynamics::model::body::Body;
use crate::scene::Kind;

/// Components of a planar body.
pub const PLANAR: usize = 6;
/// Components of a spatial body.
pub const SPATIAL: usize = 13;

/// Components of a body in a scene of this kind.
pub fn width(kind: Kind) -> usize {
    match kind {
        Kind::Planar => PLANAR,
        Kind::Spatial => SPATIAL,
    }
}

/// Where place and attitude of a body stand in the vector.
pub fn parts(kind: Kind, index: usize) -> [std::ops::Range<usize>; 2] {
    let (from, [place, turn]) = (index * width(kind), if kind == Kind::Planar { [2, 3] } else { [3, 7] });
    [from..from + place, from + place..from + turn]
}

/// State at the start of a run.
pub fn initial(kind: Kind, body: &Body) -> Vec<f64> {
    let ([x, y, z, turn], [vx, vy, vz, spin]) = (body.start, body.start_rate);
    match kind {
        Kind::Planar => vec![x, y, turn, vx, vy, spin],
        Kind::Spatial => {
            let q = DQuat::from_rotation_z(turn);
            vec![x, y, z, q.x, q.y, q.z, q.w, vx, vy, vz, 0.0, 0.0, spin]
        }
    }
}

/// What a body has turned since it was placed, in a spatial state.
pub fn turn(state: &[f64]) -> DQuat {
    let q = DQuat::from_xyzw(state[3], state[4], state[5], state[6]);
    // Kept near 1 by every accepted step; never 0.
    q * (1.0 / q.length())
}

/// Pose and twist of a body.
#[inline]
pub fn frame(kind: Kind, body: &Body, state: &[f64]) -> Frame {
    match kind {
        Kind::Planar => body.planar_frame(state),
        Kind::Spatial => Frame {
            home: body.home,
            shift: DVec3::new(state[0], state[1], state[2]),
            turned: turned_by(turn(state)),
            velocity: DVec3::new(state[7], state[8], state[9]),
            spin: DVec3::new(state[10], state[11], state[12]),
            level: false,
        },
    }
}

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
}

/// Rate of a planar body's state under bearings, push, ground and contact (1).
#[inline]
pub fn planar_slope(body: &Body, state: &[f64], contact: &Wrench, ground: DVec3, out: &mut [f64]) {
    planar_slope_from(body, DVec3::ZERO, state, contact, ground, out);
}

/// The same of a state counted from `x, y, θ`.
#[inline]
pub(in crate::dynamics) fn planar_slope_from(
    body: &Body,
    base: DVec3,
    state: &[f64],
    contact: &Wrench,
    ground: DVec3,
    out: &mut [f64],
) {
    let q = base + DVec3::new(state[0], state[1], state[2]);
    let v = DVec3::new(state[3], state[4], state[5]);
    let bearings = body.planar.stiffness * q + body.planar.damping * v;
    let force =
        DVec3::new(contact.force.x + body.push.x, contact.force.y + body.push.y, contact.moment.z + body.moment);
    let total = force - bearings;
    let rates =
        [total.x / body.mass - ground.x, total.y / body.mass - ground.y, total.z / (body.mass * body.gyration2)];
    for (i, free) in [body.free[0], body.free[1], body.free[5]].into_iter().enumerate() {
        out[i] = if free { state[3 + i] } else { 0.0 };
        out[3 + i] = if free { rates[i] } else { 0.0 };
    }
}

/// Rate of a spatial body's state, whose pose since it was placed is `here`, from wherever the state is counted: bearings
/// at their true attachment points, what they leave of the weight, Euler's equations.
pub fn spatial_slope(body: &Body, here: &Frame, state: &[f64], contact: &Wrench, ground: DVec3, out: &mut [f64]) {
    let mut wrench = on_bearings(body, here);
    wrench.force += contact.force + body.push + DVec3::Z * body.standing.left;
    wrench.moment += contact.moment + first_moment(body, here).cross(DVec3::Z);
    wrench.moment.z += body.moment;
    let acceleration = wrench.force / body.mass - ground;
    let spin_rate = spin_rate(body, here, wrench.moment);
    for i in 0..3 {
        out[i] = if body.free[i] { state[7 + i] } else { 0.0 };
        out[7 + i] = if body.free[i] { acceleration[i] } else { 0.0 };
        out[10 + i] = spin_rate[i];
    }
    let w = here.spin;
    let q = turn(state);
    // q̇ = ½ ω q, ω in the world.
    let rate = DQuat::from_xyzw(w.x, w.y, w.z, 0.0) * q * 0.5;
    out[3..7].copy_from_slice(&[rate.x, rate.y, rate.z, rate.w]);
}

/// `Σ f l` of the preloads where the body is now, in the world: across the upward vertical it is their moment \[N·m\].
fn first_moment(body: &Body, here: &Frame) -> DVec3 {
    let placed = body.axes * body.standing.first_moment;
    placed + here.turned * placed
}

/// What the bearings do to a body together beyond what they do at rest: those parts of the forces of [`bearing_forces`],
/// summed in their axes.
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
        let (moved, speed) = (shift + swung, velocity + spin.cross(arm));
        sum.push(-b.stiffness * moved - b.damping * speed, arm);
    }
    sum
}

/// Arm from G and force of every bearing: `preload − K (p − p0) − C ṗ`.
pub fn bearing_forces<'a>(body: &'a Body, here: &'a Frame) -> impl Iterator<Item = (DVec3, DVec3)> + 'a {
    let into_axes = body.axes.transpose();
    body.bearings.iter().map(move |b| {
        let placed = body.axes * b.place;
        let swung = here.turned * placed;
        let arm = placed + swung;
        let moved = into_axes * (here.shift + swung);
        let speed = into_axes * here.velocity_at(arm);
        (arm, b.preload + body.axes * (-b.stiffness * moved - b.damping * speed))
    })
}

/// Turns a spatial state's attitude on by what its spin gains in `dt`, where `slope` is the rate of the state.
pub fn turn_on(state: &mut [f64], slope: &[f64], dt: f64) {
    let q = DQuat::from_xyzw(state[3], state[4], state[5], state[6]);
    let more = DQuat::from_xyzw(slope[10], slope[11], slope[12], 0.0) * q * (0.25 * dt * dt);
    for (component, more) in state[3..7].iter_mut().zip([more.x, more.y, more.z, more.w]) {
        *component += more;
    }
}

/// Acceleration along two axes of the point at `arm` from G per force along them there \[1/kg\].
pub fn mobility(body: &Body, rotation: &DMat3, arm: DVec3, axes: [DVec3; 2]) -> DMat2 {
    let along = |force: DVec3| {
        let free = |i: usize| if body.free[i] { force[i] / body.mass } else { 0.0 };
        let turned = free_inverse(body, rotation, arm.cross(force)).cross(arm);
        let acceleration = DVec3::new(free(0), free(1), free(2)) + turned;
        DVec2::new(acceleration.dot(axes[0]), acceleration.dot(axes[1]))
    };
    DMat2::from_cols(along(axes[0]), along(axes[1]))
}

/// Acceleration and rate of spin of a body per unit of a force that acts at `arm` from G, along `force`.
pub fn response(body: &Body, rotation: &DMat3, force: DVec3, arm: DVec3) -> (DVec3, DVec3) {
    let free = DVec3::from_array(std::array::from_fn(|i| f64::from(u8::from(body.free[i]))));
    (force * free / body.mass, free_inverse(body, rotation, arm.cross(force)))
}

/// `I ω̇ = M − ω × I ω`, solved in the directions that the body is free to turn in.
fn spin_rate(body: &Body, here: &Frame, moment: DVec3) -> DVec3 {
    let [inertia, inverse] = &body.inertia;
    if body.free[3..] == [true; 3] {
        // In the body frame, where the inertia stands still.
        let rotation = here.rotation(&body.axes);
        let into_body = rotation.transpose();
        let spin = into_body * here.spin;
        return rotation * (*inverse * (into_body * moment - spin.cross(*inertia * spin)));
    }
    let rotation = here.rotation(&body.axes);
    let inertia = world_inertia(body, &rotation);
    free_inverse(body, &rotation, moment - here.spin.cross(inertia * here.spin))
}

/// `I⁻¹ M` in the directions that the body is free to turn in.
fn free_inverse(body: &Body, rotation: &DMat3, moment: DVec3) -> DVec3 {
    let mut matrix = world_inertia(body, rotation);
    let mut right = moment;
    // A held direction becomes an equation of its own: its rate is 0.
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

/// Inertia about G in world axes \[kg·m²\].
pub fn world_inertia(body: &Body, rotation: &DMat3) -> DMat3 {
    *rotation * body.inertia[0] * rotation.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::model::bearing::Standing;
    use crate::scene::presets;

    /// A deck of three different inertias that nothing acts on.
    fn free_top() -> Body {
        let model = Model::compile(&presets::load("deck-30m").expect("a preset")).expect("a scene");
        let mut body = model.bodies[0].clone();
        body.bearings.clear();
        (body.standing, body.push, body.moment) = (Standing::default(), DVec3::ZERO, 0.0);
        body.free = [true; 6];
        body
    }

    #[test]
    fn a_free_top_keeps_energy_momentum_and_the_length_of_its_quaternion() {
        let body = free_top();
        let q = DQuat::from_scaled_axis(DVec3::new(0.3, -0.8, 0.5));
        let state = [1.0, 2.0, 3.0, q.x, q.y, q.z, q.w, 0.4, -0.1, 0.2, 0.7, -1.1, 0.4];
        let mut rate = [0.0; SPATIAL];
        let here = frame(Kind::Spatial, &body, &state);
        spatial_slope(&body, &here, &state, &Wrench::default(), DVec3::ZERO, &mut rate);
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
    fn a_response_is_what_the_slope_gives_per_force_and_its_point_moves_by_the_mobility() {
        let body = free_top();
        let mut state = [0.0; SPATIAL];
        state[6] = 1.0;
        let (force, arm) = (DVec3::new(3.0, -1.0, 2.0), DVec3::new(4.0, 1.0, -0.5));
        let (mut wrench, mut rate) = (Wrench::default(), [0.0; SPATIAL]);
        wrench.push(force, arm);
        let here = frame(Kind::Spatial, &body, &state);
        spatial_slope(&body, &here, &state, &wrench, DVec3::ZERO, &mut rate);
        let (linear, turning) = response(&body, &body.axes, force, arm);
        assert!((linear - DVec3::from_slice(&rate[7..])).length() < 1e-15 * force.length(), "linear");
        assert!((turning - DVec3::from_slice(&rate[10..])).length() < 1e-14 * turning.length(), "angular");
        let there = linear + turning.cross(arm);
        let axes = [DVec3::X, DVec3::Y];
        let m = mobility(&body, &body.axes, arm, axes);
        let third = response(&body, &body.axes, DVec3::Z * force.z, arm);
        let rest = third.0 + third.1.cross(arm);
        let seen = m * DVec2::new(force.x, force.y) + DVec2::new(rest.x, rest.y);
        assert!((seen - there.truncate()).length() < 1e-14 * there.length(), "{seen} against {there}");
    }

    #[test]
    fn a_planar_slope_is_newtons_law_in_the_free_directions() {
        let model = Model::compile(&presets::load("skew45-abutment").expect("a preset")).expect("a scene");
        let mut body = model.bodies[0].clone();
        let state = [0.01, -0.02, 0.03, 0.4, 0.5, -0.6];
        let contact = Wrench { force: DVec3::new(7.0, -3.0, 0.0), moment: DVec3::Z * 0.2 };
        let ground = DVec3::new(1.5, -0.5, 0.0);
        let mut rate = [0.0; PLANAR];
        body.free[5] = false;
        planar_slope(&body, &state, &contact, ground, &mut rate);
        assert_eq!([rate[0], rate[1]], [0.4, 0.5], "velocities");
        assert_eq!([rate[2], rate[5]], [0.0; 2], "a held direction stands still");
        let (k, c) = (&body.planar.stiffness, &body.planar.damping);
        let row = |m: &DMat3, i: usize, from: usize| (0..3).map(|j| m.col(j)[i] * state[from + j]).sum::<f64>();
        for i in 0..2 {
            let wanted = (contact.force[i] + body.push[i] - row(k, i, 0) - row(c, i, 3)) / body.mass - ground[i];
            assert!((rate[3 + i] - wanted).abs() < 1e-12 * wanted.abs().max(1.0), "{} against {wanted}", rate[3 + i]);
        }
    }
}
