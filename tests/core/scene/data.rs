//! What the numbers of a scene mean: bearings (5), ground motion, places; and that writing loses nothing.

use std::f64::consts::TAU;

use girderbench::scene::{
    Bearings, Kind, Motion, STANDARD_GRAVITY, Scene, Setting, format, overrides, placed, presets,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};

fn preset(name: &str, settings: &[&str]) -> Scene {
    let scene = presets::load(name).unwrap_or_else(|errors| panic!("{errors}"));
    overrides::apply_all(&scene, settings).unwrap_or_else(|errors| panic!("{errors}"))
}

fn bearings(scene: &Scene) -> &Bearings {
    scene.girders[0].bearings.as_ref().unwrap_or_else(|| panic!("{} has bearings", scene.name))
}

fn setting(kind: Kind) -> Setting {
    Setting { kind, gravity: STANDARD_GRAVITY }
}

#[test]
fn shared_bearings_together_have_the_stiffness_and_damping_asked_for() {
    let scene = preset("skew45-abutment", &["girder.deck.bearings.frequency_hz=[2.6, 3.1]"]);
    let legs = bearings(&scene).resolve(&scene.girders[0], setting(Kind::Planar));
    assert_eq!(legs.len(), 4, "four legs");
    let sum = |of: &dyn Fn(usize) -> f64| (0..4).map(of).sum::<f64>();
    for (axis, f) in [(0, 2.6), (1, 3.1)] {
        let (k, c) = (2.0 * (TAU * f).powi(2), 2.0 * 0.28 * 2.0 * TAU * f);
        let found = (sum(&|n| legs[n].stiffness[axis]), sum(&|n| legs[n].damping[axis]));
        // A few roundings.
        assert!((found.0 / k - 1.0).abs() < 1e-15 * 4.0, "k = m (2πf)² along axis {axis}: {} for {k}", found.0);
        assert!((found.1 / c - 1.0).abs() < 1e-15 * 4.0, "c = 2 h m (2πf) along axis {axis}: {} for {c}", found.1);
    }
    assert_eq!(legs[0].stiffness[2], 0.0, "a planar scene has no vertical");
    assert_eq!(legs[0].place.z, 0.0, "and stands at the height of G");
}

#[test]
fn skewed_places_follow_the_skew() {
    let straight = preset("straight-abutment", &[]);
    let at = |scene: &Scene| bearings(scene).resolve(&scene.girders[0], setting(Kind::Planar))[0].place;
    assert_eq!(at(&straight).to_array(), [0.07, 0.025, 0.0], "a straight girder: as written");
    let skewed = at(&preset("skew45-abutment", &[]));
    assert!((skewed.x - 0.095).abs() < 1e-16 * 4.0, "x + y cot 45°: {}", skewed.x);
}

#[test]
fn spatial_bearings_stand_at_the_underside_with_their_own_vertical() {
    let scene = preset("deck-30m", &[]);
    let legs = bearings(&scene).resolve(&scene.girders[0], setting(Kind::Spatial));
    assert_eq!(legs[0].place.z, -0.75, "half the thickness below G");
    let k = 600e3 * (TAU * 10.0).powi(2) / 4.0;
    assert!((legs[0].stiffness[2] / k - 1.0).abs() < 1e-15 * 4.0, "vertical: {} for {k}", legs[0].stiffness[2]);
    let c = 2.0 * 0.05 * 600e3 * TAU * 10.0 / 4.0;
    assert!((legs[0].damping[2] / c - 1.0).abs() < 1e-15 * 4.0, "vertical: {} for {c}", legs[0].damping[2]);
}

#[test]
fn single_bearings_are_taken_as_they_are() {
    let one = "girder.deck.bearings=[{ at_m = [1, 2], stiffness_n_per_m = [3, 4], damping_n_s_per_m = [5, 6, 7] }]";
    let scene = preset("deck-30m", &[one]);
    let found = bearings(&scene).resolve(&scene.girders[0], setting(Kind::Spatial))[0];
    assert_eq!(found.place.to_array(), [1.0, 2.0, -0.75], "true place");
    assert_eq!((found.stiffness, found.damping), ([3.0, 4.0, 0.0], [5.0, 6.0, 7.0]), "two or three numbers");
}

#[test]
fn right_angles_are_exact() {
    for (angle, direction) in
        [(0.0, [1.0, 0.0]), (90.0, [0.0, 1.0]), (180.0, [-1.0, 0.0]), (-90.0, [0.0, -1.0]), (450.0, [0.0, 1.0])]
    {
        let scene = preset("straight-abutment", &[&format!("motion.angle_deg={angle}")]);
        assert_eq!(scene.motion.direction(), direction, "{angle}°");
        let turned = preset("straight-abutment", &[&format!("girder.deck.heading_deg={angle}")]);
        assert_eq!(placed::axes(&turned.girders[0]).x_axis.to_array(), [direction[0], direction[1], 0.0], "{angle}°");
    }
}

#[test]
fn amplitudes_in_g_and_in_si_are_one() {
    let amplitude = |setting: &str| {
        let Motion::Sine(sine) = preset("straight-abutment", &[setting]).motion else { panic!("a sine") };
        sine.amplitude_si()
    };
    assert_eq!(amplitude("motion.amplitude_g=0.5"), 0.5 * 9.80665, "standard gravity");
    assert_eq!(amplitude("motion.amplitude_m_s2=3.924"), 3.924, "as given");
}

const PAGE: &str = include_str!("../../../docs/scene-format.md");

/// Rows of the page's tables about a key.
fn rows(key: &str) -> impl Iterator<Item = &'static str> {
    let start = format!("| `{key}` |");
    PAGE.lines().filter(move |line| line.starts_with(&start))
}

#[test]
fn the_page_names_every_default() {
    let text = "name = \"s\"\nduration_s = 1\n[[girder]]\nname = \"deck\"\nlength_m = 2\nwidth_m = 1\nthickness_m = 0.1\nmass_kg = 5\n";
    let scene = format::read(text, "s").unwrap_or_else(|errors| panic!("{errors}"));
    let tables = [toml::to_string(&scene), toml::to_string(&scene.girders[0].initial), toml::to_string(&scene.solver)];
    let tables =
        tables.into_iter().chain([toml::to_string(&scene.view.overlays), toml::to_string(&scene.girders[0].push)]);
    let given = ["name", "duration_s", "length_m", "width_m", "thickness_m", "mass_kg"];
    for line in tables.flat_map(|table| table.unwrap_or_default().lines().map(str::to_owned).collect::<Vec<_>>()) {
        let Some((key, value)) = line.split_once(" = ").filter(|(key, _)| !given.contains(key)) else { continue };
        let value = if key == "tolerance" { "1e-10" } else { value };
        assert!(
            rows(key).any(|row| row.contains(&format!("`{value}`"))),
            "a row for `{key}` with its default `{value}`"
        );
    }
}

#[test]
fn the_page_has_a_row_for_every_key() {
    let record = ["motion.kind=record", "motion.file=a.csv"];
    let single = ["girder.deck.bearings=[{ at_m = [1, 2], stiffness_n_per_m = [3, 4], damping_n_s_per_m = [5, 6] }]"];
    let pair = ["contact.pair=[{ between = [\"deck\", \"wall\"] }]"];
    let plot = ["view.plot=[{ y = [\"deck.x\"] }]"];
    let places: [(&[&str], &str); 16] = [
        (&[], ""),
        (&[], "girder.deck."),
        (&[], "girder.deck.bearings."),
        (&single, "girder.deck.bearings.0."),
        (&[], "girder.deck.initial."),
        (&[], "girder.deck.push."),
        (&[], "abutment.wall."),
        (&[], "contact."),
        (&pair, "contact.pair.0."),
        (&[], "motion."),
        (&record, "motion."),
        (&[], "solver."),
        (&[], "limits."),
        (&[], "view."),
        (&plot, "view.plot.0."),
        (&[], "view.overlays."),
    ];
    for (settings, place) in places {
        let scene = preset("skew45-abutment", settings);
        let errors = overrides::apply(&scene, &format!("{place}nothing=1")).expect_err("no such key").to_string();
        let known = errors.split("keys known here: ").nth(1).unwrap_or_else(|| panic!("{errors}"));
        for key in known.split(", ") {
            assert!(rows(key).next().is_some(), "docs/scene-format.md has a row for {place}{key}");
        }
    }
}

#[test]
fn the_example_of_the_page_is_a_scene() {
    let example = PAGE.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap_or_default();
    let scene = format::read(example, "docs/scene-format.md").unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(scene.contact.pairs.len(), 1, "all of it");
}

#[test]
fn the_page_lists_every_preset() {
    for preset in presets::all() {
        assert!(rows(preset.name).next().is_some(), "a row for {}", preset.name);
    }
}

proptest! {
    #![proptest_config(Config { cases: 500, rng_seed: RngSeed::Fixed(0x6769_7264), failure_persistence: None, ..Config::default() })]

    #[test]
    fn every_float_survives_writing(bits in prop::array::uniform12(any::<u64>()), which in 0..7_usize) {
        let mut scene = presets::load(presets::all()[which].name).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let mut next = bits.into_iter().map(f64::from_bits).map(|x| if x.is_nan() { 0.1 } else { x });
        let mut number = || next.next().unwrap_or(0.3);
        scene.duration = number();
        scene.girders[0].position = [number(), number(), number()];
        scene.girders[0].initial.velocity = [number(), number(), number()];
        scene.girders[0].heading_deg = number();
        scene.contact.mu_static = number();
        scene.contact.area = Some(number());
        scene.solver.tolerance = number();
        let text = format::write(&scene);
        prop_assert_eq!(format::parse(&text, "written"), Ok(scene), "{}", text);
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in "[\\[\\]{}=\"'a-z_0-9.,\n #+-]{0,200}") {
        let _ = format::read(&text, "noise");
    }

    #[test]
    fn no_override_makes_the_reader_panic(setting in "[a-z_.0-9=\\[\\]{}\"+-]{0,40}", which in 0..4_usize) {
        let scene = presets::load("skew45-abutment").map_err(|e| TestCaseError::fail(e.to_string()))?;
        let stem = ["", "girder.deck.", "motion.", "contact.pair."][which];
        let _ = overrides::apply(&scene, &format!("{stem}{setting}"));
    }
}
