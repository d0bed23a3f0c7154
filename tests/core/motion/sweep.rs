//! The sine sweep of a scene: the response to it in both models, what it refuses.

use girderbench::motion::sweep::LINE_ERROR;
use girderbench::scene::{ModelKind, Motion, Scene, SweepMotion, SweepRate, format, presets, validate};

use crate::support::{run, within};

/// The paper's straight girder, its abutment out of reach, under a sweep of the paper's range.
fn swept(sweep: SweepMotion) -> Scene {
    let mut scene = presets::load("straight-abutment").expect("a preset");
    scene.abutments[0].gap = Some(0.2);
    (scene.duration, scene.motion) = (22.0, Motion::Sweep(sweep));
    validate::validate(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    scene
}

fn of_paper(rate: SweepRate) -> SweepMotion {
    SweepMotion { amplitude_g: 0.05, length: 20.0, rate, ..SweepMotion::default() }
}

/// Displacement under the sweep itself at multiples of 0.01 s: `ẍ + 2hω ẋ + ω² x = −a`, by the classical Runge–Kutta method.
fn integrated(motion: SweepMotion, [omega, h]: [f64; 2], count: usize) -> Vec<f64> {
    let sweep = motion.sweep();
    let slope = |t: f64, [x, v]: [f64; 2]| [v, -sweep.acceleration(t) - 2.0 * h * omega * v - omega * omega * x];
    let (mut y, step, mut all) = ([0.0; 2], 2.5e-4, vec![0.0]);
    let on = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
    for n in 0..count * 40 {
        let t = n as f64 * step;
        let k1 = slope(t, y);
        let k2 = slope(t + 0.5 * step, on(y, k1, 0.5 * step));
        let k3 = slope(t + 0.5 * step, on(y, k2, 0.5 * step));
        let k4 = slope(t + step, on(y, k3, step));
        y = [0, 1].map(|i| y[i] + step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        if n % 40 == 39 {
            all.push(y[0]);
        }
    }
    all
}

#[test]
fn both_models_answer_to_the_sweep_itself_within_the_bound_of_its_samples() {
    let (omega, h) = (std::f64::consts::TAU * 2.4, 0.29_f64);
    // ∫ |impulse response| dt, by which a difference of the ground's acceleration is multiplied at most.
    let gain = 1.0 / (0.5 * std::f64::consts::PI * h / (1.0 - h * h).sqrt()).tanh() / (omega * omega);
    for rate in [SweepRate::Linear, SweepRate::Logarithmic] {
        let motion = of_paper(rate);
        let exact = integrated(motion, [omega, h], 1990);
        for kind in [ModelKind::Contact, ModelKind::Impact] {
            let mut scene = swept(motion);
            scene.model.kind = kind;
            let history = run(&scene);
            let off = |(n, x): (usize, &f64)| (history.motion(0, 0.01 * n as f64).displacement.x - x).abs();
            let worst = exact.iter().enumerate().map(off).fold(0.0, f64::max);
            within(&format!("{rate:?}, {kind:?} [m]"), worst, LINE_ERROR * motion.sweep().amplitude.abs() * gain);
        }
    }
}

#[test]
fn a_swept_girder_pounds_and_keeps_its_energy() {
    let motion = SweepMotion { amplitude_g: 0.4, length: 4.0, angle_deg: 22.5, ..SweepMotion::default() };
    let mut scene = presets::load("skew45-abutment").expect("a preset");
    (scene.duration, scene.motion) = (5.0, Motion::Sweep(motion));
    let history = run(&scene);
    let ledger = history.energy().ledger(history.end());
    assert!(ledger.loss_normal > 0.0, "it hits the wall");
    within("residual of the ledger", ledger.residual / ledger.scale, 5e-13);
    let text = format::write(&scene);
    assert_eq!(format::read(&text, "again").as_ref(), Ok(&scene), "{text}");
}

#[test]
fn a_sweep_that_cannot_be_sampled_is_refused() {
    let refused = |change: SweepMotion, place: &str, remedy: &str| {
        let mut scene = swept(SweepMotion::default());
        scene.motion = Motion::Sweep(change);
        let errors = validate::validate(&scene).expect_err(place).to_string();
        assert!(errors.contains(place) && errors.contains(remedy), "{place}: {errors}");
    };
    let sound = SweepMotion::default();
    refused(SweepMotion { length: 1e4, ..sound }, "motion.length_s", "shorter");
    refused(SweepMotion { from_hz: 0.0, ..sound }, "motion.from_hz", "greater than 0");
    refused(SweepMotion { to_hz: f64::NAN, ..sound }, "motion.to_hz", "finite");
    refused(SweepMotion { from_hz: 1e-300, to_hz: 1e300, ..sound }, "motion.length_s", "lower frequencies");
}
