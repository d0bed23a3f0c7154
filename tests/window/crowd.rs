//! Many girders: the window shows them with about as many triangles as a few.

#[expect(dead_code, reason = "rows of placed corners are for pictures")]
#[path = "../support/row.rs"]
mod row;

use egui::epaint::{ClippedPrimitive, Primitive};
use egui::{Context, RawInput, Rect, pos2, vec2};
use girderbench::app::Workbench;
use girderbench::files::SceneSource;
use girderbench::scene::Scene;

/// Vertices of a frame of a row's window, once it has come to rest.
fn vertices(girders: usize) -> usize {
    let mut bench = Workbench::new(Scene { duration: 1.0, ..row::of(girders) }, SceneSource::New);
    bench.replay.runner.set_estimates(false);
    bench.replay.runner.wait();
    let context = Context::default();
    let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 720.0));
    let mut last = 0;
    for _ in 0..4 {
        let input = RawInput { screen_rect: Some(screen), ..RawInput::default() };
        let mut output = context.run_ui(input, |ui| girderbench::app::show(&mut bench, ui));
        output.textures_delta.clear();
        let of = |job: &ClippedPrimitive| match &job.primitive {
            Primitive::Mesh(mesh) => mesh.vertices.len(),
            Primitive::Callback(_) => 0,
        };
        last = context.tessellate(std::mem::take(&mut output.shapes), 1.0).iter().map(of).sum();
    }
    last
}

#[test]
fn a_frame_of_sixty_girders_has_few_more_triangles_than_one_of_eight() {
    let (few, many) = (vertices(8), vertices(60));
    assert!(few > 10_000, "curves, bars and words: {few}");
    assert!(many < 2 * few, "no curve of its own for each of sixty: {many} vertices, {few} for eight");
}
