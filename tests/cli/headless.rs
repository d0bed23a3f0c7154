//! Without a display the program does its main job all the same: pictures, tables, a short summary.

use std::path::Path;

use crate::program::{Said, program, said};

/// Calls the program with no arguments but the folder, and with what `environment` sets.
fn main_job(folder: &Path, environment: &[(&str, &str)]) -> Said {
    let mut command = program();
    command.arg("--out").arg(folder).envs(environment.iter().copied());
    let said = said(&command.output().expect("the program starts"));
    assert_eq!(said.status, Some(0), "the main job is done: {}", said.err);
    assert!(said.out.contains("largest displacement"), "a summary: {}", said.out);
    said
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder is there");
    let mut names: Vec<_> = entries.map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

const TABLES: [&str; 4] = ["contacts.csv", "events.csv", "summary.json", "trajectory.csv"];

#[test]
fn no_display_is_said_and_the_job_is_done() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = main_job(folder.path(), &[]);
    let why = if cfg!(feature = "gui") { "display" } else { "no window" };
    assert!(said.err.contains(why), "says why there is no window: {}", said.err);
    let names = names_in(folder.path());
    assert!(TABLES.iter().all(|table| names.iter().any(|name| name == table)), "the tables: {names:?}");
    // An adapter may be missing on this machine; then the package that brings one is named (the next test).
    let pictures = names.iter().filter(|name| Path::new(name).extension().is_some_and(|e| e == "png")).count();
    let expected = if cfg!(feature = "render") && !said.err.contains("mesa-vulkan-drivers") { 4 } else { 0 };
    assert_eq!(pictures, expected, "a picture from each side: {names:?}, said {}", said.err);
}

#[cfg(feature = "render")]
#[test]
fn no_adapter_leaves_tables_and_names_the_package() {
    let folder = tempfile::tempdir().expect("a folder");
    // A backend that this system cannot have.
    let none = if cfg!(windows) { "metal" } else { "dx12" };
    let said = main_job(folder.path(), &[("WGPU_BACKEND", none)]);
    assert!(said.err.contains("mesa-vulkan-drivers"), "names the package: {}", said.err);
    assert_eq!(names_in(folder.path()), TABLES, "tables and nothing else");
}
