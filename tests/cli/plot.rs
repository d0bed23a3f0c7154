//! `girderbench plot`: quantities of a run, by their names, as a table and a picture.

use crate::program::call;

const SHORT: [&str; 4] = ["plot", "skew45-abutment", "--until", "0.5"];

#[test]
fn what_can_be_plotted_is_listed() {
    let said = call(&SHORT);
    assert_eq!(said.status, Some(0), "{}", said.err);
    assert!(said.out.lines().any(|line| line == "deck.theta") && said.out.lines().count() > 20, "{}", said.out);
}

#[test]
fn a_folder_for_nothing_is_refused() {
    let said = call(&[&SHORT[..], &["--out", "plots"]].concat());
    assert_eq!(said.status, Some(2), "{}", said.err);
    assert!(said.err.contains("--y <NAME>"), "{}", said.err);
}

#[test]
fn quantities_are_written_against_each_other_with_their_units() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a UTF-8 path");
    let said = call(&[&SHORT[..], &["--x", "deck.x", "--y", "deck.y", "--sample", "20", "--out", out]].concat());
    assert_eq!(said.status, Some(0), "{}", said.err);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect(name);
    assert_eq!(read("plot.csv").lines().count(), 12, "heading and 0, 0.05, … 0.5 s");
    assert!(read("plot.svg").contains("deck.x [mm]"), "an engineer's unit");
}

#[test]
fn a_name_that_is_not_there_and_a_run_that_ends_early_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a UTF-8 path");
    let unknown = call(&[&SHORT[..], &["--y", "deck.thet", "--out", out]].concat());
    assert_eq!(unknown.status, Some(2), "{}", unknown.err);
    assert!(unknown.err.contains("deck.thet") && unknown.err.contains("deck.theta"), "{}", unknown.err);
    let ends = ["--set", "girder.deck.bearings.travel_m=0.001", "--y", "deck.x", "--out", out];
    let stopped = call(&[&SHORT[..], &ends].concat());
    assert_eq!(stopped.status, Some(1), "{}", stopped.err);
    assert!(stopped.err.contains("vertical support is lost"), "{}", stopped.err);
    assert!(folder.path().join("plot.csv").exists(), "and what there is is written");
}

#[test]
fn more_points_than_a_picture_holds_are_refused_before_the_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a UTF-8 path");
    let said = call(&[&SHORT[..], &["--y", "deck.x", "--sample", "1e9", "--out", out]].concat());
    assert_eq!(said.status, Some(2), "{}", said.err);
    assert!(said.err.contains("plot.csv"), "{}", said.err);
    assert!(!folder.path().join("plot.csv").exists(), "nothing is written");
}
