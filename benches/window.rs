//! What a frame of the window costs besides drawing it: panels, handles, draw list, tessellation.
//! `cargo bench --bench window`; nothing is rasterised.

#[expect(dead_code, reason = "rows of placed corners are for pictures")]
#[path = "../tests/support/row.rs"]
mod row;

use divan::Bencher;
use egui::{Context, Rect, pos2, vec2};
use girderbench::app::{SelectCommand, TimeCommand, Workbench, show};
use girderbench::files::SceneSource;
use girderbench::scene::{Scene, presets};
use girderbench::view::Target;

fn main() {
    divan::main();
}

/// A window that has come to rest on a scene, with a girder selected.
fn window(scene: Scene) -> (Workbench, Context) {
    let mut bench = Workbench::new(scene, SceneSource::New);
    bench.replay.runner.set_estimates(false);
    bench.tasks.set_silent();
    bench.replay.runner.wait();
    bench.apply(SelectCommand::Only(Some(Target::Girder(0))));
    let context = Context::default();
    for _ in 0..8 {
        frame(&mut bench, &context);
    }
    (bench, context)
}

fn frame(bench: &mut Workbench, context: &Context) -> usize {
    let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 720.0));
    let input = egui::RawInput { screen_rect: Some(screen), ..egui::RawInput::default() };
    let mut output = context.run_ui(input, |ui| show(bench, ui));
    let shapes = std::mem::take(&mut output.shapes);
    output.textures_delta.clear();
    context.tessellate(shapes, output.pixels_per_point).len()
}

/// A frame in which the time has moved on: everything that depends on it is made anew.
fn moving(bencher: Bencher<'_, '_>, scene: Scene) {
    let (mut bench, context) = window(scene);
    let mut t = 0.1;
    bencher.bench_local(|| {
        t = if t > 1.5 { 0.1 } else { t + 0.0011 };
        bench.apply(TimeCommand::Seek(t));
        frame(&mut bench, &context)
    });
}

fn opening() -> Scene {
    presets::load(presets::OPENING).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A row, run for two seconds.
fn row_of(count: usize) -> Scene {
    Scene { duration: 2.0, ..row::of(count) }
}

#[divan::bench]
fn frame_of_the_opening_scene(bencher: Bencher<'_, '_>) {
    moving(bencher, opening());
}

#[divan::bench]
fn frame_of_a_hundred_girders(bencher: Bencher<'_, '_>) {
    moving(bencher, row_of(100));
}

/// Nothing has changed: what an event that changes nothing costs.
#[divan::bench]
fn frame_in_which_nothing_moved(bencher: Bencher<'_, '_>) {
    let (mut bench, context) = window(opening());
    bencher.bench_local(|| frame(&mut bench, &context));
}
