//! New, recent files, unsaved work and its recovery, a file that another program changes.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::harness::{open, press, settle, slide};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{FileCommand, LeaveCommand, Workbench};
use girderbench::files::{SceneSource, find_in, load_scene, save_scene};
use girderbench::scene::{Scene, presets};

/// A window on the opening scene that keeps its lists and unsaved work in a folder, without waiting.
fn kept(folder: &Path) -> Harness<'static, Workbench> {
    let mut harness = open(presets::OPENING);
    harness.state_mut().keep_in(&folder.join("state"));
    harness.state_mut().files.session.set_autosave_delay(Duration::ZERO);
    settle(&mut harness);
    harness
}

/// A scene file of one's own.
fn file(folder: &Path, name: &str) -> PathBuf {
    let path = folder.join(name);
    save_scene(&presets::load("skew60-abutment").expect("ships"), &SceneSource::New, &path).expect("written");
    path
}

fn open_file(harness: &mut Harness<'_, Workbench>, path: &Path) {
    harness.state_mut().apply(FileCommand::Open(path.to_owned()));
    settle(harness);
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Ends a window as a crash would: nobody is asked, nothing is cleaned up.
fn crash(harness: Harness<'_, Workbench>) {
    harness.state().files.session.wait();
    drop(harness);
}

#[test]
fn new_is_empty_and_undo_brings_the_old_scene_back() {
    let mut harness = open(presets::OPENING);
    let before = harness.state().files.document.scene().clone();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    settle(&mut harness);
    let scene = harness.state().files.document.scene();
    assert!(scene.girders.is_empty() && scene.abutments.is_empty(), "nothing is placed");
    assert!(harness.query_by_label_contains("Nothing is placed").is_some(), "and what to do is said");
    assert!(!harness.state().files.document.is_dirty(), "nothing would be lost");
    press(&mut harness, "Add girder");
    assert_eq!(harness.state().files.document.scene().girders.len(), 1, "a beginning");
    press(&mut harness, "Undo");
    press(&mut harness, "Undo");
    assert_eq!(*harness.state().files.document.scene(), before, "the old one, exactly");
}

#[test]
fn an_empty_scene_offers_a_bridge_by_its_numbers_and_no_complaint() {
    let mut harness = open(presets::OPENING);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    settle(&mut harness);
    assert!(harness.query_by_label_contains("[[girder]]").is_none(), "no complaint about what was not begun");
    assert!(harness.query_by_label_contains("Assumed until you say otherwise").is_some(), "what is assumed is said");
    for (label, typed) in
        [("Span length", "40"), ("Deck width", "12"), ("Skew angle β", "50"), ("Number of spans", "3")]
    {
        harness.get_by_role_and_label(Role::SpinButton, label).click();
        settle(&mut harness);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.event(Event::Text(typed.into()));
        settle(&mut harness);
        harness.key_press(Key::Enter);
        settle(&mut harness);
    }
    press(&mut harness, "Build the bridge");
    let scene = harness.state().files.document.scene();
    let spans: Vec<_> = scene.girders.iter().map(|g| (g.length, g.width, g.skew_deg)).collect();
    assert_eq!(spans, [(40.0, 12.0, 50.0); 3], "as asked for");
    assert_eq!((scene.abutments.len(), harness.state().replay.runner.problems()), (2, None), "and it runs");
    let rect = harness.get_by_role_and_label(Role::Canvas, "3D view").rect();
    let camera = harness.state().view.viewport.camera().expect("shown");
    let seen = girderbench::view::in_view(scene, camera, f64::from(rect.width() / rect.height()));
    assert_eq!(seen, girderbench::view::InView::Whole, "and all of it is in view");
}

#[test]
fn the_first_tab_on_an_empty_scene_leads_to_the_numbers_of_a_bridge() {
    let mut harness = open(presets::OPENING);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    settle(&mut harness);
    for (label, typed) in
        [("Span length", "40"), ("Deck width", "12"), ("Skew angle β", "50"), ("Number of spans", "2")]
    {
        harness.key_press(Key::Tab);
        settle(&mut harness);
        assert!(
            harness.get_by_role_and_label(Role::SpinButton, label).accesskit_node().is_focused(),
            "{label} has the keyboard"
        );
        harness.event(Event::Text(typed.into()));
        settle(&mut harness);
    }
    harness.key_press(Key::Tab);
    settle(&mut harness);
    harness.key_press(Key::Enter);
    settle(&mut harness);
    let scene = harness.state().files.document.scene();
    let spans: Vec<_> = scene.girders.iter().map(|g| (g.length, g.width, g.skew_deg)).collect();
    assert_eq!(spans, [(40.0, 12.0, 50.0); 2], "built without a mouse");
}

/// Opens the list of recent files in the file menu.
fn open_recent(harness: &mut Harness<'_, Workbench>) {
    press(harness, "File");
    harness.get_by_label_contains("Open recent").click();
    harness.run_steps(5);
}

#[test]
fn recent_files_are_listed_opened_and_forgotten() {
    let folder = tempfile::tempdir().expect("a folder");
    let (one, other) = (file(folder.path(), "one.toml"), file(folder.path(), "other.toml"));
    let mut harness = kept(folder.path());
    open_file(&mut harness, &one);
    open_file(&mut harness, &other);
    drop(harness);
    std::fs::remove_file(&other).expect("gone");
    let mut harness = kept(folder.path());
    assert_eq!(harness.state().files.session.recent(), [other, one.clone()], "the next window knows them");
    open_recent(&mut harness);
    assert!(harness.query_by_label_contains("other.toml (missing)").is_some(), "what has gone is said to be missing");
    press(&mut harness, "Forget");
    assert_eq!(harness.state().files.session.recent(), [one], "forgotten");
    open_recent(&mut harness);
    harness.get_by_label_contains("/one.toml").click();
    settle(&mut harness);
    assert_eq!(harness.state().files.name(), "one.toml", "opened");
}

#[test]
fn a_recent_list_of_nonsense_does_not_keep_the_window_from_opening() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir_all(folder.path().join("state/recent.toml")).expect("a folder where a file should be");
    let mut harness = kept(folder.path());
    assert!(harness.state().files.session.recent().is_empty(), "nothing to list");
    let mine = file(folder.path(), "mine.toml");
    open_file(&mut harness, &mine);
    assert_eq!(harness.state().files.name(), "mine.toml", "and everything else goes on");
}

#[test]
fn unsaved_work_outlives_its_window() {
    let folder = tempfile::tempdir().expect("a folder");
    let mine = file(folder.path(), "mine.toml");
    let mut harness = kept(folder.path());
    open_file(&mut harness, &mine);
    slide(&mut harness, "Skew β", 75.0);
    let edited = harness.state().files.document.scene().clone();
    crash(harness);
    let left = ["mine.toml", "mine.toml.unsaved", "state"];
    assert_eq!(names(folder.path()), left, "the scene and the unsaved work beside it");

    let mut harness = kept(folder.path());
    open_file(&mut harness, &mine);
    assert_ne!(*harness.state().files.document.scene(), edited, "the file, to begin with");
    assert!(harness.query_by_label_contains("mine.toml, from less than a minute ago").is_some(), "asked, in words");
    press(&mut harness, "Keep for later");
    assert!(harness.state().files.session.found_work().is_empty(), "asked once");
    open_file(&mut harness, &mine);
    press(&mut harness, "Recover");
    assert_eq!(*harness.state().files.document.scene(), edited, "all of it is back");
    assert!(harness.state().files.document.is_dirty(), "and still to be saved");
    press(&mut harness, "Undo");
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 60.0, "the file's scene is one step back");
    press(&mut harness, "Redo");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    settle(&mut harness);
    harness.state().files.session.wait();
    assert_eq!(load_scene(&mine, &[]).expect("good"), edited, "saved");
    assert_eq!(names(folder.path()), ["mine.toml", "state"], "nothing unsaved is left");
}

#[test]
fn work_without_a_file_is_asked_about_at_the_next_start() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("state");
    let mut harness = kept(folder.path());
    slide(&mut harness, "Skew β", 75.0);
    let edited = harness.state().files.document.scene().clone();
    harness.state().files.session.wait();
    assert!(find_in(&state.join("unsaved")).is_empty(), "another window does not take it from a living one");
    crash(harness);
    let mut harness = kept(folder.path());
    press(&mut harness, "Recover");
    assert_eq!(*harness.state().files.document.scene(), edited, "back");
    assert!(harness.state().files.document.is_dirty(), "to be saved somewhere");
    crash(harness);
    let mut harness = kept(folder.path());
    press(&mut harness, "Discard");
    assert_eq!(*harness.state().files.document.scene(), presets::load(presets::OPENING).expect("ships"), "not wanted");
    assert!(names(&state.join("unsaved")).is_empty(), "and gone");
}

#[test]
fn closing_and_undoing_leave_no_unsaved_work() {
    let folder = tempfile::tempdir().expect("a folder");
    let unsaved = folder.path().join("state/unsaved");
    let mut harness = kept(folder.path());
    slide(&mut harness, "Skew β", 75.0);
    harness.state().files.session.wait();
    assert_eq!(names(&unsaved).len(), 1, "kept");
    press(&mut harness, "Undo");
    harness.state().files.session.wait();
    assert!(names(&unsaved).is_empty(), "nothing to lose any more");
    slide(&mut harness, "Skew β", 75.0);
    harness.state_mut().apply(LeaveCommand::Close);
    settle(&mut harness);
    press(&mut harness, "Close without saving");
    crash(harness);
    assert!(names(&unsaved).is_empty(), "given up");
}

/// Opens a preset through the menu.
fn choose_preset(harness: &mut Harness<'_, Workbench>, name: &str) {
    press(harness, "Presets");
    press(harness, name);
}

#[test]
fn a_preset_replaces_unsaved_work_only_after_asking() {
    let folder = tempfile::tempdir().expect("a folder");
    let mine = file(folder.path(), "mine.toml");
    let mut harness = kept(folder.path());
    open_file(&mut harness, &mine);
    slide(&mut harness, "Skew β", 75.0);
    let edited = harness.state().files.document.scene().clone();
    choose_preset(&mut harness, "straight-straight");
    assert!(harness.query_by_label("The scene has changes that are not saved.").is_some(), "asked");
    assert_eq!(*harness.state().files.document.scene(), edited, "and nothing is replaced yet");
    press(&mut harness, "Keep working");
    assert_eq!(*harness.state().files.document.scene(), edited, "stays");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    settle(&mut harness);
    press(&mut harness, "Save first");
    assert_eq!(load_scene(&mine, &[]).expect("good"), edited, "saved");
    assert!(harness.state().files.document.scene().girders.is_empty(), "then begun anew");

    open_file(&mut harness, &mine);
    slide(&mut harness, "Skew β", 50.0);
    choose_preset(&mut harness, "straight-straight");
    press(&mut harness, "Go on without saving");
    assert_eq!(harness.state().files.document.scene().name, "straight-straight", "opened");
    harness.state().files.session.wait();
    assert_eq!(names(folder.path()), ["mine.toml", "state"], "what was given up is not asked about at the next start");
    press(&mut harness, "Undo");
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 50.0, "undo brings it back");
}

#[test]
fn presets_that_are_only_looked_at_leave_nothing_to_save() {
    let mut harness = open(presets::OPENING);
    for name in ["span-as-built", "twin-span-restrained", "viaduct-5", "span-as-built", "deck-30m-elastic", "deck-30m"]
    {
        choose_preset(&mut harness, name);
        let document = &harness.state().files.document;
        assert_eq!((document.scene().name.as_str(), document.is_dirty()), (name, false), "{:?}", document.undo_label());
    }
}

#[test]
fn all_unsaved_work_is_asked_about_at_once_each_by_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut scenes = Vec::new();
    for (preset, skew) in [(presets::OPENING, 75.0), ("skew60-abutment", 50.0)] {
        let mut harness = kept(folder.path());
        if !scenes.is_empty() {
            press(&mut harness, "Keep for later");
        }
        choose_preset(&mut harness, preset);
        slide(&mut harness, "Skew β", skew);
        scenes.push(harness.state().files.document.scene().clone());
        crash(harness);
    }
    let mut harness = kept(folder.path());
    for name in [presets::OPENING, "skew60-abutment"] {
        let words = format!("{name}: without a file, from less than a minute ago.");
        assert!(harness.query_by_label(&words).is_some(), "{words}");
    }
    let which = ["Recover 1: skew45-abutment", "Recover 2: skew45-abutment"];
    let which = which.into_iter().find(|label| harness.query_by_role_and_label(Role::Button, label).is_some());
    press(&mut harness, which.expect("one of them"));
    assert_eq!(*harness.state().files.document.scene(), scenes[0], "the one that was chosen");
    assert!(harness.state().files.session.found_work().is_empty(), "and no second question");
    assert!(harness.query_by_label_contains("Bring it back?").is_none(), "none");
}

/// Changes the file as an editor would.
fn change(path: &Path) -> Scene {
    let mut scene = load_scene(path, &[]).expect("good");
    scene.girders[0].skew_deg = 52.25;
    scene.description.push_str(" Changed.");
    save_scene(&scene, &SceneSource::New, path).expect("written");
    scene
}

#[test]
fn a_file_changed_by_another_program_is_read_again_or_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let mine = file(folder.path(), "mine.toml");
    let mut harness = kept(folder.path());
    open_file(&mut harness, &mine);
    let theirs = change(&mine);
    harness.event(Event::WindowFocused(true));
    settle(&mut harness);
    assert!(harness.query_by_label_contains("mine.toml was changed by another program").is_some(), "asked");
    press(&mut harness, "Reload");
    assert_eq!(*harness.state().files.document.scene(), theirs, "read again");
    assert!(!harness.state().files.document.is_dirty(), "as it is on the disk");
    press(&mut harness, "Undo");
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 60.0, "and what was here is one step back");
    assert!(harness.state().files.document.is_dirty(), "which is not what is on the disk");

    slide(&mut harness, "Skew β", 75.0);
    std::fs::write(&mine, "half a sce").expect("written");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    settle(&mut harness);
    assert!(harness.state().files.session.file_has_changed(), "nobody's work is written over without a question");
    press(&mut harness, "Keep mine");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    settle(&mut harness);
    let saved = load_scene(&mine, &[]).expect("a scene again");
    assert_eq!(saved.girders[0].skew_deg, 75.0, "mine");
}

#[test]
fn a_file_that_is_only_touched_or_gone_raises_no_question() {
    let folder = tempfile::tempdir().expect("a folder");
    let mine = file(folder.path(), "mine.toml");
    let mut harness = kept(folder.path());
    open_file(&mut harness, &mine);
    let text = std::fs::read(&mine).expect("there");
    std::thread::sleep(Duration::from_millis(20));
    std::fs::write(&mine, &text).expect("written again, the same");
    harness.event(Event::WindowFocused(true));
    settle(&mut harness);
    assert!(
        !harness.state().files.session.file_has_changed() && !harness.state().files.document.is_dirty(),
        "nothing is different"
    );
    std::fs::remove_file(&mine).expect("gone");
    harness.event(Event::WindowFocused(true));
    settle(&mut harness);
    assert!(harness.state().window.notice().is_some_and(|n| n.contains("no longer there")), "said");
    assert!(harness.state().files.document.is_dirty(), "what is here is nowhere else");
}

#[test]
fn an_idle_window_with_unsaved_work_falls_asleep() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = kept(folder.path());
    harness.state_mut().files.session.set_autosave_delay(Duration::from_millis(50));
    harness.get_by_role_and_label(Role::Slider, "Skew β").set_value_accesskit(75.0);
    settle(&mut harness);
    std::thread::sleep(Duration::from_millis(60));
    harness.run_steps(5);
    let delay = harness.output().viewport_output.values().next().expect("one window").repaint_delay;
    assert_eq!(delay, Duration::MAX, "written once, then nothing is to come");
    harness.state().files.session.wait();
    assert_eq!(names(&folder.path().join("state/unsaved")).len(), 1, "and written it is");
}
