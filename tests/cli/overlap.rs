//! Bodies that pass through each other: `check` warns before, `run` says so, and so does `summary.json`.

use crate::program::call;

/// Two girders side by side that swing towards each other and that no contact joins.
const TWINS: &str = r#"
name = "twin decks"
duration_s = 1
[contact]
between = "ends"
[[girder]]
name = "one"
length_m = 0.19
width_m = 0.07
thickness_m = 0.02
mass_kg = 2.0
bearings = { frequency_hz = 1.0, damping_ratio = 0.0, at_m = [[0.05, 0.0], [-0.05, 0.0]] }
initial = { velocity_m_s = [0, 0.1] }
[[girder]]
name = "two"
length_m = 0.19
width_m = 0.07
thickness_m = 0.02
mass_kg = 2.0
position_m = [0.02, 0.08, 0]
bearings = { frequency_hz = 1.0, damping_ratio = 0.0, at_m = [[0.05, 0.0], [-0.05, 0.0]] }
initial = { velocity_m_s = [0, -0.1] }
"#;

#[test]
fn what_passes_through_is_warned_of_and_reported() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("a UTF-8 path").to_owned();
    let (twins, out) = (path("twins.toml"), path("out"));
    std::fs::write(&twins, TWINS).expect("a scene");
    let checked = call(&["check", &twins]);
    assert_eq!(checked.status, Some(0), "a warning is no failure");
    assert!(checked.err.starts_with("warning: one and two: 10 mm apart as placed"), "{}", checked.err);
    // A preset whose pairs are all joined: nothing to warn of, and an empty list.
    for (scene, overlaps) in [(twins.as_str(), 1), ("skew45-abutment", 0)] {
        let said = call(&["run", scene, "--until", "0.5", "--out", &out]);
        assert_eq!(said.status, Some(0), "{}", said.err);
        let lines = said.out.lines().filter(|line| line.starts_with("  overlap ")).count();
        let text = std::fs::read_to_string(folder.path().join("out/summary.json")).expect("the summary");
        let summary: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let listed = summary["overlaps"].as_array().expect("a list");
        assert_eq!((lines, listed.len()), (overlaps, overlaps), "{scene}: {}\n{text}", said.out);
        if let [one] = &listed[..] {
            assert_eq!(one["bodies"], serde_json::json!(["one", "two"]), "{one}");
            // Each 0.1/(2π) m towards the other, over a gap of 10 mm, a quarter of a second after the start.
            let depth = 2.0 * 0.1 / (2.0 * std::f64::consts::PI) - 0.01;
            let found = |key: &str| one[key].as_f64().expect("a number");
            assert!((found("depth") - depth).abs() < 1e-12 && (found("deepest_at") - 0.25).abs() < 1e-6, "{one}");
            assert_eq!(one["intervals"][0][0], one["t"], "{one}");
        }
    }
}
