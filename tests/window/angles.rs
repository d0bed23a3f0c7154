//! Which way is worst: the shaking turned all round in the background, a click gives the scene an angle.

use super::harness::{open, settle};
use super::studio;
use egui::{Key, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{AngleCommand, EditCommand, Workbench};
use girderbench::scene::edit::Edit;
use girderbench::scene::presets;
use girderbench::study::sweep::Measure;

type Window = Harness<'static, Workbench>;

const PLOT: &str = "max rotation [°] by angle of shaking";

/// The window on a second of the opening scene, the angles on their way.
fn turning() -> Window {
    let mut harness = open(presets::OPENING);
    let edit = Edit::Set("duration_s=1".into());
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    settle(&mut harness);
    harness.state_mut().apply(AngleCommand::Show(true));
    harness.step();
    harness
}

fn wait(harness: &mut Window) {
    let scene = harness.state().files.document.scene().clone();
    harness.state_mut().angles.wait(&scene);
    settle(harness);
}

fn angle(harness: &Window) -> f64 {
    harness.state().files.document.scene().motion.angle_deg()
}

#[test]
fn the_worst_angle_is_filled_in_while_one_works_and_a_click_gives_it_to_the_scene_undoably() {
    let mut harness = turning();
    let before = angle(&harness);
    // Work goes on: an edit of the angle itself leaves the runs what they are.
    let edit = Edit::Set("motion.angle_deg=12.0".into());
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    wait(&mut harness);
    assert!(harness.state().angles.fits(), "every angle, whatever the scene's is");
    assert!(harness.query_by_label("72 of 72 runs").is_some(), "whole");
    // 35° to the upper right of the middle: key number (35 + 175)/5.
    let rect = harness.get_by_label(PLOT).rect();
    let aside = 60.0 * egui::vec2(35_f32.to_radians().cos(), -35_f32.to_radians().sin());
    let at = pos2(rect.center().x, rect.center().y) + aside;
    harness.drag_at(at);
    harness.run_steps(2);
    harness.drop_at(at);
    settle(&mut harness);
    assert_eq!(angle(&harness), 35.0);
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    let turned = harness.state().angles.turned().expect("turned");
    for (number, name) in ["max_rotation", "max_total_force"].into_iter().enumerate() {
        let value = Measure::named(name).expect("known").of(&answer.history);
        assert_eq!(turned.row([42]).expect("out").values[number], value, "{name}: to the last bit");
    }
    for expected in [12.0, before] {
        harness.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
        settle(&mut harness);
        assert_eq!(angle(&harness), expected, "one step each");
    }
    let edit = Edit::Set("contact.mu_kinetic=0.02".into());
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    settle(&mut harness);
    assert!(harness.query_by_label("of the scene as it was").is_some(), "another scene");
}

#[test]
fn the_worst_is_said_in_words_and_arrows_and_enter_choose_an_angle() {
    let mut harness = turning();
    wait(&mut harness);
    let turned = harness.state().angles.turned().expect("turned");
    let rotations: Vec<f64> = (0..72).map(|n| turned.row([n]).expect("out").values[0].expect("rotates")).collect();
    let worst = (0..72).max_by(|a, b| rotations[*a].total_cmp(&rotations[*b])).expect("some");
    let first = rotations.iter().position(|value| *value == rotations[worst]).expect("itself");
    let words = format!("Worst at {}°: ", -175 + 5 * i32::try_from(first).expect("small"));
    let links: Vec<String> =
        harness.get_all_by_label_contains("Worst at ").filter_map(|node| node.accesskit_node().label()).collect();
    assert!(links.iter().any(|link| link.starts_with(&words)), "{words} among {links:?}");
    harness.get_by_label(PLOT).focus();
    harness.run_steps(4);
    for key in [Key::ArrowLeft, Key::ArrowLeft, Key::ArrowRight, Key::Enter] {
        harness.key_press(key);
        harness.run_steps(2);
    }
    settle(&mut harness);
    assert_eq!(angle(&harness), 5.0, "one step to the left of 0°");
}

#[test]
#[ignore = "leaves a picture to be looked at"]
fn picture_of_angles() {
    let Some(_studio) = studio::studio("picture_of_angles") else { return };
    let mut harness = super::harness::builder([1280.0, 720.0])
        .wgpu()
        .build_ui_state(super::harness::show, super::harness::bench("skew45-abutment"));
    settle(&mut harness);
    harness.state_mut().apply(AngleCommand::Show(true));
    harness.step();
    wait(&mut harness);
    harness.render().expect("drawn").save("target/angles.png").expect("written");
}
