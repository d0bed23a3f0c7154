//! Free motion against closed forms written out here, and against an integrator that knows no closed form.

use crate::support::{run, scene, within};
use girderbench::dynamics::Model;
use girderbench::dynamics::integrator::dop853::Dop853;
use girderbench::dynamics::integrator::system::System;
use girderbench::dynamics::model::coordinates::planar;
use girderbench::dynamics::model::wrench::Wrench;
use girderbench::scene::Scene;

fn girder(bearings: &str, rest: &str) -> Scene {
    scene(&format!(
        r#"
        name = "free"
        duration_s = 6.0
        [[girder]]
        name = "deck"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        mass_kg = 2.0
        bearings = {bearings}
        {rest}
        "#
    ))
}

const LEGS: &str = "at_m = [[0.07, 0.025], [0.07, -0.025], [-0.07, 0.025], [-0.07, -0.025]]";

#[test]
fn free_decay_is_the_textbook_oscillator() {
    let history = run(&girder(
        &format!("{{ frequency_hz = 2.4, damping_ratio = 0.29, {LEGS} }}"),
        "initial = { displacement_m = [0.01, 0.0], velocity_m_s = [0.0, 0.2] }",
    ));
    let (w, h): (f64, f64) = (std::f64::consts::TAU * 2.4, 0.29);
    let (wd, mut worst) = (w * (1.0 - h * h).sqrt(), 0.0f64);
    for i in 0..600 {
        let t = f64::from(i) * 0.01;
        let e = (-h * w * t).exp();
        let x = 0.01 * e * ((wd * t).cos() + h * w / wd * (wd * t).sin());
        let y = 0.2 * e * (wd * t).sin() / wd;
        let got = history.motion(0, t).displacement;
        worst = worst.max((got.x - x).abs().max((got.y - y).abs()) / 0.01);
    }
    within("free decay, of the largest displacement", worst, 1e-13);
    assert!(history.events().is_empty(), "nothing to touch");
}

#[test]
fn the_response_to_a_sine_is_steady_plus_transient() {
    let history = run(&girder(
        &format!("{{ frequency_hz = 2.6, damping_ratio = 0.28, {LEGS} }}"),
        "[motion]\nkind = \"sine\"\namplitude_m_s2 = 3.924\nfrequency_hz = 2.4\nphase_deg = 30.0",
    ));
    let tau = std::f64::consts::TAU;
    let (w, h, drive, phase): (f64, f64, f64, f64) = (tau * 2.6, 0.28, tau * 2.4, 30f64.to_radians());
    // Steady amplitude and lag of x'' + 2hw x' + w² x = −A sin(Ωt + φ), and the decay that starts it from rest.
    let (re, im) = (w * w - drive * drive, 2.0 * h * w * drive);
    let (amplitude, lag) = (-3.924 / re.hypot(im), im.atan2(re));
    let steady = |t: f64| amplitude * (drive * t + phase - lag).sin();
    let steady_rate = |t: f64| amplitude * drive * (drive * t + phase - lag).cos();
    let (wd, q0, v0) = (w * (1.0 - h * h).sqrt(), -steady(0.0), -steady_rate(0.0));
    let mut worst = 0.0f64;
    for i in 0..600 {
        let t = f64::from(i) * 0.01;
        let e = (-h * w * t).exp();
        let decay = e * (q0 * (wd * t).cos() + (v0 + h * w * q0) / wd * (wd * t).sin());
        worst = worst.max((history.motion(0, t).displacement.x - steady(t) - decay).abs() / amplitude.abs());
    }
    within("harmonic response, of the steady amplitude", worst, 1e-13);
}

/// (1) as it stands, for an integrator.
struct Equation(Model);

impl System for Equation {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        planar::slope(&self.0.bodies[0], y, &Wrench::default(), self.0.ground.acceleration(t), out);
    }

    fn size2(&self, d: &[f64]) -> f64 {
        d.iter().map(|x| x * x).sum()
    }
}

/// Largest difference between the closed form and small Runge–Kutta steps from kink to kink, in parts of the largest.
fn against_steps(scene: &Scene) -> f64 {
    let history = run(scene);
    let mut equation = Equation(Model::compile(scene).expect("valid"));
    let (mut rk, mut y, mut t) = (Dop853::default(), vec![0.0; 6], 0.0);
    let start = history.motion(0, 0.0);
    y.copy_from_slice(&[
        start.displacement.x,
        start.displacement.y,
        start.theta,
        start.velocity.x,
        start.velocity.y,
        start.spin.z,
    ]);
    rk.resize(6);
    let (mut worst, mut largest) = (0.0f64, 0.0f64);
    while t < scene.duration {
        let end = (t + 0.01).min(equation.0.ground.next_kink(t)).min(scene.duration);
        // A kink's own piece ends just before it.
        let inside = Equation(equation.0.clone());
        let mut inside = Shifted(inside, end);
        rk.start(&mut inside, t, &y);
        rk.attempt(&mut inside, t, &y, end - t);
        rk.accept(&mut inside, t, &mut y, end - t);
        t = end;
        let got = history.motion(0, t);
        let i = equation.0.bodies[0].gyration2.sqrt();
        for (a, b) in [(got.displacement.x, y[0]), (got.displacement.y, y[1]), (got.theta * i, y[2] * i)] {
            worst = worst.max((a - b).abs());
            largest = largest.max(b.abs());
        }
    }
    equation.0.duration = t;
    worst / largest
}

/// The equation within one piece of a record: at its very end the next piece has not begun.
struct Shifted(Equation, f64);

impl System for Shifted {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        let t = if t >= self.1 { self.1 * (1.0 - 1e-15) } else { t };
        self.0.slope(t, y, out);
    }

    fn size2(&self, d: &[f64]) -> f64 {
        self.0.size2(d)
    }
}

const ECCENTRIC: &str = "[\
    { at_m = [0.07, 0.02], stiffness_n_per_m = [120.0, 90.0], damping_n_s_per_m = [4.0, 1.0] },\
    { at_m = [0.06, -0.03], stiffness_n_per_m = [60.0, 150.0], damping_n_s_per_m = [0.5, 6.0] },\
    { at_m = [-0.08, 0.01], stiffness_n_per_m = [200.0, 110.0], damping_n_s_per_m = [2.0, 3.0] }]";

#[test]
fn eccentric_bearings_are_followed_in_closed_form() {
    let start = "initial = { displacement_m = [0.004, -0.003], rotation_deg = 2.0, spin_deg_s = 20.0 }\n";
    let push = "push = { force_n = [0.4, 0.2], moment_n_m = 0.01 }\n";
    for motion in ["", "[motion]\nkind = \"sine\"\namplitude_m_s2 = 2.0\nfrequency_hz = 2.2\nangle_deg = 35.0"] {
        let worst = against_steps(&girder(ECCENTRIC, &format!("{start}{push}{motion}")));
        within("eccentric girder against small steps", worst, 1e-11);
    }
}

#[test]
fn an_undamped_resonance_is_followed_in_closed_form() {
    let bearings = format!("{{ frequency_hz = 2.4, damping_ratio = 0.0, {LEGS} }}");
    let motion = "[motion]\nkind = \"sine\"\namplitude_m_s2 = 2.0\nfrequency_hz = 2.4\nangle_deg = 35.0";
    within("undamped resonance against small steps", against_steps(&girder(&bearings, motion)), 1e-11);
}

#[test]
fn a_record_is_followed_exactly_from_sample_to_sample() {
    let samples: Vec<String> =
        (0..=400).map(|i| format!("{:.4}", (f64::from(i) * 0.7).sin() * 3.0 + f64::from(i % 7))).collect();
    let motion =
        format!("[motion]\nkind = \"record\"\ndt_s = 0.01\nangle_deg = 20.0\nsamples_m_s2 = [{}]", samples.join(", "));
    for bearings in [format!("{{ frequency_hz = 2.4, damping_ratio = 0.1, {LEGS} }}"), ECCENTRIC.to_owned()] {
        within("record against small steps", against_steps(&girder(&bearings, &motion)), 1e-11);
    }
}

#[test]
fn a_girder_without_bearings_falls_under_a_push_as_a_parabola() {
    let mut free = girder(&format!("{{ frequency_hz = 1.0, damping_ratio = 0.0, {LEGS} }}"), "");
    free.girders[0].bearings = None;
    free.girders[0].push.force = [1.5, -0.5, 0.0];
    let got = run(&free).motion(0, 6.0).displacement;
    within("x", got.x - 0.5 * 0.75 * 36.0, 1e-13 * 14.0);
    within("y", got.y + 0.5 * 0.25 * 36.0, 1e-13 * 14.0);
}
