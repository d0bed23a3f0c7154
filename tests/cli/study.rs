//! `study stability`: what it says of failures is true, and mistaken flags are told.

use girderbench::scene::format;

use crate::program::call;

#[test]
fn a_failure_is_written_as_a_small_scene_with_the_command_that_repeats_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("study");
    // Nothing finishes within a nanosecond: every seed fails, and says so.
    let study = |patience: &str| {
        let out = out.to_str().expect("a UTF-8 path");
        call(&["study", "stability", "--seeds", "2", "--from", "3", "--patience", patience, "--out", out])
    };
    let failed = study("1e-9");
    assert_eq!(failed.status, Some(1), "a failure is a failure: {}", failed.err);
    let page = std::fs::read_to_string(out.join("stability.md")).expect("the page");
    assert!(page.contains("girderbench study stability --seeds 1 --from 3 --out"), "the command: {page}");
    let table = std::fs::read_to_string(out.join("seeds.csv")).expect("the table");
    assert_eq!(table.lines().count(), 3, "a heading and two seeds: {table}");
    let small = std::fs::read_to_string(out.join("seed-3.toml")).expect("the shrunk scene");
    format::read(&small, "seed-3.toml").unwrap_or_else(|errors| panic!("{errors}"));
    let passed = study("600");
    assert_eq!(passed.status, Some(0), "the same seeds with patience: {}", passed.err);
}

#[test]
fn mistaken_flags_are_told() {
    for (flags, word) in [
        (vec!["--seeds", "0", "--out", "x"], "--seeds"),
        (vec!["--seeds", "3"], "--out"),
        (vec!["--patience", "-1", "--out", "x"], "--patience"),
        (vec!["--threads", "0", "--out", "x"], "--threads"),
    ] {
        let said = call(&[&["study", "stability"], flags.as_slice()].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{flags:?}: {}", said.err);
    }
}

#[test]
fn waves_are_drawn_and_what_does_not_bend_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a UTF-8 path");
    let drawn = call(&["waves", "deck-30m-elastic", "--until", "1.2", "--force", "moment", "--out", out]);
    assert_eq!(drawn.status, Some(0), "{}", drawn.err);
    let svg = std::fs::read_to_string(folder.path().join("deck-moment.svg")).expect("the picture");
    assert!(
        svg.contains("bending moment M") && svg.contains("[MN·m]") && svg.contains("A wave runs"),
        "it says what it is"
    );
    let table = std::fs::read_to_string(folder.path().join("deck-moment.csv")).expect("the table");
    assert_eq!(table.lines().count(), 161 * 81 + 1, "a heading and a line each");
    for (args, word) in [
        (vec!["skew45-abutment"], "no girder bends"),
        (vec!["deck-30m-elastic", "--girder", "bridge"], "no girder has this name; there are deck"),
        (vec!["deck-30m-elastic", "--until", "1", "--from", "2"], "--from 2: the run ends at 1 s"),
        (vec!["deck-30m-elastic", "--until", "1", "--to", "0.5"], "--to without --from"),
    ] {
        let said = call(&[&["waves"], args.as_slice(), &["--out", out]].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{args:?}: {}", said.err);
    }
}
