//! Standard output that cannot be written: a full device is an error, a reader that has gone is not.

#![cfg(target_os = "linux")]

use std::fs::File;
use std::process::Stdio;

use crate::program::{Said, call, call_within, program, said};

/// Every way to print: an answer, a list, a page of help.
const CALLS: &[&[&str]] = &[
    &["run", "flush-free-hit"],
    &["run", "flush-free-hit", "--digest"],
    &["check", "flush-free-hit"],
    &["compare", "flush-free-hit", "flush-free-hit"],
    &["presets"],
    &["--help"],
    &["help", "run"],
    &["--version"],
];

fn call_into(args: &[&str], out: Stdio) -> Said {
    said(&program().args(args).stdout(out).output().expect("the program starts"))
}

#[test]
fn a_full_device_is_an_error() {
    for args in CALLS {
        let full = File::options().write(true).open("/dev/full").expect("the device that is always full");
        let said = call_into(args, full.into());
        assert_eq!(said.status, Some(4), "{args:?}: a status of its own, said {}", said.err);
        let line = said.err.lines().find(|line| line.contains("standard output"));
        let line = line.unwrap_or_else(|| panic!("{args:?}: names standard output: {}", said.err));
        assert!(line.starts_with("error: ") && line.contains("No space"), "{args:?}: says why: {line}");
    }
}

#[test]
fn a_reader_that_has_gone_is_no_error() {
    for args in CALLS {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let said = call_into(args, writer.into());
        assert_eq!((said.status, said.err.as_str()), (Some(0), ""), "{args:?}: silent");
    }
}

#[test]
fn a_disk_that_takes_no_more_is_no_fault_of_the_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("results");
    // So many blocks a file may have, and the program lives to hear of it.
    let script = "trap '' XFSZ; ulimit -f 16; exec \"$@\"";
    let mut command = std::process::Command::new("sh");
    command.args(["-c", script, "sh", env!("CARGO_BIN_EXE_girderbench"), "run", "skew45-abutment", "--out"]).arg(&out);
    let said = said(&command.output().expect("the shell starts"));
    assert_eq!(said.status, Some(4), "a status of its own: {}", said.err);
    assert!(said.err.contains("results/trajectory.csv: cannot be written"), "the file as it is called: {}", said.err);
    assert!(
        said.err.contains("make room") && !said.err.contains(".csv.tmp"),
        "what to do, and no other name: {}",
        said.err
    );
    assert!(!out.exists(), "nothing is written");
}

#[test]
fn rows_are_limited_where_they_are_wanted_and_with_their_columns() {
    let still = ["run", "skew45-abutment", "--set", "motion.kind=none", "--until", "1000", "--sample", "1e9"];
    let said = call_within(60, program().args(still));
    assert_eq!(said.status, Some(0), "no table is asked for: {}", said.err);
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("results");
    let out = out.to_str().expect("a UTF-8 path");
    let said = call_within(60, program().args(still).args(["--out", out]));
    assert_eq!(said.status, Some(2), "too many rows");
    assert!(said.err.contains("--sample: 1000000000: trajectory.csv would have"), "says what: {}", said.err);
    // Ten million rows would do for one girder.
    let five = ["run", "row-of-5", "--until", "10", "--sample", "1e6", "--out", out];
    let said = call_within(60, program().args(five));
    assert_eq!(said.status, Some(2), "five girders have more columns: {}", said.err);
    let less = said.err.split("give at most ").nth(1).and_then(|rest| rest.split(' ').next()).expect("how many");
    let less: f64 = less.parse().expect("a number");
    assert!((5.4e5..5.6e5).contains(&less), "1.7e8 cells in 31 columns: {less}");
}

#[test]
fn the_number_of_threads_is_checked() {
    for threads in ["0", "-1", "many", "1025"] {
        let said = call(&["run", "flush-free-hit", "--threads", threads]);
        assert_eq!(said.status, Some(2), "{threads}: {}", said.err);
    }
}

#[test]
fn as_many_threads_work_as_are_asked_for() {
    let mut child = program()
        .env("RAYON_NUM_THREADS", "2")
        .args(["run", "skew45-abutment", "--until", "100000", "--threads", "5"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let tasks = format!("/proc/{}/task", child.id());
    let mut most = 0;
    for _ in 0..400 {
        most = most.max(std::fs::read_dir(&tasks).map_or(0, Iterator::count));
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    child.kill().expect("it was still running");
    child.wait().expect("ended");
    assert_eq!(most, 6, "five, and the main thread, whatever the environment says");
}
