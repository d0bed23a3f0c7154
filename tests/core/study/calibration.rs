//! Gap, restitution and friction come back from the program's own pounding histories with noise.

use girderbench::scene::presets;
use girderbench::study::calibration::{Measured, NotCalibrated, calibrate};

use crate::support::run;

/// Seconds of a film at 30 pictures a second.
const LENGTH: f64 = 3.0;

/// The paper's 45° girder as a camera of noise 0.01 mm would show it.
fn filmed(seed: u64) -> (girderbench::scene::Scene, Measured) {
    let mut scene = presets::load("skew45-abutment").expect("a preset");
    scene.duration = LENGTH;
    let history = run(&scene);
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    // The sum of twelve uniform numbers has a variance of 1.
    let mut noise = || 1e-5 * ((0..12).map(|_| uniform()).sum::<f64>() - 6.0);
    let times: Vec<f64> = (0..90).map(|n| f64::from(n) / 30.0).collect();
    let mut along = Vec::new();
    for axis in [0, 1] {
        along.push((axis, times.iter().map(|t| history.motion(0, *t).displacement[axis] + noise()).collect()));
    }
    (scene, Measured { girder: 0, times, along })
}

/// Histories that are examined.
const SEEDS: u64 = 20;
/// So many of their intervals of 95 % hold the truth at least: of the binomial distribution, P(14 or fewer of 20) = 0.0003.
const HELD: usize = 15;

#[test]
#[expect(clippy::print_stdout, reason = "shown when a test fails, or with --nocapture")]
fn gap_restitution_and_friction_come_back_from_other_starts() {
    let truth = [("abutment.wall.gap_m", 0.003), ("contact.restitution_normal", 0.4), ("contact.mu_kinetic", 0.15)];
    let mut held = [0; 3];
    for seed in 1..=SEEDS {
        let (scene, measured) = filmed(seed);
        let starts: Vec<(String, f64)> =
            truth.iter().zip([1.2, 0.8, 1.2]).map(|((key, value), off)| ((*key).to_owned(), value * off)).collect();
        let found = calibrate(&scene, &starts, &measured).expect("they show");
        // Of 177 residuals; five standard deviations.
        assert!((found.rms / 1e-5 - 1.0).abs() < 0.27, "seed {seed}: noise of 0.01 mm is left: {} m", found.rms);
        for (n, (fitted, (_, value))) in found.keys.iter().zip(truth).enumerate() {
            assert!(fitted.half_width < 0.02 * value, "seed {seed}: it is sharp: {fitted:?}");
            held[n] += usize::from((fitted.value - value).abs() <= fitted.half_width);
        }
    }
    println!("of {SEEDS} intervals {held:?} hold gap, e_n and mu_k");
    assert!(held.iter().all(|held| *held >= HELD), "{held:?} of {SEEDS}");
}

#[test]
fn keys_that_do_not_show_and_starts_that_do_not_run_are_told() {
    let (scene, measured) = filmed(1);
    let keys = |key: &str, start: f64| vec![(key.to_owned(), start)];
    let hidden = calibrate(&scene, &keys("impact.mu_kinetic", 0.15), &measured);
    assert!(matches!(hidden, Err(NotCalibrated::Undetermined(_))), "of the other model: {hidden:?}");
    let wrong = calibrate(&scene, &keys("contact.mu_kinetic", -1.0), &measured).expect_err("negative");
    assert!(wrong.to_string().contains("contact.mu_kinetic=-1.0"), "{wrong}");
}
