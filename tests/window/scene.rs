//! What if, placing, undo, files: every change of the scene comes back as another answer.

use super::harness::{click, drag, on_screen, open, press, settle, slide};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{EditCommand, Export, FileCommand, LeaveCommand, SelectCommand, TimeCommand};
use girderbench::scene::{Motion, presets};
use girderbench::view::Target;
use glam::DVec3;

fn digest(harness: &egui_kittest::Harness<'_, girderbench::app::Workbench>) -> u64 {
    harness.state().replay.runner.answer().expect("an answer").history.digest()
}

#[test]
fn every_slider_changes_the_answer_at_once() {
    let sliders = [
        ("Skew β", 60.0),
        ("Gap", 2.0),
        ("Amplitude", 0.3),
        ("Frequency", 2.4),
        ("Angle α", 15.0),
        ("μ static", 0.3),
        ("μ kinetic", 0.1),
        ("e normal", 0.6),
        ("e tangential", 0.5),
    ];
    for (label, value) in sliders {
        let mut harness = open(presets::OPENING);
        let (before, picture) = (digest(&harness), harness.state().view.viewport.pictures());
        slide(&mut harness, label, value);
        assert_ne!(digest(&harness), before, "{label} is part of the physics");
        assert!(!harness.state().replay.runner.is_stale(), "{label}: the answer is the new scene's");
        assert!(harness.state().view.viewport.pictures() > picture, "{label}: the picture followed");
    }
}

/// Opens a list of choices by its name and takes one.
fn choose(harness: &mut egui_kittest::Harness<'_, girderbench::app::Workbench>, list: &str, choice: &str) {
    harness.get_by_role_and_label(Role::ComboBox, list).scroll_to_me();
    harness.run_steps(40);
    harness.get_by_role_and_label(Role::ComboBox, list).click();
    // It opens in a few frames.
    harness.run_steps(40);
    harness.get_by_label(choice).click();
    harness.run_steps(40);
    settle(harness);
}

#[test]
fn the_other_model_is_a_switch_away_and_comes_with_its_numbers() {
    let mut harness = open(presets::OPENING);
    let first = digest(&harness);
    choose(&mut harness, "Model", "both");
    let answer = harness.state().replay.runner.answer().expect("an answer").history.clone();
    let beside = answer.beside().expect("the impact model beside").digest();
    assert_eq!(answer.digest(), first, "the contact model still leads");
    assert!(harness.query_by_label_contains("Models apart now").is_some(), "the difference is read out");
    assert!(harness.query_by_label_contains("A whole face hits").is_some(), "a flush hit is pointed out");
    harness.run_steps(2);
    assert!(harness.query_by_label_contains("deck: b free 並進").is_some(), "the state at the start, by its names");
    for (label, value) in [("Impact e n", 0.8), ("Impact e t", -0.5), ("Corner μ k", 0.05)] {
        let before = harness
            .state()
            .replay
            .runner
            .answer()
            .and_then(|a| a.history.beside().map(girderbench::sim::History::digest));
        slide(&mut harness, label, value);
        let after = harness
            .state()
            .replay
            .runner
            .answer()
            .and_then(|a| a.history.beside().map(girderbench::sim::History::digest));
        assert_ne!(after, before, "{label} is part of the impact model");
        assert_eq!(digest(&harness), first, "and of no other");
    }
    choose(&mut harness, "Flush hits", "two-corner");
    for _ in 0..4 {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        settle(&mut harness);
    }
    let again =
        harness.state().replay.runner.answer().and_then(|a| a.history.beside().map(girderbench::sim::History::digest));
    assert_eq!(again, Some(beside), "every number is taken back");
    choose(&mut harness, "Model", "impact");
    assert_eq!(digest(&harness), beside, "alone it is the same run");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(
        *harness.state().files.document.scene(),
        presets::load(presets::OPENING).expect("the preset ships"),
        "as it was"
    );
}

#[test]
fn the_switch_says_why_a_spatial_scene_has_one_model() {
    let harness = open("deck-30m");
    assert!(harness.query_by_label_contains("planar scenes only").is_some(), "the reason stands there");
}

#[test]
fn the_answer_shown_is_the_one_without_a_window() {
    let mut harness = open(presets::OPENING);
    slide(&mut harness, "Skew β", 60.0);
    let scene = harness.state().files.document.scene().clone();
    assert_eq!(scene.girders[0].skew_deg, 60.0, "the slider's number");
    let headless = girderbench::sim::History::of(&scene).expect("a good scene");
    assert_eq!(digest(&harness), headless.digest(), "bit for bit");
}

#[test]
fn undo_and_redo_bring_answers_back() {
    let mut harness = open(presets::OPENING);
    let first = digest(&harness);
    slide(&mut harness, "Amplitude", 0.3);
    let second = digest(&harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(digest(&harness), first, "taken back");
    assert!(!harness.state().files.document.is_dirty(), "as it was opened");
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    settle(&mut harness);
    assert_eq!(digest(&harness), second, "made again");
    press(&mut harness, "Undo");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Y);
    settle(&mut harness);
    assert_eq!(digest(&harness), second, "by button and by the other key too");
}

#[test]
fn one_drag_of_a_slider_is_one_step_of_undo() {
    let mut harness = open(presets::OPENING);
    let first = digest(&harness);
    let rect = harness.get_by_role_and_label(Role::Slider, "Amplitude").rect();
    let at = |share: f32| egui::pos2(rect.left() + rect.width() * share, rect.center().y);
    drag(&mut harness, at(0.3), at(0.8));
    assert_ne!(digest(&harness), first, "moved");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(digest(&harness), first, "one step back is before the drag");
    assert_eq!(harness.state().files.document.undo_label(), None, "and there is no other");
}

#[test]
fn a_bad_scene_says_what_is_wrong_and_keeps_the_last_answer() {
    let mut harness = open(presets::OPENING);
    let good = digest(&harness);
    slide(&mut harness, "μ kinetic", 0.9);
    let problems = harness.state().replay.runner.problems().expect("kinetic friction above static");
    assert!(problems.0[0].place.plain().contains("mu_kinetic"), "names the field: {problems}");
    assert_eq!(digest(&harness), good, "the last good answer is still there");
    assert!(harness.state().replay.runner.is_stale(), "and is marked as old");
    let remedy = problems.0[0].remedy.to_string();
    assert!(harness.query_all_by_label_contains(&remedy).count() >= 2, "over the view and at the field: {remedy}");
    slide(&mut harness, "μ kinetic", 0.1);
    assert!(
        harness.state().replay.runner.problems().is_none() && !harness.state().replay.runner.is_stale(),
        "put right"
    );
}

#[test]
fn a_click_selects_and_a_drag_moves_over_the_ground() {
    let mut harness = open(presets::OPENING);
    harness.key_press(Key::Num2);
    settle(&mut harness);
    let top = DVec3::new(-0.02, 0.0, 0.01);
    let place = on_screen(&harness, top);
    click(&mut harness, place);
    assert_eq!(harness.state().files.document.selection().lead(), Some(Target::Girder(0)), "the girder");
    let before = harness.state().files.document.scene().girders[0].position;
    let to = on_screen(&harness, top + DVec3::new(-0.05, 0.02, 0.0));
    drag(&mut harness, place, to);
    let after = harness.state().files.document.scene().girders[0].position;
    // A pixel of the view from above is half a millimetre here; the plane of dragging is the girder's mid-depth.
    let way = [after[0] - before[0], after[1] - before[1]];
    assert!((way[0] + 0.05).abs() < 2e-3 && (way[1] - 0.02).abs() < 2e-3, "follows the mouse, went {way:?}");
    assert_eq!(after[2], before[2], "on its level");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().girders[0].position, before, "one drag is one step");
}

#[test]
fn a_drag_beside_the_selection_turns_the_view() {
    let mut harness = open(presets::OPENING);
    let scene = harness.state().files.document.scene().clone();
    let before = *harness.state().view.viewport.camera().expect("shown");
    let rect = super::harness::view(&harness);
    let from = rect.right_bottom() - egui::vec2(40.0, 20.0);
    drag(&mut harness, from, from - egui::vec2(80.0, 10.0));
    let after = *harness.state().view.viewport.camera().expect("shown");
    assert_ne!((before.yaw, before.pitch), (after.yaw, after.pitch), "turned");
    assert_eq!(*harness.state().files.document.scene(), scene, "nothing was moved");
}

#[test]
fn girders_and_abutments_are_added_and_removed() {
    let mut harness = open(presets::OPENING);
    let first = digest(&harness);
    press(&mut harness, "Add girder");
    assert_eq!(harness.state().files.document.scene().girders.len(), 2, "one more");
    assert_eq!(harness.state().replay.runner.problems(), None, "placed where it overlaps nobody");
    let scene = harness.state().files.document.scene();
    assert_eq!(scene.abutments[0].faces, scene.girders[1].name, "a span: the abutment stands at the row's end");
    assert!(scene.girders[1].position[0] - scene.girders[0].position[0] < 1.1 * scene.girders[0].length, "beside it");
    assert_eq!(harness.state().files.document.selection().lead(), Some(Target::Girder(1)), "and selected");
    press(&mut harness, "Add abutment");
    assert_eq!(harness.state().files.document.scene().abutments.len(), 2, "a wall before a free end");
    assert_eq!(harness.state().replay.runner.problems(), None, "that stands free");
    harness.key_press(Key::Delete);
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().abutments.len(), 1, "removed");
    press(&mut harness, "Undo");
    press(&mut harness, "Undo");
    press(&mut harness, "Undo");
    assert_eq!(digest(&harness), first, "and all of it taken back");
}

#[test]
fn a_duplicate_has_a_name_of_its_own() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::D);
    settle(&mut harness);
    let girders = &harness.state().files.document.scene().girders;
    assert_eq!(girders.len(), 2, "a copy");
    assert_ne!(girders[0].name, girders[1].name, "called otherwise");
    assert_eq!(girders[0].mass, girders[1].mass, "and as heavy");
}

#[test]
fn a_number_is_typed_in_the_inspector() {
    let mut harness = open(presets::OPENING);
    press(&mut harness, "deck β 45°");
    let before = digest(&harness);
    harness.get_by_role_and_label(Role::SpinButton, "Mass m").click();
    settle(&mut harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(egui::Event::Text("2.5".into()));
    settle(&mut harness);
    harness.key_press(Key::Enter);
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().girders[0].mass, 2.5, "as typed");
    assert_ne!(digest(&harness), before, "and run");
}

#[test]
fn a_name_typed_is_a_name_everywhere() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(EditCommand::Rename(Target::Girder(0), "span".into()));
    settle(&mut harness);
    let scene = harness.state().files.document.scene();
    assert_eq!((scene.girders[0].name.as_str(), scene.abutments[0].faces.as_str()), ("span", "span"), "both");
    harness.state_mut().apply(EditCommand::Rename(Target::Girder(0), "wall".into()));
    settle(&mut harness);
    assert!(harness.state().window.notice().is_some_and(|n| n.contains("wall")), "a taken name is refused in words");
}

#[test]
fn overlays_change_the_picture_and_nothing_else() {
    let mut harness = open(presets::OPENING);
    let hit = harness.state().replay.runner.answer().and_then(|a| a.summary.peak_time).expect("a hit");
    harness.state_mut().apply(TimeCommand::Seek(hit));
    settle(&mut harness);
    let answer = digest(&harness);
    for label in ["Grid", "Bearings", "Gap", "Contact points", "Normal force", "Resultant", "Friction cones", "Names"] {
        let before = harness.state().view.viewport.list().expect("shown").to_string();
        harness.get_by_role_and_label(Role::CheckBox, label).click_accesskit();
        settle(&mut harness);
        assert_ne!(harness.state().view.viewport.list().expect("shown").to_string(), before, "{label}");
    }
    assert_eq!(digest(&harness), answer, "the run is the same");
    assert!(!harness.state().files.document.is_dirty(), "and so is the scene");
}

#[test]
fn a_preset_opens_and_undo_brings_the_old_scene_back() {
    let mut harness = open(presets::OPENING);
    harness.get_by_role_and_label(Role::Button, "Presets").click();
    settle(&mut harness);
    harness.get_by_label("straight-straight").click();
    settle(&mut harness);
    harness.state_mut().replay.runner.wait();
    assert_eq!(harness.state().files.document.scene().name, "straight-straight", "opened");
    assert!(!harness.state().files.document.is_dirty(), "nothing of it is unsaved");
    press(&mut harness, "Undo");
    assert_eq!(harness.state().files.document.scene().name, presets::OPENING, "back");
}

#[test]
fn a_big_scene_is_run_on_a_thread_and_can_be_stopped() {
    let mut harness = open("flush-free-hit");
    let mut long = presets::load("row-of-5").expect("ships");
    long.duration = 3000.0;
    let edit = girderbench::scene::edit::Edit::Scene(Box::new(long));
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    harness.run_steps(2);
    assert!(harness.state().replay.runner.progress().is_some(), "it goes on while the window is drawn");
    assert_eq!(
        harness.state().replay.runner.answer().expect("old").history.scene().name,
        "flush-free-hit",
        "the old one is shown"
    );
    harness.get_by_label("Cancel").click();
    harness.run();
    assert!(
        harness.state().replay.runner.progress().is_none() && harness.state().replay.runner.is_stale(),
        "stopped, and said to be old"
    );
}

#[test]
fn a_scene_is_saved_and_opened_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.toml");
    let mut harness = open(presets::OPENING);
    slide(&mut harness, "Skew β", 70.0);
    assert!(harness.state().files.document.is_dirty() && harness.state().title().starts_with('●'), "marked");
    harness.state_mut().apply(FileCommand::SaveTo(path.clone()));
    settle(&mut harness);
    assert!(!harness.state().files.document.is_dirty() && harness.state().title().starts_with("mine.toml"), "saved");
    let saved = digest(&harness);
    slide(&mut harness, "Skew β", 45.0);
    harness.state_mut().apply(FileCommand::Open(path));
    settle(&mut harness);
    press(&mut harness, "Go on without saving");
    assert_eq!(digest(&harness), saved, "the same answer");
}

#[test]
fn a_file_that_is_no_scene_is_refused_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bad.toml");
    std::fs::write(&path, "name = 3").expect("written");
    let mut harness = open(presets::OPENING);
    let before = harness.state().files.document.scene().clone();
    harness.state_mut().apply(FileCommand::Open(path));
    settle(&mut harness);
    assert!(harness.state().window.notice().is_some_and(|n| n.contains("bad.toml")), "names the file");
    assert_eq!(*harness.state().files.document.scene(), before, "and nothing is lost");
}

#[test]
fn tables_are_exported_while_the_window_goes_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(FileCommand::Export(Export::Tables, folder.path().to_owned()));
    for _ in 0..500 {
        harness.run();
        if harness.state().window.notice().is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    assert!(harness.state().window.notice().is_some_and(|n| n.contains("summary.json")), "said");
    assert!(folder.path().join("trajectory.csv").is_file(), "written");
}

#[test]
fn closing_asks_when_something_is_not_saved() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(LeaveCommand::Close);
    assert!(harness.state().window.closes(), "nothing to lose");
    let mut harness = open(presets::OPENING);
    slide(&mut harness, "Skew β", 70.0);
    harness.state_mut().apply(LeaveCommand::Close);
    settle(&mut harness);
    assert!(!harness.state().window.closes(), "first the question");
    press(&mut harness, "Keep working");
    assert!(!harness.state().window.asks() && !harness.state().window.closes(), "stays");
    harness.state_mut().apply(LeaveCommand::Close);
    settle(&mut harness);
    press(&mut harness, "Close without saving");
    assert!(harness.state().window.closes(), "goes");
}

#[test]
fn a_still_ground_can_be_shaken() {
    let mut harness = open("flush-free-hit");
    press(&mut harness, "Shake it");
    assert!(matches!(harness.state().files.document.scene().motion, Motion::Sine(_)), "a sine to begin with");
}
