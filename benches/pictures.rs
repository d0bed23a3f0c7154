//! What pictures cost, and what is saved by not drawing what a picture does not need.
//! `cargo bench --features render --bench pictures`; compare figures of one run with each other.
//!
//! Without an adapter, not even in software, the benchmarks that draw do nothing and say so.

#[path = "../tests/support/row.rs"]
mod row;

use std::io::Write as _;
use std::process::{Command, Stdio};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use divan::{Bencher, black_box};
use girderbench::render::{GpuError, Image, Packing};
use girderbench::scene::{Overlays, Scene, ViewPreset, presets};
use girderbench::sim::History;
use girderbench::snapshot::{Instant, Shot, Studio, film};
use girderbench::view::{Background, Bounds, Camera, DrawList, Moment, ViewInput, draw_moment};

const SIZE: [u32; 2] = [1280, 720];
const ASPECT: f64 = 16.0 / 9.0;
/// Girders in a row.
const ROWS: [usize; 4] = [1, 5, 100, 1000];
/// Frames of the short film.
const FRAMES: u32 = 10;

fn main() {
    divan::main();
}

/// The device that all benchmarks draw on.
fn studio() -> Option<MutexGuard<'static, Studio>> {
    static STUDIO: OnceLock<Option<Mutex<Studio>>> = OnceLock::new();
    let studio = STUDIO.get_or_init(|| match Studio::open(None) {
        Ok(studio) => Some(Mutex::new(studio)),
        Err(error) => {
            // Where nobody reads, nobody is told.
            let _ = writeln!(std::io::stderr(), "no pictures are drawn: {error}");
            None
        }
    });
    studio.as_ref().map(|studio| studio.lock().unwrap_or_else(PoisonError::into_inner))
}

fn skewed() -> History {
    let scene = presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"));
    History::of(&scene).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A row as placed.
fn placed(girders: usize) -> (Scene, Moment) {
    let scene = row::of(girders);
    let moment = Moment::placed(&scene);
    (scene, moment)
}

/// A row seen whole, or one girder of it, with every overlay that needs no run.
fn list_of((scene, moment): &(Scene, Moment), close: bool) -> DrawList {
    let mut camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(scene), ASPECT);
    if close {
        camera.frame(Bounds::of_points(row::corners_of(scene, scene.girders.len() / 2)), ASPECT);
    }
    let input = ViewInput {
        scene,
        history: None,
        t: 0.0,
        camera: &camera,
        overlays: Overlays::default(),
        force_scale: None,
        selected: &[],
        kept: &[],
        exaggeration: 1.0,
        bent: None,
        clear: &[],
        size: SIZE,
        pixels_per_point: 1.0,
        background: Background::Studio,
        title: None,
    };
    draw_moment(&input, moment)
}

/// From a moment of a row to its draw list, all of it in view.
#[divan::bench(args = ROWS)]
fn list_of_all(bencher: Bencher<'_, '_>, girders: usize) {
    let row = placed(girders);
    bencher.bench(|| list_of(black_box(&row), false));
}

/// From a moment of a row to its draw list, one girder in view.
#[divan::bench(args = ROWS)]
fn list_of_one(bencher: Bencher<'_, '_>, girders: usize) {
    let row = placed(girders);
    bencher.bench(|| list_of(black_box(&row), true));
}

fn frames(bencher: Bencher<'_, '_>, culls: bool, list: &DrawList) {
    let Some(mut studio) = studio() else { return };
    studio.set_culling(culls);
    bencher.bench_local(|| studio.draw(black_box(list)).map(|image| image.rgba.len()));
    studio.set_culling(true);
}

/// One frame of one girder of a row, what is out of view left out.
#[divan::bench(args = ROWS, sample_count = 20)]
fn frame_culled(bencher: Bencher<'_, '_>, girders: usize) {
    frames(bencher, true, &list_of(&placed(girders), true));
}

/// The same with all of the row uploaded and drawn.
#[divan::bench(args = ROWS, sample_count = 20)]
fn frame_not_culled(bencher: Bencher<'_, '_>, girders: usize) {
    frames(bencher, false, &list_of(&placed(girders), true));
}

/// The hardest hit at 1280 × 720 with all overlays, some, and none.
#[divan::bench(args = ["all", "no cones", "no arrows", "no texts", "none"], sample_count = 20)]
fn frame_with_overlays(bencher: Bencher<'_, '_>, which: &str) {
    let on = Overlays { normal: true, tangential: true, damping: true, ..Overlays::default() };
    let bodies = Overlays { gap: false, contacts: false, legend: false, axes: false, title: false, names: false, ..on };
    let overlays = match which {
        "no cones" => Overlays { cones: false, ..on },
        "no arrows" => Overlays { normal: false, tangential: false, damping: false, resultant: false, ..on },
        "no texts" => bodies,
        "none" => {
            let quiet = Overlays { cones: false, grid: false, bearings: false, resultant: false, ..bodies };
            Overlays { normal: false, tangential: false, damping: false, ..quiet }
        }
        _ => on,
    };
    let shot = Shot { overlays: Some(overlays), size: SIZE, ..Shot::default() };
    frames(bencher, true, &shot.list(&skewed()));
}

/// One picture on a device that is there.
#[divan::bench(sample_count = 10)]
fn picture_on_a_kept_device(bencher: Bencher<'_, '_>) {
    frames(bencher, true, &Shot::default().list(&skewed()));
}

/// One picture on a device brought up for it.
#[divan::bench(sample_count = 10)]
fn picture_on_a_new_device(bencher: Bencher<'_, '_>) {
    if studio().is_some() {
        let list = Shot::default().list(&skewed());
        bencher.bench(|| Studio::open(None)?.draw(black_box(&list)));
    }
}

/// A PNG file of a frame at 1280 × 720.
#[divan::bench(args = [Packing::Small, Packing::Quick], sample_count = 10)]
fn png(bencher: Bencher<'_, '_>, packing: Packing) {
    let image: Option<Image> = studio().and_then(|mut studio| studio.draw(&Shot::default().list(&skewed())).ok());
    if let Some(image) = image {
        bencher.bench(|| black_box(&image).to_png(&[], packing));
    }
}

/// Ten frames, drawn and packed in this process, device and pipelines there.
#[divan::bench(sample_count = 5)]
fn film_in_this_process(bencher: Bencher<'_, '_>) {
    let Some(mut studio) = studio() else { return };
    let history = skewed();
    let shot = |i| Shot { at: Instant::At(0.05 * f64::from(i)), size: SIZE, ..Shot::default() };
    let shots: Vec<Shot> = (0..FRAMES).map(shot).collect();
    bencher.bench_local(|| film(&mut studio, &history, &shots, Packing::Quick, &mut |_| Ok::<_, GpuError>(())));
}

fn call(args: &[&str]) {
    let program = env!("CARGO_BIN_EXE_girderbench");
    let done = Command::new(program).args(args).stdout(Stdio::null()).stderr(Stdio::null()).status();
    assert!(done.is_ok_and(|status| status.success()), "{program} {args:?}");
}

/// Ten frames by one call of the program.
#[divan::bench(sample_count = 5)]
fn film_in_one_process(bencher: Bencher<'_, '_>) {
    if studio().is_some() {
        let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
        let (out, frames) = (folder.path().to_string_lossy(), FRAMES.to_string());
        bencher.bench(|| call(&["render", "skew45-abutment", "--frames", &frames, "--to", "0.45", "--out", &out]));
    }
}

/// The same ten frames by ten calls.
#[divan::bench(sample_count = 3)]
fn film_in_ten_processes(bencher: Bencher<'_, '_>) {
    if studio().is_some() {
        let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
        let out = folder.path().to_string_lossy();
        bencher.bench(|| {
            for i in 0..FRAMES {
                let at = format!("{}", 0.05 * f64::from(i));
                call(&["render", "skew45-abutment", "--at", &at, "--out", &out]);
            }
        });
    }
}
