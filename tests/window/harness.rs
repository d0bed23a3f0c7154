//! What the window tests share: the whole workbench in a harness, and the mouse in its 3D view.

use egui::accesskit::Role;
use egui::{Key, Modifiers, Pos2, Rect, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use girderbench::app::Workbench;
use girderbench::files::SceneSource;
use girderbench::scene::{Scene, presets};
use glam::DVec3;

/// Time that one frame of the harness takes \[s\].
pub(crate) const FRAME: f32 = 0.02;

/// Frames in which the window comes to rest, a camera on its way among them.
const MOST_FRAMES: u64 = 32;

/// The workbench on a preset, its first run done, at 1280×720.
pub(crate) fn open(preset: &str) -> Harness<'static, Workbench> {
    let mut harness = builder([1280.0, 720.0]).build_ui_state(show, bench(preset));
    settle(&mut harness);
    harness
}

/// The workbench on the first seconds of a preset, for tests of a window that is to look the same and run again and again.
pub(crate) fn open_for(preset: &str, duration_s: f64) -> Harness<'static, Workbench> {
    let scene = Scene { duration: duration_s, ..presets::load(preset).expect("the preset ships") };
    let mut harness = builder([1280.0, 720.0]).build_ui_state(show, bench_of(scene));
    settle(&mut harness);
    harness
}

/// A workbench on a preset that leaves the machine alone while idle, so that tests do not depend on time.
pub(crate) fn bench(preset: &str) -> Workbench {
    bench_of(presets::load(preset).expect("the preset ships"))
}

/// As [`bench`], on any scene.
pub(crate) fn bench_of(scene: Scene) -> Workbench {
    let mut bench = Workbench::new(scene, SceneSource::New);
    bench.replay.runner.set_estimates(false);
    bench.replay.runner.wait();
    bench
}

/// The size of a harness whose inside is a window of this size: the harness itself keeps 8 points on every side.
pub(crate) fn in_harness(size: [f32; 2]) -> Vec2 {
    Vec2::from(size) + Vec2::splat(16.0)
}

/// A harness whose inside is a window of this size.
pub(crate) fn builder(size: [f32; 2]) -> egui_kittest::HarnessBuilder<Workbench> {
    Harness::builder().with_size(in_harness(size)).with_step_dt(FRAME).with_max_steps(MOST_FRAMES)
}

/// The whole window.
pub(crate) fn show(ui: &mut egui::Ui, bench: &mut Workbench) {
    girderbench::app::show(bench, ui);
}

/// Lets the window come to rest. A run that a busy machine did not finish within a frame is waited for.
pub(crate) fn settle(harness: &mut Harness<'_, Workbench>) {
    harness.step();
    harness.state_mut().replay.runner.wait();
    harness.run();
}

/// Moves a slider by its name.
pub(crate) fn slide(harness: &mut Harness<'_, Workbench>, label: &str, value: f64) {
    harness.get_by_role_and_label(Role::Slider, label).set_value_accesskit(value);
    settle(harness);
}

/// Presses a button by its name.
pub(crate) fn press(harness: &mut Harness<'_, Workbench>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click();
    settle(harness);
}

/// Scrolls a button into sight and lets its panel come to rest.
pub(crate) fn reach(harness: &mut Harness<'_, Workbench>, label: &str) {
    reach_as(harness, Role::Button, label);
}

/// Scrolls what is called so and has this role into sight.
pub(crate) fn reach_as(harness: &mut Harness<'_, Workbench>, role: Role, label: &str) {
    harness.get_by_role_and_label(role, label).scroll_to_me();
    harness.run_steps(40);
}

/// Opens a list by its name and takes one of its choices.
pub(crate) fn choose(harness: &mut Harness<'_, Workbench>, list: &str, choice: &str) {
    reach_as(harness, Role::ComboBox, list);
    harness.get_by_role_and_label(Role::ComboBox, list).click();
    harness.run_steps(20);
    let choices: Vec<_> = harness.query_all_by_role_and_label(Role::Button, choice).collect();
    choices.last().expect("in the list").click();
    harness.run_steps(20);
    settle(harness);
}

/// Types a text into a field.
pub(crate) fn type_in(harness: &mut Harness<'_, Workbench>, label: &str, text: &str) {
    reach_as(harness, Role::SpinButton, label);
    harness.get_by_role_and_label(Role::SpinButton, label).click();
    settle(harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    if text.is_empty() {
        harness.key_press(Key::Delete);
    } else {
        harness.event(egui::Event::Text(text.into()));
    }
    settle(harness);
    harness.key_press(Key::Enter);
    settle(harness);
}

/// The 3D view on the screen.
pub(crate) fn view(harness: &Harness<'_, Workbench>) -> Rect {
    harness.get_by_label("3D view").rect()
}

/// Where a point of the world is on the screen.
pub(crate) fn on_screen(harness: &Harness<'_, Workbench>, world: DVec3) -> Pos2 {
    let rect = view(harness);
    let size = [f64::from(rect.width()), f64::from(rect.height())];
    let camera = harness.state().view.viewport.camera().expect("the view has been shown");
    let [x, y] = camera.project(world, size).expect("before the eye");
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    let aside = egui::vec2(x as f32, y as f32);
    rect.min + aside
}

/// Clicks at a place.
pub(crate) fn click(harness: &mut Harness<'_, Workbench>, at: Pos2) {
    harness.drag_at(at);
    settle(harness);
    harness.drop_at(at);
    settle(harness);
}

/// Drags from a place to another, in two strokes.
pub(crate) fn drag(harness: &mut Harness<'_, Workbench>, from: Pos2, to: Pos2) {
    harness.drag_at(from);
    settle(harness);
    harness.hover_at(from + (to - from) * 0.5);
    settle(harness);
    harness.hover_at(to);
    settle(harness);
    harness.drop_at(to);
    settle(harness);
}
