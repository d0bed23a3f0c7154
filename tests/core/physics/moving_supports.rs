//! Supports whose ground moves later or more than the ground of reference: shifts in time, superposition, limits, books
//! (`docs/physics.md#supports-that-move`).

use girderbench::dynamics::Model;
use girderbench::motion::support::GroundPath;
use girderbench::scene::{Abutment, NamedGround, Scene, overrides, presets, validate};
use girderbench::sim::moving_ground::moved_supports;
use girderbench::sim::{ErrorEstimate, History};
use girderbench::tables::{Report, TableOptions, trajectory};
use glam::DVec3;

use crate::support::{run, scene, within};

const DELAY: f64 = 0.137;

/// Displacement of the ground of reference \[m\].
fn ground(history: &History, t: f64) -> DVec3 {
    GroundPath::of(history.model().ground.clone()).at(t)[1]
}

/// Displacement of a girder against the place where the ground of reference was at the start \[m\].
fn absolute(history: &History, girder: usize, t: f64) -> DVec3 {
    history.motion(girder, t).displacement + ground(history, t)
}

fn times(duration: f64) -> impl Iterator<Item = f64> {
    (0..=200).map(move |i| duration * f64::from(i) / 200.0)
}

fn delayed(abutment: &mut Abutment) {
    abutment.delay = Some(DELAY);
}

/// A scene in which everything stands on ground that moves later is the scene on one ground, later.
fn shifted(mut scene: Scene, allowed: f64) {
    scene.solver.tolerance = 1e-11;
    let before = run(&scene);
    scene.abutments.iter_mut().for_each(delayed);
    scene.piers.iter_mut().for_each(|pier| pier.delay = Some(DELAY));
    scene.duration += DELAY;
    let after = run(&scene);
    assert!(after.energy().balance().holds(), "{:?}", after.energy().ledger(after.end()));
    let bodies = scene.girders.len();
    let (mut worst, mut turned) = (0.0f64, 0.0f64);
    for t in times(before.end()) {
        for girder in 0..bodies {
            let apart = absolute(&after, girder, t + DELAY) - absolute(&before, girder, t);
            worst = worst.max(apart.length());
            turned = turned.max((after.motion(girder, t + DELAY).theta - before.motion(girder, t).theta).abs());
        }
    }
    within("displacement", worst, allowed);
    within("rotation", turned, allowed);
    let touches = |history: &History| history.hits().touches().len();
    assert_eq!(touches(&after), touches(&before), "the same touches");
    let peak = |history: &History| history.hits().touches().iter().map(|touch| touch.peak_force).fold(0.0, f64::max);
    within("peak force", (peak(&after) - peak(&before)) / peak(&before).max(1.0), 1e-7);
}

#[test]
fn a_girder_and_its_abutment_on_ground_that_moves_later_do_the_same_later() {
    let mut scene = presets::load("skew45-abutment").expect("a preset");
    scene.duration = 2.0;
    for girder in &mut scene.girders {
        for end in girderbench::geometry::End::BOTH {
            assert!(girder.stand_on(end, Some(&scene.abutments[0].name)), "bearings");
        }
    }
    shifted(scene, 1e-9);
}

/// A deck on a pier that turns, under this motion.
fn on_a_pier(more: &str, motion: &str) -> Scene {
    scene(&format!(
        r#"
        name = "pier"
        duration_s = 5.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        mass_kg = 3e5
        bearings = {{ frequency_hz = 1.1, damping_ratio = 0.03, at_m = [[12, 4], [-12, 4], [-12, -4], [12, -4]], on_minus_x = "p", on_plus_x = "p" }}
        [[pier]]
        name = "p"
        mass_kg = 1.2e5
        stiffness_n_per_m = [2e7, 3e7]
        position_m = [2.0, 1.0]
        turn_stiffness_n_m_per_rad = 2e9
        {more}
        [motion]
        {motion}
        "#
    ))
}

#[test]
fn girders_on_piers_whose_feet_move_later_do_the_same_later() {
    let quake = "kind = \"synthetic\"\nlength_s = 5.0\npeak_g = 0.4\nangle_deg = 30.0";
    let pier = |more: &str| on_a_pier(more, quake);
    shifted(pier(""), 1e-9);
    shifted(pier("yield_force_n = [3e5, 4e5]"), 1e-8);
}

/// A straight girder between two abutments that it does not reach, on a spring of its own to each.
fn between(springs: [f64; 2], wave: &str) -> Scene {
    let [west, east] = springs;
    scene(&format!(
        r#"
        name = "between"
        duration_s = 4.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        mass_kg = 8e5
        bearings = [
            {{ at_m = [-14.0, 0.0], stiffness_n_per_m = [{west:?}, 1e7], damping_n_s_per_m = [1e5, 1e5], on = "west" }},
            {{ at_m = [14.0, 0.0], stiffness_n_per_m = [{east:?}, 1e7], damping_n_s_per_m = [1e5, 1e5], on = "east" }},
        ]
        [[abutment]]
        name = "west"
        faces = "deck"
        end = "-x"
        gap_m = 2.0
        [[abutment]]
        name = "east"
        faces = "deck"
        gap_m = 2.0
        [motion]
        kind = "sine"
        amplitude_g = 0.3
        frequency_hz = 1.3
        phase_deg = 90.0
        [solver]
        tolerance = 1e-12
        {wave}
        "#
    ))
}

#[test]
fn a_wall_before_soil_on_ground_that_moves_later_does_the_same_later() {
    let mut scene = presets::load("span-as-built").expect("a preset");
    scene.duration = 6.0;
    let names: Vec<String> = scene.abutments.iter().map(|abutment| abutment.name.clone()).collect();
    let ends: Vec<_> = scene.abutments.iter().map(|abutment| abutment.end).collect();
    for girder in &mut scene.girders {
        for (end, name) in ends.iter().zip(&names) {
            assert!(girder.stand_on(*end, Some(name)), "bearings");
        }
    }
    shifted(scene, 1e-8);
}

#[test]
fn a_wall_on_a_slider_before_soil_keeps_the_tolerance_on_ground_that_moves_later() {
    let mut scene = scene(
        r#"
        name = "wall"
        kind = "planar"
        duration_s = 2.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.6
        mass_kg = 3e5
        bearings = { frequency_hz = 0.8, damping_ratio = 0.05, at_m = [[12, 4], [12, -4], [-12, 4], [-12, -4]] }
        [[abutment]]
        name = "east"
        faces = "deck"
        gap_m = 2.0
        delay_s = 0.05
        [abutment.backfill]
        law = "bilinear"
        stiffness_n_per_m = 2.6e8
        ultimate_n = 3.5e6
        unloading_stiffness_n_per_m = 5e8
        base_displacement_m = 0.001
        wall_mass_kg = 15e3
        base_friction = 0.6
        [motion]
        kind = "sine"
        amplitude_g = 0.4
        frequency_hz = 0.75
        "#,
    );
    // An independent integration (SciPy's DOP853, relative tolerance 1e-12, every change of soil and slider an event) has the wall apart
    // from the soil at 0.7297234 s and the largest push up to then at 0.7215294 s.
    for (tolerance, allowed) in [(1e-10, 5e-8), (1e-8, 5e-7)] {
        scene.solver.tolerance = tolerance;
        let history = run(&scene);
        let soil = history.model().links.iter().position(|link| link.name == "east.soil").expect("the soil");
        let changes: Vec<f64> =
            history.connections().link_phases(soil).iter().map(|(t, _)| *t).filter(|t| *t > 0.7).collect();
        within("turn", changes[1] - 0.721_529_4, allowed);
        within("apart", changes[2] - 0.729_723_4, allowed);
        within("estimate", ErrorEstimate::of(&history).error, tolerance);
    }
}

#[test]
fn a_girder_on_springs_to_two_supports_follows_both() {
    // m y'' = −Σ k (y − x_s): the weighted sum of the answers on either ground, where damping has the same shares.
    let springs = [8e6, 8e6];
    let one = run(&between(springs, ""));
    let speed = 250.0;
    // The faces are 30 m + 2 · 2 m apart.
    let delay = 34.0 / speed;
    let two = run(&between(springs, &format!("[wave]\nspeed_m_per_s = {speed:?}")));
    assert!(two.energy().balance().holds(), "{:?}", two.energy().ledger(4.0));
    let mut worst = 0.0f64;
    for t in times(4.0) {
        let late = if t < delay { DVec3::ZERO } else { absolute(&one, 0, t - delay) };
        let wanted = 0.5 * (absolute(&one, 0, t) + late);
        worst = worst.max((absolute(&two, 0, t) - wanted).length());
    }
    within("superposition", worst, 1e-11);
    assert!(two.motion(0, 1.0).displacement.x.abs() > 1e-3, "it moves");
}

#[test]
fn factors_scale_the_share_of_a_support() {
    let springs = [8e6, 8e6];
    let one = run(&between(springs, ""));
    let mut scene = between(springs, "");
    scene.abutments[1].motion_factor = Some(0.4);
    let two = run(&scene);
    let mut worst = 0.0f64;
    for t in times(4.0) {
        worst = worst.max((absolute(&two, 0, t) - 0.7 * absolute(&one, 0, t)).length());
    }
    within("superposition", worst, 1e-11);
}

#[test]
fn a_fast_wave_is_one_ground_and_none_is_it_to_the_last_bit() {
    let scene = presets::load("span-as-built").expect("a preset");
    let scene = Scene { duration: 4.0, ..scene };
    let one = run(&scene);
    let mut same = scene.clone();
    for abutment in &mut same.abutments {
        (abutment.delay, abutment.motion_factor) = (Some(0.0), Some(1.0));
    }
    assert_eq!(run(&same).digest(), one.digest(), "no delay and the factor 1");
    let answer = |speed: f64| {
        let mut fast = scene.clone();
        fast.wave = Some(girderbench::scene::Wave { speed, angle_deg: 0.0 });
        let fast = run(&fast);
        times(2.0)
            .map(|t| (fast.motion(0, t).displacement - one.motion(0, t).displacement).length())
            .fold(0.0, f64::max)
    };
    let [slow, fast] = [answer(1e6), answer(1e8)];
    assert!(slow < 1e-4 && fast < 0.03 * slow, "{slow} and {fast} m: the difference falls with the speed");
}

#[test]
fn a_wave_from_the_other_side_gives_the_mirrored_answer() {
    let mut scene = between([5e6, 9e6], "[wave]\nspeed_m_per_s = 200.0\nangle_deg = 0.0");
    scene.abutments.iter_mut().for_each(|abutment| abutment.gap = Some(0.03));
    let there = run(&scene);
    let mut mirrored = between([9e6, 5e6], "[wave]\nspeed_m_per_s = 200.0\nangle_deg = 180.0");
    mirrored.abutments.iter_mut().for_each(|abutment| abutment.gap = Some(0.03));
    let girderbench::scene::Motion::Sine(sine) = &mut mirrored.motion else { panic!("a sine") };
    sine.amplitude_g = sine.amplitude_g.map(|a| -a);
    let back = run(&mirrored);
    assert!(!there.hits().touches().is_empty(), "it touches");
    assert!(there.energy().balance().holds(), "{:?}", there.energy().ledger(4.0));
    let mut worst = 0.0f64;
    for t in times(4.0) {
        worst = worst.max((there.motion(0, t).displacement.x + back.motion(0, t).displacement.x).abs());
    }
    within("mirror", worst, 1e-9);
}

/// The same with grounds of their own under the abutments, in place of `[motion]` or beside it.
fn on_grounds(springs: [f64; 2], motion: &str, grounds: [&str; 2]) -> Scene {
    let [west, east] = grounds;
    let own = format!("[[ground]]\nname = \"a\"\n{west}\n[[ground]]\nname = \"b\"\n{east}");
    let mut scene = between(springs, &own);
    scene = shaken(&scene, motion);
    for (abutment, name) in scene.abutments.iter_mut().zip(["a", "b"]) {
        abutment.ground = Some(name.to_owned());
    }
    validate::validate(&scene).expect("a sound scene");
    scene
}

/// The scene with another `[motion]`.
fn shaken(scene: &Scene, motion: &str) -> Scene {
    let setting = format!("motion={{ {} }}", motion.replace('\n', ", "));
    overrides::apply(scene, &setting).unwrap_or_else(|errors| panic!("{errors}"))
}

const STILL: &str = "kind = \"none\"";
const SINE: &str = "kind = \"sine\"\namplitude_g = 0.3\nfrequency_hz = 1.3\nphase_deg = 90.0";
const OTHER: &str = "kind = \"sine\"\namplitude_g = 0.2\nfrequency_hz = 0.9\nangle_deg = 40.0";
const RECORD: &str =
    "kind = \"record\"\ndt_s = 0.17\nscale = 2.0\nsamples_m_s2 = [0.0, 0.4, -0.6, 0.5, 0.0, -0.7, 0.2, 0.3, -0.2, 0.0]";

#[test]
fn supports_on_one_ground_of_their_own_are_a_scene_on_that_ground() {
    for ground in [SINE, RECORD] {
        let springs = [5e6, 9e6];
        let alone = run(&shaken(&between(springs, ""), ground));
        // Displacements are against the ground of [motion]: still, another sine, a record.
        for reference in [STILL, OTHER, RECORD] {
            let own = run(&on_grounds(springs, reference, [ground, ground]));
            assert!(own.energy().balance().holds(), "{:?}", own.energy().ledger(4.0));
            let apart = |t: f64| (absolute(&own, 0, t) - absolute(&alone, 0, t)).length();
            within("displacement", times(4.0).map(apart).fold(0.0, f64::max), 1e-11);
        }
    }
}

#[test]
fn a_girder_between_two_grounds_is_the_mean_of_those_on_either() {
    let springs = [8e6, 8e6];
    let alone = [SINE, RECORD].map(|ground| run(&on_grounds(springs, STILL, [ground, ground])));
    for reference in [STILL, OTHER] {
        let both = run(&on_grounds(springs, reference, [SINE, RECORD]));
        assert!(both.energy().balance().holds(), "{:?}", both.energy().ledger(4.0));
        let apart = |t: f64| {
            let mean = 0.5 * (absolute(&alone[0], 0, t) + absolute(&alone[1], 0, t));
            (absolute(&both, 0, t) - mean).length()
        };
        within("superposition", times(4.0).map(apart).fold(0.0, f64::max), 1e-11);
    }
}

#[test]
fn a_ground_of_its_own_under_a_pier_carries_it_as_motion_does() {
    let mut scene = on_a_pier("yield_force_n = [3e5, 4e5]", RECORD);
    scene.solver.tolerance = 1e-12;
    let before = run(&scene);
    let own = std::mem::take(&mut scene.motion);
    scene.grounds.push(NamedGround { name: "foot".into(), motion: own });
    scene.piers[0].ground = Some("foot".into());
    scene.piers[0].delay = Some(DELAY);
    scene.duration += DELAY;
    let after = run(&scene);
    assert!(after.energy().balance().holds(), "{:?}", after.energy().ledger(after.end()));
    let apart = |t: f64| (absolute(&after, 0, t + DELAY) - absolute(&before, 0, t)).length();
    within("displacement", times(5.0).map(apart).fold(0.0, f64::max), 1e-9);
}

#[test]
fn a_ground_that_no_support_names_changes_no_bit() {
    let plain = between([5e6, 9e6], "");
    let more = between([5e6, 9e6], &format!("[[ground]]\nname = \"a\"\n{RECORD}"));
    assert_eq!(run(&more).digest(), run(&plain).digest(), "as without");
}

#[test]
fn still_ground_is_no_later_under_a_wave() {
    let mut scene = on_grounds([5e6, 9e6], STILL, [SINE, SINE]);
    scene.abutments[0].ground = None;
    let alone = run(&scene);
    scene.wave = Some(girderbench::scene::Wave { speed: 100.0, angle_deg: 180.0 });
    assert_eq!(run(&scene).digest(), alone.digest(), "nothing of [motion] travels");
    let supports = scene.moving_supports().expect("the east one");
    assert!(supports.of_abutment(0).is_none() && supports.of_abutment(1).is_some(), "{supports:?}");
}

#[test]
fn tables_and_summary_tell_ground_from_what_stands_on_it() {
    let mut scene = on_a_pier("delay_s = 0.2", SINE);
    scene.duration = 1.0;
    let history = run(&scene);
    let options = TableOptions::default();
    let mut table = Vec::new();
    trajectory(&history, 1.0, &mut table).expect("it is written into memory");
    let table = String::from_utf8(table).expect("UTF-8");
    let columns: Vec<&str> = table.lines().next().expect("a head").split(',').collect();
    let different: std::collections::BTreeSet<&str> = columns.iter().copied().collect();
    assert_eq!(different.len(), columns.len(), "each column has a name of its own: {columns:?}");
    assert!(different.contains("p.x") && different.contains("p.ground.x"), "{columns:?}");
    let links: Vec<&str> = history.model().links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(links.iter().collect::<std::collections::BTreeSet<_>>().len(), links.len(), "devices too: {links:?}");
    let moved = Report::of(&history, &options).moved_supports;
    let [one] = &moved[..] else { panic!("one support: {moved:?}") };
    assert_eq!((one.name.as_str(), one.motion.delay, &one.ground), ("p", 0.2, &None), "whose, and how");
    assert!(one.largest > 0.0 && one.last <= one.largest, "{one:?}");
}

#[test]
fn frequencies_are_those_on_supports_that_stand_still() {
    let history = run(&Scene { duration: 0.5, ..on_a_pier("delay_s = 0.2", SINE) });
    let [x, y, _] = history.connections().bearing_quantities(0).omega.map(|omega| omega / std::f64::consts::TAU);
    within("f of the scene", (x - 1.1).abs().max((y - 1.1).abs()), 1e-14);
}

#[test]
fn a_support_drifts_where_its_record_does_not_end_as_that_of_the_ground_of_reference() {
    let record = |samples: &str| format!("kind = \"record\"\ndt_s = 0.2\nsamples_m_s2 = {samples}");
    let [rest, moving] = ["[0.0, 1.0, -1.0, 0.0]", "[0.0, 1.0, 0.0]"].map(record);
    let drifts = |motion: &str, grounds: [&str; 2]| {
        let scene = on_grounds([5e6, 9e6], motion, grounds);
        let model = Model::compile(&scene).expect("a model");
        moved_supports(&scene, &model).into_iter().map(|moved| moved.drift).collect::<Vec<_>>()
    };
    assert_eq!(drifts(&rest, [&rest, &rest]), [None, None], "all come to rest");
    let [west, east] = drifts(&rest, [&moving, &rest])[..] else { panic!("two supports") };
    assert!(west.is_some_and(|speed| (speed - 0.2).abs() < 1e-12) && east.is_none(), "one goes on: {west:?}, {east:?}");
    assert_eq!(drifts(&moving, [&moving, &moving]), [None, None], "all go on alike");
    assert_eq!(drifts(STILL, [&rest, SINE]), [None, None], "a sine has no end");
}
