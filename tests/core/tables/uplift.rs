//! What bearings in space carry, where they lift or hold a girder down, and girders that tip, against closed forms.

use std::f64::consts::TAU;

use girderbench::scene::STANDARD_GRAVITY;
use girderbench::sim::History;

use crate::support::{run, scene, within};

const MASS: f64 = 6e4;
/// Natural frequency of the deck on its bearings, vertically \[Hz\].
const VERTICAL_HZ: f64 = 10.0;

/// A deck of 60 t on four bearings, with a vertical velocity at the start \[m/s\].
fn deck(bearings: &str, more: &str) -> History {
    run(&scene(&format!(
        "name = \"deck\"\nkind = \"spatial\"\nduration_s = 0.5\n[[girder]]\nname = \"deck\"\nlength_m = 10.0\nwidth_m = 4.0\n\
         thickness_m = 1.0\nmass_kg = {MASS}\n{more}\nbearings = {{ {bearings}, vertical_frequency_hz = {VERTICAL_HZ}, \
         vertical_damping_ratio = 0.0, at_m = [[4, 1.5], [4, -1.5], [-4, 1.5], [-4, -1.5]] }}\n"
    )))
}

#[test]
fn a_linear_bearing_that_pulls_is_told() {
    let (omega, speed) = (TAU * VERTICAL_HZ, 0.3);
    let history =
        deck("frequency_hz = 1.0, damping_ratio = 0.0", &format!("initial = {{ velocity_m_s = [0.0, 0.0, {speed}] }}"));
    // w = v/ω sin ωt; a quarter of m (g − ω² w) each.
    let load = |t: f64| 0.25 * MASS * (STANDARD_GRAVITY - omega * speed * (omega * t).sin());
    for t in [0.0, 0.013, 0.07, 0.21] {
        within("load", history.seats().bearing_load(0, 2, t) - load(t), 1e-3);
    }
    let all = &history.seats().upright(0).expect("in space").uplifts;
    assert_eq!(all.len(), 4, "{all:?}");
    for one in all {
        within("first", one.t - (STANDARD_GRAVITY / (omega * speed)).asin() / omega, 1e-8);
        within("pull", one.pull.value - 0.25 * MASS * (omega * speed - STANDARD_GRAVITY), 1.0);
        within("load at rest", one.load - 0.25 * MASS * STANDARD_GRAVITY, 1e-6);
    }
    let calm = deck("frequency_hz = 1.0, damping_ratio = 0.0", "initial = { velocity_m_s = [0.0, 0.0, 0.1] }");
    assert!(calm.seats().upright(0).expect("in space").uplifts.is_empty(), "it stays pressed");
}

#[test]
fn a_slider_that_lifts_pulls_nothing() {
    let slides = "kind = \"pendulum\", friction = 0.05, radius_m = 0.0";
    let history = deck(slides, "initial = { velocity_m_s = [0.0, 0.0, 0.3] }");
    let lifts = history.connections().link_phases(0).iter().find(|(_, phase)| phase.branch == 2).expect("it lifts").0;
    let all = &history.seats().upright(0).expect("in space").uplifts;
    assert_eq!(all.len(), 4, "{all:?}");
    for one in all {
        assert_eq!(one.pull.value, 0.0);
        within("first", one.t - lifts, 1e-8);
    }
    within("in the air", history.seats().bearing_load(0, 0, lifts + 0.02), 1e-6);
}

#[test]
fn a_deck_on_one_row_of_bearings_tips_and_does_not_stay_on_its_seats() {
    let history = run(&scene(
        "name = \"tips\"\nkind = \"spatial\"\nduration_s = 12.0\n[[girder]]\nname = \"deck\"\nlength_m = 10.0\nwidth_m = 4.0\n\
         thickness_m = 3.0\nmass_kg = 6e4\nseat_m = { \"+x\" = 4.0, \"-x\" = 4.0 }\ninitial = { roll_deg = 1.0 }\n\
         bearings = { frequency_hz = 1.0, damping_ratio = 0.0, vertical_frequency_hz = 10.0, at_m = [[4, 0], [-4, 0]] }\n",
    ));
    let (t, tilt) = history.seats().tipped(0).expect("it tips");
    assert!(t > 0.1 && tilt > 1.0, "{tilt} rad, beyond 10° from {t} s");
    let verdict = history.seats().verdict(0).expect("seats");
    assert!(!verdict.stays() && verdict.words().starts_with("tips over"), "{}", verdict.words());
    let upright = deck("frequency_hz = 1.0, damping_ratio = 0.0", "initial = { roll_deg = 1.0 }");
    within("as placed at most", upright.seats().upright(0).expect("in space").tilt.value - 1f64.to_radians(), 1e-3);
    assert_eq!(upright.seats().tipped(0), None);
}
