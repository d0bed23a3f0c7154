//! Long runs: what each step loses does not add up, and what a step meets at its end does not stop it.

use crate::support::{run, within};
use girderbench::scene::{Scene, format, overrides, presets};
use girderbench::sim::History;
use girderbench::study::stability::family;

/// The ledger's residual at the end, in parts of the largest energy in play.
fn left_over(history: &History) -> f64 {
    let at = |i: u32| history.energy().ledger(history.end() * f64::from(i) / 20.0);
    let scale = (1..=20).map(|i| at(i).scale).fold(0.0, f64::max);
    at(20).residual / scale
}

fn seed(number: u64) -> Scene {
    family::scene(number).1
}

/// A frictionless girder between two elastic walls, head-on.
fn bounce(tolerance: f64) -> History {
    let text = format!(
        "name = \"bounce\"\nkind = \"planar\"\nduration_s = 20.0\n[[girder]]\nname = \"deck\"\nlength_m = 0.19\nwidth_m = 0.07\n\
         thickness_m = 0.02\nmass_kg = 2.0\ninitial = {{ velocity_m_s = [0.5, 0.0] }}\n\
         [[abutment]]\nname = \"east\"\nfaces = \"deck\"\ngap_m = 0.005\n\
         [[abutment]]\nname = \"west\"\nfaces = \"deck\"\nend = \"-x\"\ngap_m = 0.005\n\
         [contact]\nstiffness_n_per_m = 1.55e5\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\nmu_static = 0.0\n\
         mu_kinetic = 0.0\n[solver]\ntolerance = {tolerance:e}\n"
    );
    run(&format::parse(&text, "bounce").unwrap_or_else(|errors| panic!("{errors}")))
}

#[test]
fn a_touch_ends_as_exactly_as_its_steps() {
    // What starts from within a step's continuous answer, an order less exact, comes to 3.6e-8 at a tolerance of 1e-9.
    for tolerance in [1e-9, 1e-11] {
        let history = bounce(tolerance);
        let touches = history.hits().touches().len() as f64;
        assert!(touches > 500.0, "it bounces: {touches}");
        let speed = history.motion(0, history.end()).velocity.length();
        within(&format!("{touches} touches at {tolerance:e}"), speed / 0.5 - 1.0, 0.012 * tolerance * touches);
    }
}

#[test]
fn two_thousand_elastic_corners_lose_no_more_than_their_places_round() {
    let history = run(&seed(8076));
    assert!(history.hits().touches().len() > 1500, "corners of two walls: {}", history.hits().touches().len());
    within("seed 8076", left_over(&history), 5e-9);
}

#[test]
fn ten_thousand_steps_of_a_swinging_girder_lose_less_than_a_hundred_tolerances() {
    let scene = seed(7375);
    let history = run(&scene);
    assert!(history.effort().steps > 10_000, "{} steps", history.effort().steps);
    within("seed 7375", left_over(&history), 100.0 * scene.solver.tolerance);
}

#[test]
fn a_slip_that_turns_to_its_very_end_is_followed() {
    let mut scene = seed(3329);
    scene.solver.tolerance = 1e-13;
    let history = run(&scene);
    assert!(history.stop().is_none(), "{:?}", history.stop());
    assert!(history.events().len() > 500, "it touches: {} events", history.events().len());
}

#[test]
fn a_run_that_would_never_end_says_so_soon() {
    let scene = presets::load("deck-30m").expect("a preset");
    let scene = overrides::apply(&scene, "girder.deck.bearings.damping_ratio=1e12").expect("a scene");
    let history = History::of(&scene).expect("it runs");
    let stop = history.stop().expect("it gives up");
    assert!(stop.t < 1e-3 && stop.place == "deck", "at once, and names the girder: {stop:?}");
    for words in ["at this pace", "lower its stiffness, damping or frequency"] {
        assert!(stop.reason.to_string().contains(words), "{words} in {}", stop.reason);
    }
    assert!(history.effort().steps < 1_000_000, "far from the bound on the work: {:?}", history.effort());
}
