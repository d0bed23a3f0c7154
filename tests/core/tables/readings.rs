//! What a designer reads off a run, against closed forms: extremes, seats, limits and when they are passed; quantities
//! by name.

use girderbench::scene::{
    AfterUnseating, Bearings, Limits, Motion, PlotSettings, PlotShows, Scene, Seat, format, presets,
};
use girderbench::sim::quantity::{OfContact, OfPair, Quantity};
use girderbench::sim::{Carrying, ContactState, ErrorEstimate, History, Unit, readings};
use girderbench::tables::{Report, TableOptions, devices, in_memory};

use crate::support::{run, scene, within};

/// Start speed \[m/s\], angular frequency of the bearings \[rad/s\].
const V: f64 = 0.02;

/// The straight girder on undamped bearings, set going along x over a still ground; it never touches its wall.
fn swinging() -> (Scene, f64) {
    let mut scene = presets::load("straight-abutment").expect("ships");
    scene.motion = Motion::None;
    scene.duration = 2.0;
    let girder = &mut scene.girders[0];
    girder.initial.velocity = [V, 0.0, 0.0];
    let Some(Bearings::Shared(shared)) = &mut girder.bearings else { panic!("equal bearings") };
    shared.damping_ratio = girderbench::scene::PerDirection::Both(0.0);
    let omega = std::f64::consts::TAU * shared.frequency_hz.xy()[0];
    scene.abutments[0].gap = Some(2.0 * V / omega);
    (scene, omega)
}

fn near(got: f64, wanted: f64, within: f64, what: &str) {
    assert!((got - wanted).abs() <= within, "{what}: {wanted}, got {got} (off by {:e})", got - wanted);
}

/// A deck that swings at 1 Hz from rest at 0.3 m/s: `v/ω sin ωt`, largest at a quarter of a second.
fn swing(until: f64) -> Scene {
    scene(&format!(
        "name = \"swing\"\nduration_s = {until}\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 8.0\nthickness_m = 1.2\n\
         mass_kg = 4e5\nbearings = {{ frequency_hz = 1.0, damping_ratio = 0.0, at_m = [[-13, -3], [-13, 3], [13, -3], [13, 3]] }}\n\
         initial = {{ velocity_m_s = [0.3, 0.0] }}\n"
    ))
}

#[test]
fn a_peak_between_the_last_two_looks_is_read_and_a_limit_below_it_is_passed() {
    let most = 0.3 / std::f64::consts::TAU;
    for until in [0.251, 0.255, 0.26, 0.27, 0.29, 0.4] {
        let mut scene = swing(until);
        scene.limits =
            Limits { bearing_displacement: Some(most - 1e-8), drift: Some(most - 1e-8), ..Limits::default() };
        let history = run(&scene);
        within("displacement", history.summary().max_displacement / most - 1.0, 1e-9);
        let moved = history.connections().bearings_reading(0).expect("bearings").deformation.1;
        within("bearing", moved.value / most - 1.0, 1e-9);
        let passed = readings::passed(&history);
        assert_eq!(passed.len(), 1 + 4, "until {until} s: the drift and four bearings: {passed:?}");
        // sin ωt = 1 − 2.1e-7 at 6.5e-4 rad before the peak.
        for passed in &passed {
            within("when", passed.t - 0.25, 2e-4);
        }
    }
}

#[test]
fn extremes_of_a_free_swing_are_the_closed_form_s() {
    let (scene, omega) = swinging();
    let history = History::of(&scene).expect("runs");
    let reading = readings::reading(&history, 0);
    for corner in reading.drift {
        near(corner.value, V / omega, 1e-12, "amplitude v/ω");
    }
    let bearings = reading.bearings.expect("it stands on some");
    near(bearings.deformation.1.value, V / omega, 1e-12, "of every bearing");
    let body = &history.model().girders()[0];
    let share = body.mass * omega * V / body.bearings.len() as f64;
    near(bearings.force.1.value, share, 1e-9 * share, "m ω v of all, equal shares");
    let gap = reading.gap.expect("it faces a wall");
    near(gap.value, V / omega, 1e-12, "twice the amplitude less once");
    // Flat at the top: the instant is as sharp as the square root of the height.
    let peaks = gap.t * omega / std::f64::consts::TAU - 0.25;
    near(peaks, peaks.round(), 1e-6, "a quarter of a period after a whole one");
    assert_eq!((reading.force, reading.rotation.value), (None, 0.0), "it touches nobody and does not turn");
}

#[test]
fn what_is_read_of_a_girder_ends_where_it_falls() {
    let (mut scene, omega) = swinging();
    let travel = 0.5 * V / omega;
    let girder = &mut scene.girders[0];
    girder.after_unseating = Some(AfterUnseating::Continue);
    let Some(Bearings::Shared(shared)) = &mut girder.bearings else { panic!("equal bearings") };
    shared.travel = Some(travel);
    let history = History::of(&scene).expect("runs");
    near(
        history.seats().sound_until(0),
        0.5f64.asin() / omega,
        1e-9,
        "all bearings lose their support at v/ω sin ωt = travel",
    );
    let far = history.motion(0, history.end()).displacement.length();
    assert!(far > 3.0 * travel && !history.events().is_empty(), "it is computed beyond: {far} m, and hits the wall");
    near(history.summary().max_displacement, travel, 1e-9, "until the fall");
    let reading = readings::reading(&history, 0);
    near(reading.bearings.expect("some").deformation.1.value, travel, 1e-9, "of the bearings");
    near(reading.drift[0].value, travel, 1e-9, "of a corner");
    assert!(history.hits().touches().is_empty(), "no touch before the fall: {:?}", history.hits().touches());
    let verdict = history.seats().verdict(0).expect("it falls");
    assert!(!verdict.stays() && verdict.words().starts_with("falls: "), "{}", verdict.words());
    let carrying = history.seats().carrying(0, history.end());
    assert!(!carrying.is_empty() && carrying.iter().all(|now| *now == Carrying::Lost), "{carrying:?}");
}

#[test]
fn the_ground_is_plotted_in_all_directions_that_it_moves_in() {
    let mut scene = presets::load("deck-30m").expect("ships");
    scene.duration = 0.1;
    let Motion::Sine(sine) = &mut scene.motion else { panic!("a sine") };
    (sine.angle_deg, sine.phase_deg) = (30.0, 10.0);
    (sine.vertical_amplitude, sine.vertical_phase_deg) = (Some(1.5), Some(70.0));
    let (amplitude, omega) = (sine.amplitude_si(), std::f64::consts::TAU * sine.frequency_hz);
    let history = History::of(&scene).expect("runs");
    let at = |name: &str, t: f64| {
        let quantity = Quantity::find(&history, name).unwrap_or_else(|| panic!("{name} is there"));
        assert_eq!(quantity.unit(), Unit::MetrePerSecond2, "{name}");
        quantity.at(&history, t)
    };
    let wave = |phase: f64, t: f64| (omega * t + phase.to_radians()).sin();
    for t in [0.0, 0.03, 0.1] {
        near(at("ground.x", t), amplitude * wave(10.0, t) * 30f64.to_radians().cos(), 1e-14, "A cos α");
        near(at("ground.y", t), amplitude * wave(10.0, t) * 30f64.to_radians().sin(), 1e-14, "A sin α");
        near(at("ground.z", t), 1.5 * wave(70.0, t), 1e-14, "A_z");
    }
    let plan = History::of(&swinging().0).expect("runs");
    assert_eq!(Quantity::find(&plan, "ground.z"), None, "nothing moves vertically in plan");
}

#[test]
fn a_limit_is_passed_when_the_closed_form_says() {
    let (mut scene, omega) = swinging();
    let limit = 0.6 * V / omega;
    scene.limits = Limits { drift: Some(limit), rotation_deg: Some(0.1), ..Limits::default() };
    let history = History::of(&scene).expect("runs");
    let passed = readings::passed(&history);
    let [drift] = &passed[..] else { panic!("the drift alone: {passed:?}") };
    assert_eq!((drift.limit.key(), drift.whose.as_str()), ("drift_m", scene.girders[0].name.as_str()), "names it");
    near(drift.t, (0.6f64).asin() / omega, 4e-9, "v/ω sin ωt = limit");
    near(drift.reached, V / omega, 1e-12, "as far as it goes");
    scene.limits = Limits { bearing_displacement: Some(limit), ..Limits::default() };
    let history = History::of(&scene).expect("runs");
    let passed = readings::passed(&history);
    assert_eq!(passed.len(), history.model().girders()[0].bearings.len(), "every bearing alike: {passed:?}");
    for (number, bearing) in passed.iter().enumerate() {
        assert_eq!(bearing.whose, format!("{}.bearing{}", scene.girders[0].name, number + 1), "names it");
        near(bearing.t, (0.6f64).asin() / omega, 4e-9, "v/ω sin ωt = limit");
        near(bearing.reached, V / omega, 1e-12, "as far as it goes");
    }
}

#[test]
fn a_seat_is_left_when_the_end_has_moved_its_length() {
    let (mut scene, omega) = swinging();
    let length = 0.8 * V / omega;
    scene.girders[0].seat = Seat { minus: Some(length), ..Seat::default() };
    scene.limits.remaining_seat = Some(0.5 * length);
    let history = History::of(&scene).expect("runs");
    let seat = readings::reading(&history, 0).seats[0];
    // The -x end leaves its seat by moving along +x, towards the middle of the girder.
    near(seat.off_at().expect("it falls"), 0.8f64.asin() / omega, 1e-12, "v/ω sin ωt = length");
    near(seat.lost_at.expect("both corners at once"), 0.8f64.asin() / omega, 1e-12, "v/ω sin ωt = length");
    for corner in seat.corners {
        near(corner.least.value, length - V / omega, 1e-12, "less than nothing, without turning both corners alike");
    }
    let passed = readings::passed(&history);
    near(passed[0].t, 0.4f64.asin() / omega, 4e-9, "half of it left");
}

#[test]
fn a_force_limit_is_passed_in_the_touch_that_reaches_it() {
    let mut scene = presets::load(presets::OPENING).expect("ships");
    let history = History::of(&scene).expect("runs");
    let peak = history.summary().peak_force;
    assert!(readings::passed(&history).is_empty(), "no limit, nothing to pass");
    scene.limits.force = Some(0.7 * peak);
    let history = History::of(&scene).expect("runs");
    let passed = readings::passed(&history);
    let [force] = &passed[..] else { panic!("one pair: {passed:?}") };
    near(force.reached, peak, 1e-9 * peak, "the peak");
    let first = history.hits().touches().iter().find(|t| t.peak_force > 0.7 * peak).expect("one does");
    assert!((first.start..=first.peak_time).contains(&force.t), "between its closing and its peak: {}", force.t);
    scene.limits.force = Some(1.01 * peak);
    assert!(readings::passed(&History::of(&scene).expect("runs")).is_empty(), "just above the peak");
}

#[test]
fn no_force_is_above_a_limit_before_it_is_passed() {
    // Two corners that touch from the start: the one whose touch is listed first passes either limit later than the other.
    let mut scene = scene(
        r#"
        name = "two corners"
        duration_s = 0.05
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        mass_kg = 3e5
        bearings = [{ at_m = [0.0, 0.0], stiffness_n_per_m = [1e7, 1e7], damping_n_s_per_m = [2e5, 2e5] }]
        initial = { velocity_m_s = [-0.32, 0.06], spin_deg_s = 0.49 }
        elastic = { area_m2 = 6.1, modes = 3 }
        [[abutment]]
        name = "west"
        faces = "deck"
        end = "-x"
        gap_m = 0.0
        [contact]
        stiffness_n_per_m = 7e8
        normal_law = "bilinear"
        "#,
    );
    for limit in [5e5, 1e6] {
        scene.limits.force = Some(limit);
        let history = History::of(&scene).expect("runs");
        let [passed] = &readings::passed(&history)[..] else { panic!("one pair") };
        for i in 0..2000 {
            let t = passed.t * f64::from(i) / 2000.0;
            let most = history.contacts().at(t).iter().map(|now| now.force.length()).fold(0.0, f64::max);
            assert!(most <= limit * (1.0 + 1e-6), "{most} N at {t} s before {passed:?}");
        }
    }
}

/// A girder of 600 t at 1 m/s against one of 300 t, in line or shifted sideways by a little \[m\].
fn hit(kind: &str, aside: f64) -> History {
    let deck = "length_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n";
    let text = format!(
        "name = \"hit\"\nkind = \"{kind}\"\nduration_s = 0.1\n{}[contact]\nstiffness_n_per_m = 1e9\nrestitution_normal = 0.5\n\
         mu_static = 0.0\nmu_kinetic = 0.0\n[limits]\ntotal_force_n = 8e6\n\
         [[girder]]\nname = \"a\"\n{deck}mass_kg = 6e5\nposition_m = [-15.01, 0, 0]\ninitial = {{ velocity_m_s = [1, 0] }}\n\
         [[girder]]\nname = \"b\"\n{deck}mass_kg = 3e5\nposition_m = [15.01, {aside}, 0]\n",
        if kind == "spatial" { "gravity_m_s2 = 0.0\n" } else { "" }
    );
    History::of(&scene(&text)).expect("runs")
}

#[test]
fn the_force_between_two_bodies_is_nowhere_above_its_peak() {
    // In space nodes at the top and at the bottom of a corner peak within microseconds, and the corner beside closes in between.
    for (angle, until) in [(40.0, 1.0), (-30.0, 0.9)] {
        let mut deck = presets::load("deck-30m").expect("ships");
        let Motion::Sine(shaking) = &mut deck.motion else { panic!("a sine shakes it") };
        (shaking.angle_deg, deck.duration) = (angle, until);
        let history = History::of(&deck).expect("runs");
        let hits = history.hits().poundings().iter().flat_map(|of| of.hits.iter().map(|hit| (of.pair, hit)));
        assert!(hits.clone().count() > 0, "it hits");
        for (pair, hit) in hits {
            let at = |look: u32| hit.start + (hit.end - hit.start) * f64::from(look) / 2000.0;
            let highest = (0..2000).map(|look| history.hits().resultant(pair, at(look)).length()).fold(0.0, f64::max);
            assert!(
                highest <= hit.peak.value * (1.0 + 1e-9),
                "{angle}°, {} s: {highest} N, told {:?}",
                hit.start,
                hit.peak
            );
        }
    }
}

#[test]
fn the_force_between_two_bodies_does_not_depend_on_how_many_corners_share_it() {
    let totals = [("planar", 0.0), ("planar", 1e-6), ("spatial", 0.0), ("spatial", 1e-6)].map(|(kind, aside)| {
        let history = hit(kind, aside);
        let summary = history.summary();
        let [(pair, most)] = history.hits().largest_resultants()[..] else { panic!("two bodies") };
        assert_eq!((summary.peak_total, summary.peak_total_time), (most.value, Some(most.t)));
        near(history.hits().resultant(pair, most.t).length(), most.value, 1e-6, "at that time");
        near(Quantity::Pair(pair, OfPair::Total).at(&history, most.t), most.value, 1e-6, "as a curve");
        let [passed] = &readings::passed(&history)[..] else { panic!("one limit") };
        assert_eq!((passed.limit.key(), passed.reached), ("total_force_n", most.value));
        near(history.hits().resultant(pair, passed.t).length(), 8e6, 1e3, "when it is passed");
        most.value
    });
    // Kelvin and Voigt: the largest of F = K δ + C δ̇ with M = 200 t and the damping of e = 0.5, found by hand.
    let (mass, stiffness, speed): (f64, f64, f64) = (2e5, 1e9, 1.0);
    let ratio = girderbench::contact::damping_ratio(0.5);
    let (omega, c) = ((stiffness / mass).sqrt(), 2.0 * ratio * (stiffness * mass).sqrt());
    let damped = omega * (1.0 - ratio * ratio).sqrt();
    let force = |t: f64| {
        let (sin, cos, fall) = ((damped * t).sin(), (damped * t).cos(), (-ratio * omega * t).exp());
        let depth = speed / damped * fall * sin;
        stiffness * depth + c * (speed * fall * cos - ratio * omega * depth)
    };
    let largest = (0..100_000).map(|i| force(1e-6 * f64::from(i))).fold(0.0, f64::max);
    for total in totals {
        near(total / largest, 1.0, 1e-6, "of all corners together");
    }
}

#[test]
fn every_quantity_has_a_name_of_its_own_and_a_finite_value() {
    for preset in ["row-of-5", "deck-30m", presets::OPENING] {
        let mut scene = presets::load(preset).expect("ships");
        scene.duration = scene.duration.min(2.0);
        let history = History::of(&scene).expect("runs");
        let all = Quantity::all(&history);
        let mut names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), all.len(), "{preset}: no name twice");
        let t = history.summary().peak_time.unwrap_or(0.5);
        for (name, quantity) in &all {
            assert_eq!(Quantity::find(&history, name), Some(*quantity), "{name} is found");
            assert!(quantity.at(&history, t).is_finite(), "{preset}: {name} at the peak");
        }
    }
}

#[test]
fn quantities_are_what_the_history_says() {
    let scene = presets::load(presets::OPENING).expect("ships");
    let history = History::of(&scene).expect("runs");
    let t = history.summary().peak_time.expect("a hit");
    let value = |name: &str| Quantity::find(&history, name).expect(name).at(&history, t);
    let motion = history.motion(0, t);
    assert_eq!(value("deck.theta"), motion.theta, "the same bits");
    let energy: f64 = ["kinetic", "bearings", "contacts", "lost-bearings", "lost-contacts", "friction"]
        .iter()
        .map(|of| value(&format!("energy.{of}")))
        .sum();
    let ledger = history.energy().ledger(t);
    let jumps = ledger.jump_slip + ledger.jump_open + ledger.jump_edge + ledger.jump_entry;
    near(energy + jumps, value("energy.work"), 1e-9 * ledger.scale, "what is stored and lost was worked");
    assert_eq!(Quantity::find(&history, "deck.theta").map(Quantity::unit), Some(Unit::Radian), "its unit");
    for now in history.contacts().at(t).iter().filter(|c| c.state == ContactState::Slip) {
        near(Quantity::Contact(now.contact, OfContact::Use).at(&history, t), 1.0, 1e-9, "on the rim while it slips");
    }
    assert_eq!(Quantity::find(&history, "nobody.x"), None, "nobody");
    assert_eq!(Quantity::find(&history, "energy.devices"), None, "a scene without devices");
}

#[test]
fn what_presets_plot_are_quantities_of_their_runs() {
    let mut plotted = 0;
    for preset in presets::all() {
        let mut scene = presets::load(preset.name).expect("ships");
        scene.duration = 0.01;
        let history = History::of(&scene).expect("runs");
        for name in scene.view.plots.iter().flat_map(|plot| plot.x.iter().chain(&plot.y)) {
            assert!(Quantity::find(&history, name).is_some(), "{}: {name}", preset.name);
            plotted += 1;
        }
    }
    assert!(plotted > 0, "there are some");
}

#[test]
fn limits_and_plots_are_kept_in_the_file() {
    let mut scene = presets::load(presets::OPENING).expect("ships");
    scene.limits = Limits {
        rotation_deg: Some(1.0),
        drift: Some(0.01),
        remaining_seat: Some(0.002),
        force: Some(50.0),
        total_force: Some(90.0),
        bearing_displacement: Some(0.02),
        pier_drift: Some(0.03),
    };
    scene.view.plots = vec![
        PlotSettings::over_time(vec!["energy.kinetic".into()]),
        PlotSettings { x: Some("deck.x".into()), ..PlotSettings::over_time(vec!["deck.y".into()]) },
        PlotSettings { shows: PlotShows::Response, log: true, ..PlotSettings::over_time(vec!["ground.x".into()]) },
    ];
    let again = format::parse(&format::write(&scene), "again").expect("reads");
    assert_eq!(again, scene, "as written");
    let bad = format::write(&scene).replace("drift_m = 0.01", "drift_m = -0.01");
    let complaint = format::parse(&bad, "bad").map(|s| girderbench::scene::validate::validate(&s)).expect("reads");
    assert!(complaint.expect_err("negative").to_string().contains("limits.drift_m"), "names the key");
}

#[test]
fn what_a_cable_did_is_the_closed_form_s() {
    // ω = √(K/m) = 10 rad/s; taut at 10 mm; the elastic peak would be v √(K m) = 1 kN.
    let cable = |more: &str| {
        let text = format!(
            "format = 1\nname = \"cable\"\nduration_s = 0.9\n[[girder]]\nname = \"deck\"\nlength_m = 3.0\nwidth_m = 1.0\n\
             thickness_m = 0.2\nmass_kg = 1000.0\ninitial = {{ velocity_m_s = [0.1, 0.0] }}\n[[restrainer]]\nname = \"cable\"\n\
             girder = \"deck\"\nat_m = [-1.5, 0.0]\nto_m = [-2.5, 0.0]\nslack_m = 0.01\nstiffness_n_per_m = 1e5\n{more}"
        );
        let scene = format::read(&text, "cable").unwrap_or_else(|errors| panic!("{errors}"));
        let history = History::of(&scene).expect("runs");
        let readings = history.connections().devices();
        assert_eq!(readings.len(), 1);
        (readings[0].clone(), String::from_utf8(in_memory(|out| devices(&history, out))).expect("a text"))
    };
    let (whole, table) = cable("");
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|row| row.split(',').collect()).collect();
    let states: Vec<_> = rows.iter().map(|row| (row[1], row[2])).collect();
    assert_eq!(states, [("cable", "slack"), ("cable", "taut"), ("cable", "slack")]);
    let slack_again: f64 = rows[2][0].parse().expect("a time");
    near(slack_again, 0.1 + 0.1 * std::f64::consts::PI, 1e-9, "half a period after it is taut");
    for row in &rows[1..] {
        near(row[3].parse().expect("a length"), 0.01, 1e-9, "elongation at its slack");
        near(row[6].parse().expect("a force"), 0.0, 1e-3, "no force where it sets in and ends");
    }
    near(whole.force.value, 1000.0, 1e-6, "peak");
    near(whole.force.t, 0.1 + 0.05 * std::f64::consts::PI, 1e-5, "a quarter of a period after it is taut");
    near(whole.first.expect("it acts"), 0.1, 1e-10, "taut");
    near(whole.deformation[1].value, 0.02, 1e-10, "slack and v/ω");
    near(whole.deformation[0].value, -0.1 * (0.9 - 0.2 - 0.1 * std::f64::consts::PI), 1e-9, "back past where it began");
    assert_eq!((whole.times, whole.part_of_strength, whole.yielded_at, whole.broke_at), (1, None, None, None));
    let (yields, _) = cable("yield_force_n = 500.0\npost_yield_stiffness_n_per_m = 0.0\nbreak_elongation_m = 0.0085\n");
    let at = 0.1 + 0.5f64.asin() / 10.0;
    near(yields.yielded_at.expect("it yields"), at, 1e-9, "F_y is half of the peak");
    near(yields.part_of_strength.expect("it has a strength"), 1.0, 1e-9, "at most its strength");
    // Under F_y alone from v cos 30° on: 3.5 mm more.
    let (speed, slowing) = (0.1 * 0.75f64.sqrt(), 0.5);
    let more = (speed - (speed * speed - 2.0 * slowing * 0.0035).sqrt()) / slowing;
    near(yields.broke_at.expect("it breaks"), at + more, 1e-9, "8.5 mm beyond its slack");
}

#[test]
fn an_error_that_is_known_of_a_part_of_the_run_says_so() {
    let history = hit("planar", 0.0);
    let said = |until: Option<f64>| {
        let options = TableOptions {
            estimated_error: Some(ErrorEstimate { error: 1e-9, rotation: 1e-10, stress: None, until }),
            ..TableOptions::default()
        };
        let json = String::from_utf8(Report::of(&history, &options).to_json()).expect("text");
        (
            json.contains("\"estimated_until\": 1.25"),
            girderbench::report::html(&history, &options).contains("as far as 1.2500 s"),
        )
    };
    assert_eq!((said(Some(1.25)), said(None)), ((true, true), (false, false)));
}

#[test]
fn a_bearing_that_yields_on_a_pier_is_listed_once() {
    let deck = scene(
        "name = \"deck\"\nkind = \"planar\"\nduration_s = 0.5\n[[girder]]\nname = \"deck\"\nlength_m = 30\nwidth_m = 10\n\
         thickness_m = 1.5\nmass_kg = 3e5\nbearings = { kind = \"lead-rubber\", at_m = [[12, 4], [-12, 4], [-12, -4], [12, -4]], \
         on_minus_x = \"p\", on_plus_x = \"p\" }\n[[pier]]\nname = \"p\"\nmass_kg = 1e5\nfrequency_hz = 2\n[motion]\nkind = \"sine\"\n\
         amplitude_g = 0.3\nfrequency_hz = 1\n",
    );
    let history = History::of(&deck).expect("runs");
    let table = String::from_utf8(in_memory(|out| devices(&history, out))).expect("a text");
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let of_first: Vec<&Vec<&str>> = rows.iter().filter(|row| row[1] == "deck.bearing1").collect();
    assert!(of_first.len() > 1, "it yields: {table}");
    assert_eq!(of_first.iter().filter(|row| row[0] == "0.0").count(), 1, "{table}");
    let mut seen: Vec<[&str; 2]> = rows.iter().map(|row| [row[0], row[1]]).collect();
    let all = seen.len();
    seen.dedup();
    assert_eq!(seen.len(), all, "no two rows of one device at one time");
}
