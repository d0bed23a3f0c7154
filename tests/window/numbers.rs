//! Every number of a scene in the inspector: bearings one by one, pairs, seats, pushes, the scene's own.

use super::harness::{choose, open, open_for, press, reach_as, settle, type_in};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{SelectCommand, Workbench};
use girderbench::scene::{Bearings, Kind, Motion, PerDirection, presets};
use girderbench::view::Target;

type Window = Harness<'static, Workbench>;

fn with(preset: &str, select: &[Target]) -> Window {
    let mut harness = open(preset);
    for target in select {
        harness.state_mut().apply(SelectCommand::Also(*target));
    }
    settle(&mut harness);
    harness
}

fn button(harness: &mut Window, label: &str) {
    super::harness::reach(harness, label);
    press(harness, label);
}

/// Opens a section that is folded away.
fn unfold(harness: &mut Window, label: &str) {
    harness.get_by_label(label).scroll_to_me();
    harness.run_steps(40);
    harness.get_by_label(label).click_accesskit();
    harness.run_steps(40);
}

#[test]
fn bearings_are_edited_one_by_one() {
    let mut harness = with(presets::OPENING, &[Target::Girder(0)]);
    let digest = harness.state().replay.runner.answer().expect("run").history.digest();
    button(&mut harness, "Edit one by one");
    let each = |h: &Window| match &h.state().files.document.scene().girders[0].bearings {
        Some(Bearings::Each(each)) => each.clone(),
        other => panic!("one by one, got {other:?}"),
    };
    let before = each(&harness);
    let same = harness.state().replay.runner.answer().expect("run").history.summary().max_displacement;
    assert!(same > 0.0, "it still runs");
    type_in(&mut harness, "k x", "1.5 kN/m");
    let after = each(&harness);
    assert_eq!(after[0].stiffness[0], 1500.0, "as typed");
    assert_eq!(after[1..], before[1..], "the others as they were");
    assert_ne!(harness.state().replay.runner.answer().expect("run").history.digest(), digest, "and it matters");
    button(&mut harness, "Add a bearing");
    assert_eq!(each(&harness).len(), before.len() + 1, "one more");
    button(&mut harness, "Remove no. 1");
    assert_eq!(each(&harness).len(), before.len(), "one less");
}

#[test]
fn a_girder_is_put_on_bearings_and_taken_off() {
    let mut harness = with("flush-free-hit", &[Target::Girder(0)]);
    button(&mut harness, "Put it on four bearings");
    assert!(
        matches!(harness.state().files.document.scene().girders[0].bearings, Some(Bearings::Shared(_))),
        "four equal ones"
    );
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
    let places = |h: &Window| match h.state().files.document.scene().girders[0].bearings.clone() {
        Some(Bearings::Shared(shared)) => (false, shared.at_skewed),
        Some(Bearings::Deck(deck)) => (true, deck.at_skewed),
        other => panic!("equal ones, got {other:?}"),
    };
    let (_, before) = places(&harness);
    button(&mut harness, "Put it on lead rubber");
    assert_eq!(places(&harness), (true, before.clone()), "other bearings where those stood");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
    button(&mut harness, "Put it on linear bearings");
    assert_eq!(places(&harness), (false, before), "and back");
    button(&mut harness, "Take the bearings away");
    assert_eq!(harness.state().files.document.scene().girders[0].bearings, None, "none");
}

#[test]
fn a_pier_has_round_columns_or_rectangular_ones() {
    let mut harness = open_for("viaduct-5", 0.5);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Pier(0))));
    settle(&mut harness);
    let column = |h: &Window| h.state().files.document.scene().piers[0].column.expect("columns");
    let round = column(&harness);
    assert!(matches!(round, PerDirection::Both(_)), "round to begin with");
    choose(&mut harness, "Stiffness from", "rectangular columns");
    assert_eq!(column(&harness), PerDirection::Each(round.xy()), "as wide");
    type_in(&mut harness, "Column along", "2.5 m");
    assert_eq!(column(&harness), PerDirection::Each([2.5, round.xy()[1]]), "of two sides");
    choose(&mut harness, "Stiffness from", "round columns");
    type_in(&mut harness, "Column diameter", "2.1 m");
    assert_eq!(column(&harness), PerDirection::Both(2.1), "of one diameter");
}

#[test]
fn a_pair_says_where_its_numbers_come_from_and_takes_its_own() {
    let mut harness = with(presets::OPENING, &[Target::Abutment(0)]);
    assert!(harness.query_by_label("of this pair").is_none(), "all are the scene's");
    assert!(harness.query_all_by_label("μ kinetic").count() > 0, "numbers in force by their names");
    assert!(harness.query_all_by_label_contains("field-").next().is_none(), "no key of a text in place of its words");
    type_in(&mut harness, "μ static of pair", "0.5");
    let pair = &harness.state().replay.runner.answer().expect("run").history.model().pairs[0];
    assert_eq!(pair.contact.mu_static, 0.5, "in force");
    assert_eq!(harness.state().files.document.scene().contact.pairs.len(), 1, "as an entry of its own");
    harness.run_steps(10);
    assert!(harness.query_by_label("of this pair").is_some(), "said");
    button(&mut harness, "Use the scene's numbers");
    assert!(harness.state().files.document.scene().contact.pairs.is_empty(), "gone again");
}

#[test]
fn what_is_typed_goes_to_all_that_are_selected() {
    let all: Vec<Target> = (0..5).map(Target::Girder).collect();
    let mut harness = with("row-of-5", &all);
    let before = harness.state().files.document.scene().clone();
    type_in(&mut harness, "Mass m", "500 t");
    assert!(harness.state().files.document.scene().girders.iter().all(|g| g.mass == 5e5), "every one");
    let places = |s: &girderbench::scene::Scene| s.girders.iter().map(|g| g.position).collect::<Vec<_>>();
    assert_eq!(places(harness.state().files.document.scene()), places(&before), "and nothing else of them");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "one step of undo");
}

#[test]
fn the_scenes_own_numbers_are_there_when_nothing_is_selected() {
    let mut harness = with(presets::OPENING, &[]);
    type_in(&mut harness, "Tolerance", "1e-8");
    assert!((harness.state().files.document.scene().solver.tolerance - 1e-8).abs() < 1e-20, "10⁻⁸");
    reach_as(&mut harness, Role::ComboBox, "Motion in");
    harness.get_by_role_and_label(Role::ComboBox, "Motion in").click();
    harness.run_steps(20);
    press(&mut harness, "space");
    assert_eq!(harness.state().files.document.scene().kind, Kind::Spatial, "in space");
    assert!(harness.state().replay.runner.problems().is_some(), "its bearings have no vertical springs yet");
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    type_in(&mut harness, "Bearings f z", "20 Hz");
    assert_eq!(harness.state().replay.runner.problems(), None, "now it runs");
}

#[test]
fn an_earthquake_is_chosen_with_its_length_and_one_step_of_undo() {
    let mut harness = with(presets::OPENING, &[]);
    let before = harness.state().files.document.scene().clone();
    choose(&mut harness, "Ground", "synthetic earthquake");
    let scene = harness.state().files.document.scene().clone();
    let Motion::Synthetic(quake) = &scene.motion else { panic!("{:?}", scene.motion) };
    assert!(quake.duration > before.duration && scene.duration >= quake.duration, "to its end: {} s", scene.duration);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "one step");
}

#[test]
fn escape_closes_an_open_list_and_leaves_the_selection() {
    let mut harness = with(presets::OPENING, &[Target::Girder(0)]);
    reach_as(&mut harness, Role::ComboBox, "Ground");
    harness.get_by_role_and_label(Role::ComboBox, "Ground").click();
    harness.run_steps(20);
    assert!(egui::Popup::is_any_open(&harness.ctx), "it is open");
    harness.key_press(Key::Escape);
    settle(&mut harness);
    assert!(!egui::Popup::is_any_open(&harness.ctx), "it is closed");
    assert_eq!(harness.state().files.document.selection().lead(), Some(Target::Girder(0)), "still selected");
    harness.key_press(Key::Escape);
    settle(&mut harness);
    assert_eq!(harness.state().files.document.selection().lead(), None, "the next one lets go of it");
}

#[test]
fn what_is_selected_next_is_shown_from_its_beginning() {
    let mut harness = with("twin-span-restrained", &[Target::Girder(0)]);
    unfold(&mut harness, "Start, push, held");
    reach_as(&mut harness, Role::SpinButton, "Push moment");
    let top = harness.get_by_role_and_label(Role::TextInput, "Name").rect().top();
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(1))));
    harness.run_steps(40);
    let again = harness.get_by_role_and_label(Role::TextInput, "Name").rect().top();
    assert!(again > top, "scrolled to {top}, then {again}");
}

#[test]
fn starts_pushes_and_seats_have_their_fields() {
    let mut harness = with(presets::OPENING, &[Target::Girder(0)]);
    unfold(&mut harness, "Start, push, held");
    type_in(&mut harness, "Push moment", "0.2 N m");
    assert_eq!(harness.state().files.document.scene().girders[0].push.moment, 0.2, "as typed");
    reach_as(&mut harness, Role::CheckBox, "held in yaw");
    harness.get_by_role_and_label(Role::CheckBox, "held in yaw").click();
    settle(&mut harness);
    let turned = harness.state().replay.runner.answer().expect("run").summary.max_rotation;
    assert_eq!(turned, 0.0, "held, it does not turn");
    unfold(&mut harness, "Seats");
    reach_as(&mut harness, Role::CheckBox, "Seat at +x");
    harness.get_by_role_and_label(Role::CheckBox, "Seat at +x").click();
    settle(&mut harness);
    type_in(&mut harness, "Seat at +x", "8 mm");
    assert_eq!(harness.state().files.document.scene().girders[0].seat.plus, Some(0.008), "as typed");
}

#[test]
fn a_long_number_behind_a_slider_takes_from_the_slider_and_no_number_stops_the_window() {
    let mut harness = with("skew45-abutment", &[]);
    let right = |h: &Window| h.get_by_label("3D view").rect().right();
    let before = right(&harness);
    // Shown as 0.399729 g, and as a ten-figure number, whose curves go on far beyond every plot.
    for typed in ["392 gal", "1e9"] {
        type_in(&mut harness, "Amplitude", typed);
        harness.run_steps(60);
        assert_eq!(right(&harness), before, "{typed}: the panel is as wide as it was");
    }
}
