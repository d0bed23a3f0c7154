//! `girderbench identify`: runs of the program and histories of others recovered, bad tables refused.

use std::fmt::Write as _;
use std::path::Path;

use crate::program::call;

/// A decay of 3.8 Hz and h = 0.05 from 10 mm at 30 rows a second, rounded to a hundredth of a millimetre.
fn decay(folder: &Path, heading: &str) -> String {
    let (omega, h) = (std::f64::consts::TAU * 3.8, 0.05_f64);
    let damped = omega * (1.0 - h * h).sqrt();
    let mut table = format!("{heading}\n");
    for n in 0..150 {
        let t = f64::from(n) / 30.0;
        let x = 10.0 * (-h * omega * t).exp() * ((damped * t).cos() + h * omega / damped * (damped * t).sin());
        let _ = writeln!(table, "{t:.6},{x:.2}");
    }
    written(folder, "decay.csv", &table)
}

fn written(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).expect("written");
    path.to_str().expect("a UTF-8 path").to_owned()
}

/// The value of a line of the answer.
fn value(said: &str, label: &str) -> f64 {
    let line = said.lines().find(|line| line.trim_start().starts_with(label)).expect(label);
    let number = line.trim_start().trim_start_matches(label).split_whitespace().next().expect("a value");
    number.parse().unwrap_or_else(|_| panic!("{line}"))
}

#[test]
fn a_decay_is_identified_and_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = decay(folder.path(), "t_s,x_mm");
    let out = folder.path().join("fit");
    let said = call(&["identify", &file, "--out", out.to_str().expect("UTF-8")]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    assert!((value(&said.out, "natural frequency f") - 3.8).abs() < 1e-3, "{}", said.out);
    assert!((value(&said.out, "damping ratio h") - 0.05).abs() < 3e-4, "{}", said.out);
    assert!(said.out.contains("displacements in mm") && said.out.contains("a free decay"), "{}", said.out);
    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("decay-identified.json")).expect("JSON")).expect("sound");
    assert!((json["natural_frequency"]["value"].as_f64().expect("f") - 3.8).abs() < 1e-3, "{json}");
    assert!(
        json["natural_frequency"]["half_width_95"].as_f64().is_some_and(|half| half > 0.0 && half < 1e-3),
        "{json}"
    );
    let svg = std::fs::read_to_string(out.join("decay-identified.svg")).expect("a plot");
    assert!(svg.contains("least squares") && !svg.contains("NaN"), "both curves");
    let rows = std::fs::read_to_string(out.join("decay-identified.csv")).expect("a table");
    assert_eq!(rows.lines().count(), 151, "heading and rows");
}

#[test]
fn what_hardly_swings_is_said_to_lie_at_the_bound() {
    let folder = tempfile::tempdir().expect("a folder");
    // ω = 6 1/s, h = 1.5: two exponentials.
    let root = 1.25f64.sqrt();
    let [slow, fast] = [6.0 * (1.5 - root), 6.0 * (1.5 + root)];
    let x = |t: f64| 10.0 * (fast * (-slow * t).exp() - slow * (-fast * t).exp()) / (fast - slow);
    let mut table = "t_s,x_mm\n".to_owned();
    for t in (0..60).map(|n| f64::from(n) / 30.0) {
        let _ = writeln!(table, "{t},{}", x(t));
    }
    let file = written(folder.path(), "over.csv", &table);
    let said = call(&["identify", &file]);
    assert!(said.out.contains("highest that is looked for"), "{}{}", said.out, said.err);
    let said = call(&["identify", &decay(folder.path(), "t_s,x_mm")]);
    assert!(!said.out.contains("highest that is looked for"), "{}", said.out);
}

#[test]
fn a_run_under_a_sweep_is_identified_from_its_own_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let sweep = ["--set", "motion.kind=sweep", "--set", "motion.length_s=8"];
    let run = ["run", "skew45-abutment", "--set", "abutment.wall.gap_m=0.2", "--until", "8", "--out", out];
    assert_eq!(call(&[run.as_slice(), &sweep].concat()).status, Some(0), "it runs");
    let table = format!("{out}/trajectory.csv");
    let of = ["identify", &table, "--column", "deck.x", "--scene", "skew45-abutment"];
    let said = call(&[of.as_slice(), &sweep].concat());
    assert_eq!(said.status, Some(0), "{}", said.err);
    assert!((value(&said.out, "natural frequency f") - 2.6).abs() < 1e-9, "{}", said.out);
    assert!((value(&said.out, "damping ratio h") - 0.28).abs() < 1e-9, "{}", said.out);
    let held = call(&[of.as_slice(), &sweep, &["--frequency", "2.6", "--scaled"]].concat());
    assert!(held.out.contains("2.6 Hz, as given") && held.out.contains("factor of the ground motion"), "{}", held.out);
    let across = call(&[of.as_slice(), &sweep, &["--along", "90"]].concat());
    assert!(across.err.contains("does not move along 90°"), "{}", across.err);
    let pounding = call(&[of.as_slice(), &["--set", "motion.amplitude_g=0.1"]].concat());
    assert!(pounding.status == Some(0) && pounding.out.contains("otherwise than an oscillator"), "{}", pounding.out);
    assert!(pounding.err.contains("touches from"), "the scene with its wall hits: {}", pounding.err);
    let free = call(&[of.as_slice(), &sweep, &["--set", "abutment.wall.gap_m=0.2"]].concat());
    assert!(free.err.is_empty(), "nothing in reach: {}", free.err);
}

#[test]
fn gap_and_restitution_of_a_pounding_run_are_found_from_its_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let run = ["run", "straight-abutment", "--until", "2", "--sample", "30", "--out", out];
    assert_eq!(call(&run).status, Some(0), "it runs");
    let table = format!("{out}/trajectory.csv");
    let of = ["identify", &table, "--scene", "straight-abutment"];
    let fit = ["--fit", "abutment.wall.gap_m=0.0033", "--fit", "contact.restitution_normal=0.36", "--out", out];
    let said = call(&[of.as_slice(), &fit].concat());
    assert_eq!(said.status, Some(0), "{}", said.err);
    assert!((value(&said.out, "abutment.wall.gap_m") - 0.003).abs() < 1e-9, "{}", said.out);
    assert!((value(&said.out, "contact.restitution_normal") - 0.4).abs() < 1e-6, "{}", said.out);
    let svg = std::fs::read_to_string(folder.path().join("trajectory-fitted.svg")).expect("a plot");
    assert!(svg.contains("least squares") && svg.contains("y [mm]"), "both axes");
    for (flags, word) in [
        (vec!["--fit", "contact.restitution_normal"], "KEY=START"),
        (vec!["--fit", "contact.restitution_normal=2"], "does not run with contact.restitution_normal=2.0"),
        (vec!["--fit", "impact.mu_static=0.2"], "impact.mu_static do not show"),
        (vec!["--fit", "contact.mu_kinetic=0.1", "--girder", "other"], "--girder: give one of deck"),
        (vec!["--fit", "contact.mu_kinetic=0.1", "--to", "0.1"], "4 rows up to 0.1 s: give 20 rows"),
    ] {
        let said = call(&[of.as_slice(), &flags].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{flags:?}: {}", said.err);
    }
}

#[test]
fn bad_tables_and_flags_are_refused_with_a_remedy() {
    let folder = tempfile::tempdir().expect("a folder");
    let bare = decay(folder.path(), "t,x");
    let word = written(folder.path(), "word.csv", "t_s,x_mm\n0,1\n0.1,high\n");
    let still: Vec<String> = (0..50).map(|n| format!("{n},2")).collect();
    let still = written(folder.path(), "still.csv", &format!("t_s,x_mm\n{}", still.join("\n")));
    let short = written(folder.path(), "short.csv", "t_s,x_mm\n0,1\n0.1,2\n0.2,1\n");
    for (flags, word) in [
        (vec![bare.as_str()], "line 1: found the column x without a unit"),
        (vec![&bare, "--unit", "inch"], "m, cm, mm, um"),
        (vec![&word], "line 3: found `high`; column 2 must hold finite numbers"),
        (vec![&still], "give a history that moves"),
        (vec![&short], "give 10 at least"),
        (vec!["nowhere.csv"], "nowhere.csv"),
        (vec![&bare, "--unit", "mm", "--scaled"], "--scaled: give the ground motion"),
        (vec![&bare, "--unit", "mm", "--response"], "name the column of frequency in Hz f"),
        (vec![&bare, "--unit", "mm", "--scene", "no-scene"], "no-scene"),
        (vec![&bare, "--unit", "mm", "--from", "100"], "0 rows within the time asked for"),
        (vec![], "FILE"),
    ] {
        let said = call(&[&["identify"], flags.as_slice()].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{flags:?}: {}", said.err);
    }
}
