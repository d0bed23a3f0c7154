//! `study experiment`: resumed without doing anything twice, the same for any number of threads, mistaken flags told.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::program::{Said, call};

/// Calls the study on two cases, `--out` as named from where the page is said to be made.
fn study(out: &Path, more: &[&str]) -> Said {
    let out = out.to_str().expect("a UTF-8 path");
    let fixed = ["study", "experiment", "--only", "straight_0_0.23g,pair_22.5_0.40g", "--out", out];
    call(&[&fixed, more].concat())
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("an entry").path());
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    entries.filter(|path| path.is_file()).map(|path| (name(&path), fs::read(&path).expect("a file"))).collect()
}

#[test]
fn a_result_that_is_there_is_not_computed_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let (out, results) = (folder.path().join("study"), folder.path().join("study/results"));
    let first = study(&out, &["--threads", "1"]);
    assert_eq!(first.status, Some(0), "{}", first.err);
    assert!(first.out.contains("2 computed, 0 there before"), "{}", first.out);
    let (page, kept) = (fs::read_to_string(out.join("report.html")).expect("the page"), files(&results));
    assert_eq!(kept.keys().collect::<Vec<_>>(), ["pair_22.5_0.40g.json", "straight_0_0.23g.json"], "and nothing else");

    let again = study(&out, &["--threads", "1"]);
    assert!(again.out.contains("0 computed, 2 there before"), "{}", again.out);
    fs::remove_file(results.join("straight_0_0.23g.json")).expect("it is there");
    fs::write(results.join("pair_22.5_0.40g.json"), &kept["pair_22.5_0.40g.json"][..1000]).expect("cut");
    let resumed = study(&out, &["--threads", "2"]);
    assert!(resumed.out.contains("2 computed, 0 there before"), "one is gone, one is half a file: {}", resumed.out);
    assert_eq!(files(&results), kept, "to the last bit, by another number of threads");
    let resumed = fs::read_to_string(out.join("report.html")).expect("the page");
    assert!(resumed == page, "so is the page");

    let louder = study(&out, &["--record-scale", "2"]);
    assert!(louder.out.contains("0 computed, 2 there before"), "neither is shaken by the earthquake: {}", louder.out);
}

#[test]
fn the_page_is_whole_by_itself_and_states_what_is_assumed() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = study(folder.path(), &["--date", "a day", "--machine", "a <machine>"]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    let page = fs::read_to_string(folder.path().join("report.html")).expect("the page");
    let ends = page.replace("http://www.w3.org/2000/svg", "");
    for outside in ["http:", "https:", "src=", "@import", "url("] {
        assert!(!ends.contains(outside), "nothing from outside: {outside}");
    }
    assert!(page.contains("a &lt;machine&gt;"), "names cannot break the page");
    for stated in
        ["gap of 3 mm", "built-in synthetic one, not El Centro", "scale 1", "2 of 68 cases", "--only straight_0_0.23g"]
    {
        assert!(page.contains(stated), "{stated}");
    }
    assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count(), "pictures are closed");
    assert!(page.contains("id=\"case-pair_22.5_0.40g\"") && page.contains("Fig. 26"), "what was run is shown");
    assert!(!page.contains("NaN") && page.contains("not run"), "what was not is named");
}

#[test]
fn a_record_is_named_with_its_scale() {
    let folder = tempfile::tempdir().expect("a folder");
    let (record, out) = (folder.path().join("quake.csv"), folder.path().join("study"));
    let samples: Vec<String> = (0..400).map(|i| (f64::from(i) * 0.15).sin().to_string()).collect();
    fs::write(&record, samples.join("\n")).expect("written");
    let (out, record) = (out.to_str().expect("UTF-8"), record.to_str().expect("UTF-8"));
    let fixed = ["study", "experiment", "--only", "straight_0_record", "--out", out, "--record", record];
    let said = call(&[&fixed[..], &["--dt", "0.01", "--unit", "m/s2", "--record-scale", "1.5"]].concat());
    assert_eq!(said.status, Some(0), "{}", said.err);
    let page = fs::read_to_string(Path::new(out).join("report.html")).expect("the page");
    // 1 m/s² times 1.5 is 0.153 g.
    assert!(
        page.contains("quake.csv") && page.contains("scale 1.5, peak 0.15") && !page.contains("not El Centro"),
        "named"
    );
    let missing = call(&fixed);
    assert!(
        missing.status == Some(2) && missing.err.contains("quake.csv"),
        "its interval is not stated: {}",
        missing.err
    );
}

#[test]
fn mistaken_flags_of_the_experiment_are_told() {
    for (flags, word) in [
        (vec!["--only", "straight"], "--out"),
        (vec!["--only", "straight_1_0.23g", "--out", "x"], "straight_1_0.23g"),
        (vec!["--channel", "1", "--out", "x"], "--record"),
        (vec!["--record-scale", "0", "--out", "x"], "--record-scale"),
        (vec!["--record", "there-is-no-such-file", "--out", "x"], "there-is-no-such-file"),
        (vec!["--threads", "0", "--out", "x"], "--threads"),
    ] {
        let said = call(&[&["study", "experiment"], flags.as_slice()].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{flags:?}: {}", said.err);
    }
    assert!(!Path::new("x").exists(), "nothing was written");
}
