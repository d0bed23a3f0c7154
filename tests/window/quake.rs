//! Histories and response spectrum of the ground motion, with the girders' own periods.

use super::harness::{open, press, reach, settle};
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
