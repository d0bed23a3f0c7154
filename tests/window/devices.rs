//! Devices between two points: added, selected in the list and in the view, dragged, edited, copied and removed, with undo.

use super::harness::{click, drag, on_screen, open, open_for, press, reach, settle, type_in};
use super::studio;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{EditCommand, PlaceCommand, SelectCommand, TimeCommand, ViewCommand, Workbench};
use girderbench::scene::device::{Device, Joint};
use girderbench::scene::edit::Edit;
use girderbench::scene::{DeviceId, DeviceKind, PlotSettings, ViewPreset, ViewSettings};
use girderbench::view::Target;

type Window = Harness<'static, Workbench>;

fn undo(harness: &mut Window) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(harness);
}

fn device(harness: &Window, kind: DeviceKind, number: usize) -> Device {
    harness.state().files.document.scene().device(DeviceId { kind, number }).expect("it is there")
}

#[test]
fn every_kind_is_added_from_the_list_runs_and_is_undone() {
    let mut harness = open_for("deck-30m", 2.0);
    let before = harness.state().files.document.scene().clone();
    for (kind, words) in [
        (DeviceKind::Restrainer, "Restrainer cable"),
        (DeviceKind::Bumper, "Bumper"),
        (DeviceKind::Damper, "Damper"),
        (DeviceKind::Stopper, "Stopper"),
    ] {
        press(&mut harness, "Add device");
        press(&mut harness, words);
        let target = Target::Device(DeviceId { kind, number: 0 });
        assert_eq!(harness.state().files.document.selection().all(), [target], "{words}: the new one is selected");
        assert_eq!(harness.state().replay.runner.problems(), None, "{words} runs");
        assert!(harness.query_by_label_contains("is assumed: it fits").is_some(), "which is said");
    }
    for _ in 0..4 {
        undo(&mut harness);
    }
    assert_eq!(*harness.state().files.document.scene(), before, "all undone");
}

#[test]
fn a_cable_is_picked_in_the_view_dragged_by_its_points_and_edited() {
    let mut harness = open_for("deck-30m", 2.0);
    harness.state_mut().apply(ViewCommand::Preset(ViewPreset::Top));
    harness.state_mut().apply(PlaceCommand::AddDevice(DeviceKind::Restrainer));
    harness.state_mut().apply(SelectCommand::Only(None));
    settle(&mut harness);
    let placed = device(&harness, DeviceKind::Restrainer, 0);
    let joint = Joint::of(harness.state().files.document.scene(), &placed.part().ends()).expect("both bodies");
    let at = on_screen(&harness, joint.points[0].midpoint(joint.points[1]));
    click(&mut harness, at);
    let target = Target::Device(DeviceId { kind: DeviceKind::Restrainer, number: 0 });
    assert_eq!(harness.state().files.document.selection().all(), [target], "by its line");
    let name = placed.part().ends().name.to_owned();
    let handle = harness.get_by_label(&format!("first point of {name}")).rect().center();
    drag(&mut harness, handle, handle + egui::vec2(0.0, 40.0));
    let moved = device(&harness, DeviceKind::Restrainer, 0);
    let (was, is) = (placed.part().ends(), moved.part().ends());
    assert!((was.at[1] - is.at[1]).abs() > 0.1, "across: {} and {}", was.at[1], is.at[1]);
    assert_eq!(was.to_at, is.to_at, "the other point stays");
    undo(&mut harness);
    assert_eq!(device(&harness, DeviceKind::Restrainer, 0), placed, "one step");
    type_in(&mut harness, "Slack", "5 cm");
    let Device::Restrainer(cable) = device(&harness, DeviceKind::Restrainer, 0) else { panic!("a cable") };
    assert_eq!(cable.slack, 0.05, "as typed");
    let second = format!("second point of {name}");
    harness.get_by_label(&second).focus();
    harness.run_steps(4);
    harness.event(egui::Event::Text("1 m".into()));
    settle(&mut harness);
    harness.key_press(Key::Enter);
    settle(&mut harness);
    let typed = device(&harness, DeviceKind::Restrainer, 0);
    let there = Joint::of(harness.state().files.document.scene(), &typed.part().ends()).expect("still").points[1];
    assert!((there.x - joint.points[1].x - 1.0).abs() < 1e-5, "a metre along x, got {there}");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::D);
    settle(&mut harness);
    let copy = device(&harness, DeviceKind::Restrainer, 1);
    assert_eq!(copy.part().ends().at[1], -typed.part().ends().at[1], "a copy on the other side");
    harness.key_press(Key::Delete);
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().count_of(DeviceKind::Restrainer), 1, "removed");
}

#[test]
fn the_state_of_a_device_is_told_and_its_loop_is_a_plot() {
    let mut harness = open("skew45-abutment");
    harness.state_mut().apply(PlaceCommand::AddDevice(DeviceKind::Bumper));
    settle(&mut harness);
    let history = &harness.state().replay.runner.answer().expect("run").history;
    let device = history.model().devices[0].clone();
    let phases = history.connections().link_phases(device.links.start).to_vec();
    let squeezed = phases.iter().find(|(t, _)| *t > 0.0).expect("the girder reaches it").0;
    assert!(harness.query_all_by_label_contains("squeezed").count() > 0, "in the list of states");
    harness.state_mut().apply(TimeCommand::Seek(squeezed + 1e-3));
    settle(&mut harness);
    let now = harness
        .state()
        .replay
        .runner
        .answer()
        .expect("run")
        .history
        .connections()
        .link(device.links.start, squeezed + 1e-3);
    assert!(now.is_some_and(|now| now.acts && now.force.length() > 0.0), "its force acts");
    reach(&mut harness, "Add plot");
    press(&mut harness, "Add plot");
    press(&mut harness, "Loop of a device or of soil");
    let plots = harness.state().files.document.scene().view.plots.clone();
    assert_eq!(plots[0].x.as_deref(), Some(&*format!("{}.deformation", device.name)), "{plots:?}");
    assert_eq!(plots[0].y, [format!("{}.force", device.name)], "{plots:?}");
}

#[test]
#[ignore = "leaves pictures to be looked at"]
fn pictures_of_devices() {
    let Some(_studio) = studio::studio("pictures_of_devices") else { return };
    let mut harness = super::harness::builder([1280.0, 720.0])
        .wgpu()
        .build_ui_state(super::harness::show, super::harness::bench("deck-30m"));
    settle(&mut harness);
    for kind in DeviceKind::ALL {
        harness.state_mut().apply(PlaceCommand::AddDevice(*kind));
    }
    harness.state_mut().apply(PlaceCommand::AddDevice(DeviceKind::Damper));
    let view = harness.state().files.document.scene().view.clone();
    let force = PlotSettings::over_time(vec!["restrainer.force".into()]);
    let plots = vec![PlotSettings { x: Some("restrainer.deformation".into()), ..force }];
    let edit = Edit::View(ViewSettings { plots, ..view });
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    let id = DeviceId { kind: DeviceKind::Restrainer, number: 0 };
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Device(id))));
    settle(&mut harness);
    harness.state_mut().apply(ViewCommand::Frame);
    harness.run_steps(60);
    harness.render().expect("drawn").save("target/device-iso.png").expect("written");
    harness.state_mut().apply(ViewCommand::Preset(ViewPreset::Top));
    harness.state_mut().apply(TimeCommand::Seek(2.0));
    harness.run_steps(60);
    harness.state_mut().apply(ViewCommand::Frame);
    harness.run_steps(60);
    harness.render().expect("drawn").save("target/device-top.png").expect("written");
}
