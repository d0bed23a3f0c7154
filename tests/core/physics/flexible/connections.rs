//! Bars and decks that bend on bearings that yield, on piers, and with devices.

use super::closed_forms::st_venant;
use super::{Bar, bars};
use crate::support::{run, scene, within};
use girderbench::scene::{Degree, Device, STANDARD_GRAVITY, Scene, format};
use girderbench::sim::History;

/// A deck of 30 m and 60° that bends, or not, on four bearings, two of them at each end, with these lines after it.
fn deck(elastic: &str, bearing: &dyn Fn(f64) -> String, more: &str) -> Scene {
    let bearings: Vec<String> = [[14.0, 4.0], [12.0, -4.0], [-12.0, 4.0], [-14.0, -4.0]]
        .into_iter()
        .map(|[x, y]| format!("{{ at_m = [{x:?}, {y:?}], {} }}", bearing(x)))
        .collect();
    scene(&format!(
        "name = \"deck\"\nduration_s = 2.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
         mass_kg = 6e5\nskew_deg = 60.0\nbearings = [{}]\n{elastic}\n{more}\n\
         [motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 2.0\nangle_deg = 30\n[solver]\ntolerance = 1e-11\n",
        bearings.join(", ")
    ))
}

const CONCRETE: &str = "elastic = { area_m2 = 8.0, modes = 6 }";
const LINEAR: &str = "stiffness_n_per_m = [2e7, 3e7], damping_n_s_per_m = [4e5, 4e5]";
const YIELDING: &str = "stiffness_n_per_m = [2e6, 2e6], damping_n_s_per_m = [1e5, 1e5], yield_force_n = 2e5, \
                        yield_displacement_m = 0.01";

/// Largest difference of displacement \[m\] and rotation times half the length of a girder in two runs.
fn apart(one: &History, other: &History, girder: usize) -> f64 {
    let end = one.end().min(other.end());
    (0..=200)
        .map(|i| {
            let t = end * f64::from(i) / 200.0;
            let (a, b) = (one.motion(girder, t), other.motion(girder, t));
            (a.displacement - b.displacement).length() + 15.0 * (a.theta - b.theta).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn bearings_that_do_not_yield_yet_are_linear_ones() {
    let linear = run(&deck(CONCRETE, &|_| LINEAR.to_owned(), ""));
    // A tenth of the stiffness beside a part that yields far away.
    let part = |_| {
        "stiffness_n_per_m = [2e6, 3e6], damping_n_s_per_m = [4e5, 4e5], yield_force_n = 1.8e12, yield_displacement_m = 1e5"
            .to_owned()
    };
    let same = |_| "stiffness_n_per_m = [20e6, 21e6], damping_n_s_per_m = [4e5, 4e5]".to_owned();
    let stepped = run(&deck(CONCRETE, &part, ""));
    let wanted = run(&deck(CONCRETE, &same, ""));
    assert_eq!((wanted.effort().steps, stepped.effort().steps > 0), (0, true), "a flight, and steps");
    within("in steps and in flight", apart(&stepped, &wanted, 0), 1e-9);
    assert!(apart(&linear, &wanted, 0) > 1e-3, "stiffness does matter");
}

#[test]
fn modes_that_decay_at_once_cost_no_steps_of_their_own() {
    // Two seconds in steps of five time constants of what decays at 1e7 1/s would be 4e6 steps.
    let damped =
        "elastic = { area_m2 = 8.0, modes = 6, shear_factor = \"none\", rayleigh = { mass = 0.3, stiffness = 4e-4 } }";
    let bearings = |[x, y]: [f64; 2], more: &str| {
        format!("stiffness_n_per_m = [{x:?}, {y:?}], damping_n_s_per_m = [4e5, 4e5]{more}")
    };
    // A part of 1.8e7 N/m that yields far away has no closed form.
    let part = |_| bearings([2e6, 3e6], ", yield_force_n = 1.8e12, yield_displacement_m = 1e5");
    let stepped = run(&deck(damped, &part, ""));
    let wanted = run(&deck(damped, &|_| bearings([20e6, 21e6], ""), ""));
    let made = stepped.sections().flexible(0).and_then(|flexible| flexible.girder.clone()).expect("it bends");
    let fastest = made.frequencies().into_iter().map(|omega| made.damping().dashpot(omega)).fold(0.0, f64::max);
    assert!(fastest > 1e7, "decays at {fastest} 1/s");
    assert!((1..5000).contains(&stepped.effort().steps), "{} steps", stepped.effort().steps);
    within("in steps and in flight", apart(&stepped, &wanted, 0), 1e-9);
}

#[test]
fn a_deck_that_one_bearing_leaves_free_to_turn_turns_as_in_steps() {
    // The turning has no spring: of the springs' matrix, coupled with the modes, rounding is left.
    let on = |bearing: &str, more: &str| {
        run(&scene(&format!(
            "name = \"deck\"\nduration_s = 2.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
             mass_kg = 6e5\nskew_deg = 110.0\nelastic = {{ area_m2 = 8.0, modes = 11 }}\ninitial = {{ velocity_m_s = [0.1, -0.07] }}\n\
             bearings = [{{ at_m = [-4.9, 0.0], damping_n_s_per_m = [0, 0], {bearing} }}{more}]\n"
        )))
    };
    // In steps: a part that yields far away.
    let wanted = on("stiffness_n_per_m = [1e6, 1e6], yield_force_n = 9e11, yield_displacement_m = 1e5", "");
    assert!(wanted.effort().steps > 0 && wanted.motion(0, 2.0).theta.abs() > 1e-3, "it turns, in steps");
    for spring in [0.0, 1e-6, 1e-3] {
        let second = format!(
            ", {{ at_m = [3.0, 0.0], damping_n_s_per_m = [0, 0], stiffness_n_per_m = [{spring:?}, {spring:?}] }}"
        );
        let more = if spring > 0.0 { second.as_str() } else { "" };
        let history = on("stiffness_n_per_m = [1e7, 1e7]", more);
        within(&format!("beside {spring} N/m"), apart(&history, &wanted, 0), 1e-8);
    }
}

#[test]
fn bearings_on_a_pier_that_hardly_moves_are_on_the_ground() {
    let ground = run(&deck(CONCRETE, &|_| LINEAR.to_owned(), ""));
    let on_pier = |x: f64| if x < 0.0 { format!("{LINEAR}, on = \"p\"") } else { LINEAR.to_owned() };
    let off = |stiffness: f64| {
        let pier = format!(
            "[[pier]]\nname = \"p\"\nmass_kg = 1e5\nstiffness_n_per_m = [{stiffness:?}, {stiffness:?}]\ndamping_ratio = 0.05\n"
        );
        apart(&run(&deck(CONCRETE, &on_pier, &pier)), &ground, 0)
    };
    let [soft, stiff] = [1e11, 1e12].map(off);
    assert!(stiff > 0.0 && stiff < 1e-4, "{stiff} m");
    within("ten times stiffer, ten times nearer", soft / stiff - 10.0, 0.2);
}

#[test]
fn a_cable_between_two_bars_pulls_as_st_venant_says() {
    let still = bars(&[Bar::DECK; 2], 8e9, 0.0, 0.2);
    let cable = "[[restrainer]]\nname = \"cable\"\ngirder = \"a\"\nto = \"b\"\nat_m = [15.0, 0.0]\nto_m = [-15.0, 0.0]\n\
                 slack_m = 0.001\nstiffness_n_per_m = 8e9\n";
    let mut scene = scene(&format!("{}{cable}", format::write(&still)));
    scene.girders[1].initial.velocity[0] = 0.5;
    for elastic in scene.girders.iter_mut().filter_map(|girder| girder.elastic.as_mut()) {
        elastic.modes = Degree(Some(40.0));
    }
    let history = run(&scene);
    let [back, z] = [Bar::DECK.there_and_back(), Bar::DECK.impedance()];
    let (a, taut, largest) = (4.0 / back, 0.001 / 0.5, 0.25 * z);
    let worst = (1..400).map(|i| {
        let t = 1.418_217 * back * f64::from(i) / 400.0;
        let pull = history.connections().link(0, taut + t).expect("the cable").force;
        (pull.x / largest - st_venant(a, back, t)).abs()
    });
    within("pull", worst.fold(0.0, f64::max), 3e-4);
    let speed = |t: f64| history.motion(1, t).velocity.x - history.motion(0, t).velocity.x;
    within("e", -speed(taut + 1.43 * back) / 0.5 - 0.975_858_5, 1e-4);
}

/// Moment over the middle support of a beam on three springs of stiffness k under an even load q: that of rigid ones less what the
/// springs give, by the force method.
fn moment_over_a_support([one, two]: [f64; 2], bending: f64, k: f64, q: f64) -> f64 {
    let length = one + two;
    // Deflection at the support of the beam on the outer two under q, and under a unit force there; springs at the ends beside.
    let of_load =
        q * two * (length.powi(3) - 2.0 * length * two * two + two.powi(3)) / (24.0 * bending) + q * length / (2.0 * k);
    let share = [one / length, two / length];
    let of_unit = (one * two).powi(2) / (3.0 * bending * length) + (share[0].powi(2) + share[1].powi(2)) / k;
    let reaction = of_load / (of_unit + 1.0 / k);
    let end = q * length / 2.0 - reaction * share[0];
    // From the far end of the second span.
    q * two * two / 2.0 - end * two
}

#[test]
fn the_largest_stress_is_found_over_a_support_between_even_stations() {
    let (mass, k, at) = (6e5, 1e11, 1.875);
    let support = |x: f64, along: f64| {
        format!("{{ at_m = [{x:?}, 0.0], stiffness_n_per_m = [{along:?}, {k:?}], damping_n_s_per_m = [1e7, 1e8] }}")
    };
    let history = run(&scene(&format!(
        "name = \"two spans\"\nduration_s = 3.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 8.0\nthickness_m = 1.5\n\
         mass_kg = {mass:?}\nbearings = [{}, {}, {}]\n\
         elastic = {{ area_m2 = 6.0, second_moment_m4 = 10.0, damping_ratio = 0.1, modes = 24, shear_factor = \"none\" }}\n\
         [motion]\nkind = \"sine\"\namplitude_g = 1.0\nfrequency_hz = 0.1\nangle_deg = 90\n",
        support(15.0, 1e9),
        support(at, 0.0),
        support(-15.0, 0.0)
    )));
    let reading = &history.sections().readings()[0];
    within("station", (reading.stressed_at - at) / 30.0, 1e-6);
    let stations = (0..=3000).map(|i| history.sections().stress(0, 0.01 * f64::from(i) - 15.0, reading.stress.t));
    let fine = stations.fold(0.0, f64::max);
    assert!(reading.stress.value >= fine, "{} Pa, {fine} Pa on a fine grid", reading.stress.value);
    let q = mass / 30.0 * STANDARD_GRAVITY;
    let moment = moment_over_a_support([15.0 + at, 15.0 - at], 3e10 * 10.0, k, q);
    within("stress by the force method", reading.stress.value / (moment * 4.0 / 10.0) - 1.0, 5e-3);
}

#[test]
fn section_forces_jump_by_what_a_bearing_and_a_cable_do() {
    let cable = "[[restrainer]]\nname = \"cable\"\ngirder = \"deck\"\nat_m = [5.0, 0.0]\nto_m = [4.0, 0.0]\nslack_m = 0.005\n\
                 stiffness_n_per_m = 3e7\n";
    let history = run(&deck(CONCRETE, &|_| YIELDING.to_owned(), cable));
    let name = |wanted: &str| history.model().links.iter().position(|link| link.name == wanted).expect("a link");
    let (cable, bearing) = (name("cable"), name("deck.bearing2"));
    // A point in the middle is on its own station, the bearing's on its oblique section.
    let cot = 1.0 / 60f64.to_radians().tan();
    let mut pulled = 0.0f64;
    for i in 1..40 {
        let t = 2.0 * f64::from(i) / 40.0;
        let jump = |station: f64| {
            let [a, b] = [-1e-7, 1e-7].map(|off| history.sections().forces(0, station + off, t));
            [a.axial - b.axial, a.shear - b.shear]
        };
        let force = history.connections().link(cable, t).expect("it").force;
        let turned = force.truncate().rotate(glam::DVec2::from_angle(-history.motion(0, t).theta));
        let [axial, shear] = jump(5.0);
        // A smooth part of the section forces changes by 2e-7 m of inertia forces.
        within("N at the cable", axial - turned.x, 1.0 + 1e-5 * force.length());
        within("Q at the cable", shear - turned.y, 1.0 + 1e-5 * force.length());
        pulled = pulled.max(force.length());
        let whole = history.connections().bearing_loop(0, 1, t).expect("it").resistance;
        let [axial, shear] = jump(12.0 + 4.0 * cot);
        within("N at the bearing", axial + whole[0], 1.0 + 1e-5 * whole[0].abs());
        within("Q at the bearing", shear + whole[1], 1.0 + 1e-5 * whole[1].abs());
        assert!(history.connections().link(bearing, t).is_some());
    }
    assert!(pulled > 1e4, "the cable pulls: {pulled} N");
}

/// A deck on bearings that yield, with a bumper before one end, a cable behind the other and a damper.
fn held(elastic: &str) -> Scene {
    let devices = "[[bumper]]\nname = \"rubber\"\ngirder = \"deck\"\nat_m = [15.0, 0.0]\nto_m = [15.5, 0.0]\ngap_m = 0.03\n\
                   stiffness_n_per_m = 4e7\ndamping_n_s_per_m = 1e5\n\
                   [[restrainer]]\nname = \"cable\"\ngirder = \"deck\"\nat_m = [-15.0, 0.0]\nto_m = [-16.0, 1.0]\nslack_m = 0.002\n\
                   stiffness_n_per_m = 3e7\nyield_force_n = 4e5\npost_yield_stiffness_n_per_m = 1e6\n\
                   [[damper]]\nname = \"damper\"\ngirder = \"deck\"\nat_m = [0.0, 5.0]\nto_m = [2.0, 8.0]\n\
                   coefficient = 5e5\n";
    deck(elastic, &|_| YIELDING.to_owned(), devices)
}

#[test]
fn a_stiff_deck_with_devices_moves_as_the_rigid_one_with_an_error_of_1_over_e() {
    let rigid = run(&held(""));
    let off = |young: f64| {
        let elastic = format!("elastic = {{ area_m2 = 8.0, modes = 2, tol_flex = 0.0, young_modulus_pa = {young:?} }}");
        apart(&run(&held(&elastic)), &rigid, 0)
    };
    let [soft, stiff] = [3e11, 3e12].map(off);
    assert!(stiff > 0.0 && stiff < 1e-4, "{stiff} m");
    within("slope", (soft / stiff).log10() - 1.0, 0.1);
}

#[test]
fn the_ledger_of_a_deck_with_devices_that_bends_closes() {
    let history = run(&held(CONCRETE));
    let changes = |name: &str| {
        let number = history.model().links.iter().position(|link| link.name == name).expect("a link");
        history.connections().link_phases(number).len()
    };
    for name in ["deck.bearing1", "rubber", "cable"] {
        assert!(changes(name) > 2, "{name} acts: {} phases", changes(name));
    }
    let ledger = history.energy().ledger(history.end());
    within("residual in parts of the largest energy", ledger.residual.abs() / ledger.scale, 1e-9);
    assert!(ledger.loss_device > 1e4 && ledger.loss_girder > 0.0, "{ledger:?}");
}

#[test]
fn a_bearing_that_loses_its_support_bears_no_more() {
    let lost = |x: f64| if x > 13.5 { format!("{YIELDING}, travel_m = 0.02") } else { YIELDING.to_owned() };
    let mut scene = deck(CONCRETE, &lost, "");
    scene.girders[0].after_unseating = Some(girderbench::scene::AfterUnseating::Continue);
    let history = run(&scene);
    let number = history.model().links.iter().position(|link| link.name == "deck.bearing1").expect("a link");
    let (lost, phase) = *history.connections().link_phases(number).last().expect("phases");
    assert!(history.model().links[number].device.is_lost(&phase) && lost < history.end(), "{phase:?} at {lost} s");
    let after = history.connections().bearing_loop(0, 0, 0.5 * (lost + history.end())).expect("it").resistance;
    within("resistance", after[0].abs() + after[1].abs(), 1e-6);
    let ledger = history.energy().ledger(history.end());
    within("residual in parts of the largest energy", ledger.residual.abs() / ledger.scale, 1e-9);
}

#[test]
fn a_point_of_a_device_beyond_an_end_is_carried_by_its_end_section() {
    let beyond = |x: f64| {
        let mut scene = held("elastic = { area_m2 = 8.0, modes = 6 }");
        let Some(Device::Restrainer(mut cable)) = scene.device(scene.devices()[0].0) else { panic!("a cable") };
        (cable.at[0], cable.to_at) = (-x, cable.to_at);
        scene.restrainers[0] = cable;
        run(&scene)
    };
    let history = beyond(15.4);
    let number = history.model().links.iter().position(|link| link.name == "cable").expect("a link");
    for i in 0..=20 {
        let t = history.end() * f64::from(i) / 20.0;
        let [end, centre] = [
            history.connections().link(number, t).expect("it").ends[0],
            history.sections().end_displacement(0, girderbench::geometry::End::Minus, t),
        ];
        let placed = glam::DVec3::new(-15.0, 0.0, 0.0) + centre;
        within("distance from the end's centre", (end - placed).truncate().length() - 0.4, 1e-9);
    }
}

#[test]
fn a_girder_that_only_dashpots_hold_bends_where_they_are_as_stiff_as_waves() {
    let held = |coefficient: f64, modes: &str| {
        let damper = format!(
            "[[damper]]\nname = \"damper\"\ngirder = \"deck\"\nat_m = [0.0, 5.0]\nto_m = [2.0, 8.0]\ncoefficient = {coefficient:?}\n"
        );
        let none = |_| "stiffness_n_per_m = [0.0, 0.0], damping_n_s_per_m = [0.0, 0.0]".to_owned();
        run(&deck(&format!("elastic = {{ area_m2 = 8.0, modes = {modes} }}"), &none, &damper))
    };
    // Z = 69 MN s/m: a dashpot of 0.1 N s/m is nothing to it.
    assert!(held(0.1, "\"auto\"").sections().flexible(0).is_none(), "as good as rigid");
    let [own, finer] = ["\"auto\"", "12"].map(|modes| held(1e8, modes));
    assert_eq!(own.sections().flexible(0).and_then(|f| f.girder.as_ref()).expect("it bends").degree(), 10, "κ = 1");
    // 2e-5 of 450 mm; places of a deck that is hit differ by 1e-4 between degrees 8 and 12 (`invariants`).
    within("against degree 12", apart(&own, &finer, 0), 1e-5);
}
