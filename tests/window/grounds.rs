//! Motions that supports have of their own: added, changed, named, stood on and taken away by hand.

use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{EditCommand, SelectCommand};
use girderbench::scene::{Motion, overrides, presets};
use girderbench::view::Target;

use super::harness::{bench_of, builder, choose, open, press, reach_as, settle, show, slide};

type Window = egui_kittest::Harness<'static, girderbench::app::Workbench>;

fn undo(harness: &mut Window) {
    harness.state_mut().apply(EditCommand::Undo);
    settle(harness);
}

/// Excitation angles of `[motion]` and of the first ground.
fn angles(harness: &Window) -> [f64; 2] {
    let scene = harness.state().files.document.scene();
    [&scene.motion, &scene.grounds[0].motion].map(Motion::angle_deg)
}

#[test]
fn an_abutment_is_put_on_a_ground_of_its_own() {
    let mut harness = open(presets::OPENING);
    let before = harness.state().files.document.scene().clone();
    press(&mut harness, "Another ground for a support");
    settle(&mut harness);
    let added = harness.state().files.document.scene().clone();
    assert_eq!(added.grounds.len(), 1, "added");
    assert_eq!(added.grounds[0].motion, before.motion, "it begins as that of all supports");
    let answer = |harness: &Window| harness.state().replay.runner.answer().map(|run| run.history.digest());
    let alone = answer(&harness);
    slide(&mut harness, "Angle α", 35.0);
    assert_eq!(angles(&harness), [before.motion.angle_deg(), 35.0], "the ground that is shown, and no other");
    assert_eq!(answer(&harness), alone, "nothing stands on it");
    choose(&mut harness, "Motion of", "all supports");
    slide(&mut harness, "Angle α", 10.0);
    assert_eq!(angles(&harness), [10.0, 35.0], "the other one");
    undo(&mut harness);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Abutment(0))));
    settle(&mut harness);
    choose(&mut harness, "Its ground", "own-ground");
    let scene = harness.state().files.document.scene().clone();
    assert_eq!(scene.abutments[0].ground.as_deref(), Some("own-ground"), "it stands there");
    assert!(harness.state().replay.runner.problems().is_none() && answer(&harness) != alone, "and moves with it");
    for (label, default) in [("Delay of its ground", "(0 s)"), ("Factor of its motion", "(1)")] {
        let field = harness.get_by_role_and_label(Role::SpinButton, label);
        let said = field.accesskit_node().description().unwrap_or_default();
        assert!(said.contains(default), "what it is where it is left out: {said}");
    }
    choose(&mut harness, "Motion of", "own-ground");
    press(&mut harness, "Take it away");
    settle(&mut harness);
    let scene = harness.state().files.document.scene().clone();
    assert!(scene.grounds.is_empty() && scene.abutments[0].ground.is_none(), "with what names it");
    assert_eq!(answer(&harness), alone, "as before");
    undo(&mut harness);
    assert_eq!(
        harness.state().files.document.scene().abutments[0].ground.as_deref(),
        Some("own-ground"),
        "one step back"
    );
    choose(&mut harness, "Motion of", "own-ground");
    reach_as(&mut harness, Role::TextInput, "Name of this ground");
    harness.get_by_role_and_label(egui::accesskit::Role::TextInput, "Name of this ground").click();
    settle(&mut harness);
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
    harness.event(egui::Event::Text("east bank".into()));
    settle(&mut harness);
    harness.key_press(egui::Key::Enter);
    settle(&mut harness);
    let scene = harness.state().files.document.scene();
    assert_eq!(scene.grounds[0].name, "east bank", "named");
    assert_eq!(scene.abutments[0].ground.as_deref(), Some("east bank"), "wherever it is named");
}

#[test]
fn ground_that_drifts_and_motion_that_is_cut_are_said() {
    let window = |sets: &[&str]| {
        let scene = overrides::apply_all(&presets::load(presets::OPENING).expect("ships"), sets).expect("fits");
        let mut harness = builder([1280.0, 720.0]).build_ui_state(show, bench_of(scene));
        settle(&mut harness);
        harness
    };
    let bank = "ground=[{ name = \"bank\", kind = \"record\", dt_s = 0.1, samples_m_s2 = [0, 1, 0] }]";
    let still = ["motion.kind=none", bank, "duration_s=1"];
    let drifts = |harness: &Window| harness.query_by_label("ground of a support drifts away").is_some();
    assert!(!drifts(&window(&still)), "nothing stands on it");
    assert!(drifts(&window(&[&still[..], &["abutment.wall.ground=bank"]].concat())), "0.1 m/s are left");
    let cut =
        |harness: &Window| harness.query_by_label_contains("the strong motion of motion lasts until 12 s").is_some();
    let quake = ["motion.kind=synthetic", "duration_s=3"];
    assert!(
        cut(&window(&quake)) && !cut(&window(&["motion.kind=synthetic", "duration_s=12"])),
        "rise and strong motion"
    );
}
