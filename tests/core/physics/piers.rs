//! Girders on piers: closed forms of two masses, stiff piers, yield, momentum, books, seats.

use std::f64::consts::TAU;

use girderbench::geometry::End;
use girderbench::scene::{Scene, overrides, presets};
use girderbench::sim::{History, Quantity, readings};
use glam::DVec3;

use crate::support::{run, scene, within};

/// Mass of the girder and of the pier \[kg\].
const MASSES: [f64; 2] = [3e5, 1.2e5];
/// Frequencies of the girder on a pier that stands still, and of the pier alone \[Hz\].
const FREQUENCIES: [f64; 2] = [1.1, 2.3];

/// A girder that stands on one pier with all of its bearings, without damping unless more is said.
fn on_one_pier(more: &str, motion: &str) -> Scene {
    let ([girder, pier], [f, f_pier]) = (MASSES, FREQUENCIES);
    scene(&format!(
        r#"
        name = "two masses"
        duration_s = 6.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        mass_kg = {girder:?}
        bearings = {{ frequency_hz = {f}, damping_ratio = 0.0, at_m = [[12, 4], [-12, 4], [-12, -4], [12, -4]], on_minus_x = "p", on_plus_x = "p" }}
        {more}
        [[pier]]
        name = "p"
        mass_kg = {pier:?}
        frequency_hz = {f_pier}
        damping_ratio = 0.0
        [solver]
        tolerance = 1e-12
        {motion}
        "#
    ))
}

/// Squared circular frequencies of the two masses, and the mode shapes of unit modal mass.
fn modes() -> [(f64, [f64; 2]); 2] {
    let [m, p] = MASSES;
    let [k, c] = [m * (TAU * FREQUENCIES[0]).powi(2), p * (TAU * FREQUENCIES[1]).powi(2)];
    // (k − m ω²) u = k v, and ω⁴ m p − ω² (m (k + c) + p k) + k c = 0.
    let (half, whole) = (0.5 * (m * (k + c) + p * k) / (m * p), k * c / (m * p));
    let root = (half * half - whole).sqrt();
    [half - root, half + root].map(|squared| {
        let shape = [k, k - m * squared];
        let mass = (m * shape[0] * shape[0] + p * shape[1] * shape[1]).sqrt();
        (squared, shape.map(|v| v / mass))
    })
}

fn displacements(history: &History, t: f64) -> [f64; 2] {
    [0, 1].map(|body| history.motion(body, t).displacement.x)
}

#[test]
fn a_girder_let_go_on_a_pier_swings_in_two_modes() {
    let start = 0.05;
    let history = run(&on_one_pier(&format!("initial = {{ displacement_m = [{start}, 0.0] }}"), ""));
    let mut worst = 0.0f64;
    for i in 0..=120 {
        let t = 0.05 * f64::from(i);
        let mut wanted = [0.0; 2];
        for (squared, shape) in modes() {
            let amount = shape[0] * MASSES[0] * start * (squared.sqrt() * t).cos();
            (0..2).for_each(|body| wanted[body] += shape[body] * amount);
        }
        let here = displacements(&history, t);
        worst = (0..2).map(|body| (here[body] - wanted[body]).abs()).fold(worst, f64::max);
    }
    within("two modes", worst, 1e-10 * start);
    assert!(history.energy().balance().holds(), "{:?}", history.energy().ledger(6.0));
    let ledger = history.energy().ledger(6.0);
    assert!(ledger.bearing > 0.0 && ledger.device == 0.0, "bearings on piers are bearings: {ledger:?}");
}

#[test]
fn under_a_sine_both_masses_follow_the_closed_form() {
    let (amplitude, omega) = (0.8, TAU * 1.7);
    let motion = "[motion]\nkind = \"sine\"\namplitude_m_s2 = 0.8\nfrequency_hz = 1.7";
    let history = run(&on_one_pier("", motion));
    let mut worst = 0.0f64;
    for i in 0..=120 {
        let t = 0.05 * f64::from(i);
        let mut wanted = [0.0; 2];
        for (squared, shape) in modes() {
            let own = squared.sqrt();
            let part = MASSES[0] * shape[0] + MASSES[1] * shape[1];
            let amount =
                -part * amplitude / (squared - omega * omega) * ((omega * t).sin() - omega / own * (own * t).sin());
            (0..2).for_each(|body| wanted[body] += shape[body] * amount);
        }
        let here = displacements(&history, t);
        worst = (0..2).map(|body| (here[body] - wanted[body]).abs()).fold(worst, f64::max);
    }
    within("two masses under a sine", worst, 1e-10);
    // The base carries what the column is bent by.
    let pier = history.connections().piers()[0];
    let stiffness = MASSES[1] * (TAU * FREQUENCIES[1]).powi(2);
    within("base shear", pier.shear.value / (stiffness * pier.drift.value) - 1.0, 1e-12);
    within("period", pier.periods[0] * FREQUENCIES[1] - 1.0, 1e-14);
    let drift = Quantity::find(&history, "p.drift").expect("a quantity");
    within("its plot", drift.at(&history, pier.drift.t) - pier.drift.value, 1e-15);
    // A limit on it is passed where the curve comes to it for the first time.
    let mut limited = on_one_pier("", motion);
    let limit = 0.5 * pier.drift.value;
    limited.limits.pier_drift = Some(limit);
    let passed = readings::passed(&run(&limited));
    let [passed] = &passed[..] else { panic!("one pier: {passed:?}") };
    assert_eq!((passed.limit.key(), passed.whose.as_str(), passed.reached), ("pier_drift_m", "p", pier.drift.value));
    within("drift then", drift.at(&history, passed.t) - limit, 1e-8);
    let before = (0..1000).map(|i| drift.at(&history, passed.t * f64::from(i) / 1000.0)).fold(0.0, f64::max);
    assert!(before < limit, "not before: {before}");
}

/// The paper's skewed girder before its abutment, on the ground or on a pier with this stiffness.
fn skewed(stiffness: Option<f64>) -> Scene {
    let mut scene = presets::load("skew45-abutment").expect("a preset");
    scene.duration = 2.0;
    scene.solver.tolerance = 1e-11;
    let Some(stiffness) = stiffness else { return scene };
    let mut pier = crate::support::scene(
        "name = \"p\"\nduration_s = 1.0\n[[girder]]\nname = \"g\"\nlength_m = 1\nwidth_m = 1\nthickness_m = 1\nmass_kg = 1\n[[pier]]\nname = \"p\"\nmass_kg = 0.5\nstiffness_n_per_m = 1.0\ndamping_ratio = 0.3\nposition_m = [0, 0]\n",
    )
    .piers
    .remove(0);
    pier.stiffness = Some(girderbench::scene::PerDirection::Both(stiffness));
    scene.piers.push(pier);
    let Some(girderbench::scene::Bearings::Shared(bearings)) = &mut scene.girders[0].bearings else {
        panic!("equal bearings")
    };
    (bearings.on_minus_x, bearings.on_plus_x) = (Some("p".to_owned()), Some("p".to_owned()));
    scene
}

#[test]
fn on_stiffer_and_stiffer_piers_a_girder_comes_to_move_as_on_the_ground() {
    let ground = run(&skewed(None));
    assert!(ground.summary().hits > 2, "it hits: {:?}", ground.summary());
    let apart = |stiffness: f64| {
        let history = run(&skewed(Some(stiffness)));
        let at = |t: f64| (history.motion(0, t).displacement - ground.motion(0, t).displacement).length();
        (0..=200).map(|i| at(0.01 * f64::from(i))).fold(0.0, f64::max)
    };
    let [soft, stiff, stiffer] = [1e6, 1e7, 1e8].map(apart);
    for (one, next) in [(soft, stiff), (stiff, stiffer)] {
        assert!((8.0..12.5).contains(&(one / next)), "the difference goes with 1/k: {soft:e}, {stiff:e}, {stiffer:e}");
    }
    assert!(stiffer < 1e-6, "{stiffer:e} m");
}

#[test]
fn a_pier_that_yields_is_a_mass_on_a_bearing_that_yields() {
    let motion = "[motion]\nkind = \"sine\"\namplitude_m_s2 = 3.0\nfrequency_hz = 1.3";
    let pier = scene(&format!(
        r#"
        name = "pier"
        duration_s = 4.0
        [[girder]]
        name = "far"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        mass_kg = 1e5
        position_m = [500.0, 0.0, 0.0]
        [[pier]]
        name = "p"
        mass_kg = 1e5
        stiffness_n_per_m = 4e7
        damping_ratio = 0.0
        yield_force_n = 2e5
        post_yield_ratio = 0.1
        position_m = [0.0, 0.0]
        [solver]
        tolerance = 1e-11
        {motion}
        "#
    ));
    // k₂ = 0.1 k, Q = 0.9 F_y, u_y = F_y/k.
    let deck = scene(&format!(
        r#"
        name = "deck"
        duration_s = 4.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        mass_kg = 1e5
        bearings = [{{ at_m = [0.0, 0.0], stiffness_n_per_m = [4e6, 4e6], damping_n_s_per_m = [0, 0], yield_force_n = 1.8e5, yield_displacement_m = 5e-3 }}]
        [solver]
        tolerance = 1e-11
        {motion}
        "#
    ));
    let (pier, deck) = (run(&pier), run(&deck));
    let apart = |t: f64| (pier.motion(1, t).displacement - deck.motion(0, t).displacement).length();
    within("pier and deck", (0..=400).map(|i| apart(0.01 * f64::from(i))).fold(0.0, f64::max), 1e-10);
    let reading = pier.connections().piers()[0];
    let base = reading.base.expect("its base can yield");
    assert!(base.yielded_at.is_some_and(|t| t < 0.5), "{reading:?}");
    within("ductility is drift over F_y/k", base.ductility[0] - reading.drift.value / 5e-3, 1e-9);
    let beyond = 2e5 + 4e6 * (reading.drift.value - 5e-3);
    assert!(reading.shear.value > 2e5 && reading.shear.value <= beyond * (1.0 + 1e-9), "on the loop: {reading:?}");
    // What is plotted as the pier's loop is the whole of its base: its area is what is lost, and what is stored at the end.
    let names: Vec<String> = Quantity::all(&pier).into_iter().map(|(name, _)| name).collect();
    assert!(names.iter().all(|name| !name.starts_with("p.base")), "no part of it by itself: {names:?}");
    let [drift, shear] =
        ["p.drift-along", "p.shear-along"].map(|name| Quantity::find(&pier, name).expect("a quantity of piers"));
    let at = |i: u32| [drift, shear].map(|quantity| quantity.at(&pier, f64::from(i) / 1e4));
    let area: f64 = (0..40_000).map(|i| (at(i), at(i + 1))).map(|(a, b)| 0.5 * (a[1] + b[1]) * (b[0] - a[0])).sum();
    let ledger = pier.energy().ledger(4.0);
    let wanted = ledger.loss_bearing + ledger.bearing + ledger.loss_device + ledger.device;
    assert!(wanted > 1.0 && (area - wanted).abs() < 1e-5 * wanted, "{area} J of {wanted} J");
    assert!(pier.energy().balance().holds(), "{:?}", pier.energy().ledger(4.0));
}

#[test]
fn what_stays_of_a_yielded_piers_drift_is_where_it_comes_to_rest() {
    let text = r#"
        name = "pushed"
        duration_s = 30.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        mass_kg = 1e5
        bearings = [{ at_m = [0.0, 0.0], stiffness_n_per_m = [1e9, 1e9], damping_n_s_per_m = [1e6, 1e6], on = "p" }]
        [girder.initial]
        velocity_m_s = [0.3, 0.4, 0.0]
        [[pier]]
        name = "p"
        mass_kg = 1e5
        stiffness_n_per_m = 4e7
        damping_ratio = 0.05
        yield_force_n = FORCE
        post_yield_ratio = 0.1
        height_m = 8.0
        [solver]
        tolerance = 1e-10
        "#;
    for force in ["2e5", "[2e5, 3e5]"] {
        let history = run(&scene(&text.replace("FORCE", force)));
        let reading = history.connections().piers()[0];
        let (base, axes) = (reading.base.expect("its base can yield"), history.scene().pier(0).axes);
        let rest = axes.transpose() * history.connections().pier(0, 30.0).expect("a pier").displacement;
        assert!(rest.x.abs() > 1e-4 && base.ductility[0] > 1.0, "it yields: {reading:?}, {rest}");
        within("along", base.residual[0] - rest.x, 1e-7);
        within("across", base.residual[1] - rest.y, 1e-7);
        let weight = 2e5 * history.scene().gravity;
        let wanted = weight * reading.drift.value / (reading.shear.value * 8.0);
        within("P Δ/(V h)", reading.second_order.expect("of a height") - wanted, 1e-12);
    }
}

#[test]
fn the_moment_at_the_feet_is_that_of_how_the_tops_are_held() {
    for (top, arms) in [("free", [9.0, 9.0]), ("fixed-across", [9.0, 4.5]), ("fixed", [4.5, 4.5])] {
        for (angle, arm) in [(0, arms[0]), (90, arms[1])] {
            let sets = [
                "pier.p.column_m=[1.5, 2.0]".to_owned(),
                "pier.p.height_m=9".to_owned(),
                format!("pier.p.column_top={top}"),
                "pier.p.columns=2".to_owned(),
                format!("motion.angle_deg={angle}"),
            ];
            let sine = "[motion]\nkind = \"sine\"\namplitude_g = 0.1\nfrequency_hz = 0.7\n";
            let scene = overrides::apply_all(&on_one_pier("", sine), &sets).unwrap_or_else(|e| panic!("{e}"));
            let reading = &run(&scene).connections().piers()[0];
            within(&format!("{top} at {angle}°"), reading.moment.value / (reading.shear.value * arm) - 1.0, 1e-9);
        }
    }
}

#[test]
fn two_girders_that_hit_on_a_pier_without_a_column_keep_their_momentum() {
    let mut scene = presets::load("straight-straight").expect("a preset");
    scene.motion = girderbench::scene::Motion::None;
    scene.duration = 1.0;
    scene.solver.tolerance = 1e-11;
    scene.piers.push(skewed(Some(1e-12)).piers.remove(0));
    scene.piers[0].position = None;
    scene.piers[0].damping_ratio = Some(girderbench::scene::PerDirection::Both(0.0));
    for girder in &mut scene.girders {
        let Some(girderbench::scene::Bearings::Shared(bearings)) = &mut girder.bearings else { panic!("equal") };
        (bearings.on_minus_x, bearings.on_plus_x) = (Some("p".to_owned()), Some("p".to_owned()));
    }
    scene.girders[0].initial.velocity = [0.4, 0.05, 0.0];
    scene.girders[1].initial.velocity = [-0.3, 0.02, 0.0];
    let history = run(&scene);
    assert!(history.summary().hits > 0, "they hit");
    let momentum = |t: f64| -> DVec3 {
        let bodies = history.model().bodies.iter().enumerate();
        bodies.map(|(i, body)| body.mass * history.motion(i, t).velocity).sum()
    };
    let start = momentum(0.0);
    let drift = (0..=100).map(|i| (momentum(0.01 * f64::from(i)) - start).length()).fold(0.0, f64::max);
    within("momentum", drift / start.length(), 1e-9);
    assert!(history.energy().balance().holds(), "{:?}", history.energy().ledger(1.0));
}

#[test]
fn a_seat_on_a_pier_moves_with_it() {
    let mut scene = on_one_pier("initial = { displacement_m = [-0.3, 0.0] }\nseat_m = { \"+x\" = 0.2 }", "");
    scene.duration = 1.0;
    let history = run(&scene);
    assert_eq!(scene.pier_under(&scene.girders[0], End::Plus), Some(0));
    let seat = history.seats().of_girder(0)[0];
    for i in 0..=10 {
        let t = 0.1 * f64::from(i);
        let [deck, pier] = displacements(&history, t);
        let [[_, remaining], _] = history.seats().corners_at(0, &seat.ledge, t);
        within("what remains", remaining - (0.2 + deck - pier), 1e-14);
    }
    assert_eq!(seat.off_at(), Some(0.0), "0.3 m off at once");
}

#[test]
fn in_space_a_deck_on_a_stiffer_and_stiffer_pier_comes_to_move_as_on_the_ground() {
    let mut ground = presets::load("deck-30m").expect("a preset");
    ground.duration = 2.0;
    let on_pier = |stiffness: f64| {
        let mut scene = ground.clone();
        let mut pier = skewed(Some(stiffness)).piers.remove(0);
        (pier.mass, pier.position, pier.turn_stiffness) = (5e4, None, Some(100.0 * stiffness));
        scene.piers.push(pier);
        assert!(End::BOTH.into_iter().all(|end| scene.girders[0].stand_on(end, Some("p"))));
        run(&scene)
    };
    let still = run(&ground);
    let [stiff, stiffer] = [1e10, 1e11].map(|stiffness| {
        let history = on_pier(stiffness);
        assert!(history.energy().balance().holds(), "{:?}", history.energy().ledger(2.0));
        let apart = |t: f64| (history.motion(0, t).displacement - still.motion(0, t).displacement).length();
        (0..=100).map(|i| apart(0.02 * f64::from(i))).fold(0.0, f64::max)
    });
    assert!((9.0..11.0).contains(&(stiff / stiffer)), "the difference goes with 1/k: {stiff:e}, {stiffer:e}");
    within("all but the ground", stiffer, 1e-3);
}

#[test]
fn the_impact_model_refuses_piers_in_words() {
    let mut scene = on_one_pier("", "");
    scene.model.kind = girderbench::scene::ModelKind::Impact;
    let errors = History::of(&scene).expect_err("refused").to_string();
    assert!(errors.contains("model.kind") && errors.contains("no piers"), "{errors}");
}
