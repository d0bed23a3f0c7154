//! Without a mouse: Tab reaches every control, each has a name that a screen reader can say, and Enter presses it.

use std::collections::BTreeMap;

use super::harness::{bench, builder, open, reach_as, settle, show};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{SelectCommand, Workbench};
use girderbench::scene::presets;
use girderbench::view::Target;

/// What a person works with, as a screen reader tells it.
const CONTROLS: [Role; 7] =
    [Role::Button, Role::CheckBox, Role::ComboBox, Role::RadioButton, Role::Slider, Role::SpinButton, Role::TextInput];

/// Every control that can be used now: role and name by its number.
fn controls(harness: &Harness<'_, Workbench>) -> BTreeMap<String, String> {
    let nodes = harness.root().children_recursive();
    let usable = nodes.map(|n| n.accesskit_node()).filter(|n| CONTROLS.contains(&n.role()) && !n.is_disabled());
    usable.map(|n| (format!("{:?}", n.id()), format!("{:?} \"{}\"", n.role(), n.label().unwrap_or_default()))).collect()
}

/// The number of what has the focus.
fn focused(harness: &Harness<'_, Workbench>) -> Option<String> {
    let mut nodes = harness.root().children_recursive();
    nodes.find(|n| n.accesskit_node().is_focused()).map(|n| format!("{:?}", n.accesskit_node().id()))
}

/// Presses Tab until it begins anew.
fn walk(harness: &mut Harness<'_, Workbench>) -> Vec<String> {
    let mut walked: Vec<String> = Vec::new();
    for _ in 0..500 {
        harness.key_press(Key::Tab);
        harness.step();
        let Some(here) = focused(harness) else { continue };
        if walked.first() == Some(&here) {
            return walked;
        }
        walked.push(here);
    }
    panic!("Tab does not come round: {} stops", walked.len());
}

#[test]
fn tab_reaches_every_control_and_each_has_a_name() {
    for selected in [None, Some(Target::Girder(0)), Some(Target::Abutment(0))] {
        let mut harness = builder([1280.0, 720.0]).build_ui_state(show, bench(presets::OPENING));
        harness.state_mut().apply(SelectCommand::Only(selected));
        settle(&mut harness);
        let wanted = controls(&harness);
        assert!(wanted.len() > 40, "a window full of controls: {}", wanted.len());
        let walked = walk(&mut harness);
        let missed: Vec<_> = wanted.iter().filter(|(id, _)| !walked.contains(id)).map(|(_, name)| name).collect();
        assert!(missed.is_empty(), "{selected:?}: Tab never comes to {missed:#?}");
        let mute: Vec<_> = wanted.values().filter(|name| name.ends_with("\"\"")).collect();
        assert!(mute.is_empty(), "{selected:?}: without a name: {mute:?}");
    }
}

#[test]
fn a_control_that_has_the_focus_is_pressed_by_enter_and_by_space() {
    for key in [Key::Enter, Key::Space] {
        let mut harness = open(presets::OPENING);
        harness.get_by_role_and_label(Role::Button, "Add girder").focus();
        harness.step();
        harness.key_press(key);
        settle(&mut harness);
        assert_eq!(harness.state().files.document.scene().girders.len(), 2, "{key:?} presses it");
        assert!(!harness.state().replay.playback.clock.playing, "and nothing else");
    }
}

#[test]
fn keys_typed_in_the_frame_of_a_click_into_a_field_go_to_the_field() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    reach_as(&mut harness, Role::SpinButton, "Mass m");
    let at = harness.get_by_role_and_label(Role::SpinButton, "Mass m").rect().center();
    harness.hover_at(at);
    settle(&mut harness);
    let before = harness.state().replay.playback.clone();
    let press =
        |pressed| Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE };
    harness.event(press(true));
    harness.event(press(false));
    // A slow frame: the click and everything after it come at once.
    for (key, text) in
        [(Key::Num3, "3"), (Key::Space, " "), (Key::L, "l"), (Key::Backspace, ""), (Key::M, "m"), (Key::Backspace, "")]
    {
        harness.event(Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE });
        if !text.is_empty() {
            harness.event(Event::Text(text.into()));
        }
    }
    harness.step();
    settle(&mut harness);
    assert!(harness.state().replay.playback == before, "nothing plays, loops or slows down");
    assert_eq!(harness.state().files.document.scene().girders.len(), 1, "and nothing is removed");
    harness.key_press(Key::Enter);
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().girders[0].mass, 3.0, "all of it was typed into the field");
}

#[test]
fn keys_in_the_frame_after_a_click_into_a_field_that_was_never_edited_are_typed_too() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    reach_as(&mut harness, Role::SpinButton, "Mass m");
    harness.get_by_role_and_label(Role::SpinButton, "Mass m").click();
    harness.step();
    harness.event(Event::Key {
        key: Key::Space,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    });
    harness.event(Event::Text(" ".into()));
    harness.step();
    settle(&mut harness);
    assert!(!harness.state().replay.playback.clock.playing, "typed text is never a shortcut");
}
