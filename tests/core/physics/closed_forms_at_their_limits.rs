//! Closed forms where their terms cancel or vanish: soft springs, dashpots without a spring, sines far slower than the run
//! (`docs/physics.md#free-flight`).

use girderbench::scene::{Motion, Scene};

use crate::support::{run, scene, within};

const DECK: &str = r#"
    [[girder]]
    name = "deck"
    length_m = 30.0
    width_m = 10.0
    thickness_m = 1.5
    mass_kg = 4e5
"#;

/// A free deck 20 mm before a wall that the ground drives at it, by a sine of this frequency at its crest \[Hz\].
fn driven(frequency: f64) -> Scene {
    scene(&format!(
        r#"
        name = "driven"
        duration_s = 2.0
        {DECK}
        [[abutment]]
        name = "west"
        faces = "deck"
        end = "-x"
        gap_m = 0.02
        [motion]
        kind = "sine"
        amplitude_m_s2 = 1.0
        frequency_hz = {frequency:e}
        phase_deg = 90
        "#
    ))
}

#[test]
fn a_sine_far_slower_than_the_run_is_a_constant_force() {
    for frequency in [0.0, 1e-9, 1e-7, 1e-5] {
        // The path is (1 − cos ωt)/ω², t²/2 less (ωt)² /12 of it: 1.3e-11 at 1e-5 Hz; √(2 · 0.02 m/1 m/s²) = 0.2 s.
        let history = run(&driven(frequency));
        within(&format!("first touch at {frequency:e} Hz"), history.hits().touches()[0].start - 0.2, 1e-11);
    }
    // The same force in either form, beside where the steady response takes over: ω t = 0.0446 rad at 2 s.
    let places = [3.5e-3, 3.6e-3].map(|frequency| {
        let mut scene = driven(frequency);
        scene.abutments.clear();
        let omega = std::f64::consts::TAU * frequency;
        // Either form, and the one below, loses three digits of a place of 2 m: 1e-12 m.
        run(&scene).motion(0, 2.0).displacement.x + (1.0 - (omega * 2.0).cos()) / (omega * omega)
    });
    for off in places {
        within("path under a slow sine", off, 1e-12);
    }
}

/// A deck on a dashpot of 80 1/s of its mass beside a spring of this stiffness, shaken by a synthetic earthquake.
fn damped(stiffness: f64) -> f64 {
    let scene = scene(&format!(
        r#"
        name = "damped"
        duration_s = 10.0
        {DECK}
        bearings = [{{ at_m = [0.0, 0.0], stiffness_n_per_m = [{stiffness:e}, 0.0], damping_n_s_per_m = [3.2e7, 3.2e7] }}]
        initial = {{ velocity_m_s = [0.1, 0.0] }}
        [motion]
        kind = "synthetic"
        seed = 3
        peak_g = 0.3
        length_s = 10.0
        "#
    ));
    run(&scene).motion(0, 10.0).displacement.x
}

#[test]
fn a_spring_that_is_soft_against_its_dashpot_tends_to_none() {
    // A spring k holds the deck back by its force over the dashpot's: k x t/c, at most 3e-9 of x at k = 0.01 N/m.
    let none = damped(0.0);
    for stiffness in [1e-9, 1e-3, 1e-2] {
        let bound = 1e-13 + none.abs().max(0.1) * stiffness * 10.0 / 3.2e7;
        within(&format!("place with {stiffness:e} N/m"), damped(stiffness) - none, bound);
    }
}

#[test]
fn a_coordinate_of_a_block_with_a_dashpot_alone_is_a_number() {
    let history = run(&scene(&format!(
        r#"
        name = "dashpot"
        duration_s = 2.0
        {DECK}
        bearings = [
            {{ at_m = [0.0, 0.0], stiffness_n_per_m = [1e7, 0.0], damping_n_s_per_m = [1e5, 0.0], on = "p" }},
            {{ at_m = [0.0, 0.0], stiffness_n_per_m = [0.0, 0.0], damping_n_s_per_m = [0.0, 1e5] }},
        ]
        initial = {{ velocity_m_s = [0.3, 0.2] }}
        [[pier]]
        name = "p"
        mass_kg = 1e5
        frequency_hz = 2.0
        [[abutment]]
        name = "east"
        faces = "deck"
        gap_m = 0.02
        "#
    )));
    assert!(!history.hits().touches().is_empty(), "it comes to the wall");
    // Across nothing but the dashpot acts until the touch: v (1 − e^{−ct/m}) m/c, in steps at the default tolerance of 1e-10 m.
    let t = 0.9 * history.hits().touches()[0].start;
    within("across", history.motion(0, t).displacement.y - 0.2 * 4.0 * (1.0 - (-t / 4.0).exp()), 1e-10);
}

#[test]
fn a_face_slides_under_a_constant_sine_as_under_a_push() {
    let sliding = |friction: f64, motion: &str, push: f64| {
        let scene = scene(&format!(
            r#"
            name = "slides"
            duration_s = 0.5
            {DECK}
            bearings = [{{ at_m = [0.0, 0.0], stiffness_n_per_m = [1e6, 1e6], damping_n_s_per_m = [1e4, 1e4] }}]
            push = {{ force_n = [4e5, {push:e}] }}
            [[abutment]]
            name = "east"
            faces = "deck"
            gap_m = 0.0
            [model]
            kind = "impact"
            [impact]
            mu_static = {friction}
            mu_kinetic = {friction}
            {motion}
            "#
        ));
        run(&scene).motion(0, 0.5).displacement.y
    };
    let constant =
        "[motion]\nkind = \"sine\"\namplitude_m_s2 = 2.0\nfrequency_hz = 0.0\nphase_deg = 90.0\nangle_deg = 90.0";
    for friction in [0.0, 0.1] {
        let pushed = sliding(friction, "", -2.0 * 4e5);
        assert!(pushed < -0.2, "it slides: {pushed} m");
        within(&format!("slide at μ = {friction}"), sliding(friction, constant, 0.0) - pushed, 1e-12);
    }
}

#[test]
fn a_component_that_ends_before_others_drops_to_nothing() {
    let shaken = |other: &str| {
        let scene = scene(&format!(
            r#"
            name = "ends"
            duration_s = 2.0
            {DECK}
            bearings = [{{ at_m = [0.0, 0.0], stiffness_n_per_m = [1e7, 1e7], damping_n_s_per_m = [1e5, 1e5] }}]
            [motion]
            kind = "record"
            x_azimuth_deg = 0
            [[motion.component]]
            azimuth_deg = 0.0
            dt_s = 0.1
            samples_m_s2 = [0, 3, 3, 3, 3, 3]
            {other}
            "#
        ));
        assert!(matches!(scene.motion, Motion::Record(_)), "a record");
        let history = run(&scene);
        [0.6, 1.0, 2.0].map(|t| history.motion(0, t).displacement.x)
    };
    let (alone, beside) = (
        shaken(""),
        shaken("[[motion.component]]\nazimuth_deg = 90.0\ndt_s = 0.1\nsamples_m_s2 = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]"),
    );
    assert!(alone[0].abs() > 0.05, "it moves: {alone:?}");
    for (a, b) in alone.iter().zip(beside) {
        within("place beside a component of zeros", a - b, 1e-14);
    }
}
