//! Bad input: each kind is answered with exit status 2 and a line that names file, place, value and remedy.

use std::path::PathBuf;

use crate::program::call;

/// A scene without fault, to be spoilt in one place.
const SOUND: &str = r#"format = 1
name = "sound"
kind = "planar"
duration_s = 0.1

[[girder]]
name = "deck"
length_m = 0.190
width_m = 0.070
thickness_m = 0.020
skew_deg = 45.0
mass_kg = 2.0
position_m = [0.0, 0.0, 0.0]
bearings = { frequency_hz = 2.6, damping_ratio = 0.28, at_skewed_m = [[0.07, 0.025], [-0.07, -0.025]] }

[[abutment]]
name = "wall"
faces = "deck"
end = "+x"
gap_m = 0.003
width_m = 2.0
height_m = 0.06

[contact]
stiffness_n_per_m = 1.55e5
restitution_normal = 0.4
restitution_tangential = 0.9
mu_static = 0.20
mu_kinetic = 0.15

[motion]
kind = "sine"
amplitude_g = 0.40
frequency_hz = 2.6
"#;

/// A second girder for scenes that need one.
const SECOND: &str = "[[girder]]\nname = \"second\"\nlength_m = 0.190\nwidth_m = 0.070\nthickness_m = 0.020\n\
                      skew_deg = 45.0\nmass_kg = 2.0\nposition_m = [-0.180, 0.0, 0.0]\n\n[[abutment]]";

/// What is written in place of what, and what the complaint must name: the place and the value that stands there.
struct Fault {
    what: &'static str,
    from: &'static str,
    to: &'static str,
    names: &'static [&'static str],
}

const fn fault(what: &'static str, from: &'static str, to: &'static str, names: &'static [&'static str]) -> Fault {
    Fault { what, from, to, names }
}

#[rustfmt::skip]
const FAULTS: &[Fault] = &[
    fault("not TOML", "[contact]", "[contact", &["line "]),
    fault("unknown key", "mass_kg = 2.0", "mass_kg = 2.0\ncolour = 3", &["girder.deck", "colour"]),
    fault("misspelt key", "mu_static", "mu_statik", &["contact", "mu_statik", "mu_static"]),
    fault("missing key", "mass_kg = 2.0\n", "", &["girder.deck", "mass_kg"]),
    fault("wrong type", "mass_kg = 2.0", "mass_kg = \"heavy\"", &["girder.deck.mass_kg", "heavy"]),
    fault("unknown word", "kind = \"planar\"", "kind = \"flat\"", &["kind", "flat", "planar"]),
    fault("not a number", "mass_kg = 2.0", "mass_kg = nan", &["girder.deck.mass_kg", "nan"]),
    fault("infinite", "gap_m = 0.003", "gap_m = inf", &["abutment.wall.gap_m", "inf"]),
    fault("zero mass", "mass_kg = 2.0", "mass_kg = 0.0", &["girder.deck.mass_kg", "0"]),
    fault("negative mass", "mass_kg = 2.0", "mass_kg = -2.0", &["girder.deck.mass_kg", "-2"]),
    fault("zero length", "length_m = 0.190", "length_m = 0", &["girder.deck.length_m", "0"]),
    fault("negative thickness", "thickness_m = 0.020", "thickness_m = -0.02", &["girder.deck.thickness_m", "-0.02"]),
    fault("zero stiffness", "1.55e5", "0.0", &["contact.stiffness_n_per_m", "0"]),
    fault("zero duration", "duration_s = 0.1", "duration_s = 0.0", &["duration_s", "0"]),
    fault("skew of a line", "skew_deg = 45.0", "skew_deg = 180.0", &["girder.deck.skew_deg", "180"]),
    fault("negative skew", "skew_deg = 45.0", "skew_deg = -45.0", &["girder.deck.skew_deg", "-45"]),
    fault("restitution of zero", "restitution_normal = 0.4", "restitution_normal = 0.0", &["contact.restitution_normal", "0"]),
    fault("restitution above one", "restitution_tangential = 0.9", "restitution_tangential = 1.1", &["contact.restitution_tangential", "1.1"]),
    fault("kinetic above static", "mu_kinetic = 0.15", "mu_kinetic = 0.25", &["contact.mu_kinetic", "0.25"]),
    fault("negative friction", "mu_static = 0.20", "mu_static = -0.2", &["contact.mu_static", "-0.2"]),
    fault("a faceless abutment", "faces = \"deck\"", "faces = \"dekc\"", &["abutment.wall.faces", "dekc"]),
    fault("duplicate names", "name = \"wall\"", "name = \"deck\"", &["deck"]),
    fault("a pair of nobody", "[motion]", "[[contact.pair]]\nbetween = [\"deck\", \"ghost\"]\n\n[motion]", &["contact.pair", "ghost"]),
    fault("a face that is not flat", "gap_m = 0.003\nwidth_m = 2.0\nheight_m = 0.06",
          "polygon_m = [[0.2, 1, -1], [0.2, -1, -1], [0.2, -1, 1], [0.3, 1, 1]]", &["abutment.wall.polygon_m"]),
    fault("a face that is not convex", "gap_m = 0.003\nwidth_m = 2.0\nheight_m = 0.06",
          "polygon_m = [[0.2, 1, -1], [0.2, 0.9, 0.9], [0.2, -1, 1], [0.2, 1, 1]]", &["abutment.wall.polygon_m"]),
    fault("bodies in each other", "[[abutment]]", SECOND, &["second"]),
    fault("a negative interval", "kind = \"sine\"\namplitude_g = 0.40\nfrequency_hz = 2.6",
          "kind = \"record\"\nsamples_m_s2 = [0, 1, 0]\ndt_s = -0.01", &["motion.dt_s", "-0.01"]),
    fault("a record that is not there", "kind = \"sine\"\namplitude_g = 0.40\nfrequency_hz = 2.6",
          "kind = \"record\"\nfile = \"nowhere.csv\"", &["motion.file", "nowhere.csv"]),
    fault("bearings in mm", "[[0.07, 0.025], [-0.07, -0.025]]", "[[70, 25], [-70, -25]]", &["girder.deck.bearings", "in m"]),
    fault("a bearing on another planet", "[[0.07, 0.025], [-0.07, -0.025]]", "[[1e15, 25], [-70, -25]]", &["girder.deck.bearings", "in m"]),
    fault("a later format", "format = 1", "format = 2", &["format", "2"]),
];

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder for the scene")
}

fn write(folder: &tempfile::TempDir, text: &[u8]) -> PathBuf {
    let path = folder.path().join("spoilt.toml");
    std::fs::write(&path, text).expect("the scene is written");
    path
}

/// What a call lacks of a complaint: the status, an empty answer, and one line that names the file and all else.
fn lacks(args: &[&str], names: &[&str]) -> Option<String> {
    let said = call(args);
    let line = said.err.lines().find(|line| names.iter().all(|name| line.contains(name)));
    // error, file, place, and the value with its remedy
    let whole = line.is_some_and(|line| line.split(": ").count() >= 4 && line.contains("; "));
    let good = said.status == Some(2) && said.out.is_empty() && whole;
    (!good).then(|| format!("{names:?}: status {:?}, said {}", said.status, said.err))
}

fn expect_complaint(args: &[&str], names: &[&str], what: &str) {
    let lack = lacks(args, names);
    assert_eq!(lack, None, "{what}");
}

#[test]
fn the_sound_scene_is_sound() {
    let folder = folder();
    let path = write(&folder, SOUND.as_bytes());
    let said = call(&["check", path.to_str().expect("a UTF-8 path")]);
    assert_eq!(said.status, Some(0), "nothing to complain about: {}", said.err);
}

#[test]
fn every_fault_in_a_file_is_named() {
    let mut lacking = Vec::new();
    for fault in FAULTS {
        let folder = folder();
        let spoilt = SOUND.replace(fault.from, fault.to);
        assert_ne!(spoilt, SOUND, "{}: the text to spoil is there", fault.what);
        let path = write(&folder, spoilt.as_bytes());
        let args = ["run", path.to_str().expect("a UTF-8 path")];
        let lack = lacks(&args, &[&["spoilt.toml"], fault.names].concat());
        lacking.extend(lack.map(|lack| format!("{}: {lack}", fault.what)));
    }
    assert!(lacking.is_empty(), "each fault is named:\n{}", lacking.join("\n"));
}

#[test]
fn bytes_that_are_no_text_are_named_by_place() {
    let folder = folder();
    let path = write(&folder, b"format = 1\nname = \"\xff\xfe\"\n");
    expect_complaint(
        &["check", path.to_str().expect("a UTF-8 path")],
        &["spoilt.toml", "byte 19", "UTF-8"],
        "not UTF-8",
    );
}

#[test]
fn of_many_complaints_the_first_are_told_and_how_many_there_are() {
    let folder = folder();
    let girder = |i: usize| {
        format!(
            "[[girder]]\nname = \"g{i}\"\nlength_m = -1.0\nwidth_m = 1.0\nthickness_m = 1.0\nmass_kg = 1.0\nposition_m = [{i}.0, 0.0, 0.0]\n"
        )
    };
    let text: String = (0..30).map(girder).collect();
    let path = write(&folder, format!("name = \"many\"\nduration_s = 1.0\n{text}").as_bytes());
    let said = call(&["check", path.to_str().expect("a path")]);
    let lines: Vec<&str> = said.err.lines().collect();
    assert!(lines.len() == 21 && lines[20].trim() == "and 10 more", "{}", said.err);
}

#[test]
fn a_scene_that_is_not_there_leads_to_the_presets() {
    expect_complaint(&["run", "nowhere.toml"], &["nowhere.toml", "skew45-abutment"], "no such file");
    expect_complaint(&["run", env!("CARGO_MANIFEST_DIR")], &[env!("CARGO_MANIFEST_DIR"), "directory"], "a folder");
}

#[test]
fn overrides_are_checked_like_the_file() {
    let set = |set: &str, names: &[&str]| expect_complaint(&["run", "skew45-abutment", "--set", set], names, set);
    set("girder.deck.skew_deg=190", &["girder.deck.skew_deg", "190"]);
    set("girder.deck.colour=3", &["girder.deck", "colour"]);
    set("girder.dekc.skew_deg=60", &["dekc"]);
    set("motion.angle_deg=north", &["motion.angle_deg", "north"]);
    set("girder.deck.mass_kg=nan", &["girder.deck.mass_kg", "nan"]);
    set("motion.angle_deg", &["motion.angle_deg"]);
}

#[test]
fn flags_are_checked() {
    for args in [
        &["run", "skew45-abutment", "--sample", "0"][..],
        &["run", "skew45-abutment", "--sample", "nan"],
        &["run", "skew45-abutment", "--until", "-1"],
        &["run", "skew45-abutment", "--tolerance", "inf"],
        &["run", "skew45-abutment", "--tolerance", "0.5"],
        &["run", "skew45-abutment", "--sample", "1e12", "--out", "never"],
        &["run"],
        &["shake", "skew45-abutment"],
        &["compare", "skew45-abutment"],
        &["compare", "skew45-abutment", env!("CARGO_MANIFEST_DIR")],
    ] {
        let said = call(args);
        assert_eq!(said.status, Some(2), "{args:?}: exit status 2, said {}", said.err);
        assert!(!said.err.is_empty(), "{args:?}: says why");
    }
}

#[test]
fn a_flag_hides_no_fault_of_the_file() {
    let folder = folder();
    for (from, to, flag, names) in [
        ("duration_s = 0.1", "duration_s = -1", ["--until", "1"], ["duration_s", "-1"]),
        ("[motion]", "[solver]\ntolerance = 2.0\n[motion]", ["--tolerance", "1e-9"], ["solver.tolerance", "2"]),
    ] {
        let spoilt = SOUND.replace(from, to);
        assert_ne!(spoilt, SOUND, "the text to spoil is there");
        let path = write(&folder, spoilt.as_bytes());
        let args = [&["run", path.to_str().expect("a UTF-8 path")], &flag[..]].concat();
        expect_complaint(&args, &[&["spoilt.toml"], &names[..]].concat(), "the file is checked as it stands");
    }
    expect_complaint(&["run", "flush-free-hit", "--tolerance", "0.5"], &["--tolerance", "0.5"], "the flag is named");
}

#[test]
fn flags_that_change_nothing_are_refused() {
    let folder = folder();
    let out = folder.path().to_str().expect("a UTF-8 path");
    assert_eq!(call(&["run", "flush-free-hit", "--out", out]).status, Some(0), "an answer to compare");
    for flag in [["--set", "duration_s=1"], ["--until", "1"], ["--tolerance", "1e-6"], ["--sample", "50"]] {
        let said = call(&[&["compare", out, out], &flag[..]].concat());
        assert_eq!((said.status, said.out.as_str()), (Some(2), ""), "{flag:?}: exit status 2, said {}", said.err);
        assert!(said.err.contains(flag[0]) && said.err.contains(out), "{flag:?}: names both: {}", said.err);
    }
}

#[test]
fn a_folder_is_tried_before_the_run() {
    let folder = folder();
    let path = write(&folder, b"a file, not a folder");
    let inside = path.join("deep").join("er");
    for out in [path.as_path(), inside.as_path()] {
        // A run of a thousand hours: only a program that looks first answers soon.
        let args = ["run", "skew45-abutment", "--until", "3.6e6", "--sample", "1", "--out"];
        let said = call(&[&args[..], &[out.to_str().expect("a UTF-8 path")]].concat());
        assert_eq!(said.status, Some(2), "exit status 2, said {}", said.err);
        assert!(said.err.contains("spoilt.toml"), "names it: {}", said.err);
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let folder = folder();
    let path = write(&folder, b"a file, not a folder");
    let out = path.to_str().expect("a UTF-8 path");
    let said = call(&["run", "flush-free-hit", "--out", out]);
    assert_eq!(said.status, Some(2), "exit status 2, said {}", said.err);
    assert!(said.err.contains("spoilt.toml"), "names it: {}", said.err);
    assert_eq!(std::fs::read(&path).expect("still there"), b"a file, not a folder", "and leaves it alone");
}

#[test]
fn no_folder_is_made_under_the_name_of_a_file() {
    let folder = folder();
    for name in ["a.jpg", "answer.CSV", "scene.toml"] {
        let path = folder.path().join(name);
        let said = call(&["run", "flush-free-hit", "--out", path.to_str().expect("a UTF-8 path")]);
        assert_eq!(said.status, Some(2), "exit status 2, said {}", said.err);
        assert!(said.err.contains(name) && said.err.contains("a folder is wanted"), "{}", said.err);
        assert!(!path.exists(), "{name} is not made");
    }
}

#[test]
fn the_scene_in_the_readme_is_sound() {
    let readme = include_str!("../../README.md");
    let scene = readme.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a scene in TOML");
    let folder = folder();
    let path = write(&folder, scene.as_bytes());
    let said = call(&["check", path.to_str().expect("a UTF-8 path")]);
    assert_eq!(said.status, Some(0), "nothing to complain about: {}", said.err);
}

#[test]
fn a_scene_that_no_model_can_take_is_refused_under_its_name() {
    for command in ["check", "run", "plot"] {
        let said = call(&[command, "span-as-built", "--set", "model.kind=\"impact\""]);
        assert_eq!(said.status, Some(2), "{command}: {}", said.err);
        assert!(said.err.contains("span-as-built: model.kind"), "{command} names the scene: {}", said.err);
    }
}
