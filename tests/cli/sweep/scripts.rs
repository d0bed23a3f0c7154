//! The scripts of `docs/sweep.md` divide a sweep, and other programs read its dataset.
#![expect(clippy::print_stderr, reason = "says what is skipped")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use super::results;
use crate::program::call;

/// The scripts of the page that have a word in them, in its order.
fn scripts(word: &str) -> Vec<&'static str> {
    let page = include_str!("../../../docs/sweep.md");
    let blocks = page.split("```sh\n").skip(1).filter_map(|rest| rest.split("```").next());
    blocks.filter(|script| script.contains(word)).collect()
}

/// Runs a script in a folder, where `girderbench` is this build.
fn sh(script: &str, folder: &Path) -> Output {
    let own = Path::new(env!("CARGO_BIN_EXE_girderbench")).parent().expect("a folder");
    let others = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(own.to_owned()).chain(std::env::split_paths(&others)));
    let mut command = Command::new("sh");
    command.args(["-ec", script]).env("PATH", path.expect("a path")).current_dir(folder);
    command.output().expect("a shell")
}

/// Whether a program is installed.
fn is_there(program: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success());
    if !there {
        eprintln!("skipped: {program} is not installed");
    }
    there
}

/// A script leaves in `map` what one process does.
fn makes_the_same(script: &str, folder: &Path) {
    let output = sh(script, folder);
    assert!(output.status.success(), "{script}{}", String::from_utf8_lossy(&output.stderr));
    let journals = fs::read_dir(folder.join("map")).expect("there").flatten();
    let shards = journals.filter(|entry| entry.file_name().to_string_lossy().starts_with("shard-")).count();
    assert_eq!(shards, 8, "eight parts");
    let whole = folder.join("whole");
    let sweep = ["sweep", "skew45-abutment", "--vary", "girder.deck.skew_deg=30..90:61", "--measure", "max_rotation"];
    let said = call(&[&sweep[..], &["--out", whole.to_str().expect("UTF-8")]].concat());
    assert_eq!(said.status, Some(0), "{}", said.err);
    assert!(results(&folder.join("map")) == results(&whole), "the same bytes");
}

#[test]
fn xargs_divides_a_sweep() {
    if is_there("xargs") {
        let folder = tempfile::tempdir().expect("a folder");
        makes_the_same(scripts("xargs")[0], folder.path());
    }
}

#[test]
fn gnu_parallel_divides_a_sweep() {
    if is_there("parallel") {
        let folder = tempfile::tempdir().expect("a folder");
        makes_the_same(scripts("parallel -j")[0], folder.path());
    }
}

#[test]
fn a_job_array_of_slurm_divides_a_sweep() {
    // Without a controller that answers there is no cluster.
    if is_there("sbatch") && Command::new("sinfo").output().is_ok_and(|output| output.status.success()) {
        let folder = tempfile::tempdir().expect("a folder");
        let [job, submit] = scripts("SWEEP=")[2..] else { panic!("a job and its submission") };
        fs::write(folder.path().join("sweep.sh"), job).expect("written");
        makes_the_same(submit, folder.path());
    }
}

#[cfg(feature = "parquet")]
#[test]
fn polars_and_duckdb_read_what_the_csv_holds() {
    let folder = tempfile::tempdir().expect("a folder");
    assert_eq!(super::into(folder.path(), &[]).status, Some(0), "runs");
    let python = std::env::var_os("GIRDERBENCH_PYTHON").unwrap_or_else(|| "python3".into());
    if !is_there(&python.to_string_lossy()) {
        return;
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cli/sweep/read.py");
    let files = ["sweep.parquet", "sweep.csv"].map(|name| folder.path().join(name));
    let output = Command::new(python).arg(script).args(files).output().expect("Python");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    match String::from_utf8_lossy(&output.stdout).trim() {
        "nothing" => eprintln!("skipped: Python has neither Polars nor DuckDB (GIRDERBENCH_PYTHON names another one)"),
        readers => eprintln!("read {readers}"),
    }
}
