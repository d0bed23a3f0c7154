//! Standard output that cannot be written: a full device is an error, a reader that has gone is not.

#![cfg(target_os = "linux")]

use std::fs::File;
use std::process::Stdio;

use crate::program::{Said, program, said};

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
