//! Flat sliders and friction pendulums, in plan and in space, against closed forms, momentum and energy.

use std::f64::consts::{PI, TAU};

use girderbench::scene::validate::validate;
use girderbench::scene::{STANDARD_GRAVITY, Scene};
use girderbench::sim::History;

use super::devices::girder;
use crate::support::{run, scene, within};

/// Four sliders of the model girder of 2 kg, μ, R \[m\], `u_y` \[m\].
fn sliders(friction: f64, radius: f64, displacement: f64) -> String {
    let leg = |[x, y]: [f64; 2]| {
        format!(
            "{{ at_m = [{x}, {y}], stiffness_n_per_m = [0, 0], damping_n_s_per_m = [0, 0], friction = {friction}, \
             radius_m = {radius}, slider_displacement_m = {displacement} }}"
        )
    };
    format!("bearings = [{}]", [[0.07, 0.025], [0.07, -0.025], [-0.07, 0.025], [-0.07, -0.025]].map(leg).join(", "))
}

/// The first zero after `from` of a function that is negative there.
fn zero(f: impl Fn(f64) -> f64, from: f64, step: f64) -> f64 {
    let mut low = from;
    while f(low + step) < 0.0 {
        low += step;
    }
    let mut high = low + step;
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    high
}

fn balanced(history: &History, allowed: f64) {
    let books = history.energy().ledger(history.end());
    within("ledger", books.residual / books.scale, allowed);
}

/// Changes of phase of a bearing, by time.
fn changes(history: &History, bearing: usize) -> Vec<(f64, u32)> {
    history.connections().link_phases(bearing)[1..].iter().map(|(t, phase)| (*t, phase.branch)).collect()
}

#[test]
fn a_flat_slider_on_a_shaking_ground_sticks_and_slips_as_in_closed_form() {
    let (friction, yields, amplitude, frequency) = (0.1, 2e-5, 0.2, 2.0);
    let history = run(&girder(90.0, &sliders(friction, 0.0, yields), [amplitude, frequency, 0.0], 0.5));
    let (a, w) = (amplitude * STANDARD_GRAVITY, TAU * frequency);
    // Stick is an oscillator of ω₀² = μ g/u_y from rest; slip moves freely under the ground and μ g.
    let (stop, own) = (friction * STANDARD_GRAVITY, (friction * STANDARD_GRAVITY / yields).sqrt());
    let factor = -a / (own * own - w * w);
    let stick = |t: f64| factor * ((w * t).sin() - w / own * (own * t).sin());
    let stick_rate = |t: f64| factor * w * ((w * t).cos() - (own * t).cos());
    let slips = zero(|t| stick(t).abs() - yields, 1e-6, 1e-5);
    let sign = stick(slips).signum();
    let [u, v] = [stick(slips), stick_rate(slips)];
    let phase = w * slips;
    let slip_rate = |t: f64| v + a / w * ((w * t).cos() - phase.cos()) - sign * stop * (t - slips);
    let slip = |t: f64| {
        let s = t - slips;
        u + v * s + a / (w * w) * ((w * t).sin() - phase.sin() - w * s * phase.cos()) - sign * stop * s * s / 2.0
    };
    let stops = zero(|t| -sign * slip_rate(t), slips + 1e-5, 1e-4);
    let found = changes(&history, 0);
    within("slip begins", found[0].0 - slips, 1e-11);
    within("slip ends", found[1].0 - stops, 1e-10);
    within("how far", history.motion(0, stops).displacement.x - slip(stops), 1e-11);
    assert!(slip(stops).abs() > 50.0 * yields, "it slid: {} m", slip(stops));
    within("all legs as one", history.motion(0, 0.5).theta, 1e-12);
    balanced(&history, 1e-9);
}

#[test]
fn a_pendulum_swings_with_the_period_of_its_radius() {
    let (radius, friction, yields) = (0.4, 1e-3, 1e-9);
    let words = format!("initial = {{ velocity_m_s = [0.05, 0.0] }}\n{}", sliders(friction, radius, yields));
    let history = run(&girder(90.0, &words, [0.0, 1.0, 0.0], 3.0));
    // Between two turns friction is constant: half a period whatever the amplitude, but for the way 2 u_y of the turn, where it is
    // less for √(4 u_y/a) ≈ 0.1 ms, of 4 % of the force.
    let turns: Vec<f64> = changes(&history, 0).into_iter().filter(|(_, law)| *law == 0).map(|(t, _)| t).collect();
    assert!(turns.len() > 3, "{turns:?}");
    for pair in turns.windows(2) {
        within("half a period", (pair[1] - pair[0]) / (PI * (radius / STANDARD_GRAVITY).sqrt()) - 1.0, 3e-5);
    }
    balanced(&history, 1e-9);
}

/// A deck of 300 t on pendulums of one μ and R, shaken in two directions.
fn pendulum_deck(words: &str) -> Scene {
    scene(&format!(
        r#"
        name = "pendulum-deck"
        duration_s = 6.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.7
        skew_deg = 60.0
        mass_kg = 3e5
        {words}
        [motion]
        kind = "synthetic"
        seed = 3
        peak_g = 0.4
        length_s = 6.0
        across = 0.8
        "#
    ))
}

#[test]
fn a_deck_on_equal_pendulums_does_not_turn_unless_it_is_pushed_to() {
    let bearings = "bearings = { kind = \"pendulum\", at_skewed_m = [[-14, -4], [14, -4], [14, 4], [-14, 4]] }";
    let still = run(&pendulum_deck(bearings));
    let moved = still.summary().max_displacement;
    assert!(moved > 0.02, "it slides, by {moved} m");
    within("rotation", still.summary().max_rotation, 1e-10);
    let pushed = run(&pendulum_deck(&format!("push = {{ moment_n_m = 2e6 }}\n{bearings}")));
    assert!(pushed.summary().max_rotation > 1e-5, "{} rad", pushed.summary().max_rotation);
    balanced(&pushed, 1e-8);
}

#[test]
fn loads_beside_g_are_refused_and_given_ones_must_carry_the_weight() {
    let leg = |x: f64, words: &str| {
        format!("{{ at_m = [{x}, 0], stiffness_n_per_m = [0, 0], damping_n_s_per_m = [0, 0], friction = 0.1{words} }}")
    };
    let errors = |legs: [String; 2]| {
        let scene = girder(90.0, &format!("bearings = [{}]", legs.join(", ")), [0.0, 1.0, 0.0], 1.0);
        validate(&scene).err().map(|errors| errors.to_string()).unwrap_or_default()
    };
    assert_eq!(errors([leg(0.07, ""), leg(-0.07, "")]), "", "about G");
    assert!(errors([leg(0.07, ""), leg(-0.04, "")]).contains("without a moment about G"), "beside G");
    let weight = 2.0 * STANDARD_GRAVITY;
    let load = |share: f64| format!(", load_n = {:?}", share * weight);
    assert_eq!(errors([leg(0.06, &load(0.4)), leg(-0.04, &load(0.6))]), "", "by their loads");
    assert!(errors([leg(0.07, &load(0.5)), leg(-0.07, &load(0.6))]).contains("add up to"), "too much");
    assert!(errors([leg(0.07, &load(0.5)), leg(-0.07, "")]).contains("of all bearings"), "half of them");
    assert!(
        errors([leg(0.07, ", yield_force_n = 1, yield_displacement_m = 1"), leg(-0.07, "")]).contains("one of the two")
    );
    let radius = "{ at_m = [0, 0], stiffness_n_per_m = [0, 0], damping_n_s_per_m = [0, 0], radius_m = 1.0 }";
    assert!(errors([radius.to_owned(), leg(0.0, "")]).contains("give `friction` as well"), "a radius of nothing");
}

/// A deck of 60 t in space that cannot tilt, on four sliders, under vertical shaking \[g\].
fn in_space(words: &str, vertical: f64, duration: f64) -> Scene {
    scene(&format!(
        r#"
        name = "in-space"
        kind = "spatial"
        duration_s = {duration}
        [[girder]]
        name = "deck"
        length_m = 10.0
        width_m = 4.0
        thickness_m = 1.0
        mass_kg = 6e4
        held = ["roll", "pitch"]
        {words}
        [motion]
        kind = "sine"
        amplitude_g = 0.0
        vertical_amplitude_g = {vertical}
        frequency_hz = 3.0
        [solver]
        tolerance = 1e-11
        "#
    ))
}

fn deck_sliders(friction: f64, radius: f64, damping: f64) -> String {
    format!(
        "bearings = {{ kind = \"pendulum\", friction = {friction}, radius_m = {radius}, slider_displacement_m = 1e-4, \
         vertical_frequency_hz = 12.0, vertical_damping_ratio = {damping}, at_m = [[4, 1.5], [4, -1.5], [-4, 1.5], [-4, -1.5]] }}"
    )
}

#[test]
fn a_flat_slider_in_space_loses_as_much_momentum_as_its_vertical_force_makes_friction() {
    let friction = 0.05;
    let words = format!("initial = {{ velocity_m_s = [1.2, 0.5] }}\n{}", deck_sliders(friction, 0.0, 0.0));
    let history = run(&in_space(&words, 0.5, 1.0));
    // m v̇ = −μ ΣN and m ẅ = ΣN − m g − m a_z, so that v + μ (g t + ẇ + ∫ a_z) is constant while it slides.
    let omega = TAU * 3.0;
    let kept = |t: f64| {
        let motion = history.motion(0, t);
        let ground = 0.5 * STANDARD_GRAVITY / omega * (1.0 - (omega * t).cos());
        motion.velocity.truncate().length() + friction * (STANDARD_GRAVITY * t + motion.velocity.z + ground)
    };
    let begins = changes(&history, 0)[0].0;
    assert!(begins < 0.01 && changes(&history, 0).len() == 1, "it slides throughout");
    for i in 1..=10 {
        within("kept", kept(0.1 * f64::from(i)) - kept(begins), 1e-9);
    }
    let swing = (0..100).map(|i| history.motion(0, 0.01 * f64::from(i)).displacement.z.abs()).fold(0.0, f64::max);
    assert!(swing > 5e-4, "N changes: {swing} m");
    balanced(&history, 1e-9);
}

#[test]
fn sliders_that_lift_off_move_freely_and_land() {
    let words = format!("initial = {{ velocity_m_s = [0.8, 0.0] }}\n{}", deck_sliders(0.08, 2.0, 0.05));
    let history = run(&in_space(&words, 1.4, 2.0));
    let all = changes(&history, 0);
    let lifted: Vec<[f64; 2]> = all.windows(2).filter(|two| two[0].1 == 2).map(|two| [two[0].0, two[1].0]).collect();
    assert!(lifted.len() > 2, "it lifts off: {all:?}");
    for [from, until] in lifted {
        let [before, after] = [from, until].map(|t| history.motion(0, t).velocity.truncate());
        within("free between", (after - before).length(), 1e-10);
        let now = history.connections().bearing_loop(0, 0, f64::midpoint(from, until)).expect("a bearing");
        within("no horizontal force", now.resistance[0].hypot(now.resistance[1]), 1e-6);
    }
    balanced(&history, 1e-8);
}

#[test]
fn a_pendulum_in_space_rises_in_its_dish_and_keeps_its_energy() {
    let radius = 2.0;
    let words = format!("initial = {{ velocity_m_s = [0.2, 0.0] }}\n{}", deck_sliders(1e-4, radius, 0.5));
    let history = run(&in_space(&words, 0.0, 3.0));
    let turns: Vec<f64> = changes(&history, 0).into_iter().filter(|(_, law)| *law == 0).map(|(t, _)| t).collect();
    // Half a period, but for (u/R)² and the little that the deck sinks on its springs.
    within("half a period", (turns[1] - turns[0]) / (PI * (radius / STANDARD_GRAVITY).sqrt()) - 1.0, 3e-3);
    let motion = history.motion(0, turns[0]);
    let rise = motion.displacement.x.powi(2) / (2.0 * radius);
    assert!((motion.displacement.z / rise - 1.0).abs() < 0.05, "{} m is not {rise} m", motion.displacement.z);
    balanced(&history, 1e-9);
}

#[test]
fn the_vertical_dashpot_of_a_pendulum_does_not_brake_its_swing() {
    // u²/2R is 45 mm: a dashpot on the rate of w would take four fifths of the energy at a damping of 0.3.
    let amplitude = |damping: f64| {
        let words = format!("initial = {{ displacement_m = [0.3, 0.0, 0.045] }}\n{}", deck_sliders(1e-4, 1.0, damping));
        let history = run(&in_space(&words, 0.0, 1.6));
        balanced(&history, 1e-9);
        let least = (0..=160).map(|i| history.motion(0, 0.01 * f64::from(i)).displacement.x).fold(0.0, f64::min);
        -least
    };
    for damping in [0.0, 0.02, 0.1, 0.3] {
        // μ = 1e-4 takes 2 μ R.
        within(&format!("amplitude at {damping}"), amplitude(damping) - (0.3 - 2e-4), 3e-4);
    }
}

#[test]
fn sliders_in_space_without_vertical_motion_are_those_in_plan() {
    let legs = "[[4, 1.5], [4, -1.5], [-4, 1.5], [-4, -1.5]]";
    let bearings = |more: &str| {
        format!("bearings = {{ kind = \"pendulum\", friction = 0.06, radius_m = 0.0, at_m = {legs}{more} }}")
    };
    let with = |kind: &str, held: &str, more: &str| {
        let text = format!(
            "name = \"deck\"\nkind = \"{kind}\"\nduration_s = 4.0\n[[girder]]\nname = \"deck\"\nlength_m = 10.0\nwidth_m = 4.0\n\
             thickness_m = 1.0\nmass_kg = 6e4\nheld = {held}\n{}\n[motion]\nkind = \"sine\"\namplitude_g = 0.3\n\
             frequency_hz = 0.9\nangle_deg = 20\n[solver]\ntolerance = 1e-11\n",
            bearings(more)
        );
        run(&scene(&text))
    };
    let (plan, space) =
        (with("planar", "[]", ""), with("spatial", "[\"roll\", \"pitch\"]", ", vertical_frequency_hz = 9.0"));
    for i in 0..=40 {
        let t = 0.1 * f64::from(i);
        let apart = plan.motion(0, t).displacement - space.motion(0, t).displacement;
        within(&format!("at {t}"), apart.length(), 1e-8);
    }
    assert!(plan.summary().max_displacement > 0.05);
}
