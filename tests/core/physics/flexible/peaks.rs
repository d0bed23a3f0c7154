//! Largest section forces and stress, against looks so dense that no wave runs between them; the check of the degree girder by girder.

use crate::support::{scene, within};
use girderbench::sim::History;

/// A deck without damping in its modes that bearings release at once: it rings for the whole run, and its moment is largest in a flight.
const RELEASED: &str = "name = \"released\"\nkind = \"planar\"\nduration_s = 0.5\n\
    [[girder]]\nname = \"deck\"\nlength_m = 24.0\nwidth_m = 9.0\nthickness_m = 1.2\nskew_deg = 70\nmass_kg = 4e5\n\
    elastic = { young_modulus_pa = 1.5e10, area_m2 = 9.0, modes = 7, damping_ratio = 0.0 }\n\
    initial = { velocity_m_s = [-0.2, 0.34] }\n\
    bearings = [{ at_m = [10.0, 2.0], stiffness_n_per_m = [4e7, 9e7], damping_n_s_per_m = [1e5, 1e5] }, \
    { at_m = [-11.0, -3.0], stiffness_n_per_m = [9e6, 2e8], damping_n_s_per_m = [1e6, 5e6] }]\n";

fn looked_at_densely(history: &History, until: f64) -> [f64; 3] {
    let half = 12.0;
    let mut most = [0.0f64; 3];
    for i in 0..=20_000 {
        let t = until * f64::from(i) / 20_000.0;
        let equilibrium = history.sections().equilibrium(0, t).expect("it bends");
        let middle = equilibrium.at(0.0);
        let stress =
            (-20..=20).map(|k| history.sections().stress(0, half * f64::from(k) / 20.0, t)).fold(0.0, f64::max);
        most = [most[0].max(middle.axial.abs()), most[1].max(middle.moment.abs()), most[2].max(stress)];
    }
    most
}

#[test]
fn no_peak_of_a_flight_is_larger_than_what_is_told() {
    for ground in [
        "",
        "[motion]\nkind = \"sine\"\namplitude_m_s2 = 2.0\nfrequency_hz = 2.0\nangle_deg = 30.0\n",
        "[motion]\nkind = \"record\"\ndt_s = 0.02\nsamples_m_s2 = [0.0, 1.5, -2.0, 0.7, 3.0, -1.0, 0.4, 0.0]\n",
    ] {
        let history = History::of(&scene(&format!("{RELEASED}{ground}"))).expect("runs");
        assert_eq!(history.effort().steps, 0, "flights alone");
        let reading = &history.sections().readings()[0];
        let dense = looked_at_densely(&history, history.end());
        let told = [reading.axial, reading.moment, reading.stress].map(|most| most.value);
        for (what, (told, dense)) in ["N", "M", "stress"].into_iter().zip(told.into_iter().zip(dense)) {
            assert!(told > dense * (1.0 - 1e-5), "{what} to {told}, seen {dense}, {ground}");
            assert!(told < dense * (1.0 + 5e-3), "{what} to {told}, seen {dense}, {ground}");
        }
    }
}

#[test]
fn a_push_at_mid_span_is_told_by_the_side_that_has_more() {
    // Held at one end and pushed in the middle: N is the whole of the push on one side and nothing on the other, once at rest.
    let of = |heading: f64| {
        let text = format!(
            "name = \"pushed\"\nkind = \"planar\"\nduration_s = 5.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\n\
             width_m = 10.0\nthickness_m = 1.5\nmass_kg = 6e5\nheading_deg = {heading}\n\
             bearings = [{{ at_m = [-14.0, 3.0], stiffness_n_per_m = [1e8, 1e8], damping_n_s_per_m = [5e6, 5e6] }}, \
             {{ at_m = [-14.0, -3.0], stiffness_n_per_m = [1e8, 1e8], damping_n_s_per_m = [5e6, 5e6] }}]\n\
             push = {{ force_n = [{}, 0.0] }}\nelastic = {{ area_m2 = 8.0, damping_ratio = 0.02 }}\n",
            if heading == 0.0 { 1e6 } else { -1e6 }
        );
        History::of(&scene(&text)).expect("runs").sections().readings()[0].axial.value
    };
    let [one, turned] = [0.0, 180.0].map(of);
    assert!(one > 1e6, "more than the push while it swings: {one}");
    within("turned round with its push", turned / one - 1.0, 1e-9);
}

#[test]
fn the_degree_of_a_small_girder_is_checked_beside_a_large_one() {
    let girder = |name: &str, y: f64, mass: f64, more: &str| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 30.0\nwidth_m = 3.0\nthickness_m = 1.5\nmass_kg = {mass}\n\
             position_m = [0.0, {y}, 0.0]\ninitial = {{ velocity_m_s = [0.5, 0.0] }}\nelastic = {{ {more} }}\n\
             [[abutment]]\nname = \"{name}-wall\"\nfaces = \"{name}\"\ngap_m = 0.01\n"
        )
    };
    let small = girder("small", 40.0, 6e4, "area_m2 = 0.8, modes = 2");
    let of = |girders: &str| {
        format!("name = \"a\"\nkind = \"planar\"\nduration_s = 0.1\n{girders}[contact]\nstiffness_n_per_m = 1e9\n")
    };
    let alone = of(&small);
    let both = of(&format!("{}{small}", girder("big", 0.0, 6e5, "area_m2 = 8.0, modes = 8")));
    let check = |text: &str| History::of(&scene(text)).expect("runs").sections().check_degree().expect("it bends");
    let (alone, both) = (check(&alone), check(&both));
    assert!(alone.section > 1e-2, "two polynomials are too few: {alone:?}");
    for (what, one, two) in [
        ("force", alone.force, both.force),
        ("impulse", alone.impulse, both.impulse),
        ("ends", alone.ends, both.ends),
        ("N", alone.section, both.section),
    ] {
        assert!(two >= one * (1.0 - 1e-9), "{what}: {one} alone, {two} beside a large one");
    }
}

#[test]
fn rounding_of_a_girder_that_only_sways_is_no_force_to_be_compared() {
    // Askew in the world: along its axis there is rounding alone.
    let corners = [[10.0, 2.0], [10.0, -2.0], [-10.0, 2.0], [-10.0, -2.0]];
    let bearing = |[x, y]: [f64; 2]| {
        format!("{{ at_m = [{x}, {y}], stiffness_n_per_m = [3e7, 9e7], damping_n_s_per_m = [0.0, 0.0] }}")
    };
    let text = format!(
        "name = \"sways\"\nkind = \"planar\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 24.0\nwidth_m = 9.0\n\
         thickness_m = 1.2\nmass_kg = 4e5\nheading_deg = 30\n\
         elastic = {{ young_modulus_pa = 1.5e10, area_m2 = 9.0, modes = 9, damping_ratio = 0.0 }}\n\
         initial = {{ velocity_m_s = [-0.17, {}] }}\nbearings = [{}]\n",
        0.17 * 3f64.sqrt(),
        corners.map(bearing).join(", ")
    );
    let history = History::of(&scene(&text)).expect("runs");
    let reading = &history.sections().readings()[0];
    assert!(reading.axial.value < 1e-9 * reading.moment.value, "{reading:?}");
    let check = history.sections().check_degree().expect("it bends");
    assert!(check.section < 1e-4 && check.moments > 1e-6, "{check:?}");
}
