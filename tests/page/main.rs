//! The page in a real browser, Chromium without a screen that draws WebGL2 in software: it opens, plays, takes the mouse, says its
//! numbers, opens and saves files, follows links, and answers as this program does.
//!
//! `assets/web/build.sh` makes the page; `cargo test --test page -- --ignored` wants chromium and chromedriver.

mod driver;

use std::io::Write as _;
use std::path::{Path, PathBuf};

use driver::{Page, serve};
use flate2::Compression;
use flate2::write::GzEncoder;
use girderbench::language::JAPANESE_FONT;
use girderbench::scene::presets;
use girderbench::sim::History;
use serde_json::Value;

/// Longest time to the first picture, drawn in software on two processors \[ms\]; a desk computer has a graphics card.
const FIRST_PICTURE: f64 = 10_000.0;

/// Farthest that displacements part from those of this program \[m\]: libraries round sin and exp differently in the last bit, and
/// each hit magnifies that (`tests/web/core.mjs` measures it over all presets).
const PARTED: f64 = 1e-9;

/// Presets whose answers are compared.
const COMPARED: [&str; 4] = ["straight-abutment", "skew60-abutment", "skew45-abutment", "deck-30m"];

/// Times at which displacements are compared.
const LOOKS: u32 = 500;

/// Most bytes of the page as a server sends them, compressed, without the Japanese letters.
const MOST_BYTES: usize = 4_000_000;

/// The page's files.
fn folder() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = std::env::var_os("GIRDERBENCH_PAGE").map_or_else(|| root.join("out/web"), PathBuf::from);
    assert!(folder.join("index.html").is_file(), "{}: assets/web/build.sh makes it", folder.display());
    folder
}

/// A page that has been opened, with a folder for its downloads.
struct Opened {
    page: Page,
    address: String,
    _downloads: tempfile::TempDir,
}

impl Opened {
    fn at(fragment: &str) -> (Self, Value) {
        let downloads = tempfile::tempdir().expect("a folder");
        let address = format!("{}/index.html", serve(&folder()));
        let page = Page::open([1280, 800], downloads.path());
        page.go(&format!("{address}{fragment}"));
        let readings = page.until("the first picture", |r| r["first_picture_ms"].is_number() && is_there(r));
        (Self { page, address, _downloads: downloads }, readings)
    }
}

/// Whether the answer of the scene is there, in full.
fn is_there(readings: &Value) -> bool {
    readings["digest"].is_string() && readings["stale"] == false
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

/// What is told of the runs; the harness keeps it unless it is asked for or the test fails.
fn tell(words: &str) {
    let _ = writeln!(std::io::stderr(), "page: {words}");
}

#[test]
#[ignore = "wants a browser and the page: .ci/run brings both"]
fn the_page_opens_plays_takes_the_mouse_and_says_its_numbers() {
    let (opened, readings) = Opened::at("");
    let page = &opened.page;
    tell(&format!("first picture after {} ms, drawn by {}", readings["first_picture_ms"], readings["adapter"]));
    assert!(number(&readings["first_picture_ms"]) < FIRST_PICTURE, "{readings}");
    assert_eq!(readings["scene"], presets::OPENING, "what the window opens on");
    assert_eq!(page.script("return document.getElementById('message').textContent"), "", "nothing over it");

    // It reads a number that the run has.
    let peak = page.widget("Button", "pair peak ");
    let here = History::of(&presets::load(presets::OPENING).expect("ships")).expect("it runs").summary();
    let words = peak["name"].as_str().expect("it has a name");
    let parted = (number(&readings["summary"]["peak_force"]) - here.peak_force).abs() / here.peak_force;
    assert!(parted < 1e-6, "the force of this program's run, {words}: it parts by {parted}");
    tell(&format!("says {words}"));

    let still = page.picture();
    page.key(" ");
    let played = page.until("the time goes on", |r| number(&r["t"]) > 0.05);
    page.key(" ");
    page.until("the time stands", |r| r["playing"] == false);
    assert_ne!(page.picture(), still, "another picture, t = {}", played["t"]);

    let slider = page.widget("Slider", "Skew");
    let before = page.readings()["digest"].clone();
    page.drag(&slider, 40.0);
    let after = page.until("a drag of a slider is answered", |r| is_there(r) && r["digest"] != before);
    let moved = page.widget("Slider", "Skew");
    assert_ne!(moved["number"], slider["number"], "{slider}");
    tell(&format!(
        "{} from {} to {}: computed in {} s",
        slider["name"], slider["number"], moved["number"], after["took_s"]
    ));
    assert_eq!(page.complaints(), [""; 0], "nothing on the console");
}

#[test]
#[ignore = "wants a browser and the page: .ci/run brings both"]
fn links_lead_to_a_lesson_a_moment_a_language_and_a_scene() {
    let (opened, readings) = Opened::at("#lesson=stick-and-slip&t=0.42&lang=ja");
    let page = &opened.page;
    assert_eq!(readings["lesson"], "stick-and-slip", "the lesson");
    assert_eq!(
        (number(&readings["t"]), &readings["language"]),
        (0.42, &Value::from("ja")),
        "when, and in which language"
    );
    page.widget("Button", "ファイル");

    // Another link into the page that is open.
    page.script("location.hash = '#scene=skew60-abutment&t=1.5&lang=en'");
    let other = page.until("the other scene", |r| r["scene"] == "skew60-abutment" && is_there(r));
    assert_eq!((number(&other["t"]), other["lesson"].is_null()), (1.5, true), "its moment, and no lesson");
    page.script("location.hash = '#scene=no-such-scene'");
    page.until("what has no sense is said", |r| {
        r["notice"].as_str().is_some_and(|words| words.contains("no-such-scene"))
    });

    // A scene of the user's own, copied as a link and opened by it.
    page.drag(&page.widget("Slider", "Skew"), 40.0);
    page.until("the edit", |r| is_there(r) && r["digest"] != other["digest"]);
    page.choose("File", "Copy link");
    page.until("it is said", |r| r["notice"].as_str().is_some_and(|words| words.contains("copied")));
    let own = page.until("the last of the edit", is_there);
    let link = page.script("return location.href");
    let link = link.as_str().expect("an address");
    assert!(link.contains("#toml="), "{link}");
    tell(&format!("a scene of the user's own is a link of {} letters", link.len()));
    assert_eq!(page.complaints(), [""; 0], "nothing on the console");
    let (again, readings) = Opened::at(&link[opened.address.len()..]);
    assert_eq!((&readings["digest"], &readings["scene"]), (&own["digest"], &own["scene"]), "the same run");
    assert_eq!(again.page.complaints(), [""; 0], "nothing on the console");
}

#[test]
#[ignore = "wants a browser and the page: .ci/run brings both"]
fn scenes_pictures_and_reports_are_saved_and_scenes_opened() {
    let (opened, _) = Opened::at("#scene=straight-abutment");
    let page = &opened.page;
    let choose = |item: &str| page.choose("File", item);
    choose("Save as");
    let saved = String::from_utf8(page.downloaded("straight-abutment.toml")).expect("text");
    let preset = presets::get("straight-abutment").expect("ships");
    assert_eq!(saved, preset.text, "with its comments");
    choose("Export picture");
    let picture = page.downloaded("straight-abutment.png");
    assert!(picture.starts_with(b"\x89PNG") && picture.len() > 10_000, "{} bytes", picture.len());
    choose("Export report");
    let report = String::from_utf8(page.downloaded("straight-abutment.html")).expect("text");
    assert!(report.contains("</html>"), "whole");
    assert!(report.contains("at 2.4 Hz") && !report.contains("check-"), "with its words, and none of their keys");

    // The browser's dialog is no part of the page: what a user does in it is done by a script.
    let text = preset.text.replace("straight-abutment", "of-a-file");
    page.script(&format!(
        "HTMLInputElement.prototype.click = function () {{
             const chosen = new DataTransfer();
             chosen.items.add(new File([{}], 'of-a-file.toml'));
             this.files = chosen.files;
             this.dispatchEvent(new Event('change'));
         }}",
        Value::from(text)
    ));
    choose("Open");
    page.until("the scene of the file", |r| r["scene"] == "of-a-file" && is_there(r));
    choose("Export tables");
    page.until("where the tables are is said", |r| {
        r["notice"].as_str().is_some_and(|words| words.contains("browser: trajectory.csv"))
    });
    assert_eq!(page.complaints(), [""; 0], "nothing on the console");
}

#[test]
#[ignore = "wants the page: .ci/run brings it"]
fn the_page_is_small_enough_for_a_lecture_hall() {
    let compressed = |bytes: &[u8]| {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(bytes).and_then(|()| encoder.finish()).expect("memory takes it").len()
    };
    let files = std::fs::read_dir(folder()).expect("a folder").map(|entry| entry.expect("an entry").path());
    let all: usize = files.map(|file| compressed(&std::fs::read(file).expect("a file"))).sum();
    let letters = compressed(JAPANESE_FONT);
    tell(&format!("{all} bytes compressed, {letters} of them the Japanese letters"));
    assert!(all - letters < MOST_BYTES, "{all} less {letters}");
}

/// Displacements of each girder in a table of the trajectory, at its rows' times: farthest from those of a run \[m\].
fn parted(table: &str, history: &History) -> f64 {
    let mut lines = table.lines().map(|line| line.split(','));
    let names: Vec<&str> = lines.next().expect("it has a head").collect();
    let mut most = 0.0_f64;
    let rows: Vec<Vec<f64>> = lines.map(|row| row.map(|value| value.parse().expect("a number")).collect()).collect();
    assert!(!rows.is_empty(), "it has rows");
    for row in rows.iter().step_by((rows.len() / LOOKS as usize).max(1)) {
        for (number, girder) in history.model().girders().iter().enumerate() {
            let at = |axis: &str| names.iter().position(|name| *name == format!("{}.{axis}", girder.name));
            let here = history.motion(number, row[0]).displacement;
            for (axis, here) in [("x", here.x), ("y", here.y)] {
                most = most.max((row[at(axis).expect("a column")] - here).abs());
            }
        }
    }
    most
}

#[test]
#[ignore = "wants a browser and the page: .ci/run brings both"]
fn the_page_answers_as_this_program_does() {
    let (opened, _) = Opened::at("");
    for name in COMPARED {
        let answer = opened.page.script(&format!(
            "const answer = girderbench.answer('{name}'); return [answer.digest, answer.tables['trajectory.csv']]"
        ));
        let history = History::of(&presets::load(name).expect("ships")).expect("it runs");
        let same = answer[0] == format!("{:016x}", history.digest());
        let metres = parted(answer[1].as_str().expect("a table"), &history);
        tell(&format!(
            "{name}: digest {}, displacements part by {metres:.1e} m",
            if same { "equal" } else { "differs" }
        ));
        assert!(metres <= PARTED, "{name} parts by {metres} m");
    }
}
