//! The view never loses the scene by itself: it frames what is opened, and goes out when an edit is larger than the view.

use super::harness::{open, press, settle, slide, type_in};
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{FileCommand, SelectCommand, ViewCommand, Workbench};
use girderbench::scene::presets;
use girderbench::view::{Camera, InView, Target, in_view};

/// How much of the scene is in the 3D view.
fn seen(harness: &Harness<'_, Workbench>) -> InView {
    let bench = harness.state();
    let rect = harness.get_by_role_and_label(Role::Canvas, "3D view").rect();
    let scene = bench.files.document.scene();
    in_view(scene, &camera(harness), f64::from(rect.width() / rect.height()))
}

fn camera(harness: &Harness<'_, Workbench>) -> Camera {
    *harness.state().view.viewport.camera().expect("the view has been shown")
}

fn choose_preset(harness: &mut Harness<'_, Workbench>, name: &str) {
    press(harness, "Presets");
    harness.get_by_role_and_label(Role::Button, name).click();
    settle(harness);
}

#[test]
fn every_preset_is_framed_after_every_other_size() {
    let mut harness = open(presets::OPENING);
    for name in ["deck-30m", "skew45-abutment", "row-of-5", "straight-straight", "deck-30m"] {
        choose_preset(&mut harness, name);
        assert_eq!(harness.state().files.document.scene().name, name, "opened");
        assert_eq!(seen(&harness), InView::Whole, "{name} is in view, all of it");
    }
    for _ in 0..4 {
        press(&mut harness, "Undo");
        let name = &harness.state().files.document.scene().name;
        assert_eq!(seen(&harness), InView::Whole, "{name} is in view again");
    }
}

#[test]
fn what_is_opened_is_shown_as_placed_until_its_run_is_done() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(FileCommand::OpenPreset("deck-30m".into()));
    harness.step();
    assert!(harness.state().replay.runner.answer().is_none(), "nothing of the scene before stands over it");
    assert_eq!(seen(&harness), InView::Whole, "framed at once");
    settle(&mut harness);
    assert_eq!(harness.state().replay.runner.answer().expect("run").history.scene().name, "deck-30m", "run");
}

#[test]
fn a_length_typed_beyond_the_view_takes_the_camera_out_and_undo_brings_it_in() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    let before = camera(&harness);
    type_in(&mut harness, "Length a₀", "30 m");
    assert_eq!(harness.state().files.document.scene().girders[0].length, 30.0, "as typed");
    assert_eq!(seen(&harness), InView::Whole, "all of it");
    let out = camera(&harness);
    assert!(out.distance > 20.0 * before.distance && out.yaw == before.yaw, "out, the same way: {out:?}");
    press(&mut harness, "Undo");
    assert_eq!(seen(&harness), InView::Whole, "no dot");
}

#[test]
fn a_camera_that_the_user_has_brought_near_stays_there() {
    let mut harness = open(presets::OPENING);
    let mut near = camera(&harness);
    near.zoom(0.2);
    harness.state_mut().apply(ViewCommand::Camera(near));
    settle(&mut harness);
    slide(&mut harness, "Skew β", 60.0);
    assert_eq!(camera(&harness), near, "a part was in view, and is");
    press(&mut harness, "Add girder");
    assert_eq!(camera(&harness), near, "the new one is elsewhere; that is what the user looks at");
}
