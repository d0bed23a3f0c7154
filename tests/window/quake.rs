//! Histories and response spectrum of the ground motion, with the girders' own periods.

use super::harness::{open, open_for, press, reach, settle};
use super::studio;
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{QuakeCommand, Workbench};
use girderbench::study::ground::psa;

/// Waits until it has been computed, and shows it.
fn wait(harness: &mut egui_kittest::Harness<'static, Workbench>) {
    harness.step();
    harness.state_mut().shaking.wait();
    settle(harness);
}

#[test]
fn the_spectrum_is_that_of_the_motion_as_the_run_has_it() {
    let mut harness = open("el-centro-45");
    reach(&mut harness, "Histories and spectrum…");
    press(&mut harness, "Histories and spectrum…");
    wait(&mut harness);
    let shaken = harness.state().shaking.shaken().expect("computed").clone();
    assert_eq!(shaken.components.len(), 1, "along one angle");
    let girderbench::scene::Motion::Synthetic(quake) = harness.state().files.document.scene().motion.clone() else {
        panic!("a synthetic earthquake")
    };
    let samples = quake.samples(0);
    let curve = &shaken.components[0].spectrum[0].curves[0].points;
    for [period, acceleration] in [curve[20], curve[150], curve[300]] {
        assert_eq!(acceleration, psa(&samples, quake.dt, period), "at {period} s");
    }
    assert!(harness.query_by_label_contains("PGA ").is_some(), "its figures are told");
    harness.state_mut().apply(QuakeCommand::Show(false));
    settle(&mut harness);
    assert!(harness.query_by_label_contains("PGA ").is_none(), "closed");
}

#[test]
#[ignore = "leaves pictures to be looked at"]
fn pictures_of_the_ground_motion() {
    let Some(_studio) = studio::studio("pictures_of_the_ground_motion") else { return };
    let mut harness = super::harness::builder([1280.0, 720.0])
        .wgpu()
        .build_ui_state(super::harness::show, super::harness::bench("el-centro-45"));
    settle(&mut harness);
    harness.state_mut().apply(QuakeCommand::Show(true));
    wait(&mut harness);
    harness.render().expect("drawn").save("target/quake.png").expect("written");
}

#[test]
fn the_motion_travels_at_an_assumed_speed_until_it_is_taken_back() {
    let mut harness = open_for("viaduct-5", 1.0);
    let before = harness.state().files.document.scene().clone();
    reach(&mut harness, "Let it travel along the bridge");
    press(&mut harness, "Let it travel along the bridge");
    settle(&mut harness);
    let scene = harness.state().files.document.scene();
    assert!(scene.wave.is_some() && scene.assumed.iter().any(|path| path == "wave"), "{:?}", scene.assumed);
    assert!(harness.query_all_by_label_contains("Direction of the wave").next().is_some(), "its numbers are there");
    reach(&mut harness, "Let the ground move as one");
    press(&mut harness, "Let the ground move as one");
    settle(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "as it was, assumed values too");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
}
