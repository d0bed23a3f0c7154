//! A corner that hits the side of a girder that bends: in plan, and in space held flat.

use crate::support::{scene, within};
use girderbench::sim::History;
use glam::DVec3;

/// A span of 30 m at rest but turning, and one of 12 m that comes at its side with a corner; `kind` is plan or space,
/// `mu` the coefficient of friction.
fn hit(kind: &str, mu: f64) -> History {
    let girder = |name: &str, size: &str, place: &str| {
        let held = if kind == "spatial" { "held = [\"z\", \"roll\", \"pitch\"]" } else { "" };
        format!(
            "[[girder]]\nname = \"{name}\"\nthickness_m = 1.5\n{size}\n{place}\n{held}\n[girder.elastic]\n\
             young_modulus_pa = 3e10\ndensity_kg_m3 = 2400\nmodes = 4\n"
        )
    };
    let gravity = if kind == "spatial" { "gravity_m_s2 = 0.0" } else { "" };
    let text = format!(
        "name = \"side\"\nkind = \"{kind}\"\nduration_s = 0.12\n{gravity}\n{}{}[contact]\nstiffness_n_per_m = 2e9\n\
         restitution_normal = 0.5\nmu_static = {mu}\nmu_kinetic = {mu}\n[solver]\ntolerance = 1e-8\n",
        girder(
            "long",
            "length_m = 30.0\nwidth_m = 8.0\nskew_deg = 70\nmass_kg = 4e5",
            "position_m = [0.0, 0.0, 0.0]\ninitial = { spin_deg_s = 2.0 }",
        ),
        girder(
            "short",
            "length_m = 12.0\nwidth_m = 4.0\nskew_deg = 80\nmass_kg = 2e5",
            "position_m = [4.0, 10.65, 0.0]\nheading_deg = 80\n\
             initial = { velocity_m_s = [0.3, -0.5], spin_deg_s = -5.0 }",
        ),
    );
    History::of(&scene(&text)).expect("runs")
}

#[test]
fn momentum_energy_and_section_forces_balance_and_the_side_load_is_told() {
    // What acts along a face acts at the node and before it, a penetration apart: a couple. Friction is left out here, and the
    // tangential dashpot has 80 N at the most.
    let history = hit("planar", 0.0);
    assert!(history.energy().balance().holds(), "{:?}", history.energy().balance());
    assert_eq!(history.overlaps(), []);
    let touch = *history.hits().touches().first().expect("a hit");
    assert!(touch.peak_force > 1e6 && touch.end < history.end(), "{touch:?}");
    let momentum = |t: f64| {
        let of = |girder: usize| {
            let (body, here) = (&history.model().bodies[girder], history.motion(girder, t));
            let spin = body.gyration2 * here.spin.z + here.place.cross(here.velocity).z;
            body.mass * here.velocity.with_z(spin)
        };
        of(0) + of(1)
    };
    let lost = momentum(0.0) - momentum(history.end());
    within("momentum [N·s, N·m·s]", lost.abs().max_element(), 1e-7 * momentum(0.0).length());
    // Both ends carry the load: what is beyond the one less what is beyond the other.
    let equilibrium = history.sections().equilibrium(0, touch.peak_time).expect("it bends");
    let [minus, plus] = [-15.0, 15.0].map(|end| equilibrium.at(end));
    assert!(minus.shear.abs().min(plus.shear.abs()) > 0.2 * touch.peak_force, "{minus:?} {plus:?}");
    let carried = (plus.axial - minus.axial).hypot(plus.shear - minus.shear);
    within("both ends together [N]", carried - touch.peak_force, 1e-9 * touch.peak_force);
    let [long, short] = [0, 1].map(|n| history.sections().readings()[n].neglected.side_load);
    assert!((0.3..0.5).contains(&long), "far from both ends: {long} of the length");
    within("of the girder whose corner hits", short, 0.0);
}

#[test]
fn held_flat_in_space_the_answer_is_that_in_plan() {
    let [plan, space] = ["planar", "spatial"].map(|kind| hit(kind, 0.5));
    for girder in [0, 1] {
        let [a, b] = [&plan, &space].map(|history| history.motion(girder, history.end()));
        within("place [m]", (a.displacement - b.displacement).abs().dot(DVec3::ONE), 1e-9);
        within("rotation [rad]", a.theta - b.theta, 1e-10);
    }
}
