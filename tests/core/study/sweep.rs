//! Sweeps: what the page about them says of measures.

use girderbench::scene::presets;
use girderbench::study::sweep::{MEASURES, Measure};

use crate::support::run;

#[test]
fn the_page_lists_every_measure() {
    let page = include_str!("../../../docs/sweep.md");
    let listed: Vec<String> = page
        .lines()
        .filter(|line| line.starts_with("| `") && line.matches(" | ").count() == 2)
        .map(str::to_owned)
        .collect();
    let row =
        |meaning: &str, name: &str, unit: &str| format!("| `{name}` | {unit} | {} |", meaning.replace('|', "\\|"));
    let wanted: Vec<String> = MEASURES.iter().map(|m| row(m.meaning, m.name, m.unit)).collect();
    assert_eq!(listed, wanted, "the same words in the same order");
}

#[test]
fn measures_of_what_a_scene_has_not_are_none() {
    let names = ["max_pier_drift", "max_pier_shear", "max_device_force", "max_stress"];
    for (preset, there) in [
        ("skew45-abutment", [false; 4]),
        ("viaduct-5", [true, true, false, false]),
        ("twin-span-restrained", [false, false, true, false]),
        ("deck-30m-elastic", [false, false, false, true]),
    ] {
        let mut scene = presets::load(preset).unwrap_or_else(|e| panic!("{e}"));
        scene.duration = scene.duration.min(4.0);
        let history = run(&scene);
        let values = names.map(|name| Measure::named(name).expect("known").of(&history));
        assert_eq!(values.map(|value| value.is_some_and(|value| value > 0.0)), there, "{preset}: {values:?}");
        let largest = history.connections().piers().iter().map(|pier| pier.drift.value).reduce(f64::max);
        assert_eq!(values[0], largest, "{preset}: the number of the run");
    }
}
