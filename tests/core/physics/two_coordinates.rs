//! A body of other degrees of freedom through the real solver: two coordinates on a spring, between girders in a row.

use std::ops::Range;
use std::sync::Arc;

use crate::support::{scene, within};
use girderbench::contact::Frame;
use girderbench::dynamics::Model;
use girderbench::dynamics::linear::FlightParameters;
use girderbench::dynamics::model::body::{
    Body, BodyCoordinates, BodyEnergies, BodyPowers, Coordinates, Counted, Point,
};
use girderbench::dynamics::model::closed_form::ClosedForm;
use girderbench::dynamics::model::ground_now::GroundNow;
use girderbench::dynamics::model::motion_bounds::MotionBounds;
use girderbench::dynamics::model::reference_pose::ReferencePose;
use girderbench::dynamics::model::wrench::Wrench;
use girderbench::motion::Ground;
use girderbench::scene::{ModelKind, Motion, Scene, presets};
use girderbench::sim::{History, Session};
use glam::{DMat3, DQuat, DVec2, DVec3};

const MASS: f64 = 2.0;
const SPEED: f64 = 0.5;
const GAP: f64 = 0.005;

/// A mass on one spring that is as stiff in every direction; it cannot turn: `x, y, ẋ, ẏ`.
#[derive(Clone, Copy, Debug)]
struct TwoCoordinates {
    /// ω \[rad/s\]; 0 without a spring.
    omega: f64,
    start: [f64; 4],
}

const POSITIONS: Range<usize> = 0..2;
const RATES: Range<usize> = 2..4;

impl TwoCoordinates {
    fn stiffness(&self) -> f64 {
        MASS * self.omega * self.omega
    }

    fn level(body: &Body, place: DVec2) -> ReferencePose {
        ReferencePose::level(place.extend(body.start[2]), 0.0, DMat3::ZERO)
    }
}

impl Coordinates for TwoCoordinates {
    fn width(&self) -> usize {
        4
    }

    fn positions(&self) -> usize {
        POSITIONS.len()
    }

    fn displacements(&self) -> Option<Range<usize>> {
        Some(POSITIONS)
    }

    fn initial(&self, _: &Body) -> Vec<f64> {
        self.start.to_vec()
    }

    fn frame(&self, body: &Body, _: usize, state: &[f64]) -> Frame {
        let [place, velocity] = [POSITIONS, RATES].map(|part| DVec2::from_slice(&state[part]));
        Frame { shift: place.extend(body.start[2]), velocity: velocity.extend(0.0), ..Frame::fixed(body.home) }
    }

    fn frame_since(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        let frame = self.frame(body, section, state);
        Frame { shift: frame.shift.with_z(0.0), ..frame }
    }

    fn attitude(&self, _: &Body, _: &[f64]) -> (f64, DQuat) {
        (0.0, DQuat::IDENTITY)
    }

    fn reference(&self, body: &Body, numbers: &[f64]) -> ReferencePose {
        Self::level(body, numbers.get(POSITIONS).map_or(DVec2::ZERO, DVec2::from_slice))
    }

    fn rebase(&self, body: &Body, state: &mut [f64]) -> ReferencePose {
        let base = Self::level(body, DVec2::from_slice(state));
        state[POSITIONS].fill(0.0);
        base
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        state[POSITIONS].iter_mut().zip(numbers).for_each(|(place, base)| *place += base);
    }

    fn slope(&self, _: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        let place = now.base.planar().truncate() + DVec2::from_slice(now.state);
        let force = contact[0].force.truncate() - self.stiffness() * place;
        out[POSITIONS].copy_from_slice(&now.state[RATES]);
        out[RATES].copy_from_slice(&(force / MASS - ground.acceleration.truncate()).to_array());
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        state[POSITIONS].iter_mut().zip(&slope[RATES]).for_each(|(place, gain)| *place += 0.5 * dt * dt * gain);
    }

    fn size2(&self, _: &Body, difference: &[f64]) -> [f64; 2] {
        [POSITIONS, RATES].map(|part| DVec2::from_slice(&difference[part]).length_squared())
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        if POSITIONS.contains(&i) { place } else { omega * place }
    }

    fn excursion(&self, _: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        way(POSITIONS)
    }

    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let [speed, acceleration] = rates(POSITIONS);
        MotionBounds { speed, acceleration, ..MotionBounds::still(f64::INFINITY) }
    }

    fn acceleration(&self, _: &Body, _: Point<'_>, force: DVec3) -> DVec3 {
        force.with_z(0.0) / MASS
    }

    fn port(&self, _: &Body, _: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let force = force.truncate();
        response[RATES].copy_from_slice(&(force / MASS).to_array());
        load[RATES].copy_from_slice(&force.to_array());
    }

    /// Under a moving ground there is none here: the body is integrated alone.
    fn free_motion(&self, ground: &Ground, _: f64) -> Option<Arc<dyn ClosedForm>> {
        matches!(ground, Ground::Still).then(|| Arc::new(*self) as Arc<dyn ClosedForm>)
    }

    fn fastest(&self, _: &Body) -> f64 {
        self.omega
    }

    fn energies(&self, _: &Body, state: &[f64], _: f64) -> BodyEnergies {
        let [place2, speed2] = [POSITIONS, RATES].map(|part| DVec2::from_slice(&state[part]).length_squared());
        BodyEnergies {
            kinetic: 0.5 * MASS * speed2,
            bearings: 0.5 * self.stiffness() * place2,
            ..BodyEnergies::default()
        }
    }

    fn powers(&self, _: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        BodyPowers {
            ground: -MASS * ground.acceleration.truncate().dot(DVec2::from_slice(&state[RATES])),
            ..BodyPowers::default()
        }
    }
}

impl ClosedForm for TwoCoordinates {
    fn state(&self, flight: FlightParameters<'_>, t: f64, out: &mut [f64]) {
        let FlightParameters { start, numbers: from } = flight;
        let [place, velocity] = [POSITIONS, RATES].map(|part| DVec2::from_slice(&from[part]));
        let (w, tau) = (self.omega, t - start);
        let (s, c) = (w * tau).sin_cos();
        let swung = if w > 0.0 { velocity * (s / w) } else { velocity * tau };
        out[POSITIONS].copy_from_slice(&(place * c + swung).to_array());
        out[RATES].copy_from_slice(&(velocity * c - place * (w * s)).to_array());
    }

    fn bounds(&self, flight: FlightParameters<'_>, t: f64, horizon: f64) -> MotionBounds {
        let mut state = [0.0; 4];
        self.state(flight, t, &mut state);
        let [place, rate] = [POSITIONS, RATES].map(|part| DVec2::from_slice(&state[part]).length());
        let speed = rate.hypot(self.omega * place);
        let reach = if self.omega > 0.0 { speed / self.omega } else { place + speed * horizon };
        MotionBounds { reach, speed, acceleration: self.omega * speed, ..MotionBounds::still(horizon) }
    }
}

/// The paper's girder three times in a row, the first of them under way; `rest` sets the contact's numbers and the motion.
fn row(rest: &str) -> Scene {
    let girder = |(i, name): (u32, &str)| {
        let (x, speed) = (f64::from(i) * (0.19 + GAP), if i == 0 { SPEED } else { 0.0 });
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = {MASS:?}\n\
             position_m = [{x}, 0.0, 0.0]\ninitial = {{ velocity_m_s = [{speed}, 0.0] }}\n"
        )
    };
    let girders: String = (0..).zip(["one", "mass", "two"]).map(girder).collect();
    scene(&format!("name = \"row\"\nduration_s = 0.2\n{girders}{rest}[solver]\ntolerance = 1e-12\n"))
}

fn contact(restitution: f64) -> String {
    format!(
        "[contact]\nstiffness_n_per_m = 1.55e5\nrestitution_normal = {restitution:?}\n\
         restitution_tangential = {restitution:?}\nlaw = \"paper\"\n"
    )
}

/// The scene with the second girder's degrees of freedom replaced.
fn model(scene: &Scene, coordinates: TwoCoordinates) -> Model {
    let mut model = Model::compile(scene).unwrap_or_else(|errors| panic!("{errors}"));
    let body = &mut model.bodies[1];
    assert_eq!(body.mass, MASS, "the pair's law is of the same mass");
    body.coordinates = BodyCoordinates::Custom(Arc::new(coordinates));
    body.rate_bounds.mobility = 1.0 / MASS;
    body.rate_bounds.stiffest = coordinates.omega * coordinates.omega;
    model
}

fn run(scene: &Scene, model: Model) -> History {
    let mut session = Session::of_model(scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());
    history
}

fn velocities(history: &History, t: f64) -> [f64; 3] {
    [0, 1, 2].map(|body| history.motion(body, t).velocity.x)
}

#[test]
fn between_contacts_it_swings_by_its_closed_form() {
    let mut scene = row(&contact(1.0));
    scene.girders[0].initial.velocity[0] = 0.0;
    let (omega, start) = (31.0, [0.002, -0.03, 0.05, 0.4]);
    let history = run(&scene, model(&scene, TwoCoordinates { omega, start }));
    assert_eq!((history.hits().touches().len(), history.effort().steps), (0, 0), "nothing touches, no step is taken");
    for i in 0..=100 {
        let t = scene.duration * f64::from(i) / 100.0;
        let (s, c) = (omega * t).sin_cos();
        let motion = history.motion(1, t);
        let [x, y] = [0, 1].map(|i| start[i] * c + start[2 + i] * s / omega);
        let apart = motion.displacement - DVec3::new(x, y, 0.0);
        within("displacement", apart.length(), 1e-12);
        let [u, v] = [0, 1].map(|i| start[2 + i] * c - start[i] * omega * s);
        within("velocity", (motion.velocity - DVec3::new(u, v, 0.0)).length(), 1e-12);
        assert_eq!((motion.theta, motion.spin), (0.0, DVec3::ZERO), "it does not turn");
    }
}

#[test]
fn a_hit_gives_the_velocities_of_the_coefficient_of_restitution() {
    for e in [1.0, 0.8, 0.6] {
        // The first girder catches up with the mass later.
        let mut scene = row(&contact(e));
        scene.duration = 0.06;
        let history = run(&scene, model(&scene, TwoCoordinates { omega: 0.0, start: [0.0; 4] }));
        // Equal masses: the difference of velocities turns round times e, hit by hit along the row.
        let first = [0.5 * (1.0 - e) * SPEED, 0.5 * (1.0 + e) * SPEED];
        let second = [0.5 * (1.0 - e) * first[1], 0.5 * (1.0 + e) * first[1]];
        let touches = history.hits().touches();
        let between = touches.iter().filter(|touch| touch.pair == 0).map(|touch| touch.end).fold(0.0, f64::max);
        let begins = touches.iter().filter(|touch| touch.pair == 1).map(|touch| touch.start).fold(1.0, f64::min);
        assert!(between < begins, "one hit after the other: {between} s, {begins} s");
        let after = velocities(&history, 0.5 * (between + begins));
        for (name, value, wanted) in [("girder", after[0], first[0]), ("mass", after[1], first[1])] {
            within(&format!("e = {e}: {name} after the first hit"), value / SPEED - wanted / SPEED, 1e-12);
        }
        let ends = touches.iter().filter(|touch| touch.pair == 1).map(|touch| touch.end).fold(0.0, f64::max);
        let after = velocities(&history, ends + 1e-4);
        for (name, value, wanted) in [("mass", after[1], second[0]), ("last girder", after[2], second[1])] {
            within(&format!("e = {e}: {name} after the second hit"), value / SPEED - wanted / SPEED, 1e-12);
        }
        for i in 0..=100 {
            let t = scene.duration * f64::from(i) / 100.0;
            let sum: f64 = velocities(&history, t).iter().sum();
            within("momentum", sum / SPEED - 1.0, 1e-12);
            let books = history.energy().ledger(t);
            within("ledger", books.residual / books.scale, 1e-11);
        }
    }
}

/// Shaken along x and y against friction: island of three bodies, and the mass integrated alone in between.
fn shaken() -> Scene {
    let mut scene = row(&contact(0.6));
    scene.motion = presets::load("row-of-5").unwrap_or_else(|errors| panic!("{errors}")).motion;
    let Motion::Sine(sine) = &mut scene.motion else { panic!("it is shaken by a sine") };
    (sine.amplitude, sine.angle_deg) = (Some(3.0), 20.0);
    (scene.contact.mu_static, scene.contact.mu_kinetic) = (0.3, 0.25);
    scene
}

const SHAKEN: TwoCoordinates = TwoCoordinates { omega: 25.0, start: [0.001, 0.0, 0.0, 0.1] };

#[test]
fn under_a_moving_ground_the_books_balance() {
    let scene = shaken();
    let history = run(&scene, model(&scene, SHAKEN));
    assert!(history.summary().hits > 2, "they touch: {:?}", history.summary());
    assert!(history.motion(0, scene.duration).theta.abs() > 0.0, "friction turns a girder");
    for i in 0..=20 {
        let t = scene.duration * f64::from(i) / 20.0;
        let books = history.energy().ledger(t);
        within("ledger", books.residual / books.scale, 1e-10);
    }
}

#[test]
fn its_steps_can_be_taken_again_to_the_last_bit() {
    let scene = shaken();
    let digest = |polynomial_bytes: usize| {
        let model = Model { polynomial_bytes, ..model(&scene, SHAKEN) };
        let history = run(&scene, model);
        (history.digest(), history.bytes())
    };
    let (whole, none) = (digest(usize::MAX), digest(0));
    assert_eq!(whole.0, none.0, "the same answer");
    assert!(none.1 < whole.1, "kept in {} bytes against {}", none.1, whole.1);
}

#[test]
fn the_impact_model_refuses_it() {
    let mut scene = row(&contact(1.0));
    scene.model.kind = ModelKind::Impact;
    let mut session = Session::of_model(&scene, model(&scene, SHAKEN));
    session.advance(scene.duration, &mut |_| true);
    let stop = session.finish().stop().map(|stop| stop.reason.to_string()).unwrap_or_default();
    assert!(stop.contains("rigid girders"), "{stop}");
}
