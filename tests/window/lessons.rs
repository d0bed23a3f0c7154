//! Guided scenes: opened, tried and put back by their labels.

use super::harness::{on_screen, open, press, settle, view};
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{Command, EditCommand, FileCommand, LearnCommand, Workbench, lessons};
use girderbench::scene::edit::Edit;
use girderbench::scene::{ViewPreset, presets};
use glam::DVec3;

/// Opens a guided scene through the menu.
fn learn(harness: &mut Harness<'_, Workbench>, title: &str) {
    press(harness, "Learn");
    harness.get_by_role_and_label(Role::Button, title).click();
    settle(harness);
}

/// Presses a button that may be scrolled out of sight.
fn press_there(harness: &mut Harness<'_, Workbench>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).scroll_to_me();
    harness.run_steps(30);
    press(harness, label);
}

/// The whole deck is in the view, unless the view looks at one contact.
fn sees_the_deck(harness: &Harness<'_, Workbench>) {
    let scene = harness.state().files.document.scene();
    if scene.view.camera != ViewPreset::Contact {
        let half = scene.girders[0].length / 2.0;
        for end in [-half, half] {
            let at = on_screen(harness, DVec3::new(end, 0.0, 0.0));
            assert!(view(harness).contains(at), "{}: the end at {end} m is seen, at {at}", scene.name);
        }
    }
}

#[test]
fn every_thing_to_try_is_a_press_away_and_reset_brings_the_scene_back() {
    for lesson in lessons() {
        let mut harness = open(presets::OPENING);
        learn(&mut harness, &lesson.title);
        let scene = lesson.scene().expect("good");
        assert_eq!(*harness.state().files.document.scene(), scene, "the lesson's own scene");
        assert!(harness.query_by_label(&lesson.text[0]).is_some(), "its words stand beside it");
        assert!(view(&harness).width() > 400.0, "and leave the view its room");
        sees_the_deck(&harness);
        let first = harness.state().replay.runner.answer().expect("run").history.digest();
        for (number, set) in lesson.tries.iter().enumerate() {
            press_there(&mut harness, &format!("{}  {}", number + 1, set.words));
            let mut tried = scene.clone();
            set.edit().apply(&mut tried).expect("it fits");
            assert_eq!(*harness.state().files.document.scene(), tried, "{}: {}", lesson.name, set.words);
            assert!(!harness.state().replay.runner.is_stale(), "and run");
        }
        press_there(&mut harness, "Reset");
        assert_eq!(*harness.state().files.document.scene(), scene, "{}: exactly as it was", lesson.name);
        assert_eq!(
            harness.state().replay.runner.answer().expect("run").history.digest(),
            first,
            "and so is the answer"
        );
        assert!(!harness.state().files.document.is_dirty(), "nothing of it is unsaved");
        for _ in 0..lesson.tries.len() + 2 {
            press(&mut harness, "Undo");
        }
        assert_eq!(harness.state().files.document.scene().name, presets::OPENING, "every press was a step of undo");
    }
}

#[test]
fn the_words_close_and_go_with_their_scene() {
    let mut harness = open(presets::OPENING);
    let title = &lessons()[0].title;
    learn(&mut harness, title);
    press(&mut harness, "Close the lesson");
    assert!(harness.state().learning.lesson().is_none() && harness.query_by_label(title).is_none(), "closed");
    assert_eq!(harness.state().files.document.scene().name, lessons()[0].name, "the scene stays");
    harness.state_mut().apply(Command::Learn(LearnCommand::Open(1)));
    harness.state_mut().apply(FileCommand::OpenPreset("straight-straight".into()));
    settle(&mut harness);
    assert!(harness.state().learning.lesson().is_none(), "another scene has other words");
}

#[test]
fn a_thing_to_try_finds_its_scene_again() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(Command::Learn(LearnCommand::Open(0)));
    harness.state_mut().apply(EditCommand::Change { edit: Edit::Set("name=mine".into()), gesture: None });
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().name, "mine", "another scene under the lesson's words");
    harness.state_mut().apply(Command::Learn(LearnCommand::Try(0)));
    settle(&mut harness);
    let mut tried = lessons()[0].scene().expect("good");
    lessons()[0].tries[0].edit().apply(&mut tried).expect("it fits");
    assert_eq!(*harness.state().files.document.scene(), tried, "the lesson's scene first, then what is tried");
}

#[test]
fn a_touch_that_begins_with_the_run_has_its_bar_from_the_start() {
    let mut harness = open(presets::OPENING);
    learn(&mut harness, "Stick and slip");
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    let (end, resting) = (answer.history.end(), answer.history.contacts().at(0.0).len());
    assert!(resting > 0, "the block lies on its face from the beginning");
    let told = harness.get_by_role_and_label(Role::Slider, "Timeline").accesskit_node().description();
    assert_eq!(
        told.as_deref(),
        Some(format!("{resting} bars: {} s of stick, 0 s of slip", resting as f64 * end).as_str()),
        "all stick"
    );
    assert!(answer.spans.iter().all(|bar| (bar.start, bar.end) == (0.0, end)), "each over all of the run");
}
