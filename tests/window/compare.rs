//! Before and after: runs are pinned, seen as ghosts and thin lines, and their differences are read out.

use super::harness::{open, press, reach, settle, slide};
use egui::Key;
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{CompareCommand, EditCommand, TimeCommand};
use girderbench::scene::device::Device;
use girderbench::scene::edit::Edit;
use girderbench::scene::presets;
use girderbench::sim::RunDifference;

#[test]
fn a_pinned_run_stays_as_a_ghost_and_in_the_table_while_the_scene_changes() {
    let mut harness = open(presets::OPENING);
    let plain = harness.state().view.viewport.list().expect("shown").to_string();
    harness.key_press(Key::P);
    settle(&mut harness);
    assert_eq!(harness.state().comparison.pins().len(), 1, "kept");
    let before = harness.state().replay.runner.answer().expect("run").clone();
    slide(&mut harness, "Skew β", 60.0);
    let now = harness.state().replay.runner.answer().expect("run").clone();
    let time = now.summary.peak_time.expect("a hit");
    harness.state_mut().apply(TimeCommand::Seek(time));
    settle(&mut harness);
    let list = harness.state().view.viewport.list().expect("shown").to_string();
    assert!(list.contains("ghost") && !plain.contains("ghost"), "seen in the picture");
    let RunDifference { place, turn } = now.apart_from(&before);
    assert!(place > 1e-4 && turn > 1e-3, "the skew matters: {place} m, {turn} rad");
    assert!(harness.query_by_label_contains("from 1: at the most").is_some(), "and is read out");
    reach(&mut harness, "unpin 1");
    press(&mut harness, "unpin 1");
    assert_eq!(harness.state().comparison.pins().len(), 0, "let go");
    assert!(!harness.state().view.viewport.list().expect("shown").to_string().contains("ghost"), "the ghost is gone");
}

#[test]
fn four_runs_are_kept_and_a_fifth_is_refused_in_words() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(CompareCommand::Pin);
    harness.state_mut().apply(CompareCommand::Pin);
    settle(&mut harness);
    assert_eq!(harness.state().comparison.pins().len(), 1, "the same run once");
    assert!(harness.state().window.notice().is_some_and(|n| n.contains("already")), "and says so");
    for skew in [50.0, 55.0, 60.0, 65.0] {
        slide(&mut harness, "Skew β", skew);
        harness.state_mut().apply(CompareCommand::Pin);
    }
    settle(&mut harness);
    assert_eq!(harness.state().comparison.pins().len(), 4, "four");
    assert!(harness.state().window.notice().is_some_and(|n| n.contains("unpin")), "the fifth is refused in words");
    reach(&mut harness, "Unpin all");
    press(&mut harness, "Unpin all");
    assert_eq!(harness.state().comparison.pins().len(), 0, "none");
}

#[test]
fn runs_pinned_of_another_scene_are_put_aside() {
    let mut harness = open(presets::OPENING);
    harness.key_press(Key::P);
    settle(&mut harness);
    press(&mut harness, "Presets");
    press(&mut harness, "straight-straight");
    let list = harness.state().view.viewport.list().expect("shown").to_string();
    assert!(!list.contains("ghost") && harness.query_by_label("unpin 1").is_none(), "no ghost of another scene");
    press(&mut harness, "Undo");
    assert!(harness.query_by_label("unpin 1").is_some(), "it comes back with its own");
}

#[test]
fn a_device_that_was_changed_has_its_force_in_the_table_of_runs() {
    let mut harness = open("twin-span-restrained");
    harness.key_press(Key::P);
    settle(&mut harness);
    let before = harness.state().replay.runner.answer().expect("run").clone();
    let name = before.device_names().next().expect("a cable").to_owned();
    let id = before.history.model().devices[0].id;
    let mut cable = before.history.scene().device(id).expect("there");
    let Device::Restrainer(restrainer) = &mut cable else { panic!("a cable") };
    restrainer.slack *= 2.0;
    let edit = Edit::ReplaceDevice(id, Box::new(cable));
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    settle(&mut harness);
    let now = harness.state().replay.runner.answer().expect("run").clone();
    let forces = [&now, &before].map(|run| run.device(&name).expect("read").force.value);
    assert!((forces[0] - forces[1]).abs() > 1e-3 * forces[1], "the slack matters: {forces:?} N");
    assert!(harness.query_by_label(&format!("force of {name}")).is_some(), "a row of {name}");
}
