//! Supports that stand on grounds of their own: what `check` and `run` say of them, and what a report draws.

use crate::program::call;

/// A deck between two abutments, the east one on a ground of its own with this record, and its bearings there on the abutment.
fn scene(folder: &std::path::Path, samples: &str) -> String {
    let text = format!(
        r#"format = 1
        name = "between"
        duration_s = 3.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.5
        skew_deg = 90.0
        mass_kg = 6e5
        bearings = {{ frequency_hz = 0.8, damping_ratio = 0.1, on_plus_x = "east", at_m = [[12, 4], [12, -4], [-12, 4], [-12, -4]] }}
        [[abutment]]
        name = "west"
        faces = "deck"
        end = "-x"
        gap_m = 0.9
        [[abutment]]
        name = "east"
        faces = "deck"
        end = "+x"
        gap_m = 0.9
        ground = "east bank"
        [[ground]]
        name = "east bank"
        kind = "record"
        dt_s = 0.5
        samples_m_s2 = {samples}
        [motion]
        kind = "record"
        dt_s = 0.5
        samples_m_s2 = [0.0, 0.4, -0.4, 0.0]
        "#
    );
    let path = folder.join("between.toml");
    std::fs::write(&path, text).expect("written");
    path.to_str().expect("UTF-8").to_owned()
}

/// One that ends at rest, and one that ends at 0.3 m/s.
const AT_REST: &str = "[0.0, 0.6, -0.6, 0.0]";
const MOVING: &str = "[0.0, 0.6, 0.0, 0.0]";

#[test]
fn check_says_which_bearings_stand_on_abutments() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path(), AT_REST);
    let check = call(&["check", &path]);
    assert!(check.out.contains("  2 of them on east\n"), "{}{}", check.out, check.err);
    let japanese = call(&["check", &path, "--lang", "ja"]);
    assert!(japanese.out.contains("うち 2 個は east の上"), "{}", japanese.out);
}

#[test]
fn records_that_leave_a_support_moving_are_warned_of() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path(), AT_REST);
    for args in [&["check", &path][..], &["run", &path]] {
        let said = call(args);
        assert_eq!(said.status, Some(0), "{}", said.err);
        assert!(!said.err.contains("ground under"), "both at rest: {}", said.err);
    }
    let path = scene(folder.path(), MOVING);
    let out = folder.path().join("out");
    for args in [&["check", &path][..], &["run", &path, "--out", out.to_str().expect("UTF-8")]] {
        let said = call(args);
        let words = "warning: ground under east: when its record and that of the ground of reference have ended it goes on \
                     moving at 0.3 m/s against that ground";
        assert!(
            said.err.contains(words) && said.err.contains("\"none\", \"linear\" or \"berg-housner\""),
            "{args:?}: {}",
            said.err
        );
    }
    let summary = std::fs::read_to_string(out.join("summary.json")).expect("a summary");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let support = &summary["moved_supports"][0];
    let drift = support["drift"].as_f64().expect("it drifts");
    assert!((drift - 0.3).abs() < 1e-12, "0.3 m/s: {support}");
    let (last, largest) = (support["last"].as_f64(), support["largest"].as_f64());
    assert!(last == largest && last > Some(0.5), "farthest at the end: {support}");
}

#[test]
fn a_report_draws_every_ground_that_a_support_stands_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path(), AT_REST);
    let out = folder.path().join("page.html");
    let said = call(&["report", &path, "--out", out.to_str().expect("UTF-8")]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    let page = std::fs::read_to_string(&out).expect("the page");
    for name in ["[motion] x", "east bank x"] {
        assert!(page.contains(&format!("<td>{name}</td>")), "its peak: {name}");
        // In the legends of the history and of the spectrum, and in the table.
        assert!(page.matches(name).count() >= 3, "{name}: {} times", page.matches(name).count());
    }
}

#[test]
fn an_earthquake_that_drifts_is_warned_of_where_it_travels() {
    let wave = ["check", "viaduct-5", "--set", "wave.speed_m_per_s=600"];
    let drifts = call(&wave);
    let words = "warning: its record leaves the ground moving at ";
    let once = drifts.err.matches(words).count() == 1 && drifts.err.contains("the farthest, g5.bearing1, by ");
    assert!(once && drifts.err.contains("longest_period_s"), "{}", drifts.err);
    let still = call(&[&wave[..], &["--set", "motion.longest_period_s=10"]].concat());
    assert!(still.status == Some(0) && !still.err.contains("leaves the ground"), "{}", still.err);
    let alone = call(&["check", "viaduct-5"]);
    assert!(!alone.err.contains("leaves the ground"), "one ground feels no drift: {}", alone.err);
}

#[test]
fn a_support_that_is_late_is_listed_once_though_its_backwall_moves() {
    let said = call(&["check", "span-as-built", "--set", "wave.speed_m_per_s=500"]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    for name in ["east", "west"] {
        let listed = said.out.lines().filter(|line| line.starts_with(&format!("ground under {name}:"))).count();
        assert!(listed <= 1, "{name}: {}", said.out);
    }
    assert!(said.out.contains("ground under "), "one of them is late: {}", said.out);
}
