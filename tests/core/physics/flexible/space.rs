//! Girders that bend in plan and upwards and twist, in spatial scenes: against closed forms, the plan, the rigid girder, and invariants.

use std::f64::consts::PI;

use super::force_on_first;
use crate::support::{momenta_in_space, run, scene, within};
use girderbench::dynamics::elastic::legendre::integrals_to_end;
use girderbench::geometry::End;
use girderbench::scene::{Kind, Scene};
use girderbench::sim::{Comparison, History};
use glam::DVec3;

/// A deck of 30 m by this name and kind, with these lines after it.
fn deck(name: &str, x: f64, lines: &str) -> String {
    format!(
        "[[girder]]\nname = \"{name}\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\nmass_kg = 6e5\n\
         position_m = [{x:?}, 0.0, 0.0]\n{lines}\n"
    )
}

const WALL: &str = "[[abutment]]\nname = \"wall\"\nfaces = \"a\"\ngap_m = 0.01\nwidth_m = 30.0\nheight_m = 6.0\n";
const SMOOTH: &str = "[contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\nmu_static = 0.0\nmu_kinetic = 0.0\n";
const RUBBING: &str =
    "[contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 0.7\nmu_static = 0.4\nmu_kinetic = 0.3\n";

fn spatial(girders: &str, rest: &str, duration: f64) -> Scene {
    scene(&format!(
        "name = \"space\"\nkind = \"spatial\"\ngravity_m_s2 = 0.0\nduration_s = {duration:?}\n{girders}{rest}[solver]\ntolerance = 1e-11\n"
    ))
}

/// A free deck that comes to a wall askew, rolling and pitching.
fn thrown(elastic: &str, contact: &str) -> Scene {
    let lines = format!(
        "skew_deg = 70.0\ninitial = {{ velocity_m_s = [0.6, 0.1, 0.05], roll_deg = 0.2, pitch_deg = -0.1, rotation_deg = 0.15, \
         spin_deg_s = 1.0, roll_deg_s = 2.0, pitch_deg_s = -1.0 }}\n{elastic}"
    );
    spatial(&deck("a", 0.0, &lines), &[WALL, contact].concat(), 0.25)
}

fn worst_ledger(history: &History) -> f64 {
    let all = (1..=40).map(|i| history.energy().ledger(history.end() * f64::from(i) / 40.0));
    all.map(|books| (books.residual / books.scale).abs()).fold(0.0, f64::max)
}

#[test]
fn the_numbers_of_the_scene_make_the_frequencies() {
    let lines = "elastic = { area_m2 = 8.0, second_moment_vertical_m4 = 2.0, torsion_constant_m4 = 5.0, modes = 16 }";
    let history = run(&spatial(&deck("a", 0.0, lines), "", 0.01));
    let made = history.sections().flexible(0).and_then(|flexible| flexible.girder.clone()).expect("it bends");
    assert_eq!(made.count(), 6 * 16 - 2);
    let (torsion, inertia): (f64, f64) = (30e9 / 2.4 * 5.0, 6e5 / 30.0 * (100.0 + 2.25) / 12.0);
    for j in 1..=3 {
        let wanted = f64::from(j) * PI / 30.0 * (torsion / inertia).sqrt();
        let nearest = made.frequencies().into_iter().map(|omega| (omega / wanted - 1.0).abs()).fold(1.0, f64::min);
        within(&format!("torsion {j}: {wanted} rad/s"), nearest, 1e-9);
    }
    // Euler and Bernoulli's first frequency of vertical bending, less what shear and rotary inertia take: about 1 %.
    let euler = (4.730_041f64 / 30.0).powi(2) * f64::sqrt(30e9 * 2.0 / (6e5 / 30.0));
    let slower = 1.0 - made.frequencies()[0] / euler;
    assert!(slower > 0.0 && slower < 0.03, "{slower}");
}

/// What the polynomials give of the twist under a torque at mid-span: the projection of its strain, `T/2GJ` to either side.
fn projected(degree: usize) -> f64 {
    let half = integrals_to_end(degree - 1, 0.0);
    let odd = (0..degree).filter(|k| k % 2 == 1);
    odd.map(|k| (2 * k + 1) as f64 * half[k] * half[k]).sum()
}

/// Four stiff legs under the corners of a deck, with dashpots that bring it to rest.
fn stiff_legs() -> String {
    let bearings: Vec<String> = [[15.0, 5.0], [15.0, -5.0], [-15.0, 5.0], [-15.0, -5.0]]
        .iter()
        .map(|[x, y]| {
            format!("{{ at_m = [{x:?}, {y:?}], height_m = 0.0, stiffness_n_per_m = [1e7, 1e7, 2e9], damping_n_s_per_m = [2e6, 2e6, 2e7] }}")
        })
        .collect();
    bearings.join(", ")
}

#[test]
fn a_torque_at_mid_span_twists_it_by_its_stiffness() {
    let lines = format!(
        "bearings = [{}]\npush = {{ moment_x_n_m = 3e6 }}\nelastic = {{ area_m2 = 8.0, torsion_constant_m4 = 5.0, modes = 12, damping_ratio = 0.5 }}",
        stiff_legs()
    );
    let mut scene = spatial(&deck("a", 0.0, &lines), "", 1.5);
    scene.solver.tolerance = 1e-8;
    let history = run(&scene);
    let end = history.end();
    let twist = |station: f64| history.sections().deformation(0, station, end).turned.x;
    let (torque, stiffness) = (3e6, 30e9 / 2.4 * 5.0);
    let exact = torque * 30.0 / (4.0 * stiffness);
    let seen = twist(0.0) - 0.5 * (twist(15.0) + twist(-15.0));
    within("twist of degree 12", seen / (projected(12) * exact) - 1.0, 1e-6);
    // Half of a torque goes each way: TL/4GJ as the degree grows, by 1/n.
    within("twist against TL/(4GJ)", seen / exact - 1.0, 0.06);
    assert!(projected(48) > 0.986 && projected(48) < 1.0, "{}", projected(48));
    for (station, wanted) in [(-7.5, 0.5), (7.5, -0.5)] {
        within("T", history.sections().forces(0, station, end).torque / torque - wanted, 1e-6);
    }
}

#[test]
fn a_load_at_mid_span_bends_it_as_a_beam_on_two_supports() {
    let lines = format!(
        "bearings = [{}]\npush = {{ force_n = [0.0, 0.0, -2e6] }}\nelastic = {{ area_m2 = 8.0, modes = 12, damping_ratio = 0.5 }}",
        stiff_legs()
    );
    let mut scene = spatial(&deck("a", 0.0, &lines), "", 5.0);
    scene.solver.tolerance = 1e-8;
    let history = run(&scene);
    let end = history.end();
    let sagged = |station: f64| history.sections().deformation(0, station, end).moved.z;
    let (load, bending) = (2e6, 30e9 * 8.0 * 2.25 / 12.0);
    let shear = 5.0 / 6.0 * 30e9 / 2.4 * 8.0;
    let wanted = load * 30f64.powi(3) / (48.0 * bending) + load * 30.0 / (4.0 * shear);
    let seen = 0.5 * (sagged(15.0) + sagged(-15.0)) - sagged(0.0);
    // The kink of the shear's part, 3 % of the whole, converges like 1/n.
    within("deflection at mid-span", seen / wanted - 1.0, 2e-3);
    let forces = |station: f64| history.sections().forces(0, station, end);
    // M_y stretches the upper side: of a load downwards it is negative, −PL/8 at the quarter.
    within("M_y at the quarter", forces(7.5).vertical_moment / (load * 30.0 / 8.0) + 1.0, 1e-6);
    within("Q_z", forces(7.5).vertical_shear / load - 0.5, 1e-6);
    within("Q_z on the other side", forces(-7.5).vertical_shear / load + 0.5, 1e-6);
    let reading = &history.sections().readings()[0];
    let most = load * 30.0 / 4.0 * 0.75 / (8.0 * 2.25 / 12.0);
    assert!(reading.stress.value > most, "PL/4 over W, and more on its way: {} Pa", reading.stress.value);
}

/// A scene in plan, and the same in space without weight.
fn both(skew: f64, lines: &str) -> [Scene; 2] {
    let text = |kind: &str| {
        format!(
            "name = \"hit\"\nkind = \"{kind}\"\n{}duration_s = 0.25\n{}{WALL}{SMOOTH}[solver]\ntolerance = 1e-12\n",
            if kind == "spatial" { "gravity_m_s2 = 0.0\n" } else { "" },
            deck("a", 0.0, &format!("skew_deg = {skew:?}\nelastic = {{ area_m2 = 8.0, modes = 8 }}\n{lines}"))
        )
    };
    [scene(&text("planar")), scene(&text("spatial"))]
}

#[test]
fn a_level_hit_in_space_is_that_in_plan() {
    for (name, skew, lines) in [
        ("straight", 90.0, "initial = { velocity_m_s = [0.5, 0.0] }"),
        ("skewed", 60.0, "initial = { velocity_m_s = [0.5, 0.1], spin_deg_s = 0.5 }"),
    ] {
        let [plan, space] = both(skew, lines).map(|scene| run(&scene));
        assert_eq!((plan.model().kind, space.model().kind), (Kind::Planar, Kind::Spatial));
        assert!(plan.hits().count() > 0 && plan.hits().count() <= space.hits().count(), "{name}: they hit");
        let end = plan.end();
        let (mut places, mut bent, mut force) = (0.0f64, 0.0f64, 0.0f64);
        for i in 0..=500 {
            let t = end * f64::from(i) / 500.0;
            let [a, b] = [&plan, &space].map(|history| history.motion(0, t));
            places = places.max((a.displacement - b.displacement).length()).max((a.theta - b.theta).abs());
            let [a, b] = [&plan, &space].map(|history| history.sections().deformation(0, 15.0, t));
            bent = bent.max((a.moved - b.moved).length()).max((a.turned - b.turned).length());
            let [a, b] = [&plan, &space].map(|history| history.end_motion(0, End::Plus, t));
            bent = bent.max((a.displacement - b.displacement).length()).max((a.theta - b.theta).abs());
            bent = bent.max((a.attitude * DVec3::X - b.attitude * DVec3::X).length());
            force = force.max((force_on_first(&plan, t) - force_on_first(&space, t)).length());
        }
        let most = (0..=500).map(|i| plan.sections().deformation(0, 15.0, end * f64::from(i) / 500.0).moved.length());
        let most = most.fold(0.0, f64::max);
        assert!(most > 1e-4, "{name}: it bends by {most} m");
        within(&format!("{name}: places"), places / 0.1, 1e-12);
        within(&format!("{name}: deformation"), bent / most, 1e-7);
        within(&format!("{name}: force"), force / plan.hits().largest_force(), 1e-7);
    }
}

#[test]
fn the_mirror_image_of_a_scene_has_the_mirrored_answer() {
    let elastic = "elastic = { area_m2 = 8.0, modes = 6 }";
    let scene = thrown(elastic, SMOOTH);
    let mut mirrored = scene.clone();
    let girder = &mut mirrored.girders[0];
    girder.skew_deg = 180.0 - girder.skew_deg;
    girder.initial.velocity[1] *= -1.0;
    let initial = &mut girder.initial;
    (initial.rotation_deg, initial.spin_deg_s) = (-initial.rotation_deg, -initial.spin_deg_s);
    for angle in [&mut initial.roll_deg, &mut initial.roll_deg_s] {
        *angle = angle.map(|angle| -angle);
    }
    let [one, other] = [&scene, &mirrored].map(run);
    assert!(one.hits().count() > 0, "it hits");
    let mut worst = [0.0f64; 2];
    for i in 0..=200 {
        let t = one.end() * f64::from(i) / 200.0;
        let [a, b] = [&one, &other].map(|history| history.motion(0, t));
        let back = DVec3::new(1.0, -1.0, 1.0);
        worst[0] = worst[0].max((a.displacement - b.displacement * back).length());
        worst[0] = worst[0].max((a.spin + b.spin * back).length());
        let [a, b] = [&one, &other].map(|history| history.sections().deformation(0, 11.0, t));
        worst[1] = worst[1].max((a.moved - b.moved * back).length()).max((a.turned + b.turned * back).length());
    }
    within("places and spin", worst[0], 1e-9);
    within("deformation", worst[1], 1e-9);
}

#[test]
fn a_stiffer_deck_comes_to_the_rigid_one_like_one_over_e() {
    let rigid = run(&thrown("", RUBBING));
    let apart: Vec<f64> = [30.0, 300.0, 1500.0]
        .into_iter()
        .map(|factor| {
            let elastic = format!(
                "elastic = {{ area_m2 = 8.0, modes = 6, young_modulus_pa = {:e}, damping_ratio = 0.2 }}",
                30e9 * factor
            );
            Comparison::of(&run(&thrown(&elastic, RUBBING)), &rigid).of_all().place
        })
        .collect();
    let slope = |a: f64, b: f64, ratio: f64| (b / a).ln() / f64::ln(ratio);
    within("slope of the difference, E × 30 to × 300", slope(apart[0], apart[1], 10.0) + 1.0, 0.1);
    within("slope, × 300 to × 1500", slope(apart[1], apart[2], 5.0) + 1.0, 0.1);
}

#[test]
fn books_balance_under_friction_and_dashpots_in_space() {
    for (name, contact) in [("smooth", SMOOTH), ("rubbing", RUBBING)] {
        let history = run(&thrown("elastic = { area_m2 = 8.0, modes = 6 }", contact));
        within(&format!("{name}: ledger"), worst_ledger(&history), 1e-10);
        let bent = history.sections().readings();
        assert!(history.hits().count() > 0 && bent[0].hit.is_some(), "{name}: it hits");
        let upwards = (0..100)
            .map(|i| history.sections().deformation(0, 0.0, history.end() * f64::from(i) / 100.0).moved.z.abs());
        assert!(upwards.fold(0.0, f64::max) > 1e-5, "{name}: it bends upwards");
    }
}

/// Two free decks that meet, the first rolled and on its way.
fn pair(contact: &str) -> Scene {
    let elastic = "elastic = { area_m2 = 8.0, modes = 6 }";
    let first = format!(
        "skew_deg = 70.0\ninitial = {{ velocity_m_s = [0.6, 0.1, 0.03], roll_deg = 0.3, pitch_deg = 0.1, spin_deg_s = 0.5 }}\n{elastic}"
    );
    let girders = [deck("a", -15.02, &first), deck("b", 15.02, &format!("skew_deg = 70.0\n{elastic}"))].concat();
    spatial(&girders, contact, 0.3)
}

#[test]
fn two_decks_that_meet_keep_momentum_and_its_moment() {
    let history = run(&pair(SMOOTH));
    assert!(history.hits().count() > 0, "they meet");
    let [momentum, moment] = momenta_in_space(&history, 0.0);
    for i in 1..=30 {
        let [now, turning] = momenta_in_space(&history, history.end() * f64::from(i) / 30.0);
        within("momentum", (now - momentum).length() / momentum.length(), 1e-12);
        // About the origin, 15 m from each.
        within("its moment", (turning - moment).length() / (15.0 * momentum.length()), 1e-9);
    }
    within("ledger", worst_ledger(&history), 1e-10);
    let rubbing = run(&pair(RUBBING));
    within("ledger with friction", worst_ledger(&rubbing), 1e-10);
    let [now, _] = momenta_in_space(&rubbing, rubbing.end());
    within("momentum with friction", (now - momentum).length() / momentum.length(), 1e-12);
}

#[test]
fn a_deck_on_its_bearings_under_its_weight_rests_and_rings_about_that() {
    let lines = "skew_deg = 65.0\nbearings = { frequency_hz = [1.0, 1.2], vertical_frequency_hz = 6.0, damping_ratio = 0.05, \
                 at_m = [[13, 4], [13, -4], [-13, 4], [-13, -4]] }\nelastic = { area_m2 = 8.0, modes = 6 }";
    let text = |rest: &str| {
        scene(&format!(
            "name = \"rest\"\nkind = \"spatial\"\nduration_s = 1.0\n{}{rest}[solver]\ntolerance = 1e-11\n",
            deck("a", 0.0, lines)
        ))
    };
    let still = run(&text(""));
    within("it rests", still.motion(0, 1.0).displacement.length(), 1e-13);
    within("unbent", still.sections().deformation(0, 15.0, 1.0).moved.length(), 1e-13);
    let shaken = run(&text(
        "[motion]\nkind = \"sine\"\namplitude_g = 0.3\nfrequency_hz = 1.5\nangle_deg = 30\nvertical_amplitude_g = 0.2\n",
    ));
    within("ledger", worst_ledger(&shaken), 1e-9);
    assert!(shaken.sections().deformation(0, 15.0, 0.7).moved.z.abs() > 1e-6, "it bends upwards");
}

#[test]
fn more_polynomials_change_little_in_space() {
    let mut scene = thrown("elastic = { area_m2 = 8.0 }", SMOOTH);
    scene.solver.tolerance = 1e-9;
    let history = run(&scene);
    let flexible = history.sections().flexible(0).expect("it bends");
    // κ = 0.25: n = 8. Corners yield upwards far more than along the axis.
    within("κ", flexible.softness.kappa - 0.25, 1e-12);
    assert!(flexible.softness.end > 0.25 / 3.0, "κ_e = {}", flexible.softness.end);
    let check = history.sections().check_degree().expect("a girder that bends");
    assert_eq!(check.degree, [8, 12]);
    within("n → 3n/2: force", check.force, 5e-3);
    within("n → 3n/2: impulse", check.impulse, 5e-3);
    // Vertical modes above 0.65 n c/a0 ring at other frequencies.
    within("n → 3n/2: ends", check.ends, 3e-3);
}

/// Time; place of G, spin of the mean axes, displacement and turn of the +x end, of [`thrown`] with [`SMOOTH`] and degree 6.
const REFERENCE: &str = include_str!("../../../data/flexible/space_hit.csv");

/// An independent program: fields in raw Legendre coefficients with Gauss's integrals, rigid motions taken out by a null space, no modes,
/// damping by the root of a matrix, rotations by their power series, `SciPy`'s DOP853 at 1e-12 (at 1e-13 and half the steps it differs by 1e-15).
#[test]
fn a_hit_in_space_is_that_of_an_independent_program() {
    let mut scene = thrown("elastic = { area_m2 = 8.0, modes = 6 }", SMOOTH);
    scene.solver.tolerance = 1e-12;
    let history = run(&scene);
    let mut rows = 0;
    for row in REFERENCE.lines().skip(1) {
        let numbers: Vec<f64> = row.split(',').map(|number| number.parse().expect("a number")).collect();
        let [place, spin, moved, turned] = [1, 4, 7, 10].map(|from| DVec3::from_slice(&numbers[from..]));
        let t = numbers[0];
        let (motion, end) = (history.motion(0, t), history.sections().deformation(0, 15.0, t));
        let apart = |value: DVec3, wanted: DVec3| (value - wanted).length();
        within(&format!("{t} s: place, of 0.1 m"), apart(motion.displacement, place) / 0.1, 1e-11);
        within(&format!("{t} s: spin, of 0.04 rad/s"), apart(motion.spin, spin) / 0.04, 1e-11);
        within(&format!("{t} s: displacement of the end, of 1 mm"), apart(end.moved, moved) / 1e-3, 1e-9);
        within(&format!("{t} s: turn of the end, of 3e-4"), apart(end.turned, turned) / 3e-4, 1e-9);
        rows += 1;
    }
    assert_eq!(rows, 5, "of the table");
}

/// A deck that rises along a wall lower than it is deep: its edges press where they cross the wall's, beside the nodes. The moment just
/// inside the end is what turns the deck about G, less that of the force there.
#[test]
fn section_moments_know_where_edges_cross() {
    let text = "name = \"rises\"\nkind = \"spatial\"\ngravity_m_s2 = 0.0\nduration_s = 0.1\n[[girder]]\nname = \"a\"\nlength_m = 20.0\n\
                width_m = 8.0\nthickness_m = 2.0\nmass_kg = 3e5\ninitial = { velocity_m_s = [1.0, 0.0, 0.25] }\n[girder.elastic]\n\
                area_m2 = 6.0\ndamping_ratio = 0.0\nmodes = 2\n[[abutment]]\nname = \"wall\"\nfaces = \"a\"\ngap_m = 0.01\n\
                width_m = 30.0\nheight_m = 1.0\n[contact]\nstiffness_n_per_m = 1e9\nrestitution_normal = 1.0\n\
                restitution_tangential = 1.0\nmu_static = 0.0\nmu_kinetic = 0.0\n[solver]\ntolerance = 1e-11\n";
    let history = run(&scene(text));
    let dt = 1e-6;
    let mut compared = 0;
    for t in [0.025, 0.03, 0.04, 0.05, 0.055] {
        assert!(history.contacts().at(t).iter().any(|now| now.couple != DVec3::ZERO), "edges are in contact at {t} s");
        let [before, after] = [t - dt, t + dt].map(|t| history.motion(0, t));
        // The deck turns by 1e-2 rad at most, about y alone.
        let pitch = (after.spin.y - before.spin.y) / (2.0 * dt);
        let inertia = 3e5 * (20.0f64.powi(2) + 2.0f64.powi(2)) / 12.0;
        let lift = 3e5 * (after.velocity.z - before.velocity.z) / (2.0 * dt);
        let inside = history.sections().forces(0, 10.0 - 1e-9, t).vertical_moment.abs();
        let turned = (inertia * pitch + 10.0 * lift).abs();
        assert!((inside - turned).abs() < 0.02 * turned, "{inside} N·m inside the end, {turned} N·m turn it at {t} s");
        compared += usize::from(turned > 1e4);
    }
    assert!(compared > 3, "{compared} of five with a moment to speak of");
}
