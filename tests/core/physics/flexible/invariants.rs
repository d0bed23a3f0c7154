//! What no frame, mirror, number of polynomials or bearing may change.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use super::{Bar, bars, case, with_degree};
use crate::support::{run, scene, within};
use girderbench::dynamics::elastic::Modes;
use girderbench::scene::{Degree, Motion};
use girderbench::sim::History;

#[test]
fn a_girder_that_is_as_good_as_rigid_is_the_rigid_one_bit_for_bit() {
    let (case, _) = case("f4_skew60_friction", None);
    let mut rigid = case.scene.clone();
    rigid.girders[0].elastic = None;
    let mut stiff = case.scene;
    stiff.girders[0].elastic.as_mut().expect("elastic").tolerance = 1.0;
    assert_eq!(run(&rigid).digest(), run(&stiff).digest());
}

#[test]
fn a_mirrored_deck_moves_as_in_a_mirror() {
    let (case, _) = case("f4_skew60_friction", None);
    let mut mirrored = case.scene.clone();
    mirrored.girders[0].skew_deg = 120.0;
    let Some(girderbench::scene::Bearings::Shared(shared)) = &mut mirrored.girders[0].bearings else { panic!("legs") };
    shared.at.iter_mut().flatten().for_each(|leg| leg[1] = -leg[1]);
    let (one, other) = (run(&case.scene), run(&mirrored));
    for i in 0..=100 {
        let t = one.end() * f64::from(i) / 100.0;
        let (a, b) = (one.motion(0, t), other.motion(0, t));
        within("x", a.displacement.x - b.displacement.x, 1e-9);
        within("y", a.displacement.y + b.displacement.y, 1e-9);
        within("rotation", a.theta + b.theta, 1e-10);
    }
}

/// A free pair that meets aside, in axes turned by this angle \[°\].
fn turned(angle: f64) -> History {
    let (s, c) = angle.to_radians().sin_cos();
    let at = |x: f64, y: f64| format!("[{:?}, {:?}, 0.0]", c * x - s * y, s * x + c * y);
    let girder = |name: &str, x: f64, y: f64, v: f64| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\nmass_kg = 6e5\nskew_deg = 70.0\n\
             heading_deg = {angle}\nposition_m = {}\ninitial = {{ velocity_m_s = [{:?}, {:?}] }}\n\
             elastic = {{ area_m2 = 8.0, modes = 8 }}\n",
            at(x, y),
            c * v,
            s * v
        )
    };
    run(&scene(&format!(
        "name = \"pair\"\nduration_s = 0.2\n{}{}[contact]\nstiffness_n_per_m = 4e9\nrestitution_normal = 0.6\n[solver]\ntolerance = 1e-12\n",
        girder("a", -15.01, 0.0, 0.5),
        // Aside along the skewed end.
        girder("b", 15.01 + 2.0 / 70f64.to_radians().tan(), 2.0, -0.3)
    )))
}

#[test]
fn a_free_scene_may_be_turned() {
    let (straight, turned) = (turned(0.0), turned(33.0));
    let back = glam::DQuat::from_rotation_z(-33f64.to_radians());
    for i in 0..=40 {
        let t = straight.end() * f64::from(i) / 40.0;
        for girder in 0..2 {
            let (a, b) = (straight.motion(girder, t), turned.motion(girder, t));
            within("displacement", (a.displacement - back * b.displacement).length(), 1e-9);
            within("rotation", a.theta - b.theta, 1e-10);
        }
    }
    assert!(straight.hits().count() > 0, "they meet");
}

#[test]
fn more_polynomials_change_little_and_the_check_says_how_little() {
    let (case, _) = case("f2_abutment_C0", None);
    let history = run(&case.scene);
    let check = history.sections().check_degree().expect("a girder that bends");
    assert_eq!(check.degree, [8, 12]);
    within("n → 3n/2: force", check.force, 5e-4);
    within("n → 3n/2: impulse", check.impulse, 1e-4);
    within("n → 3n/2: ends", check.ends, 1e-4);
    within("n → 3n/2: N at mid-span", check.section, 5e-3);
    assert!(check.force > 0.0 && check.ends > 0.0, "they do differ");
    let finer = run(&with_degree(&case.scene, 12));
    let part = (finer.hits().largest_force() - history.hits().largest_force()).abs() / finer.hits().largest_force();
    within("it is the difference of two runs", part - check.force, 1e-12);
}

#[test]
fn where_there_can_be_no_more_polynomials_the_check_takes_fewer() {
    let bar = Bar { length: 20.0, mass: 5e4 };
    let mut scene = with_degree(&bars(&[bar, bar], 2e11, 1.0, 0.03), 64);
    scene.solver.tolerance = 1e-8;
    let check = run(&scene).sections().check_degree().expect("a girder that bends");
    assert_eq!(check.degree, [64, 42]);
    assert!(check.force > 1e-3, "{check:?}");
}

/// A deck on bearings at one end, shaken.
fn one_end(motion: &str) -> girderbench::scene::Scene {
    scene(&format!(
        "name = \"one end\"\nduration_s = 420.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
         mass_kg = 6e5\nskew_deg = 60.0\n\
         bearings = [{{ at_m = [-12, 4], stiffness_n_per_m = [2e7, 3e7], damping_n_s_per_m = [1e6, 1e6] }}, \
         {{ at_m = [-14, -4], stiffness_n_per_m = [3e7, 2e7], damping_n_s_per_m = [1e6, 2e6] }}]\n\
         elastic = {{ area_m2 = 8.0, modes = 8 }}\n{motion}[solver]\ntolerance = 1e-12\n"
    ))
}

#[test]
fn a_deck_held_at_one_end_answers_a_sine_by_its_frequency_response() {
    let history = run(&one_end("[motion]\nkind = \"sine\"\namplitude_g = 0.2\nfrequency_hz = 3.0\nangle_deg = 30\n"));
    assert_eq!(history.effort().steps, 0, "a flight costs no steps");
    let flexible = history.sections().flexible(0).expect("it bends");
    let modes = Modes::of(flexible.beam, 8);
    let (count, omega) = (3 + modes.count(), TAU * 3.0);
    // (−Ω² M + iΩ C + K) X = F, by the places of the bearings themselves.
    let body = &history.model().bodies[0];
    let mut matrix = DMatrix::<Complex<f64>>::zeros(count, count);
    let masses = [body.mass, body.mass, body.mass * body.gyration2];
    for (i, mass) in masses.into_iter().enumerate() {
        matrix[(i, i)] -= Complex::from(mass * omega * omega);
    }
    for j in 0..modes.count() {
        let own = modes.omega(j);
        matrix[(3 + j, 3 + j)] += Complex::new(own * own - omega * omega, 2.0 * 0.02 * own * omega);
    }
    for bearing in &body.bearings {
        let (x, y) = (bearing.place.x, bearing.place.y);
        let cot = body.prism.shear();
        let point = modes.point(2.0 * (x - y * cot) / 30.0, glam::DVec2::new(y * cot, y));
        for axis in 0..2 {
            let rigid = if axis == 0 { [1.0, 0.0, -y] } else { [0.0, 1.0, x] };
            let row: Vec<f64> = rigid.into_iter().chain(point.iter().map(|d| d[axis])).collect();
            let spring = Complex::new(bearing.stiffness[axis], omega * bearing.damping[axis]);
            for i in 0..count {
                for j in 0..count {
                    matrix[(i, j)] += spring * row[i] * row[j];
                }
            }
        }
    }
    let amplitude = 0.2 * girderbench::scene::STANDARD_GRAVITY;
    let (s, c) = 30f64.to_radians().sin_cos();
    let mut load = DVector::<Complex<f64>>::zeros(count);
    (load[0], load[1]) = ((-body.mass * amplitude * c).into(), (-body.mass * amplitude * s).into());
    let answer = matrix.lu().solve(&load).expect("regular");
    let mut worst = 0.0f64;
    for i in 0..200 {
        // The slowest mode, a turn about the bearings, decays by e^{−0.08 t}.
        let t = 400.0 + 0.05 * f64::from(i);
        let turn = Complex::from_polar(1.0, omega * t);
        let of = |k: usize| (answer[k] * turn).im;
        let motion = history.motion(0, t);
        worst = worst.max((motion.displacement.x - of(0)).abs()).max((motion.displacement.y - of(1)).abs());
        let q: glam::DVec3 = modes.section(1.0).into_iter().enumerate().map(|(j, field)| field * of(3 + j)).sum();
        let end = history.sections().deformation(0, 15.0, t);
        worst = worst.max((end.moved.with_z(end.turned.z) - q).length());
    }
    within("a deck held at one end: places", worst / answer[0].norm(), 1e-9);
}

#[test]
fn a_record_that_is_flown_through_balances_and_costs_no_steps() {
    let quake = "[motion]\nkind = \"synthetic\"\npeak_g = 0.3\nlength_s = 12.0\n";
    let mut scene = one_end(quake);
    scene.duration = 12.0;
    let history = run(&scene);
    assert_eq!(history.effort().steps, 0, "a flight costs no steps");
    for i in 1..=12 {
        let books = history.energy().ledger(f64::from(i));
        within("ledger", books.residual / books.scale, 1e-11);
        assert!(books.loss_girder > 0.0, "modes lose energy");
    }
    let bent = history.sections().deformation(0, 15.0, 4.0).moved;
    assert!(bent.length() > 1e-6, "it bends: {bent}");
}

#[test]
fn section_forces_vanish_at_free_ends_and_agree_with_strain_in_the_middle() {
    let (case, _) = case("f4_skew60_friction_C0", Some(16));
    let history = run(&case.scene);
    let hit = history.hits().hardest().expect("a hit").peak_time;
    let largest = history.hits().largest_force();
    for t in [hit - 0.01, hit, hit + 0.005, hit + 0.2] {
        let equilibrium = history.sections().equilibrium(0, t).expect("it bends");
        let strained = history.sections().strained(0, t).expect("it bends");
        // Nothing is at the −x end: what lies beyond it is the whole girder in equilibrium.
        let end = equilibrium.at(-15.0);
        within("N at the free end", end.axial / largest, 1e-9);
        within("Q at the free end", end.shear / largest, 1e-9);
        within("M at the free end", end.moment / (10.0 * largest), 1e-9);
        for station in [-5.0, 0.0, 5.0] {
            let (one, other) = (equilibrium.at(station), strained.at(station));
            within("N by strain", (one.axial - other.axial) / largest, 2e-2);
            within("M by strain", (one.moment - other.moment) / (10.0 * largest), 2e-2);
        }
    }
    let reading = &history.sections().readings()[0];
    assert!(reading.neglected.named().into_iter().all(|(_, bound)| bound < 1e-2), "{:?}", reading.neglected);
    assert!(reading.stress.value > 1e5 && reading.hit.is_some(), "{reading:?}");
}

#[test]
fn rayleighs_damping_is_that_of_its_frequencies() {
    let (mut case, _) = case("f2_abutment_C0", Some(8));
    let Motion::Sine(sine) = &mut case.scene.motion else { panic!("a sine") };
    sine.amplitude = Some(1.0);
    let elastic = case.scene.girders[0].elastic.as_mut().expect("elastic");
    (elastic.damping_ratio, elastic.rayleigh) =
        (None, Some(girderbench::scene::Rayleigh { mass: 0.3, stiffness: 2e-5 }));
    elastic.modes = Degree(Some(8.0));
    let history = run(&case.scene);
    let made = history.sections().flexible(0).and_then(|flexible| flexible.girder.clone()).expect("it bends");
    for omega in made.frequencies() {
        within("2ζω", made.damping().dashpot(omega) - (0.3 + 2e-5 * omega * omega), 1e-9 * omega);
    }
    let books = history.energy().ledger(history.end());
    within("ledger", books.residual / books.scale, 1e-10);
}
