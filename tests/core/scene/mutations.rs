//! Scenes with bytes changed, cut, repeated and overwritten, as files, as overrides and as unsaved work: a scene or a complaint,
//! never a panic.

use girderbench::dynamics::Model;
use girderbench::files::{find_beside, load_unsaved};
use girderbench::scene::validate::validate;
use girderbench::scene::{SceneErrors, format, overrides, presets};

use crate::support::mutate::{Case, expect_words, many, mutated, other_value, peak_memory};

/// What a value may be made to be.
const HOSTILE: &[&str] = &[
    "1e18",
    "1e-300",
    "nan",
    "-inf",
    "-1",
    "0",
    "-0.0",
    "99999999999999999999999",
    "0x7fffffffffffffff",
    "true",
    "\"\"",
    "\"\\u001b[31m\"",
    "\"deck\"",
    "\"/dev/zero\"",
    "\"../../../etc/passwd\"",
    "[]",
    "[[]]",
    "{}",
    "[1e308, 1e308, 1e308]",
    "[nan, 1]",
    "[1, 2, 3, 4, 5]",
    "\"spatial\"",
    "\"impact\"",
    "\"both\"",
    "\"paper\"",
    "\"-x\"",
    "180",
    "1e-12",
    "[[girder]]",
    "[contact]",
    "\u{fffd}",
    "\0",
    "\u{1b}]0;a\u{7}",
    "#",
    "\"\"\"",
    "\r\n",
    "١٢٣",
    "1979-05-27T07:32:00Z",
];

/// Scenes of presets and lessons.
fn scenes() -> Vec<(String, String)> {
    let presets = presets::all().iter().map(|preset| (preset.name.to_owned(), preset.text.to_owned()));
    let lessons = std::fs::read_dir("assets/lessons").expect("the lessons").flatten().map(|entry| entry.path());
    let mut lessons: Vec<_> = lessons.filter(|path| !path.to_string_lossy().ends_with(".lesson.toml")).collect();
    lessons.sort();
    let read = |path: &std::path::PathBuf| {
        (path.display().to_string(), std::fs::read_to_string(path).expect("a lesson's scene"))
    };
    presets.chain(lessons.iter().map(read)).collect()
}

fn expect_complaints(errors: &SceneErrors) {
    assert!(!errors.0.is_empty(), "a reason");
    errors.0.iter().for_each(|error| expect_words(&error.to_string()));
}

/// Reads a text as `check` does; whether it is a sound scene.
fn survives(text: &str) -> bool {
    let scene = match format::parse(text, "mutated") {
        Ok(scene) => scene,
        Err(errors) => {
            expect_complaints(&errors);
            return false;
        }
    };
    let bodies = scene.girders.len() + scene.abutments.len();
    assert!(bodies <= text.len(), "no more bodies than the text has room for: {bodies}");
    if let Err(errors) = validate(&scene) {
        expect_complaints(&errors);
        return false;
    }
    let written = format::write(&scene);
    assert_eq!(format::parse(&written, "written").as_ref(), Ok(&scene), "writing loses nothing: {written}");
    if let Err(errors) = Model::compile(&scene) {
        expect_complaints(&errors);
    }
    true
}

/// So many cases of every scene.
fn survive(cases: u64) {
    let mut sound = 0;
    for (name, text) in scenes() {
        for seed in 0..cases {
            let _case = Case::of(&name, seed);
            let bytes = mutated(text.as_bytes(), HOSTILE, seed);
            sound += u64::from(survives(&String::from_utf8_lossy(&bytes)));
            sound += u64::from(survives(&other_value(&text, HOSTILE, seed)));
        }
    }
    assert!(sound > cases, "some changes leave a scene: {sound}");
}

/// So many overrides of a scene by what stands in its own text.
fn survive_overrides(cases: u64) {
    for (name, text) in scenes() {
        let Ok(scene) = format::parse(&text, &name) else { panic!("{name} is a scene") };
        for seed in 0..cases {
            let _case = Case::of(&name, seed);
            let setting = mutated(b"girder.deck.bearings.frequency_hz=[2.6, 3.1]", HOSTILE, seed);
            if let Err(errors) = overrides::apply(&scene, &String::from_utf8_lossy(&setting)) {
                expect_complaints(&errors);
            }
        }
    }
}

/// So many files of unsaved work.
fn survive_recovery(cases: u64) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scene.toml");
    for (name, text) in scenes() {
        for seed in 0..cases {
            let _case = Case::of(&name, seed);
            let bytes = mutated(text.as_bytes(), HOSTILE, seed);
            std::fs::write(folder.path().join("scene.toml.unsaved"), bytes).expect("written");
            let found = find_beside(&file);
            assert_eq!(found.len(), 1, "nobody holds it");
            if let Err(errors) = load_unsaved(&found[0].path) {
                expect_complaints(&errors);
            }
        }
    }
}

#[test]
fn a_hundred_changes_of_every_scene_are_read_or_refused() {
    survive(100);
}

#[test]
fn a_hundred_changes_of_an_override_are_taken_or_refused() {
    survive_overrides(100);
}

#[test]
fn changed_unsaved_work_is_found_and_read_or_refused() {
    survive_recovery(20);
}

#[test]
#[ignore = "an hour"]
fn a_million_changes_of_every_scene_are_read_or_refused_in_bounded_memory() {
    survive(many());
    survive_overrides(many());
    survive_recovery(many() / 100);
    assert!(peak_memory().is_none_or(|bytes| bytes < 1 << 30), "{:?} bytes", peak_memory());
}
