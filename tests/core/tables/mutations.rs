//! Tables of a results folder with bytes changed, cut, repeated and overwritten: an answer or a complaint, never a panic, and no
//! more numbers than the file has room for.

use girderbench::scene::{Scene, presets};
use girderbench::sim::History;
use girderbench::tables::compare::{compare, compare_events};
use girderbench::tables::{self, Report, TableOptions, read};

use crate::support::mutate::{Case, expect_words, many, mutated, peak_memory};

/// What a field may be made to be.
const HOSTILE: &[&str] = &[
    "1e400",
    "nan",
    "inf",
    "-",
    "",
    ",",
    ",,,,",
    "\"",
    "\"\"\"",
    "\n",
    "\r",
    "\0",
    "\u{1b}[2J",
    "\u{fffd}",
    "t",
    "t,t,t",
    "t,pair,kind",
    ".state",
    "99999999999999999999999",
    "1;5",
    "{",
    "[[[[[[[[",
    "\"files\": [\"../../a\", \"/etc/passwd\", 7]",
    "null",
];

/// The tables of a short run.
fn written(scene: &Scene) -> [Vec<u8>; 3] {
    let history = History::of(scene).expect("it runs");
    let options = TableOptions::default();
    [
        tables::in_memory(|out| tables::trajectory(&history, 100.0, out)),
        tables::in_memory(|out| tables::events(&history, out)),
        Report { files: vec!["trajectory.csv".into()], ..Report::of(&history, &options) }.to_json(),
    ]
}

/// So many cases of every table; how many were read all the same.
fn survive(name: &str, cases: u64) -> usize {
    let mut scene = presets::load(name).expect("a preset");
    scene.duration = 0.5;
    let [trajectory, events, summary] = written(&scene);
    let whole = read::trajectory(&trajectory).expect("as written");
    let all = read::events(&events).expect("as written");
    assert_eq!(tables::named_in(&summary), ["trajectory.csv"], "as written");
    let mut read_all_the_same = 0;
    for seed in 0..cases {
        let _case = Case::of(name, seed);
        let bytes = mutated(&trajectory, HOSTILE, seed);
        match read::trajectory(&bytes) {
            Ok(table) => {
                read_all_the_same += 1;
                let numbers = table.t.len() + table.columns.iter().map(|(_, column)| column.len()).sum::<usize>();
                assert!(numbers <= bytes.len() && table.t.iter().all(|t| t.is_finite()), "{numbers} numbers");
                let comparison = compare(&whole, &table, 1e-6);
                assert!(comparison.instants <= whole.t.len(), "of both");
            }
            Err(error) => expect_words(&error.to_string()),
        }
        let bytes = mutated(&events, HOSTILE, seed);
        match read::events(&bytes) {
            Ok(rows) => {
                read_all_the_same += 1;
                assert!(rows.len() <= bytes.len(), "{} rows", rows.len());
                let differences = compare_events(&all, &rows);
                assert!(differences.len() <= all.len() + rows.len(), "of either");
            }
            Err(error) => expect_words(&error.to_string()),
        }
        for name in tables::named_in(&mutated(&summary, HOSTILE, seed)) {
            assert_eq!(name, "trajectory.csv", "no file that is no table of this program");
        }
    }
    read_all_the_same
}

#[test]
fn three_hundred_changes_of_every_table_are_read_or_refused() {
    assert!(survive("flush-free-hit", 300) > 30, "a change in a number leaves a table");
}

#[test]
#[ignore = "an hour"]
fn a_million_changes_of_every_table_are_read_or_refused_in_bounded_memory() {
    for preset in presets::all() {
        survive(preset.name, many());
    }
    assert!(peak_memory().is_none_or(|bytes| bytes < 1 << 30), "{:?} bytes", peak_memory());
}
