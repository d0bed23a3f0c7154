//! Into a folder with an earlier answer: its tables do not stay beside those of another model, and files of the user's do.

use std::fs;
use std::path::Path;

use crate::program::call;

const TABLES: [&str; 4] = ["contacts.csv", "events.csv", "summary.json", "trajectory.csv"];

fn run_into(folder: &Path, model: &str) -> String {
    let model = format!("model.kind={model}");
    let out = folder.to_str().expect("a UTF-8 path");
    let said = call(&["run", "skew45-abutment", "--until", "0.5", "--set", &model, "--out", out]);
    assert_eq!(said.status, Some(0), "runs: {}", said.err);
    said.out
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<_> = entries.map(|name| name.into_string().expect("Unicode")).collect();
    names.sort();
    names
}

#[test]
fn tables_of_another_model_do_not_stay() {
    for (earlier, gone) in [("impact", "hits.csv, transitions.csv"), ("both", "impact-trajectory.csv")] {
        let folder = tempfile::tempdir().expect("a folder");
        run_into(folder.path(), earlier);
        assert!(names_in(folder.path()).len() > TABLES.len(), "{earlier} has more tables");
        let said = run_into(folder.path(), "contact");
        assert_eq!(names_in(folder.path()), TABLES, "of the contact model alone");
        assert!(said.contains("removed, of an earlier answer: ") && said.contains(gone), "says so: {said}");
    }
}

#[test]
fn files_of_the_user_stay() {
    let folder = tempfile::tempdir().expect("a folder");
    run_into(folder.path(), "contact");
    let mine = ["hits.csv", "impact-events.csv", "notes.csv", "transitions.csv"];
    for name in mine {
        fs::write(folder.path().join(name), "mine").expect("written");
    }
    run_into(folder.path(), "contact");
    let mut wanted = [&TABLES[..], &mine].concat();
    wanted.sort_unstable();
    assert_eq!(names_in(folder.path()), wanted, "no summary names them");
}

#[test]
fn a_summary_of_another_program_names_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("summary.json"), r#"{"files": ["hits.csv"]}"#).expect("written");
    fs::write(folder.path().join("hits.csv"), "mine").expect("written");
    run_into(folder.path(), "contact");
    assert!(folder.path().join("hits.csv").exists(), "it stays");
}
