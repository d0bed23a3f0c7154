//! `sweep`: the dataset is the same however it was computed, and mistakes are told before anything runs.

mod scripts;

use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

use crate::program::{Said, call, program};

/// A sweep of 40 short runs; of ten the static friction is below the kinetic, which is refused.
const SWEEP: &[&str] = &[
    "sweep",
    "skew45-abutment",
    "--until",
    "2",
    "--vary",
    "girder.deck.skew_deg=30..90:5",
    "--vary",
    "contact.mu_static=0.1,0.3",
    "--vary",
    "contact.mu_kinetic=0.05,0.15",
    "--vary",
    "model.kind=contact,impact,contact-only",
    "--measure",
    "max_rotation,hits,max_impulse",
];

/// The same without the value that is none.
fn sweep() -> Vec<&'static str> {
    SWEEP.iter().map(|word| word.strip_suffix(",contact-only").unwrap_or(word)).collect()
}

fn into(out: &Path, more: &[&str]) -> Said {
    let out = out.to_str().expect("a UTF-8 path");
    call(&[&sweep()[..], &["--out", out], more].concat())
}

/// The names of what is in a folder, with the bytes of what does not depend on the order of the runs.
fn results(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<(String, Vec<u8>)> = fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_none_or(|extension| extension != "journal"))
        .map(|path| (path.file_name().expect("a name").to_string_lossy().into_owned(), fs::read(path).expect("read")))
        .collect();
    files.sort();
    files
}

fn lines(folder: &Path) -> usize {
    fs::read_to_string(folder.join("runs.journal")).unwrap_or_default().lines().count()
}

#[test]
fn a_row_holds_what_a_run_of_its_own_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let (out, one) = (folder.path().join("sweep"), folder.path().join("one"));
    let said = into(&out, &[]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    let table = fs::read_to_string(out.join("sweep.csv")).expect("the dataset");
    let header = "run,girder.deck.skew_deg,contact.mu_static,contact.mu_kinetic,model.kind,max_rotation,hits,max_impulse,status,reason";
    assert_eq!(table.lines().next(), Some(header), "its columns");
    assert_eq!(table.lines().count(), 41, "a row a run");
    let run = ["run", "skew45-abutment", "--until", "2", "--set", "girder.deck.skew_deg=60", "--out"];
    let set = ["--set", "contact.mu_static=0.3", "--set", "model.kind=impact"];
    assert_eq!(call(&[&run[..], &[one.to_str().expect("UTF-8")], &set].concat()).status, Some(0), "runs");
    let summary = fs::read(one.join("summary.json")).expect("its summary");
    let summary: serde_json::Value = serde_json::from_slice(&summary).expect("JSON");
    let row = table.lines().find(|row| row.contains(",60.0,0.3,0.15,impact,")).expect("its row");
    let cells: Vec<&str> = row.split(',').collect();
    let wanted =
        [&summary["max_rotation"], &summary["hits"], &summary["peak_impulse"]].map(|v| v.as_f64().expect("it"));
    let values = [cells[5], cells[6], cells[7]].map(|cell| cell.parse::<f64>().expect("a number"));
    assert_eq!((values, cells[8], cells[9]), (wanted, "complete", ""), "{row}");
    let refused = table.lines().find(|row| row.contains(",30.0,0.1,0.15,contact,")).expect("μ_s below μ_k");
    assert!(refused.contains(",,,,refused,") && refused.contains("mu_kinetic"), "{refused}");
}

#[test]
fn killed_again_and_again_it_ends_with_the_same_dataset() {
    let folder = tempfile::tempdir().expect("a folder");
    let (whole, killed) = (folder.path().join("whole"), folder.path().join("killed"));
    assert_eq!(into(&whole, &["--threads", "1"]).status, Some(0), "runs");
    for kill in 1..=10 {
        let mut command = program();
        command.args(sweep()).arg("--out").arg(&killed).stdout(Stdio::null()).stderr(Stdio::null());
        let mut child = command.spawn().expect("the program starts");
        // After the heading some rows more each time.
        while lines(&killed) < 3 * kill {
            if child.try_wait().expect("its state").is_some() {
                break;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().expect("killed");
        child.wait().expect("ended");
        // As if the process had died within a line.
        let journal = killed.join("runs.journal");
        let length = fs::metadata(&journal).expect("there").len();
        fs::File::options().write(true).open(&journal).expect("there").set_len(length - 3).expect("cut");
    }
    let kept = lines(&killed) - 2;
    let said = into(&killed, &["--threads", "2"]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    let computed = format!("40 runs, {} of them to be computed\n", 40 - kept);
    assert!(said.out.starts_with(&computed), "nothing twice, nothing lost: {computed}{}", said.out);
    assert!(results(&whole) == results(&killed), "the same bytes");
    assert!(into(&killed, &[]).out.starts_with("40 runs, 0 of them"), "and nothing again");
}

#[test]
fn two_processes_do_not_write_one_journal() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let sweep = ["sweep", "deck-30m", "--until", "600", "--vary", "motion.angle_deg=0,1", "--measure", "hits"];
    let mut command = program();
    let mut child = command
        .args(sweep)
        .args(["--out", out])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    while lines(folder.path()) == 0 {
        assert!(child.try_wait().expect("its state").is_none(), "it computes for minutes");
        std::thread::sleep(Duration::from_millis(1));
    }
    let said = call(&[&sweep[..], &["--out", out]].concat());
    child.kill().expect("killed");
    child.wait().expect("ended");
    assert_eq!(said.status, Some(2), "{}", said.err);
    assert!(said.err.contains("runs.journal: another process is at work on it: wait"), "{}", said.err);
}

#[test]
fn parts_of_it_make_the_same_dataset() {
    let folder = tempfile::tempdir().expect("a folder");
    let (whole, parts) = (folder.path().join("whole"), folder.path().join("parts"));
    let said = into(&whole, &[]);
    let whole = (said, results(&whole));
    // Four at once, as on machines of their own.
    let start = |shard: u32| {
        let mut command = program();
        command.args(sweep()).arg("--out").arg(&parts).args(["--shard", &format!("{shard}/4"), "--threads", "1"]);
        command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the program starts")
    };
    let children: Vec<_> = (1..=4).map(start).collect();
    for child in children {
        let output = child.wait_with_output().expect("it ends");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    assert!(!parts.join("sweep.csv").exists(), "a part writes no dataset");
    let merged = into(&parts, &[]);
    assert!(merged.out.starts_with("40 runs, 0 of them to be computed"), "{}", merged.out);
    let digest = |said: &Said| said.out.lines().last().map(str::to_owned);
    assert_eq!(digest(&merged), digest(&whole.0), "the same digest");
    assert!(results(&parts) == whole.1, "the same bytes");
}

#[test]
fn a_run_that_gives_up_is_a_row_with_its_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let vary = "girder.deck.bearings.damping_ratio=1e12,0.05";
    let said =
        call(&["sweep", "deck-30m", "--until", "1", "--vary", vary, "--measure", "hits,max_rotation", "--out", out]);
    let table = fs::read_to_string(folder.path().join("sweep.csv")).expect("the dataset");
    let rows: Vec<&str> = table.lines().skip(1).collect();
    assert_eq!(said.status, Some(0), "the sweep is complete: {}", said.err);
    assert!(rows[0].starts_with("0,1000000000000.0,,,gave up,\"at ") && rows[0].contains("at this pace"), "{table}");
    assert!(rows[1].starts_with("1,0.05,") && rows[1].ends_with(",complete,"), "{table}");
    assert!(said.err.contains("1 runs gave up; run 0: at "), "told: {}", said.err);
}

#[test]
fn a_run_whose_model_ends_is_a_row_with_its_values_until_then() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    // The legs lose their seats where they travel beyond a millimetre.
    let vary = "girder.deck.bearings.travel_m=0.001,1.0";
    let said = call(&[
        "sweep",
        "skew45-abutment",
        "--until",
        "1",
        "--vary",
        vary,
        "--measure",
        "max_rotation,hits",
        "--out",
        out,
    ]);
    let table = fs::read_to_string(folder.path().join("sweep.csv")).expect("the dataset");
    let rows: Vec<&str> = table.lines().skip(1).collect();
    let rotation = |row: &str| row.split(',').nth(2).and_then(|cell| cell.parse::<f64>().ok());
    assert_eq!(said.status, Some(0), "the sweep is complete: {}", said.err);
    assert!(rows[0].contains(",ended,\"at ") && rows[1].ends_with(",complete,"), "{table}");
    let [ended, complete] = [0, 1].map(|n| rotation(rows[n]).expect("a rotation"));
    assert!(ended <= complete, "until then: {ended} of {complete}");
    assert!(said.err.contains("1 runs ended; run 0: at "), "told: {}", said.err);
}

#[test]
fn records_are_found_beside_the_scene_and_a_changed_one_is_another_sweep() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let record = |name: &str, peak: f64| {
        let sample = |i: u32| format!("{},{}\n", f64::from(i) / 100.0, peak * (f64::from(i) / 7.0).sin());
        let rows: String = (0..200).map(sample).collect();
        fs::write(path(name), format!("t [s],a [m/s2]\n{rows}")).expect("written");
    };
    record("a.csv", 4.0);
    record("b.csv", 6.0);
    let preset = girderbench::scene::presets::get("skew45-abutment").expect("ships");
    fs::write(path("scene.toml"), preset.text).expect("written");
    let files = ["--vary", "motion.kind=record", "--vary", "motion.file=a.csv,b.csv", "--measure", "max_displacement"];
    let sweep = || call(&[&["sweep", &path("scene.toml"), "--until", "2", "--out", &path("out")], &files[..]].concat());
    let said = sweep();
    assert_eq!(said.status, Some(0), "{}", said.err);
    let table = fs::read_to_string(folder.path().join("out/sweep.csv")).expect("the dataset");
    for file in ["a.csv", "b.csv"] {
        let sets = ["--set", "motion.kind=record", "--set", &format!("motion.file={file}")];
        let run = call(&[&["run", &path("scene.toml"), "--until", "2", "--out", &path("run")], &sets[..]].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        let summary = fs::read(folder.path().join("run/summary.json")).expect("its summary");
        let summary: serde_json::Value = serde_json::from_slice(&summary).expect("JSON");
        let row = format!(",record,{file},{:?},complete,", summary["max_displacement"].as_f64().expect("a number"));
        assert!(table.contains(&row), "{row} in {table}");
    }
    record("b.csv", 7.0);
    let said = sweep();
    assert_eq!(said.status, Some(2), "{}", said.err);
    assert!(said.err.contains("another sweep by the records of ground motion;"), "{}", said.err);
}

#[test]
fn another_sweep_in_the_folder_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let short = |more: &[&str]| {
        let sweep = ["sweep", "skew45-abutment", "--until", "0.1", "--out", out];
        call(&[&sweep[..], more].concat())
    };
    let first = ["--vary", "motion.angle_deg=0,30", "--measure", "hits"];
    assert_eq!(short(&first).status, Some(0), "the first");
    let before = results(folder.path());
    let cases: [(&[&str], &str); 4] = [
        (&["--vary", "motion.angle_deg=0,31", "--measure", "hits"], "another sweep by --vary;"),
        (&["--vary", "motion.angle_deg=0,30", "--measure", "max_force"], "another sweep by --measure;"),
        (&[&first[..], &["--set", "contact.mu_static=0.3"]].concat(), "another sweep by the scene;"),
        (&["--vary", "motion.angle_deg=0", "--measure", "max_force"], "another sweep by --vary, --measure;"),
    ];
    for (more, words) in cases {
        let said = short(more);
        assert_eq!(said.status, Some(2), "{more:?}");
        assert!(said.err.contains(words) && said.err.contains("give another --out"), "{more:?}: {}", said.err);
    }
    assert!(results(folder.path()) == before, "nothing was touched");
    fs::write(folder.path().join("runs.journal"), "notes\n").expect("written");
    let said = short(&first);
    assert!(said.status == Some(2) && said.err.contains("journal of another sweep"), "{}", said.err);
}

#[test]
fn mistakes_are_told_before_anything_runs() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let cases: [(&[&str], &[&str]); 12] = [
        (&["--vary", "girder.deck.skew=30,40", "--measure", "hits"], &["--vary girder.deck.skew=30", "skew_deg"]),
        (&["--vary", "girder.dock.skew_deg=30", "--measure", "hits"], &["--vary girder.dock.skew_deg=30", "deck"]),
        (&["--vary", "girder.deck.skew_deg=30,190", "--measure", "hits"], &["girder.deck.skew_deg", "190"]),
        (&["--vary", "motion.kind=sinus", "--measure", "hits"], &["--vary motion.kind=sinus", "sine"]),
        (&["--vary", "motion.kind=record", "--vary", "motion.file=a.csv", "--measure", "hits"], &["a.csv"]),
        (&["--vary", "model.kind=both", "--measure", "hits"], &["model.kind", "vary model.kind=contact,impact"]),
        (&["--vary", "motion.angle_deg=0..90", "--measure", "hits"], &["LO..HI:N"]),
        (&["--vary", "motion.angle_deg=0", "--measure", "max_rotatoin"], &["did you mean `max_rotation`?"]),
        (&["--vary", "motion.angle_deg=0", "--measure", "hits,hits"], &["--measure", "hits twice"]),
        (
            &["--vary", "motion.angle_deg=0", "--vary", "motion.angle_deg=1", "--measure", "hits"],
            &["motion.angle_deg twice"],
        ),
        (&["--vary", "motion.angle_deg=0", "--measure", "hits", "--shard", "3/2"], &["--shard", "I/N"]),
        (
            &["--vary", "motion.angle_deg=0..1:9999", "--vary", "contact.mu_static=1..2:9999", "--measure", "hits"],
            &["too many runs"],
        ),
    ];
    for (more, words) in cases {
        let said = call(&[&["sweep", "skew45-abutment", "--out", out.to_str().expect("UTF-8")], more].concat());
        assert_eq!(said.status, Some(2), "{more:?}: {}", said.err);
        assert!(words.iter().all(|word| said.err.contains(word)), "{more:?} {words:?}: {}", said.err);
    }
    let said = call(&[SWEEP, &["--out", out.to_str().expect("UTF-8")]].concat());
    assert!(said.status == Some(2) && said.err.contains("--vary model.kind=contact-only"), "{}", said.err);
    assert!(!out.exists(), "not even the folder");
}
