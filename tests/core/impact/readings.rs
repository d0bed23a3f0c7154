//! What a run of the impact model says of its forces: those of contacts that there are at one instant.

use girderbench::sim::History;
use girderbench::tables::{Report, TableOptions};

use crate::support::{run, scene};

/// Three girders between two walls, shaken at 15°: touches end and begin again at one instant.
fn joint() -> History {
    let bearings = "bearings = [{ at_m = [-0.08, -0.02], stiffness_n_per_m = [120, 130], damping_n_s_per_m = [2.5, 2] }, \
                    { at_m = [0.07, 0.03], stiffness_n_per_m = [150, 90], damping_n_s_per_m = [3, 1.5] }]";
    let girder = |name: &str, mass: f64, [x, y]: [f64; 2], [turn, spin]: [f64; 2]| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = {mass:?}\n\
             position_m = [{x:?}, {y:?}, 0.0]\n{bearings}\ninitial = {{ displacement_m = [0.001, 0.0005], \
             velocity_m_s = [0.05, -0.02], rotation_deg = {turn:?}, spin_deg_s = {spin:?} }}\n"
        )
    };
    let wall = |name: &str, faces: &str, end: &str| {
        format!("[[abutment]]\nname = \"{name}\"\nfaces = \"{faces}\"\nend = \"{end}\"\ngap_m = 0.003\nwidth_m = 2.0\n")
    };
    run(&scene(
        &[
            "name = \"joint\"\nduration_s = 1.5\nmodel = { kind = \"impact\" }\n\
             impact = { restitution_normal = 0.5, mu_static = 0.3, mu_kinetic = 0.2, flush = \"two-corner\" }\n\
             motion = { kind = \"sine\", amplitude_m_s2 = 4.0, frequency_hz = 2.4, phase_deg = 33.0, angle_deg = 15.0 }\n"
                .to_owned(),
            girder("c", 2.4, [0.3885, -0.001], [0.0, 0.0]),
            girder("b", 1.3, [0.194, 0.001], [0.1, -1.0]),
            girder("a", 2.0, [0.0, 0.0], [0.0, 1.0]),
            wall("e", "c", "+x"),
            wall("w", "a", "-x"),
        ]
        .concat(),
    ))
}

#[test]
fn forces_are_those_of_one_instant() {
    let history = joint();
    let all = history.hits().largest_resultants();
    assert!(all.len() == 4, "every joint is pressed: {all:?}");
    for (pair, most) in &all {
        let there = history.hits().resultant(*pair, most.t).length();
        assert!((most.value / there - 1.0).abs() < 1e-9, "pair {pair}: {} N of {there} N at {} s", most.value, most.t);
    }
    let numbers = history.summary();
    let at = numbers.peak_time.expect("contacts that last");
    let strongest = history.contacts().at(at).into_iter().map(|now| now.force.length()).fold(0.0, f64::max);
    assert!((numbers.peak_force / strongest - 1.0).abs() < 1e-9, "{} N, {strongest} N", numbers.peak_force);
    let hit = numbers.peak_impulse_time.expect("hits");
    assert!(
        history.hits().touches().iter().any(|touch| touch.start == hit && Some(touch.impulse) == numbers.peak_impulse)
    );
    let samples = (0..3000).map(|i| f64::from(i) * 5e-4);
    let seen = samples.flat_map(|t| history.contacts().at(t)).map(|now| now.force.length()).fold(0.0, f64::max);
    assert!(seen <= numbers.peak_force * (1.0 + 1e-9), "{seen} N is more than {} N", numbers.peak_force);
}

#[test]
fn the_ledger_is_held_to_a_bound_that_says_something() {
    let balance = joint().energy().balance();
    assert!(balance.holds() && balance.bound < 1e-6, "{balance:?}");
}

#[test]
fn the_restitution_of_a_pair_is_that_of_the_model() {
    let report = Report::of(&joint(), &TableOptions::default());
    assert!(report.pairs.iter().all(|pair| pair.restitution == [0.5; 2]), "{:?}", report.pairs);
}
