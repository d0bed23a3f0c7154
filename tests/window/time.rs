//! Playing, stepping, scrubbing; and nothing at all when nothing happens.

use super::harness::{FRAME, open, press, view};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{Clock, HIT_SPEED};
use girderbench::scene::presets;
use std::time::Duration;

#[test]
fn it_opens_on_the_preset_with_its_answer() {
    let harness = open(presets::OPENING);
    let bench = harness.state();
    let answer = bench.replay.runner.answer().expect("the run is done");
    assert_eq!(bench.files.document.scene().name, presets::OPENING, "the opening scene");
    assert!(answer.summary.hits > 0, "the girder hits the wall");
    assert!(
        !bench.replay.runner.is_stale() && bench.replay.runner.problems().is_none(),
        "and the answer is the scene's"
    );
    assert!(bench.view.viewport.list().is_some_and(|list| !list.solids.is_empty()), "its bodies are in the picture");
}

#[test]
fn an_idle_window_asks_for_no_frame() {
    let mut harness = open(presets::OPENING);
    let pictures = harness.state().view.viewport.pictures();
    harness.run_steps(5);
    let delay = harness.output().viewport_output.values().next().expect("one window").repaint_delay;
    assert_eq!(delay, Duration::MAX, "nothing is to come");
    assert_eq!(harness.state().view.viewport.pictures(), pictures, "and the 3D view is not made again");
}

#[test]
fn a_mouse_over_a_panel_draws_no_new_picture() {
    let mut harness = open(presets::OPENING);
    let (pictures, list) = (harness.state().view.viewport.pictures(), harness.state().view.viewport.list().cloned());
    let over = harness.get_by_label("Timeline").rect();
    for share in [0.2, 0.5, 0.8] {
        harness.hover_at(egui::pos2(over.left() + over.width() * share, over.center().y));
        harness.run();
    }
    assert_eq!(harness.state().view.viewport.pictures(), pictures, "frames were shown, of the picture that was there");
    assert!(harness.state().view.viewport.list().cloned() == list, "the very list");
}

#[test]
fn playing_advances_by_the_speed() {
    let mut harness = open(presets::OPENING);
    harness.key_press(Key::Space);
    harness.run_steps(1);
    let (before, pictures) = (harness.state().replay.playback.clock.t, harness.state().view.viewport.pictures());
    harness.run_steps(10);
    let played = harness.state().replay.playback.clock.t - before;
    let wanted = 10.0 * f64::from(FRAME) * Clock::default().speed;
    // Frames are f32 seconds in egui.
    assert!((played - wanted).abs() < 1e-6, "ten frames at a tenth: {wanted}, got {played}");
    assert_eq!(harness.state().view.viewport.pictures(), pictures + 10, "every frame shows another instant");
    harness.key_press(Key::Space);
    harness.run();
    assert!(!harness.state().replay.playback.clock.playing, "Space pauses");
}

#[test]
fn playing_slows_by_itself_at_hits_when_asked() {
    let mut harness = open(presets::OPENING);
    let hit = harness.state().replay.runner.answer().expect("run").touches[0].0;
    harness.key_press(Key::M);
    harness.state_mut().apply(girderbench::app::TimeCommand::Seek(hit));
    harness.key_press(Key::Space);
    harness.run_steps(1);
    let before = harness.state().replay.playback.clock.t;
    harness.run_steps(5);
    let played = harness.state().replay.playback.clock.t - before;
    assert!((played - 5.0 * f64::from(FRAME) * HIT_SPEED).abs() < 1e-6, "a hundredth while touching, got {played}");
}

#[test]
fn keys_step_jump_and_change_speed() {
    let mut harness = open(presets::OPENING);
    let events = harness.state().replay.runner.answer().expect("run").event_times.clone();
    let step = Clock::default().speed / 60.0;
    harness.key_press(Key::ArrowRight);
    harness.run();
    assert!((harness.state().replay.playback.clock.t - step).abs() < 1e-12, "one step");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
    harness.run();
    assert!((harness.state().replay.playback.clock.t - 11.0 * step).abs() < 1e-12, "ten more");
    harness.key_press(Key::Home);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::ArrowRight);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::ArrowRight);
    harness.run();
    assert_eq!(harness.state().replay.playback.clock.t, events[1], "the second event from the start");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::ArrowLeft);
    harness.run();
    assert_eq!(harness.state().replay.playback.clock.t, events[0], "and back");
    harness.key_press(Key::End);
    harness.run();
    assert_eq!(harness.state().replay.playback.clock.t, harness.state().files.document.scene().duration, "the end");
    for _ in 0..20 {
        harness.key_press(Key::Comma);
    }
    harness.run();
    assert_eq!(harness.state().replay.playback.clock.speed, 0.001, "down to a thousandth");
}

#[test]
fn a_click_in_timeline_or_plots_goes_there() {
    let mut harness = open(presets::OPENING);
    for strip in ["Timeline", "Plots"] {
        let (rect, axis) = (harness.get_by_label(strip).rect(), harness.get_by_label("Plots").rect());
        // Both have one axis, between the numbers and the legends.
        super::harness::click(&mut harness, egui::pos2(axis.center().x, rect.center().y));
        let t = harness.state().replay.playback.clock.t;
        assert!((t - 5.0).abs() < 0.02, "half way of ten seconds, got {t} in {strip}");
        harness.key_press(Key::Home);
        harness.run();
    }
}

#[test]
fn dragging_the_timeline_scrubs_and_the_picture_follows() {
    let mut harness = open(presets::OPENING);
    let rect = harness.get_by_label("Timeline").rect();
    let pictures = harness.state().view.viewport.pictures();
    let y = rect.center().y;
    super::harness::drag(&mut harness, egui::pos2(rect.left() + 100.0, y), egui::pos2(rect.left() + 300.0, y));
    assert!(harness.state().replay.playback.clock.t > 1.0, "moved, got {}", harness.state().replay.playback.clock.t);
    assert!(harness.state().view.viewport.pictures() > pictures, "another instant is another picture");
}

#[test]
fn the_wheel_zooms_in_time_and_a_button_shows_the_whole_run() {
    let mut harness = open(presets::OPENING);
    let rect = harness.get_by_label("Plots").rect();
    harness.hover_at(rect.center());
    harness.run();
    harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: egui::vec2(0.0, 200.0),
        modifiers: Modifiers::NONE,
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
    });
    // A wheel's turn is spread over some frames.
    harness.run_steps(30);
    let [from, to] = harness.state().replay.playback.window.expect("a part of the run");
    assert!(to - from < 9.0, "nearer, got {from} to {to}");
    press(&mut harness, "Whole run");
    assert_eq!(harness.state().replay.playback.window, None, "all of it");
}

#[test]
fn buttons_do_what_keys_do() {
    let mut harness = open(presets::OPENING);
    press(&mut harness, "Next contact event");
    let first = harness.state().replay.runner.answer().expect("run").event_times[0];
    assert_eq!(harness.state().replay.playback.clock.t, first, "the first event");
    press(&mut harness, "To the start");
    assert_eq!(harness.state().replay.playback.clock.t, 0.0, "the start");
    harness.get_by_label("Play").click();
    harness.run_steps(3);
    assert!(harness.state().replay.playback.clock.playing, "plays");
    assert!(view(&harness).width() > 500.0, "and the view is still there");
}
