//! Decks that bend in space on bearings that yield, on piers, and with devices at their true points.

use crate::support::{run, scene, within};
use girderbench::scene::Scene;
use girderbench::sim::History;

/// A skewed deck on four bearings that yield, with a bumper before one end, a cable above the other and a damper at its side, shaken
/// in all directions.
fn held(elastic: &str) -> Scene {
    let bearings: Vec<String> = [[14.0, 4.0], [12.0, -4.0], [-12.0, 4.0], [-14.0, -4.0]]
        .into_iter()
        .map(|[x, y]| {
            format!(
                "{{ at_m = [{x:?}, {y:?}], stiffness_n_per_m = [2e6, 2e6, 1e9], damping_n_s_per_m = [1e5, 1e5, 1e6], \
                 yield_force_n = 2e5, yield_displacement_m = 0.01 }}"
            )
        })
        .collect();
    scene(&format!(
        "name = \"deck\"\nkind = \"spatial\"\nduration_s = 1.2\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
         mass_kg = 6e5\nskew_deg = 60.0\nbearings = [{}]\n{elastic}\n\
         [[bumper]]\nname = \"rubber\"\ngirder = \"deck\"\nat_m = [15.0, 0.0, 0.4]\nto_m = [15.5, 0.0, 0.4]\ngap_m = 0.03\n\
         stiffness_n_per_m = 4e7\ndamping_n_s_per_m = 1e5\n\
         [[restrainer]]\nname = \"cable\"\ngirder = \"deck\"\nat_m = [-15.0, 0.0, 0.7]\nto_m = [-16.0, 1.0, 1.2]\nslack_m = 0.002\n\
         stiffness_n_per_m = 3e7\nyield_force_n = 4e5\npost_yield_stiffness_n_per_m = 1e6\n\
         [[damper]]\nname = \"damper\"\ngirder = \"deck\"\nat_m = [0.0, 5.0, 0.0]\nto_m = [2.0, 8.0, -1.0]\ncoefficient = 5e5\n\
         [motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 2.0\nangle_deg = 30\nvertical_amplitude_g = 0.15\n\
         [solver]\ntolerance = 1e-10\n",
        bearings.join(", ")
    ))
}

/// Largest difference of displacement \[m\] and rotation times half the length of the deck in two runs.
fn apart(one: &History, other: &History) -> f64 {
    let end = one.end().min(other.end());
    (0..=200)
        .map(|i| {
            let t = end * f64::from(i) / 200.0;
            let (a, b) = (one.motion(0, t), other.motion(0, t));
            (a.displacement - b.displacement).length() + 15.0 * (a.theta - b.theta).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn a_stiff_deck_with_devices_in_space_moves_as_the_rigid_one_with_an_error_of_1_over_e() {
    let short = |elastic: &str| {
        let mut scene = held(elastic);
        scene.duration = 0.4;
        run(&scene)
    };
    let rigid = short("");
    let off = |young: f64| {
        let elastic = format!("elastic = {{ area_m2 = 8.0, modes = 2, tol_flex = 0.0, young_modulus_pa = {young:?} }}");
        apart(&short(&elastic), &rigid)
    };
    let [soft, stiff] = [1e12, 1e13].map(off);
    assert!(stiff > 0.0 && stiff < 1e-4, "{stiff} m");
    within("slope", (soft / stiff).log10() - 1.0, 0.1);
}

#[test]
fn the_ledger_of_a_deck_with_devices_that_bends_in_space_closes() {
    let history = run(&held("elastic = { area_m2 = 8.0, modes = 5 }"));
    for name in ["deck.bearing1", "rubber", "cable"] {
        let number = history.model().links.iter().position(|link| link.name == name).expect("a link");
        assert!(history.connections().link_phases(number).len() > 2, "{name} acts");
    }
    let ledger = history.energy().ledger(history.end());
    within("residual in parts of the largest energy", ledger.residual.abs() / ledger.scale, 1e-9);
    assert!(ledger.loss_device > 1e4 && ledger.loss_girder > 0.0, "{ledger:?}");
    let cable = history.model().links.iter().position(|link| link.name == "cable").expect("a link");
    let pulls = (1..600).map(|i| 0.002 * f64::from(i));
    let t = pulls.max_by(|a, b| {
        let of = |t: f64| history.connections().link(cable, t).map_or(0.0, |now| now.force.length());
        of(*a).total_cmp(&of(*b))
    });
    let t = t.expect("times");
    let force = history.motion(0, t).attitude.inverse() * history.connections().link(cable, t).expect("it").force;
    let after = history.sections().forces(0, -15.0, t);
    assert!(force.length() > 1e5, "{force}");
    // Just inside of the −x end stands what acts there; a pull above the axis bends the deck.
    within("N at the end", (after.axial + force.x) / force.length(), 1e-3);
    within("Q_z at the end", (after.vertical_shear + force.z) / force.length(), 1e-3);
    within("M_y at the end", (after.vertical_moment + 0.7 * force.x) / force.length(), 5e-3);
}

/// A deck on the ground at its −x end and on a pier that sways at the other, before an abutment; bearings at the height of G.
fn on_pier(kind: &str, skew: f64, elastic: &str) -> Scene {
    let bearings: Vec<String> = [[14.0, 4.0], [14.0, -4.0], [-14.0, 4.0], [-14.0, -4.0]]
        .into_iter()
        .map(|[x, y]| {
            let (third, height) = if kind == "spatial" { (", 1e9", "height_m = 0.0, ") } else { ("", "") };
            let (dashpot, on) =
                (if third.is_empty() { "" } else { ", 1e6" }, if x > 0.0 { ", on = \"p\"" } else { "" });
            format!(
                "{{ at_m = [{x:?}, {y:?}], {height}stiffness_n_per_m = [4e6, 4e6{third}], \
                 damping_n_s_per_m = [2e5, 2e5{dashpot}]{on} }}"
            )
        })
        .collect();
    let weightless = if kind == "spatial" { "gravity_m_s2 = 0.0\n" } else { "" };
    scene(&format!(
        "name = \"deck\"\nkind = \"{kind}\"\n{weightless}duration_s = 2.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\n\
         thickness_m = 1.5\nmass_kg = 6e5\nskew_deg = {skew:?}\nbearings = [{}]\n{elastic}\n\
         [[pier]]\nname = \"p\"\nmass_kg = 1e5\nstiffness_n_per_m = [2e8, 2e8]\ndamping_ratio = 0.05\n\
         [[abutment]]\nname = \"east\"\nfaces = \"deck\"\nend = \"+x\"\ngap_m = 0.03\nwidth_m = 24.0\nheight_m = 4.5\n\
         [contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 0.6\nmu_static = 0.2\nmu_kinetic = 0.15\n\
         [motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 1.2\n[solver]\ntolerance = 1e-11\n",
        bearings.join(", ")
    ))
}

const CONCRETE: &str = "elastic = { area_m2 = 8.0, modes = 6 }";

#[test]
fn a_deck_on_a_pier_moves_in_space_as_in_plan_where_all_is_level() {
    let [plan, space] = ["planar", "spatial"].map(|kind| run(&on_pier(kind, 90.0, CONCRETE)));
    assert!(
        plan.hits().count() > 0 && plan.hits().count() == space.hits().count(),
        "{} and {} hits",
        plan.hits().count(),
        space.hits().count()
    );
    let (mut places, mut bent) = ([0.0f64; 2], 0.0f64);
    for i in 0..=400 {
        let t = plan.end() * f64::from(i) / 400.0;
        for (body, apart) in places.iter_mut().enumerate() {
            let [a, b] = [&plan, &space].map(|history| history.motion(body, t).displacement);
            *apart = apart.max((a - b).truncate().length());
        }
        let [a, b] = [&plan, &space].map(|history| history.sections().deformation(0, 15.0, t));
        bent = bent.max((a.moved.truncate() - b.moved.truncate()).length());
    }
    let most = |body: usize| {
        (0..=400).map(|i| plan.motion(body, 0.005 * f64::from(i)).displacement.length()).fold(0.0, f64::max)
    };
    assert!(most(0) > 0.03 && most(1) > 1e-3, "deck and pier move by {} and {} m", most(0), most(1));
    within("deck [m]", places[0], 1e-9);
    within("pier [m]", places[1], 1e-9);
    within("deformation of the end [m]", bent, 1e-9);
}

#[test]
fn a_stiff_deck_on_a_pier_in_space_moves_as_the_rigid_one_with_an_error_of_1_over_e() {
    let short = |elastic: &str| {
        let mut scene = on_pier("spatial", 60.0, elastic);
        scene.duration = 1.2;
        run(&scene)
    };
    let rigid = short("");
    assert!(rigid.hits().count() > 0, "it hits");
    let off = |young: f64| {
        let elastic = format!("elastic = {{ area_m2 = 8.0, modes = 2, tol_flex = 0.0, young_modulus_pa = {young:?} }}");
        apart(&short(&elastic), &rigid)
    };
    let [soft, stiff] = [1e12, 1e13].map(off);
    assert!(stiff > 0.0 && stiff < 1e-3, "{stiff} m");
    within("slope", (soft / stiff).log10() - 1.0, 0.1);
}

#[test]
fn the_ledger_of_a_deck_that_bends_on_a_pier_in_space_closes() {
    let history = run(&on_pier("spatial", 60.0, CONCRETE));
    assert!(history.hits().count() > 0, "it hits");
    let ledger = history.energy().ledger(history.end());
    within("residual in parts of the largest energy", ledger.residual.abs() / ledger.scale, 1e-9);
    assert!(ledger.loss_girder > 0.0 && ledger.loss_normal > 0.0 && ledger.loss_friction > 0.0, "{ledger:?}");
}
