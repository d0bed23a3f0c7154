//! `run`: the files say what the history says, bit for bit, and the same every time.

use std::io::Read as _;
use std::path::Path;
use std::process::Stdio;

use crate::program::{Said, call, program, said};
use girderbench::scene::presets;
use girderbench::sim::History;
use girderbench::tables::read;

fn run_into(folder: &Path, args: &[&str]) -> String {
    let out = folder.to_str().expect("a UTF-8 path");
    let said = call(&[args, &["--out", out]].concat());
    assert_eq!(said.status, Some(0), "{args:?} runs: {}", said.err);
    said.out
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder for the tables")
}

fn bytes_of(folder: &Path, name: &str) -> Vec<u8> {
    std::fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name} is there: {error}"))
}

fn summary_of(folder: &Path) -> serde_json::Value {
    serde_json::from_slice(&bytes_of(folder, "summary.json")).expect("summary.json is JSON")
}

/// Rows of a table as maps from column to field.
fn rows_of(folder: &Path, name: &str) -> Vec<std::collections::BTreeMap<String, String>> {
    let bytes = bytes_of(folder, name);
    csv::Reader::from_reader(bytes.as_slice()).deserialize().map(|row| row.expect("a row of the table")).collect()
}

fn field(row: &std::collections::BTreeMap<String, String>, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} is a number: {}", row[name]))
}

#[test]
fn the_trajectory_is_the_history_to_the_last_bit() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--set", "duration_s=1.5", "--sample", "60"]);
    let table = read::trajectory(&bytes_of(folder.path(), "trajectory.csv")).expect("a table of numbers");
    let mut scene = presets::load("skew45-abutment").expect("a preset");
    scene.duration = 1.5;
    let history = History::of(&scene).expect("it runs");
    assert_eq!(table.t.len(), 91, "60 samples a second from 0 to 1.5 s, both included");
    for (i, &t) in table.t.iter().enumerate() {
        let expected = i as f64 / 60.0;
        assert_eq!(t.to_bits(), expected.to_bits(), "sample {i} is at i / 60");
        let motion = history.motion(0, t);
        let columns = [motion.displacement.x, motion.displacement.y, motion.theta, motion.velocity.x];
        for ((name, values), expected) in table.columns.iter().zip(columns) {
            // A table has no −0.
            assert_eq!(values[i].to_bits(), (expected + 0.0).to_bits(), "{name} at {t}");
        }
    }
}

#[test]
fn the_headers_are_as_promised() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--until", "0.5"]);
    let first_line =
        |name| String::from_utf8(bytes_of(folder.path(), name)).expect("text").lines().next().map(str::to_owned);
    let trajectory = first_line("trajectory.csv").expect("a header");
    assert_eq!(trajectory, "t,deck.x,deck.y,deck.theta,deck.vx,deck.vy,deck.omega", "planar");
    assert!(first_line("events.csv").expect("a header").starts_with("t,pair,kind,"), "events");
    let names: Vec<_> =
        std::fs::read_dir(folder.path()).expect("the folder").map(|e| e.expect("an entry").file_name()).collect();
    assert_eq!(names.len(), 4, "four tables and nothing half-written: {names:?}");
}

#[test]
fn a_flush_free_hit_leaves_the_tables_with_the_restitution_asked_for() {
    let folder = folder();
    run_into(folder.path(), &["run", "flush-free-hit"]);
    let rows = rows_of(folder.path(), "trajectory.csv");
    let (before, after) = (field(&rows[0], "deck.vx"), field(&rows[rows.len() - 1], "deck.vx"));
    // Relative to the approach; a run's own tolerance is 1e-10 and the hit takes a few dozen steps.
    assert!((after / before + 0.4).abs() < 1e-9, "e_n = 0.4, got {}", -after / before);
}

#[test]
fn contact_rows_add_up_and_hold_the_peak() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--until", "3"]);
    let (rows, summary) = (rows_of(folder.path(), "contacts.csv"), summary_of(folder.path()));
    let vector = |row: &_, name: &str| ["x", "y", "z"].map(|axis| field(row, &format!("{name}.{axis}")));
    let mut largest = 0.0_f64;
    for row in &rows {
        let (normal, force) = (vector(row, "normal"), vector(row, "force"));
        let (friction, dashpot) = (vector(row, "friction"), vector(row, "tangential_dashpot"));
        let along = field(row, "normal_force") + field(row, "normal_dashpot");
        let size = force.iter().map(|f| f * f).sum::<f64>().sqrt();
        for axis in 0..3 {
            let sum = along * normal[axis] + friction[axis] + dashpot[axis];
            // Four terms of the force's size, rounded once each, and the parts may cancel from ten times that.
            assert!((sum - force[axis]).abs() <= 1e-14 * (size + 100.0), "the parts are the force: {row:?}");
        }
        largest = largest.max(size);
    }
    let peak = summary["peak_force"].as_f64().expect("a number");
    assert!((largest - peak).abs() <= 1e-12 * peak, "the peak has its row: {largest} of {peak}");
    assert!(rows.iter().any(|row| row["why"] == "peak"), "and is marked");
    assert!(rows.iter().all(|row| ["stick", "slip"].contains(&row["state"].as_str())), "closed contacts only");
}

#[test]
fn every_event_that_leaves_a_contact_closed_has_contact_rows() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--until", "2"]);
    let (events, contacts) = (rows_of(folder.path(), "events.csv"), rows_of(folder.path(), "contacts.csv"));
    let touches: Vec<_> = events.iter().filter(|event| event["kind"].starts_with("open->")).collect();
    assert!(!touches.is_empty(), "the girder hits within 2 s");
    for event in touches {
        let row = contacts.iter().find(|row| row["t"] == event["t"] && row["node"] == event["node"]);
        assert!(row.is_some(), "a contact row for {event:?}");
    }
}

#[test]
fn the_summary_carries_accuracy_energy_and_digest() {
    let folder = folder();
    let printed = run_into(folder.path(), &["run", "skew45-abutment"]);
    let summary = summary_of(folder.path());
    let error = summary["estimated_error"].as_f64().expect("an estimate");
    assert!(error < 1e-6, "a tolerance of 1e-10 gives far better than a micrometre, got {error}");
    let (residual, scale) = (&summary["ledger"]["residual"], &summary["ledger"]["scale"]);
    let share = residual.as_f64().expect("a number").abs() / scale.as_f64().expect("a number");
    assert!(share < 1e-8, "the ledger balances, {share}");
    assert!(summary["run_time"].as_f64().expect("timed") > 0.0, "timed");
    assert_eq!(summary["pairs"][0]["law"], "paper", "says which law");
    for words in ["estimated error", "ledger residual", "largest rotation", "hits", "real time", "law paper"] {
        assert!(printed.contains(words), "{words} in {printed}");
    }
    let digest = call(&["run", "skew45-abutment", "--digest"]).out;
    assert_eq!(summary["digest"].as_str(), Some(digest.trim()), "the digest is of the answer, not of the files");
}

#[test]
fn no_row_is_beyond_the_summary_and_a_fine_table_comes_up_to_it() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--until", "4", "--sample", "20000"]);
    let table = read::trajectory(&bytes_of(folder.path(), "trajectory.csv")).expect("a table of numbers");
    let column = |name: &str| &table.columns.iter().find(|(have, _)| have == name).expect("the column").1;
    let turned = column("deck.theta").iter().copied().map(f64::abs).fold(0.0, f64::max);
    let moved = column("deck.x").iter().zip(column("deck.y")).map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    let summary = summary_of(folder.path());
    for (name, seen) in [("max_rotation", turned), ("max_displacement", moved)] {
        let said = summary[name].as_f64().expect("a number");
        // Between rows 50 µs apart a peak of 25 rad/s rises by (25 · 25e-6)² / 2 = 2e-7 of itself; rows that lie on
        // the peak may differ from it by rounding.
        assert!(seen <= said * (1.0 + 1e-9) && said <= seen * (1.0 + 1e-6), "{name}: {said} said, {seen} seen");
    }
}

#[test]
fn the_same_run_has_the_same_digest_and_another_has_another() {
    let digest = |args: &[&str]| {
        let said = call(&[&["run", "skew45-abutment", "--until", "1.5", "--digest"], args].concat());
        assert_eq!(said.status, Some(0), "runs: {}", said.err);
        assert_eq!(said.out.trim().len(), 16, "64 bits in hexadecimal: {}", said.out);
        said.out
    };
    let (first, again) = (digest(&[]), digest(&[]));
    assert_eq!(first, again, "bit for bit");
    assert_ne!(first, digest(&["--set", "motion.angle_deg=1"]), "an override reaches the run");
}

/// Two decks with a wall each, too far apart to meet: computed side by side where there are threads.
fn two_bridges() -> String {
    let bridge = |name: &str, y: f64| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nskew_deg = 45\n\
             mass_kg = 2.0\nposition_m = [0, {y}, 0]\n\
             bearings = {{ frequency_hz = 2.6, damping_ratio = 0.28, at_m = [[0.05, 0], [-0.05, 0]] }}\n\
             [[abutment]]\nname = \"{name}-wall\"\nfaces = \"{name}\"\ngap_m = 0.003\n"
        )
    };
    let motion = "[motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 2.6\n";
    let contact = "[contact]\nstiffness_n_per_m = 1.55e5\n";
    format!("name = \"two\"\nduration_s = 2\n{}{}{motion}{contact}", bridge("north", 5.0), bridge("south", -5.0))
}

#[test]
fn the_number_of_threads_does_not_change_a_bit() {
    let folder = folder();
    let path = folder.path().join("two.toml");
    std::fs::write(&path, two_bridges()).expect("the scene is written");
    let digest = |scene: &std::ffi::OsStr, threads: &str| {
        let mut command = program();
        command.env("RAYON_NUM_THREADS", threads).arg("run").arg(scene).args(["--until", "2", "--digest"]);
        let said = said(&command.output().expect("the program starts"));
        assert_eq!(said.status, Some(0), "runs: {}", said.err);
        said.out
    };
    for scene in [path.as_os_str(), "row-of-5".as_ref()] {
        assert_eq!(digest(scene, "1"), digest(scene, "4"), "one thread or four: {}", scene.display());
    }
}

#[test]
fn set_changes_what_is_run() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--set", "motion.kind=none", "--set", "duration_s=0.2"]);
    let rows = rows_of(folder.path(), "trajectory.csv");
    assert!(rows.iter().all(|row| field(row, "deck.x") == 0.0), "nothing shakes, nothing moves");
    assert_eq!(rows.len(), 21, "to 0.2 s");
}

#[test]
fn a_spatial_scene_has_the_other_directions() {
    let folder = folder();
    run_into(folder.path(), &["run", "deck-30m", "--until", "0.2"]);
    let rows = rows_of(folder.path(), "trajectory.csv");
    for row in &rows {
        let q = ["qx", "qy", "qz", "qw"].map(|axis| field(row, &format!("deck.{axis}")));
        let length = q.iter().map(|q| q * q).sum::<f64>();
        assert!((length - 1.0).abs() < 1e-12, "a unit quaternion, {length}");
    }
    assert!(rows[0].contains_key("deck.vz") && rows[0].contains_key("deck.wx"), "rates too");
}

#[test]
fn a_reader_that_leaves_early_is_no_panic() {
    let mut child = program()
        .args(["run", "flush-free-hit"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let mut err = String::new();
    child.stderr.take().expect("piped").read_to_string(&mut err).expect("text");
    let status = child.wait().expect("it ends");
    assert_eq!(status.code(), Some(0), "the work was done: {err}");
    assert!(!err.contains("panicked"), "no panic: {err}");
}

#[test]
fn tables_have_no_sign_before_nothing() {
    let folder = folder();
    run_into(folder.path(), &["run", "straight-abutment", "--until", "1"]);
    for name in ["trajectory.csv", "contacts.csv", "events.csv", "summary.json"] {
        let text = String::from_utf8(bytes_of(folder.path(), name)).expect("text");
        let signed = text.split([',', ' ', '\n']).filter(|&field| field == "-0.0").count();
        assert_eq!(signed, 0, "{name} has no -0.0");
    }
}

#[test]
fn a_girder_that_leaves_its_seat_is_said_to() {
    let folder = folder();
    let args = ["run", "skew45-abutment", "--until", "1.5", "--set"];
    let short = run_into(folder.path(), &[&args[..], &["girder.deck.seat_m={ \"+x\" = 0.002 }"]].concat());
    assert!(short.contains("placed 1.414 mm (2.000 along the axis), least -"), "square to its edge: {short}");
    assert!(short.contains("(acute) comes off at "), "says so: {short}");
    assert!(short.contains("of a single corner at "), "whose force it is: {short}");
    let seat = &summary_of(folder.path())["seats"][0];
    let [one, other] = [0, 1].map(|i| &seat["corners"][i]);
    let least = |corner: &serde_json::Value| corner["least_remaining"].as_f64().expect("a length");
    let worse = if least(one) < least(other) { one } else { other };
    assert!(short.contains(&format!(" at corner {} (", worse["corner"])), "and which corner is worse: {short}");
    let [left, farthest] = ["left_at", "t"].map(|key| seat[key].as_f64().expect("a time"));
    assert!(0.0 < left && left < farthest, "it leaves before it is farthest off: {seat}");
    let long = run_into(folder.path(), &[&args[..], &["girder.deck.seat_m={ \"+x\" = 0.2 }"]].concat());
    assert!(
        long.contains("placed 141.421 mm (200.000 along the axis)") && !long.contains("comes off"),
        "stays: {long}"
    );
    assert!(summary_of(folder.path())["seats"][0]["left_at"].is_null(), "never left");
}

#[test]
fn limits_that_are_passed_are_said() {
    let said = call(&["run", "skew45-abutment", "--until", "1", "--set", "limits.rotation_deg=0.01"]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    assert!(said.out.contains("limit passed") && said.out.contains("limit rotation_deg passed at "), "{}", said.out);
    let kept = call(&["run", "skew45-abutment", "--until", "1", "--set", "limits.rotation_deg=44"]);
    assert!(!kept.out.contains("limit passed"), "kept: {}", kept.out);
}

#[test]
fn check_prints_the_contact_numbers_of_the_paper() {
    let said = call(&["check", "skew45-abutment"]);
    assert_eq!(said.status, Some(0), "checks: {}", said.err);
    // (69b) against a wall, condition (6) of the 45° girder, and the gap and stiffness of the preset.
    for words in ["311.79", "37.32", "1.357", "1.550000e5", "gap 3 mm", "law paper", "deck.corner", "ω_x", "h_θ"] {
        assert!(said.out.contains(words), "{words} in {}", said.out);
    }
}

#[test]
fn check_prints_everything_that_was_understood() {
    let sets = [
        "girder.deck.held=[\"yaw\"]",
        "girder.deck.initial.velocity_m_s=[0.2, 0]",
        "girder.deck.push.force_n=[7, 0]",
        "girder.deck.heading_deg=12",
        "solver.tolerance=1e-9",
        "view.camera=side",
    ];
    let flags = sets.iter().flat_map(|set| ["--set", set]);
    let said = call(&["check", "deck-30m"].into_iter().chain(flags).collect::<Vec<_>>());
    let of_girder =
        ["heading 12°", "0.2, 0, 0 m/s", "pushed by 7, 0, 0 N", "held in yaw", "1.5 m under +x", "ω_z", "h_z"];
    let of_scene = ["spatial, gravity 9.80665 m/s²", "event-driven", "1e-9", "view: side", "gap 50 mm"];
    for words in of_girder.into_iter().chain(of_scene) {
        assert!(said.out.contains(words), "{words} in {} {}", said.out, said.err);
    }
    let straight = call(&["check", "straight-abutment"]).out;
    for words in ["= 0.000: it cannot rotate", "m/s² (", "phase", "planar"] {
        assert!(straight.contains(words), "{words} in {straight}");
    }
}

#[test]
fn compare_finds_no_difference_between_a_scene_and_its_own_tables() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--until", "1.5"]);
    let out = folder.path().to_str().expect("a UTF-8 path");
    let same = call(&["compare", "skew45-abutment", out, "--until", "1.5"]);
    assert_eq!(same.status, Some(0), "compares: {}", same.err);
    assert!(same.out.contains("151 instants in both") && same.out.matches("never").count() == 6, "{}", same.out);
    let other = call(&["compare", "skew60-abutment", out, "--until", "1.5"]);
    assert!(other.out.matches("never").count() < 6, "another girder parts: {}", other.out);
    let last = |said: &Said| said.out.lines().last().map(str::to_owned).unwrap_or_default();
    assert_eq!(last(&same), "agree to 0 of the largest of each quantity", "the verdict");
    // Both fly alike on like bearings and meet their walls at the same time: they part at the first row after that.
    let hit = field(&rows_of(folder.path(), "events.csv")[0], "t");
    let parts = format!("part at t = {} s: deck.x", (hit * 100.0).ceil() / 100.0);
    assert!(last(&other).starts_with(&parts), "{parts}, but the verdict: {}", last(&other));
}

#[test]
fn presets_are_listed_with_a_line_each() {
    let listed = said(&program().arg("presets").output().expect("the program starts"));
    assert_eq!(listed.out.lines().count(), presets::all().len(), "a line each");
    for preset in presets::all() {
        assert!(listed.out.contains(preset.name), "{} is listed", preset.name);
        assert_eq!(call(&["check", preset.name]).status, Some(0), "{} is sound", preset.name);
    }
}

#[test]
fn version_is_said() {
    assert_eq!(call(&["--version"]).out.trim(), concat!("girderbench ", env!("CARGO_PKG_VERSION")), "name and version");
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing_half_written() {
    let folder = folder();
    let out = folder.path().join("results");
    let mut child = program()
        .args(["run", "skew45-abutment", "--until", "100000", "--out"])
        .arg(&out)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    std::thread::sleep(std::time::Duration::from_millis(300));
    // Not INT: what is started in the background by a script ignores that, and so do its children.
    let interrupt = std::process::Command::new("kill").args(["-TERM", &child.id().to_string()]).status();
    assert!(interrupt.expect("kill is there").success(), "it was still running");
    let status = child.wait().expect("it ends");
    assert_eq!(status.code(), None, "ended by the signal");
    assert!(!out.exists(), "nothing was written");
}

#[test]
fn both_models_are_written_side_by_side() {
    let folder = folder();
    run_into(folder.path(), &["run", "skew45-abutment", "--set", "model.kind=both"]);
    let read = |name: &str| String::from_utf8(bytes_of(folder.path(), name)).expect("UTF-8");
    let header = "t,deck.x,deck.y,deck.theta,deck.vx,deck.vy,deck.omega,deck.state\n";
    assert!(read("impact-trajectory.csv").starts_with(header), "the state is a column");
    assert!(read("impact-hits.csv").contains("\"Table 9, row 9\""), "the first hit names its row");
    assert!(read("impact-transitions.csv").contains("接触滑り回転"), "the state by the paper's name");
    assert!(!read("trajectory.csv").contains("state"), "the contact model has no such states");
    let summary: serde_json::Value = serde_json::from_str(&read("impact-summary.json")).expect("JSON");
    assert_eq!(summary["model"], "impact", "who computed it");
    assert!(summary["ledger"]["loss_hits"].as_f64().is_some_and(|lost| lost > 0.0), "hits lose energy");
}

#[test]
fn the_impact_model_is_refused_in_space() {
    let said = call(&["run", "deck-30m", "--set", "model.kind=impact"]);
    assert_eq!(said.status, Some(2), "bad input");
    assert!(said.err.contains("model.kind") && said.err.contains("planar"), "place and remedy: {}", said.err);
}
