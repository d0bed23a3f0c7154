//! Closed-form flight against integration and against its own bounds.

use glam::{DMat3, DVec3};

use crate::dynamics::Body;
use crate::dynamics::Model;
use crate::dynamics::free_flight::flight::{FreeMotion, StateInFlight};
use crate::dynamics::free_flight::oscillator::{Oscillator, Phasor};
use crate::dynamics::free_flight::relative_bounds::{BodyInFlight, GirderInFlight, RelativeBounds};
use crate::dynamics::free_flight::sliding_face::SlidingFace;
use crate::dynamics::free_flight::uncoupled_axis::{SampleStep, UncoupledAxis};
use crate::dynamics::integrator::dop853::{Dop853, next_factor};
use crate::dynamics::integrator::system::System;
use crate::dynamics::model::coordinates::planar::{self, PlanarState};
use crate::dynamics::model::wrench::Wrench;
use crate::motion::Ground;
use crate::scene::presets;

const START: PlanarState = [0.012, -0.02, 0.03, 0.1, 0.15, -0.2];

/// A planar girder of unit mass with this stiffness and damping per mass (per `m i²` for θ).
fn girder(stiffness: DMat3, damping: DMat3) -> Body {
    let model = Model::compile(&presets::load("straight-abutment").expect("a preset")).expect("a scene");
    let mut body = model.bodies[0].clone();
    let inertia = DMat3::from_diagonal(DVec3::new(body.mass, body.mass, body.mass * body.gyration2));
    body.free = [true, true, false, false, false, true];
    (body.planar.stiffness, body.planar.damping) = (inertia * stiffness, inertia * damping);
    (body.push, body.moment) = (DVec3::ZERO, DVec3::ZERO);
    body
}

fn diagonal(omega2: f64, twice_gamma: f64) -> Body {
    let of = |x: f64| DMat3::from_diagonal(DVec3::new(x, 0.8 * x, 1.3 * x));
    girder(of(omega2), of(twice_gamma))
}

/// Stiffness and dashpots that couple x, y and θ, symmetric with respect to the inertia.
fn eccentric() -> Body {
    let mut body = diagonal(40.0, 0.9);
    let couple = |m: &mut DMat3, part: f64| {
        let size = part * m.x_axis.x * body.gyration2.sqrt();
        (m.z_axis.x, m.x_axis.z) = (size, size);
        (m.z_axis.y, m.y_axis.z) = (-0.5 * size, -0.5 * size);
    };
    couple(&mut body.planar.stiffness, 0.2);
    couple(&mut body.planar.damping, 0.1);
    body
}

fn grounds() -> [Ground; 4] {
    let amplitude = DVec3::new(2.0, 1.0, 0.0);
    // Back at 0 where it ends: the ground then stands still.
    let samples = [0.0, 1.5, -2.0, 0.7, 3.0, -1.0, 0.4, 0.0, -0.8, 2.2, 0.3, 0.0];
    [
        Ground::Still,
        Ground::Sine { amplitude, quadrature: DVec3::ZERO, omega: 9.0, phase: 0.4 },
        Ground::record(Ground::direction(30.0), 0.11, samples),
        // The components differ in time, not in size alone.
        Ground::components(0.11, (0..12).map(|n| DVec3::new(samples[n], 0.7 * samples[11 - n], 0.0)), []),
    ]
}

struct Equation<'a> {
    body: &'a Body,
    ground: &'a Ground,
}

impl System for Equation<'_> {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        planar::slope(self.body, y, &Wrench::default(), self.ground.acceleration(t), out);
    }

    fn size2(&self, d: &[f64]) -> f64 {
        d.iter().map(|x| (x / 1e-13).powi(2)).sum()
    }
}

fn integrated(body: &Body, ground: &Ground, until: f64) -> Vec<f64> {
    let (mut rk, mut y, mut t, mut h) = (Dop853::default(), START.to_vec(), 0.0, 1e-3);
    let mut equation = Equation { body, ground };
    rk.resize(6);
    while t < until {
        let end = until.min(ground.next_kink(t));
        rk.start(&mut equation, t, &y);
        let step = f64::min(h, end - t);
        let error = rk.attempt(&mut equation, t, &y, step);
        if error <= 1.0 {
            rk.accept(&mut equation, t, &mut y, step);
            t = if step == end - t { end } else { t + step };
        }
        h = step.max(1e-6) * next_factor(error);
    }
    y
}

#[test]
fn closed_forms_of_all_damping_cases_agree_with_integration() {
    let cases = [
        ("no bearings", diagonal(0.0, 0.0)),
        ("dashpots alone", diagonal(0.0, 1.0)),
        ("undamped", diagonal(50.0, 0.0)),
        ("underdamped", diagonal(50.0, 1.4)),
        ("critical along x", diagonal(50.0, 2.0 * 50f64.sqrt())),
        ("overdamped", diagonal(50.0, 40.0)),
        ("eccentric", eccentric()),
    ];
    for (name, body) in cases {
        for ground in grounds() {
            let motion = FreeMotion::new(&body, &ground, 2.0);
            let flight = motion.fly(0.0, START);
            let (closed, stepped) = (motion.state(&flight, 1.3), integrated(&body, &ground, 1.3));
            for (i, (a, b)) in closed.iter().zip(&stepped).enumerate() {
                assert!((a - b).abs() < 1e-10 * (1.0 + b.abs()), "{name}, {ground:?}: component {i}, {a} against {b}");
            }
        }
    }
}

#[test]
fn a_flight_stays_within_its_bounds() {
    for body in [diagonal(0.0, 0.0), diagonal(50.0, 0.0), diagonal(50.0, 1.4), diagonal(50.0, 40.0), eccentric()] {
        for ground in grounds() {
            let motion = FreeMotion::new(&body, &ground, 2.0);
            let flight = motion.fly(0.0, START);
            let (_, bounds) = motion.state_and_bounds(&flight, 0.05, 0.9);
            let h = 1e-5;
            for k in 0..200 {
                let t = 0.05 + (bounds.window - h) * f64::from(k) / 200.0;
                let ([x, y, turn, vx, vy, spin], next) = (motion.state(&flight, t), motion.state(&flight, t + h));
                let [ax, ay, bend] = [next[3] - vx, next[4] - vy, next[5] - spin].map(|d| d / h);
                let seen = [x.hypot(y), turn.abs(), vx.hypot(vy), spin.abs(), ax.hypot(ay), bend.abs()];
                let most =
                    [bounds.reach, bounds.turn, bounds.speed, bounds.spin, bounds.acceleration, bounds.spin_rate];
                for (seen, most) in seen.into_iter().zip(most) {
                    assert!(seen <= most * (1.0 + 1e-9) + 1e-9, "at {t} under {ground:?}: {seen} above {most}");
                }
            }
        }
    }
}

#[test]
fn two_girders_stay_within_their_relative_bounds() {
    let ground = Ground::Sine { amplitude: DVec3::new(2.0, 1.0, 0.0), quadrature: DVec3::ZERO, omega: 9.0, phase: 0.4 };
    let bodies = [diagonal(50.0, 1.4), diagonal(31.0, 0.8)];
    let motions = [&bodies[0], &bodies[1]].map(|body| FreeMotion::new(body, &ground, 2.0));
    let other = [-0.01, 0.005, 0.0, -0.05, 0.2, 0.1];
    let flights = [motions[0].fly(0.0, START), motions[1].fly(0.0, other)];
    let flyer = |i: usize| {
        let StateInFlight { state, free } = motions[i].parts(&flights[i], 0.0);
        let bound = motions[i].bound_from(0.0, &state, free.as_ref(), 1.0);
        Some(BodyInFlight { bound, girder: Some(GirderInFlight { free_motion: &motions[i], state, free }) })
    };
    let bounds = RelativeBounds::of(&[flyer(0), flyer(1)], 1.0);
    for k in 0..=500 {
        let t = bounds.window * f64::from(k) / 500.0;
        let [p, q] = [0, 1].map(|i| motions[i].state(&flights[i], t));
        let (apart, speed) = ((p[0] - q[0]).hypot(p[1] - q[1]), (p[3] - q[3]).hypot(p[4] - q[4]));
        assert!(apart <= bounds.reach && speed <= bounds.speed, "at {t}: {apart}, {speed} against {bounds:?}");
    }
}

#[test]
fn one_sample_of_a_record_is_crossed_by_factors_as_by_the_closed_form() {
    let oscillator = Oscillator { gamma: 0.4, omega2: 60.0 };
    let axis = |free: bool| UncoupledAxis { oscillator, free, steady: Phasor::default(), amplitude: 0.0 };
    let (step, force) = (SampleStep::of(&oscillator, 0.02), [1.3, -7.0]);
    let (short, long) = (axis(true).step(&step, [0.1, -0.3], force), axis(true).advance([0.1, -0.3], force, 0.02));
    assert!((short[0] - long[0]).abs() < 1e-16 && (short[1] - long[1]).abs() < 1e-15, "{short:?} against {long:?}");
    assert_eq!(axis(false).step(&step, [0.1, -0.3], force), [0.1, -0.3], "a held axis stays");
}

#[test]
fn a_steady_response_solves_the_driven_equation() {
    let oscillator = Oscillator { gamma: 0.7, omega2: 30.0 };
    let drive = 4.0;
    let steady = oscillator.gain(drive, 10.0).expect("off resonance");
    let axis = UncoupledAxis { oscillator, free: true, steady, amplitude: steady.re.hypot(steady.im) };
    let at = |t: f64| axis.steady((drive * t).sin_cos().into(), drive);
    let [q, v] = at(0.6);
    let acceleration = (at(0.6 + 1e-5)[1] - at(0.6 - 1e-5)[1]) / 2e-5;
    let left = acceleration + 2.0 * oscillator.gamma * v + oscillator.omega2 * q - (drive * 0.6).sin();
    assert!(left.abs() < 1e-8, "residual {left}");
}

#[test]
fn a_face_slides_by_the_forces_felt_along_its_direction() {
    let body = diagonal(50.0, 1.4);
    let ground = Ground::Sine { amplitude: DVec3::new(2.0, 1.0, 0.0), quadrature: DVec3::ZERO, omega: 9.0, phase: 0.4 };
    let s = glam::DVec2::new(0.6, 0.8);
    for mu_k in [0.0, 0.3, 3.0] {
        let d = s + s.perp() * -mu_k;
        let state = [0.01, -0.02, 0.0, 0.3 * s.x, 0.3 * s.y, 0.0];
        let slide = SlidingFace::new((&body, &ground), [s, d], &ground.piece(0), (0.2, &state), 1.0);
        let (t, h) = (0.55, 1e-5);
        let [before, here, after] = [t - h, t, t + h].map(|t| slide.state(t));
        let along = |z: &PlanarState| s.dot(glam::DVec2::new(z[3], z[4]));
        let q = DVec3::new(here[0], here[1], 0.0);
        let v = DVec3::new(here[3], here[4], 0.0);
        let force = -(body.planar.stiffness * q + body.planar.damping * v) / body.mass - ground.acceleration(t);
        let (seen, wanted) = ((along(&after) - along(&before)) / (2.0 * h), d.dot(force.truncate()));
        assert!((seen - wanted).abs() < 1e-6 * (1.0 + wanted.abs()), "μ_k = {mu_k}: ü = {seen} against {wanted}");
        let across = glam::DVec2::new(here[0] - state[0], here[1] - state[1]).perp_dot(s);
        assert!(across.abs() < 1e-15, "it stays on the wall: {across}");
    }
}
