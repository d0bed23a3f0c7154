//! Files that are no scenes, records or tables: devices, pipes, folders, files too large, bytes that a terminal obeys.

#![cfg(unix)]

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::program::{Said, call, call_within, program};
use girderbench::scene::presets;

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
}

/// A scene without fault.
fn sound() -> &'static str {
    presets::get("flush-free-hit").expect("a preset").text
}

fn check(scene: impl AsRef<OsStr>) -> Said {
    call_within(20, program().arg("check").arg(scene))
}

/// A scene whose ground moves as a record says.
fn scene_of_record(folder: &Path, record: &str) -> PathBuf {
    let mut table: toml::Table = sound().parse().expect("TOML");
    table.remove("motion");
    let table = toml::to_string(&table).expect("TOML");
    let scene = folder.join("scene.toml");
    fs::write(&scene, format!("{table}\n[motion]\nkind = \"record\"\nfile = {record:?}\n")).expect("written");
    scene
}

fn fifo(path: &Path) {
    let made = Command::new("mkfifo").arg(path).status().expect("mkfifo is there");
    assert!(made.success(), "a pipe with a name");
}

/// A file of that many bytes of which none is on the disk.
fn sparse(path: &Path, bytes: u64) {
    fs::File::create(path).and_then(|file| file.set_len(bytes)).expect("made");
}

fn expect_refusal(said: &Said, words: &[&str]) {
    assert_eq!(said.status, Some(2), "bad input: {}", said.err);
    for word in words {
        assert!(said.err.contains(word), "{word} in {}", said.err);
    }
}

#[test]
fn only_regular_files_are_read_as_scenes() {
    let folder = folder();
    let pipe = folder.path().join("pipe.toml");
    fifo(&pipe);
    let remedy = "give a regular file";
    expect_refusal(&check("/dev/zero"), &["/dev/zero", "device", remedy]);
    expect_refusal(&check(&pipe), &["pipe.toml", "a pipe", remedy]);
    expect_refusal(&check(folder.path()), &["directory", remedy]);
}

#[test]
fn only_regular_files_are_read_as_records() {
    let folder = folder();
    fifo(&folder.path().join("shake.csv"));
    for (record, what) in [("shake.csv", "a pipe"), ("/dev/zero", "device"), (".", "directory")] {
        let said = check(scene_of_record(folder.path(), record));
        expect_refusal(&said, &["scene.toml", "motion.file", record, what, "give a regular file"]);
    }
}

#[test]
fn only_regular_files_are_read_as_tables() {
    let folder = folder();
    fifo(&folder.path().join("trajectory.csv"));
    let said = call_within(20, program().arg("compare").args([folder.path(), folder.path()]));
    expect_refusal(&said, &["trajectory.csv", "a pipe", "give a regular file"]);
}

#[test]
fn a_file_that_is_too_large_is_refused_with_size_and_limit() {
    let folder = folder();
    let scene = folder.path().join("large.toml");
    sparse(&scene, 3 << 30);
    expect_refusal(&check(&scene), &["large.toml", "3072.0 MiB", "64 MiB", "give a smaller file"]);
    sparse(&folder.path().join("large.csv"), 3 << 30);
    let said = check(scene_of_record(folder.path(), "large.csv"));
    expect_refusal(&said, &["motion.file", "large.csv", "3072.0 MiB", "64 MiB"]);
}

#[test]
fn a_scene_may_have_a_name_that_is_no_unicode() {
    let folder = folder();
    let scene = folder.path().join(OsStr::from_bytes(b"br\xfccke.toml"));
    fs::write(&scene, sound()).expect("written");
    let said = check(&scene);
    assert_eq!(said.status, Some(0), "it is read: {}", said.err);
    fs::write(&scene, "format = 1\ncolour = 3").expect("written");
    expect_refusal(&check(&scene), &["br\u{fffd}cke.toml", "colour"]);
    let missing = folder.path().join(OsStr::from_bytes(b"na\xefve.toml"));
    expect_refusal(&check(&missing), &["na\u{fffd}ve.toml", "path of a scene file"]);
}

#[test]
fn a_long_line_is_cut_where_it_is_shown() {
    let folder = folder();
    let scene = folder.path().join("long.toml");
    let long = "x".repeat(1 << 20);
    for text in [
        format!("name = [[\"{long}\""),
        format!("{long}{long}"),
        format!("format = 1\n{long} = 3\n"),
        format!("format = 1\n\"{long}\" = \"{long}\"\n"),
        format!("format = \"{long}\"\n"),
    ] {
        fs::write(&scene, &text).expect("written");
        let said = check(&scene);
        expect_refusal(&said, &["long.toml"]);
        assert!(said.err.len() < 2000, "{} bytes: {:.300}", said.err.len(), said.err);
    }
}

#[test]
fn a_long_line_of_a_record_is_cut_where_it_is_shown() {
    let folder = folder();
    for line in ["7".repeat(1 << 20), format!("1,{}", "7x".repeat(1 << 20)), "1,".repeat(1 << 20)] {
        fs::write(folder.path().join("shake.csv"), format!("0,1\n{line}\n")).expect("written");
        let said = check(scene_of_record(folder.path(), "shake.csv"));
        expect_refusal(&said, &["shake.csv", "line 2"]);
        assert!(said.err.len() < 2000, "{} bytes: {:.300}", said.err.len(), said.err);
    }
}

#[test]
fn a_terminal_obeys_no_byte_of_a_file() {
    let folder = folder();
    let scene = folder.path().join("escape.toml");
    let path = scene.to_str().expect("a UTF-8 path");
    let name = r#"name = "a\u001b[2Jb\nerror: c\u202e""#;
    let named = sound().replacen(r#"name = "flush-free-hit""#, name, 1);
    assert_ne!(named, sound(), "the name is replaced");
    for text in [
        named.as_str(),
        "format = 1\nname = \u{1b}[2J",
        "format = 1\n\"\\u001b[2J\" = 3",
        "format = 1\nduration_s = '\u{9b}2J'",
    ] {
        fs::write(&scene, text).expect("written");
        for command in ["check", "run"] {
            let said = call(&[command, path]);
            for text in [&said.out, &said.err] {
                let raw = text.chars().find(|&c| (c.is_control() && c != '\n') || c == '\u{202e}');
                assert_eq!(raw, None, "{command}: {text}");
                assert!(!text.lines().any(|line| line.starts_with("error: c")), "a name is one line: {text}");
            }
        }
    }
}
