//! A run that is interrupted while it writes leaves nothing behind, and a later one removes what a killed one left.

#![cfg(unix)]

use std::fs;
use std::os::unix::process::ExitStatusExt as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, SystemTime};

use crate::program::{call, program};

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
}

pub(crate) fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> = entries.map(|entry| entry.file_name().into_string().expect("Unicode")).collect();
    names.sort();
    names
}

/// What is unfinished in a folder.
fn unfinished(folder: &Path) -> Option<PathBuf> {
    let name = names_in(folder).into_iter().find(|name| name.starts_with(".girderbench-"))?;
    Some(folder.join(name))
}

/// Files inside of what is unfinished, the lock left out.
fn count_inside(folder: &Path) -> usize {
    unfinished(folder).map_or(0, |inside| names_in(&inside).len().saturating_sub(1))
}

/// Starts a call and waits until so many files are unfinished in its folder.
fn start(args: &[&str], out: &Path, files: usize) -> Child {
    start_until(args, out, || count_inside(out) >= files)
}

/// Starts a call and waits until what it writes has come so far.
fn start_until(args: &[&str], out: &Path, come: impl Fn() -> bool) -> Child {
    let mut command = program();
    command.args(args).arg("--out").arg(out).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    while !come() {
        assert!(child.try_wait().expect("its state").is_none(), "it writes until it is interrupted");
        std::thread::sleep(Duration::from_millis(2));
    }
    child
}

fn signal(child: &Child, name: &str) {
    let sent = Command::new("kill").args([name, &child.id().to_string()]).status();
    assert!(sent.expect("kill is there").success(), "it was still running");
}

/// Minutes of writing.
const LONG: &[&str] = &["run", "skew45-abutment", "--until", "60", "--sample", "300000"];

#[test]
fn an_interrupt_while_tables_are_written_leaves_nothing() {
    for name in ["-TERM", "-INT"] {
        let folder = folder();
        let out = folder.path().join("results");
        let child = start(LONG, &out, 1);
        signal(&child, name);
        let output = child.wait_with_output().expect("it ends");
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.signal().is_some(), "{name}: ended by the signal: {:?}", output.status);
        assert!(err.contains("interrupted: nothing was written"), "{name}: says so: {err}");
        assert!(!out.exists(), "{name}: not even the folder: {:?}", names_in(&out));
    }
}

#[test]
fn what_a_killed_run_left_goes_with_the_next() {
    let folder = folder();
    let mut child = start(LONG, folder.path(), 1);
    child.kill().expect("killed");
    child.wait().expect("ended");
    let left = unfinished(folder.path()).expect("a killed process tidies nothing");
    let lock = fs::File::options().write(true).open(left.join("lock")).expect("its lock");
    lock.set_modified(SystemTime::now() - Duration::from_hours(1)).expect("set back");
    drop(lock);
    fs::write(folder.path().join(".girderbench-notes"), "mine").expect("written");
    let said = call(&["run", "flush-free-hit", "--out", folder.path().to_str().expect("a UTF-8 path")]);
    assert_eq!(said.status, Some(0), "runs: {}", said.err);
    let names = names_in(folder.path());
    let wanted = [".girderbench-notes", "contacts.csv", "events.csv", "summary.json", "trajectory.csv"];
    assert_eq!(names, wanted, "the leftover is gone, and nothing else");
}

#[cfg(feature = "render")]
#[test]
fn an_interrupted_film_keeps_its_finished_frames() {
    let folder = folder();
    let out = folder.path().join("film");
    let scene = ["render", "skew45-abutment", "--until", "1", "--size", "160x90", "--quality", "draft"];
    let probe = call(&[&scene[..], &["--out", folder.path().join("one.png").to_str().expect("UTF-8")]].concat());
    // Nothing draws here.
    if probe.status == Some(3) {
        return;
    }
    let child = start(&[&scene[..], &["--frames", "20000"]].concat(), &out, 5);
    signal(&child, "-TERM");
    let output = child.wait_with_output().expect("it ends");
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.signal().is_some(), "ended by the signal: {:?}, {err}", output.status);
    let names = names_in(&out);
    let frames = names.iter().all(|name| Path::new(name).extension().is_some_and(|extension| extension == "png"));
    assert!(names.len() >= 5 && frames, "frames only: {names:?}");
    let said = format!("{} of 20000 pictures are finished", names.len());
    assert!(err.contains(&said), "says how many: {said}: {err}");
    for name in names {
        let bytes = fs::read(out.join(&name)).expect("there");
        assert!(girderbench::render::Image::from_png(&bytes).is_ok(), "{name} is whole");
    }
}

#[cfg(feature = "render")]
#[test]
fn an_interrupted_gif_keeps_its_finished_frames() {
    let folder = folder();
    let out = folder.path().join("film.gif");
    let scene = ["render", "skew45-abutment", "--until", "1", "--size", "160x90", "--quality", "draft"];
    let probe = folder.path().join("one.png");
    // Nothing draws here.
    if call(&[&scene[..], &["--out", probe.to_str().expect("UTF-8")]].concat()).status == Some(3) {
        return;
    }
    // A palette and a few frames.
    let written = || unfinished(folder.path()).and_then(|film| fs::metadata(film).ok()).map_or(0, |film| film.len());
    let child = start_until(&[&scene[..], &["--frames", "2000"]].concat(), &out, || written() > 40_000);
    signal(&child, "-TERM");
    let output = child.wait_with_output().expect("it ends");
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.signal().is_some(), "ended by the signal: {:?}, {err}", output.status);
    let mut film = gif::DecodeOptions::new().read_info(fs::File::open(&out).expect("it is there")).expect("a GIF");
    let mut frames = 0;
    while film.read_next_frame().expect("whole to its end").is_some() {
        frames += 1;
    }
    let said = format!("{frames} of 2000 frames are finished, in {}", out.display());
    assert!(frames > 1 && err.contains(&said), "says how many: {said}: {err}");
    assert_eq!(unfinished(folder.path()), None, "nothing unfinished stays");
}
