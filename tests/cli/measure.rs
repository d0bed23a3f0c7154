//! From equations to pixels and back: films of marks, measured and held against the run that they show.

use std::path::{Path, PathBuf};

use girderbench::render::{Image, Packing};

use crate::program::{Said, call};

/// A film of marks of the 45° girder while it pounds; none where nothing draws and nothing has to.
fn film(folder: &Path, flags: &[&str]) -> Option<Said> {
    let out = folder.to_str().expect("a UTF-8 path");
    let said = call(&[&["render", "skew45-abutment", "--marks", "--out", out], flags].concat());
    let required = std::env::var_os("GIRDERBENCH_REQUIRE_GPU").is_some_and(|v| v == "1");
    assert!(said.status != Some(3) || !required, "GIRDERBENCH_REQUIRE_GPU=1, but {}", said.err);
    (said.status != Some(3)).then_some(said)
}

fn measure(folder: &Path, flags: &[&str]) -> Said {
    call(&[&["measure", folder.to_str().expect("UTF-8")], flags].concat())
}

/// Numbers before ` pixel` after `RMS` and after `largest`, of x and of y.
fn errors(said: &str) -> Vec<f64> {
    let of = |line: &str, word: &str| {
        let rest = line.split(word).nth(1)?;
        rest.trim().split(' ').next()?.parse::<f64>().ok()
    };
    let lines = said.lines().filter(|line| line.contains("pixel ="));
    lines.flat_map(|line| [of(line, "RMS"), of(line, "largest")]).map(|n| n.expect("a number")).collect()
}

fn picture(folder: &Path, number: u32) -> PathBuf {
    folder.join(format!("skew45-abutment-marks-{number:05}.png"))
}

/// Paints a disk into a picture.
fn paint(path: &Path, [cx, cy]: [f64; 2], radius: f64, brightness: u8) {
    let mut image = Image::from_png(&std::fs::read(path).expect("a picture")).expect("PNG");
    let width = image.width as usize;
    for (n, pixel) in image.rgba.chunks_exact_mut(4).enumerate() {
        let (x, y) = ((n % width) as f64 + 0.5, (n / width) as f64 + 0.5);
        if (x - cx).hypot(y - cy) <= radius {
            pixel[..3].fill(brightness);
        }
    }
    std::fs::write(path, image.to_png(&[], Packing::Quick)).expect("written");
}

#[test]
fn a_film_of_marks_gives_the_run_back_to_a_twentieth_of_a_pixel() {
    let folder = tempfile::tempdir().expect("a folder");
    let Some(said) = film(folder.path(), &["--from", "0.2", "--to", "1.2"]) else { return };
    assert!(said.status == Some(0) && said.out.contains("31 frames"), "{}{}", said.out, said.err);
    let size = Image::from_png(&std::fs::read(picture(folder.path(), 1)).expect("a picture")).expect("PNG");
    assert_eq!([size.width, size.height], [720, 465], "the paper's camera");
    let out = folder.path().join("measured");
    let flags = ["--scene", "skew45-abutment", "--out", out.to_str().expect("UTF-8")];
    let said = measure(folder.path(), &flags);
    assert_eq!(said.status, Some(0), "{}", said.err);
    let found = errors(&said.out);
    assert!(found.len() == 4 && found[0] < 0.05 && found[2] < 0.05, "RMS along x and y: {}", said.out);
    assert!(
        found.iter().all(|error| *error < 0.1 && *error > 0.0),
        "largest, and no comparison with itself: {}",
        said.out
    );
    let table = std::fs::read_to_string(out.join("measured.csv")).expect("a table");
    assert!(table.starts_with("t_s,deck.x_mm,deck.y_mm,deck.theta_deg\n0.2,"), "{table}");
    assert_eq!(table.lines().count(), 32, "heading and pictures");
    // The table of a run, read back, is the same reference.
    let run = folder.path().join("run");
    let run = run.to_str().expect("UTF-8");
    assert_eq!(
        call(&["run", "skew45-abutment", "--until", "2", "--sample", "1000", "--out", run]).status,
        Some(0),
        "run"
    );
    let again = errors(&measure(folder.path(), &["--run", run]).out);
    assert!(found.iter().zip(&again).all(|(a, b)| (a - b).abs() < 2e-3), "{found:?}, {again:?}");
    // Without a layout every mark is on one body, and the scale must be given.
    let bare = picture(folder.path(), 1);
    let bare = bare.to_str().expect("UTF-8");
    let said = call(&["measure", bare, bare, "--mm-per-pixel", "0.4"]);
    assert!(
        said.status == Some(0) && said.out.contains("5 marks") && said.out.contains("marks: x 0.000"),
        "{}",
        said.out
    );
    assert!(call(&["measure", bare]).err.contains("no scale: give mm_per_pixel"), "a scale is not guessed");
}

#[test]
fn lost_marks_and_bad_pictures_are_told_with_their_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    if film(folder.path(), &["--to", "0.1"]).is_none() {
        return;
    }
    let layout = std::fs::read_to_string(folder.path().join("marks.toml")).expect("a layout");
    let places: Vec<[f64; 2]> = layout
        .lines()
        .filter_map(|line| line.strip_prefix("pixel = [")?.strip_suffix(']')?.split_once(", "))
        .map(|(x, y)| [x, y].map(|v| v.parse().expect("a number")))
        .collect();
    let refused = |words: &[&str]| {
        let said = measure(folder.path(), &[]);
        let all = words.iter().all(|word| said.err.contains(word));
        assert!(said.status == Some(2) && all, "{words:?}: {}", said.err);
    };
    let third = picture(folder.path(), 3);
    let kept = std::fs::read(&third).expect("a picture");
    paint(&third, places[3], 20.0, 60);
    refused(&["00003.png (picture 3): mark 4 (deck) is missing"]);
    std::fs::write(&third, &kept).expect("put back");
    paint(&third, [places[3][0] + 9.0, places[3][1]], 9.0, 240);
    refused(&["picture 3", "mark 4 (deck) has run together with something bright"]);
    std::fs::write(&third, &kept[..200]).expect("cut off");
    refused(&["00003.png: no PNG picture"]);
    std::fs::remove_file(&third).expect("removed");
    refused(&[
        "after skew45-abutment-marks-00002.png comes skew45-abutment-marks-00004.png",
        "put what is missing there",
    ]);
    std::fs::remove_file(picture(folder.path(), 4)).expect("removed");
    refused(&["the layout states 4 pictures, 2 are there"]);
    std::fs::write(folder.path().join("marks.toml"), layout.replace("fps = 30.0", "fps = 30.0\nfsp = 1"))
        .expect("written");
    refused(&["marks.toml: line 2: unknown field `fsp`"]);
    let wrong = measure(folder.path(), &["--layout", "nowhere.toml"]);
    assert!(wrong.err.contains("nowhere.toml"), "{}", wrong.err);
    let empty = tempfile::tempdir().expect("a folder");
    assert!(measure(empty.path(), &[]).err.contains("no PNG pictures"), "an empty folder");
    for (flags, word) in [
        (["--marks", "--view", "iso"], "straight from above"),
        (["--marks", "--out", "film.gif"], "give a folder"),
        (["--rate", "30", "--fps"], "--fps"),
    ] {
        let said = call(&[&["render", "skew45-abutment"], flags.as_slice()].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{flags:?}: {}", said.err);
    }
}

#[test]
fn an_exposure_blurs_what_moves_and_measuring_finds_the_mean_of_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let film_of = |name: &str, flags: &[&str]| {
        let out = folder.path().join(name);
        let span = ["--from", "0.4", "--to", "0.6"];
        let said = film(&out, &[&span[..], flags].concat())?;
        assert_eq!(said.status, Some(0), "{}", said.err);
        Some(errors(&measure(&out, &["--scene", "skew45-abutment"]).out))
    };
    let Some(sharp) = film_of("sharp", &[]) else { return };
    let blurred = film_of("blurred", &["--exposure-ms", "16"]).expect("it draws");
    // ẍ T²/24 of a girder at 0.4 g is 0.04 mm, and the part of a hit within the exposure comes beside it.
    assert!(blurred[0] > 3.0 * sharp[0] && blurred[0] < 0.3, "RMS along x: {blurred:?} against {sharp:?} pixel");
    let said = call(&["render", "skew45-abutment", "--marks", "--exposure-ms", "34"]);
    assert!(said.status == Some(2) && said.err.contains("--exposure-ms 34: pictures are 33.3"), "{}", said.err);
    let said = call(&["render", "skew45-abutment", "--exposure-ms", "5"]);
    assert!(said.status == Some(2) && said.err.contains("--marks"), "{}", said.err);
}
