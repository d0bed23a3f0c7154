//! Saving, opening, exporting and filming without a dialog of the system: the window asks for the path itself.

use std::path::Path;
use std::time::Duration;

use super::harness::{open, press, settle, slide};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{FilmCommand, FilmPlan, Workbench};
use girderbench::scene::presets;

/// A window that asks for paths itself, as the menu has told it to.
fn asking() -> Harness<'static, Workbench> {
    let mut harness = open(presets::OPENING);
    press(&mut harness, "File");
    harness.get_by_role_and_label(Role::CheckBox, "Ask for paths in this window").click();
    settle(&mut harness);
    harness.key_press(Key::Escape);
    settle(&mut harness);
    harness
}

/// Chooses an entry of the file menu.
fn choose(harness: &mut Harness<'_, Workbench>, entry: &str) {
    press(harness, "File");
    harness.get_by_label_contains(entry).click();
    settle(harness);
}

/// What stands in the path.
fn path(harness: &Harness<'_, Workbench>) -> String {
    harness.get_by_role_and_label(Role::TextInput, "Path").accesskit_node().value().unwrap_or_default()
}

/// Types another path; the field has the focus from the beginning.
fn type_path(harness: &mut Harness<'_, Workbench>, path: &Path) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(egui::Event::Text(path.display().to_string()));
    settle(harness);
}

/// Goes on until work on threads has told how it ended.
fn told(harness: &mut Harness<'_, Workbench>) -> String {
    for _ in 0..3000 {
        harness.step();
        if let Some(words) = harness.state().window.notice() {
            let words = words.to_owned();
            settle(harness);
            press(harness, "Dismiss");
            return words;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    panic!("nothing was told in half a minute");
}

#[test]
fn letters_that_come_in_one_frame_with_enter_count() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = asking();
    choose(&mut harness, "Save as…");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    settle(&mut harness);
    let file = folder.path().join("fast.toml");
    let enter =
        Event::Key { key: Key::Enter, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE };
    harness.input_mut().events.extend([Event::Text(file.display().to_string()), enter]);
    settle(&mut harness);
    assert!(file.is_file(), "saved under the whole name");
}

#[test]
fn a_scene_is_saved_as_and_opened_by_its_path() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = asking();
    slide(&mut harness, "Skew β", 70.0);
    choose(&mut harness, "Save as…");
    assert!(path(&harness).ends_with("skew45-abutment.toml"), "called so at first: {}", path(&harness));
    let mine = folder.path().join("mine.toml");
    type_path(&mut harness, &folder.path().join("mine"));
    press(&mut harness, "Save it");
    assert!(mine.is_file() && !harness.state().files.document.is_dirty(), "saved");
    assert!(harness.query_by_label_contains(&mine.display().to_string()).is_some(), "where it went is said");
    assert!(harness.query_by_role_and_label(Role::Button, "Show").is_some(), "and can be shown");
    press(&mut harness, "Copy path");
    press(&mut harness, "Dismiss");

    let saved = harness.state().files.document.scene().clone();
    press(&mut harness, "Undo");
    choose(&mut harness, "Open…");
    type_path(&mut harness, &folder.path().join("mi"));
    harness.key_press(Key::Tab);
    settle(&mut harness);
    assert_eq!(Path::new(&path(&harness)), mine, "Tab completes it");
    harness.key_press(Key::Enter);
    settle(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), saved, "opened");
    assert_eq!(harness.state().files.name(), "mine.toml", "from its file");
}

#[test]
fn what_is_there_already_is_replaced_only_after_asking() {
    let folder = tempfile::tempdir().expect("a folder");
    let there = folder.path().join("there.toml");
    std::fs::write(&there, "precious").expect("written");
    let mut harness = asking();
    choose(&mut harness, "Save as…");
    type_path(&mut harness, &there);
    press(&mut harness, "Save it");
    assert!(harness.query_by_label("This file is there already.").is_some(), "asked");
    press(&mut harness, "Close");
    assert_eq!(std::fs::read(&there).expect("there"), b"precious", "as it was");
    choose(&mut harness, "Save as…");
    type_path(&mut harness, &there);
    harness.key_press(Key::Enter);
    settle(&mut harness);
    press(&mut harness, "Replace it");
    assert_ne!(std::fs::read(&there).expect("there"), b"precious", "replaced");
}

#[test]
fn every_export_and_a_film_go_where_the_path_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = asking();
    let exports = [
        ("Export picture…", "a.png", "a.png"),
        ("Export picture for print…", "p", "p.png"),
        ("Export report…", "b", "b.html"),
        ("Export tables…", "c", "c/summary.json"),
    ];
    for (entry, typed, written) in exports {
        choose(&mut harness, entry);
        type_path(&mut harness, &folder.path().join(typed));
        press(&mut harness, "Write it");
        let words = told(&mut harness);
        assert!(folder.path().join(written).is_file(), "{entry}: {words}");
        assert!(words.contains(&folder.path().join(typed).display().to_string()), "{entry} says where: {words}");
    }
    choose(&mut harness, "Export film…");
    let plan = FilmPlan {
        from: 0.6,
        to: 0.61,
        fps: 5.0,
        speed: 0.1,
        size: Some([160, 90]),
        ..harness.state().tasks.films.plan.expect("open")
    };
    harness.state_mut().apply(FilmCommand::Plan(plan));
    settle(&mut harness);
    press(&mut harness, "Choose where…");
    type_path(&mut harness, &folder.path().join("d.gif"));
    press(&mut harness, "Film it");
    let words = told(&mut harness);
    assert!(folder.path().join("d.gif").is_file() && words.contains("d.gif"), "{words}");
    choose(&mut harness, "Export tables…");
    type_path(&mut harness, &folder.path().join("c"));
    press(&mut harness, "Write it");
    assert!(harness.query_by_label_contains("This folder is not empty").is_some(), "asked");
    press(&mut harness, "Write into it");
    assert!(told(&mut harness).contains("summary.json"), "written again");
}
