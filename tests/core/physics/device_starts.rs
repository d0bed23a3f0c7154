//! Devices that are beyond yield or break at the start: as if they had been pulled there once from where they carried nothing.
//! Places at the end were computed by another program from the equations of the devices.

use girderbench::sim::History;

use crate::support::{run, scene};

/// A girder 20 mm from where its bearings are at rest, and a device with 4 mm of slack or gap.
fn displaced(device: &str) -> History {
    let text = format!(
        r#"
        name = "displaced"
        duration_s = 0.5
        [[girder]]
        name = "a"
        length_m = 25.0
        width_m = 9.0
        thickness_m = 1.5
        mass_kg = 2.5e5
        bearings = {{ frequency_hz = 0.6, damping_ratio = 0.02, at_m = [[10, 3], [10, -3], [-10, 3], [-10, -3]] }}
        initial = {{ displacement_m = [0.02, 0.0, 0.0] }}
        {device}
        [solver]
        tolerance = 1e-11
        "#
    );
    run(&scene(&text))
}

fn cable(more: &str) -> String {
    format!(
        r#"[[restrainer]]
        name = "cable"
        girder = "a"
        at_m = [-10.0, 0.0, 0.0]
        to_m = [-14.0, 0.0, 0.0]
        slack_m = 0.004
        stiffness_n_per_m = 2e7
        {more}"#
    )
}

fn stopper(more: &str) -> String {
    format!(
        r#"[[stopper]]
        name = "stopper"
        girder = "a"
        at_m = [-10.0, 0.0, 0.0]
        direction = [1.0, 0.0, 0.0]
        gap_m = 0.004
        stiffness_n_per_m = 2e7
        {more}"#
    )
}

/// Where the girder is at 0.5 s \[mm\], to the digits of the other program, and what the ledger leaves over.
fn ends_at(history: &History, wanted: f64, what: &str) {
    assert!(history.stop().is_none(), "{what}: {:?}", history.stop());
    let x = 1e3 * history.motion(0, 0.5).displacement.x;
    assert!((x - wanted).abs() < 1e-4, "{what}: {x} mm, {wanted} wanted");
    assert!(history.energy().balance().holds(), "{what}: {:?}", history.energy().ledger(0.5));
}

#[test]
fn a_cable_beyond_its_yield_begins_on_its_yield_surface() {
    let history = displaced(&cable("yield_force_n = 2e5\npost_yield_stiffness_n_per_m = 1e6"));
    let force = history.connections().link(0, 0.0).expect("a cable").force.length();
    assert!((force - 206e3).abs() < 1e-3, "T_y + K₂ (16 − 10 mm): {force} N");
    ends_at(&history, -25.5438, "yielded");
    let ended = displaced(&cable("yield_force_n = 2e5\nbreak_elongation_m = 0.012"));
    assert_eq!(ended.connections().devices()[0].broke_at, Some(0.0), "broken beyond 12 mm");
    // Alone on its bearings, from rest.
    let (omega, ratio, t) = (std::f64::consts::TAU * 0.6, 0.02_f64, 0.5);
    let own = omega * (1.0 - ratio * ratio).sqrt();
    let swing = (own * t).cos() + ratio * omega / own * (own * t).sin();
    ends_at(&ended, 20.0 * (-ratio * omega * t).exp() * swing, "broken");
}

#[test]
fn a_cable_that_is_pulled_on_yields_from_the_start() {
    let history = displaced(&cable("yield_force_n = 2e5\npost_yield_stiffness_n_per_m = 1e6"));
    assert_eq!(history.connections().devices()[0].yielded_at, None, "at rest it is drawn back");
    let scene = girderbench::scene::overrides::apply(history.scene(), "girder.a.initial.velocity_m_s=[0.1,0]");
    let pulled = run(&scene.unwrap_or_else(|errors| panic!("{errors}")));
    let reading = pulled.connections().devices().remove(0);
    assert!(pulled.stop().is_none() && reading.yielded_at == Some(0.0), "{reading:?}, {:?}", pulled.stop());
    // On the surface: T_y + K₂ (ε − T_y/K) of the largest elongation.
    let surface = 2e5 + 1e6 * (reading.deformation[1].value - 0.004 - 0.01);
    assert!((reading.force.value - surface).abs() < 1e-3, "{} N, {surface} N", reading.force.value);
    assert!(pulled.energy().balance().holds(), "{:?}", pulled.energy().ledger(0.5));
}

#[test]
fn a_stopper_beyond_its_strength_is_broken_or_has_yielded() {
    let brittle = displaced(&stopper("break_force_n = 2e5"));
    assert_eq!(brittle.connections().devices()[0].broke_at, Some(0.0), "320 kN of 200");
    ends_at(&brittle, -5.5676, "brittle");
    ends_at(&displaced(&stopper("yield_force_n = 2e5")), -12.56978, "ductile, w_p = 6 mm");
    let beyond = displaced(&stopper("yield_force_n = 2e5\nbreak_displacement_m = 0.002"));
    assert_eq!(beyond.connections().devices()[0].broke_at, Some(0.0), "w_p = 6 mm of 2");
    ends_at(&beyond, -5.56758, "ductile beyond its end");
}
