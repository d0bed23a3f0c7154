//! The energy ledger balances.

use crate::support::{run, scene, within};
use girderbench::scene::{FrictionLaw, Kind, Motion, presets};

#[test]
fn every_preset_balances_its_ledger() {
    for preset in presets::all() {
        let mut scene = presets::load(preset.name).unwrap_or_else(|errors| panic!("{errors}"));
        scene.solver.tolerance = 1e-12;
        let history = run(&scene);
        for part in [0.25, 0.5, 1.0] {
            let ledger = history.energy().ledger(history.end() * part);
            within(&format!("{} at {part}", preset.name), ledger.residual / ledger.scale, 5e-13);
        }
    }
}

#[test]
fn both_laws_book_every_jump_of_the_anchor() {
    for law in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
        let mut scene = presets::load("skew60-abutment").unwrap_or_else(|errors| panic!("{errors}"));
        scene.solver.tolerance = 1e-12;
        scene.contact.law = law;
        let Motion::Sine(sine) = &mut scene.motion else { panic!("it shakes by a sine") };
        sine.angle_deg = -30.0;
        let history = run(&scene);
        let ledger = history.energy().ledger(history.end());
        assert!(ledger.jump_slip > 0.0, "{law:?}: breakaway releases energy");
        assert!(ledger.loss_friction > 0.0 && ledger.loss_normal > 0.0, "{law:?}: contacts dissipate");
        within(&format!("{law:?}"), ledger.residual / ledger.scale, 5e-13);
    }
}

#[test]
fn the_residual_falls_with_the_tolerance() {
    let mut scene = presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"));
    let mut residuals = Vec::new();
    for tolerance in [1e-6, 1e-9, 1e-12] {
        scene.solver.tolerance = tolerance;
        let history = run(&scene);
        let ledger = history.energy().ledger(history.end());
        residuals.push(ledger.residual.abs() / ledger.scale);
    }
    assert!(residuals[0] > 10.0 * residuals[1] && residuals[1] > 10.0 * residuals[2], "{residuals:?}");
}

#[test]
fn a_spatial_deck_is_placed_in_equilibrium() {
    let mut scene = presets::load("deck-30m").unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(scene.kind, Kind::Spatial, "the deck is spatial");
    scene.motion = Motion::None;
    scene.duration = 2.0;
    let history = run(&scene);
    // Rounding of a weight of 6 MN over a stiffness of 2e9 N/m is 1e-19 m a step.
    within("it stays where it was placed", history.motion(0, 2.0).displacement.length(), 1e-15);
}

#[test]
fn dashpots_alone_are_booked_over_a_long_flight() {
    let mut scene = presets::load("flush-free-hit").unwrap_or_else(|errors| panic!("{errors}"));
    scene.abutments.clear();
    scene.duration = 10.0;
    let each = girderbench::scene::Bearing::linear([0.0, 0.0], [0.0; 3], [100.0, 100.0, 0.0]);
    scene.girders[0].bearings = Some(girderbench::scene::Bearings::Each(vec![each]));
    let ledger = run(&scene).energy().ledger(10.0);
    within("all of its energy is lost in the dashpots", ledger.loss_bearing / 0.25 - 1.0, 1e-11);
}

#[test]
fn a_girder_that_the_ground_leaves_at_rest_balances_against_what_moved() {
    // Eight whole periods of a free girder: nothing is stored, lost or worked at the end, and all was kinetic before.
    let text = "name = \"free\"\nduration_s = 10.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
                mass_kg = 6e5\n[motion]\nkind = \"sine\"\namplitude_m_s2 = 2.0\nfrequency_hz = 0.8\n";
    let history = run(&scene(text));
    let largest = 0.5 * 6e5 * (2.0 * 2.0 / (std::f64::consts::TAU * 0.8)).powi(2);
    let ledger = history.energy().ledger(history.end());
    assert!(ledger.kinetic < 1e-6 * largest, "at rest: {}", ledger.kinetic);
    assert!(ledger.scale > 0.5 * largest && ledger.scale <= largest * (1.0 + 1e-9), "{} of {largest}", ledger.scale);
    assert!(history.energy().balance().holds(), "{:?}", history.energy().balance());
}

#[test]
fn the_bound_of_the_ledger_knows_the_depth_of_a_hit_whose_dashpot_is_largest_at_closing() {
    let history = run(&scene(
        "name = \"soft\"\nkind = \"planar\"\nduration_s = 0.5\n[[girder]]\nname = \"deck\"\nlength_m = 10.0\nwidth_m = 4.0\n\
         thickness_m = 1.0\nmass_kg = 6e4\ninitial = { velocity_m_s = [1.0, 0.0] }\n[[abutment]]\nname = \"wall\"\nfaces = \"deck\"\n\
         gap_m = 0.1\n[contact]\nstiffness_n_per_m = 1e9\nrestitution_normal = 0.02\n",
    ));
    let hit = history.hits().touches()[0];
    assert!(hit.peak_time < hit.start + 1e-3 * (hit.end - hit.start), "the largest force is where it begins: {hit:?}");
    let balance = history.energy().balance();
    assert!(balance.holds() && balance.bound < 1e-6, "{balance:?}");
}
