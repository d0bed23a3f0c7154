//! Tops and undersides: a girder between two others, one that is pushed along another's top, and one that slides over its end.

use girderbench::scene::{STANDARD_GRAVITY, Scene};
use glam::DVec3;

use super::expect_carried;
use crate::support::{run, scene, within};

const STIFFNESS: f64 = 1e5;
const MU: f64 = 0.15;
/// Height of each \[m\], and mass \[kg\].
const HEIGHT: f64 = 0.1;
const MASS: f64 = 5.0;

fn girder(name: &str, [length, width]: [f64; 2], place: [f64; 3], keys: &str) -> String {
    format!(
        "[[girder]]\nname = \"{name}\"\nlength_m = {length}\nwidth_m = {width}\nthickness_m = {HEIGHT}\nmass_kg = {MASS}\nposition_m = {place:?}\n{keys}"
    )
}

/// Spatial girders under gravity.
fn stack(girders: &[String], duration: f64) -> Scene {
    let mut scene = scene(&format!(
        "name = \"stack\"\nkind = \"spatial\"\nduration_s = {duration}\n[contact]\nstiffness_n_per_m = {STIFFNESS}\n\
         restitution_normal = 0.05\nmu_static = 0.2\nmu_kinetic = {MU}\n{}",
        girders.concat()
    ));
    scene.solver.tolerance = 1e-9;
    scene
}

const FIXED: &str = "held = [\"x\", \"y\", \"z\", \"roll\", \"pitch\", \"yaw\"]\n";

/// Depth of a face under the weight of so many girders \[m\].
fn yields(girders: f64) -> f64 {
    girders * MASS * STANDARD_GRAVITY / STIFFNESS
}

#[test]
fn a_girder_between_two_others_carries_the_upper_one() {
    let (gap, pitch) = (0.005, HEIGHT + 0.005);
    let girders = [
        girder("base", [1.2, 0.3], [0.0; 3], FIXED),
        girder("middle", [0.8, 0.28], [0.1, 0.0, pitch], ""),
        girder("top", [0.5, 0.2], [0.05, 0.02, 2.0 * pitch], ""),
    ];
    let history = run(&stack(&girders, 2.0));
    expect_carried(&history);
    let end = history.end();
    let sunk = |girder| history.motion(girder, end).displacement.z;
    within("middle", sunk(1) + gap + yields(2.0), 1e-7);
    // The upper one stands 0.05 and 0.02 m off the middle of the lower, which tilts on its corners, a quarter of K each.
    let tilted = yields(1.0) * ((0.05_f64 / 0.4).powi(2) + (0.02_f64 / 0.14).powi(2));
    within("top", sunk(2) + 2.0 * gap + yields(2.0) + yields(1.0) + tilted, 1e-6);
    let pressed = |lower: usize, upper: usize| {
        let of = history.contacts().at(end);
        let between = of.iter().filter(|c| {
            let site = &history.model().sites[c.contact];
            [site.node_body, site.face_body] == [Some(lower), Some(upper)]
                || [site.face_body, site.node_body] == [Some(lower), Some(upper)]
        });
        between.map(|c| c.normal_force * c.normal.z.abs()).sum::<f64>()
    };
    within("under the middle", pressed(0, 1) / (2.0 * MASS * STANDARD_GRAVITY) - 1.0, 1e-4);
    within("under the top", pressed(1, 2) / (MASS * STANDARD_GRAVITY) - 1.0, 1e-4);
}

/// A girder that lies on a fixed one and cannot turn, pushed along it \[N\] and started along it \[m/s\].
fn lying(push: f64, speed: f64, duration: f64) -> Scene {
    let start = -yields(1.0);
    let keys = format!(
        "held = [\"roll\", \"pitch\", \"yaw\"]\npush = {{ force_n = [{push}, 0] }}\n\
         initial = {{ displacement_m = [0, 0, {start}], velocity_m_s = [{speed}, 0] }}\n"
    );
    stack(
        &[girder("base", [1.2, 0.3], [0.0; 3], FIXED), girder("top", [0.5, 0.3], [0.0, 0.0, HEIGHT], &keys)],
        duration,
    )
}

#[test]
fn what_lies_on_another_holds_up_to_static_friction_and_slides_beyond() {
    let weight = MASS * STANDARD_GRAVITY;
    let held = run(&lying(0.09 * weight, 0.0, 0.3));
    expect_carried(&held);
    within("held by the springs", held.motion(1, 0.3).displacement.x - 0.09 * weight / STIFFNESS, 2e-4);
    let pushed = run(&lying(0.5 * weight, 0.0, 0.3));
    expect_carried(&pushed);
    // The spring holds until it is stretched by μ_s δ; from there on the push less the kinetic friction.
    let slid = pushed.motion(1, 0.3).velocity.x;
    within("slides", slid / ((0.5 - MU) * STANDARD_GRAVITY * 0.3) - 1.0, 2e-2);
    let [early, late] = [0.1, 0.3].map(|t| pushed.motion(1, t).velocity.x);
    within("acceleration", (late - early) / 0.2 / ((0.5 - MU) * STANDARD_GRAVITY) - 1.0, 1e-6);
}

#[test]
fn friction_of_the_top_stops_what_slides_along_it() {
    let speed = 0.6;
    let history = run(&lying(0.0, speed, 1.0));
    expect_carried(&history);
    let way = speed * speed / (2.0 * MU * STANDARD_GRAVITY);
    within("way", history.motion(1, 1.0).displacement.x / way - 1.0, 5e-3);
    // It swings on the springs of stick, μ_k δ at first.
    within("stands", history.motion(1, 1.0).velocity.x, MU * yields(1.0) * (STIFFNESS / MASS).sqrt());
}

#[test]
fn what_slides_over_the_end_falls_beyond_it() {
    // Its trailing edge leaves the base's end after half of both lengths, and so does its contact.
    let (speed, way) = (2.0_f64, 0.85);
    let left = (speed * speed - 2.0 * MU * STANDARD_GRAVITY * way).sqrt();
    let passed = (speed - left) / (MU * STANDARD_GRAVITY);
    let duration = passed + 0.15;
    let history = run(&lying(0.0, speed, duration));
    expect_carried(&history);
    let last = history.hits().touches().iter().map(|touch| touch.end).fold(0.0, f64::max);
    // Nodes of its edges hold on for a thousandth of the face, 1.2 mm at 1.2 m/s.
    within("leaves the top", last / passed - 1.0, 2.5e-3);
    let motion = history.motion(1, duration);
    within("speed", motion.velocity.x / left - 1.0, 5e-3);
    let fallen = duration - last;
    within("fall", motion.displacement.z + yields(1.0) + 0.5 * STANDARD_GRAVITY * fallen * fallen, 2e-3 * fallen);
}

/// A girder thrown over a fixed one, which it clears by `above` \[m\] at the top of its flight.
fn thrown_over(above: f64) -> Scene {
    let rise = 0.2_f64;
    let up = (2.0 * STANDARD_GRAVITY * rise).sqrt();
    let flight = up / STANDARD_GRAVITY;
    // Highest over the middle of the base, 0.3 m long along x.
    let keys = format!("initial = {{ velocity_m_s = [3.0, 0, {up}] }}\n");
    let place = [-3.0 * flight, 0.0, HEIGHT + above - rise];
    stack(&[girder("base", [0.3, 0.4], [0.0; 3], FIXED), girder("thrown", [0.4, 0.3], place, &keys)], 2.0 * flight)
}

#[test]
fn a_girder_thrown_over_another_lands_beyond_it() {
    // Above the base's ends it is lower than at the top by what it falls in 0.35 m of way.
    let drop = 0.5 * STANDARD_GRAVITY * (0.35_f64 / 3.0).powi(2);
    let clear = run(&thrown_over(drop + 1e-3));
    assert_eq!((clear.overlaps(), clear.hits().touches().len()), (&[][..], 0), "it clears the base");
    within("returns to the height of its start", clear.motion(1, clear.end()).displacement.z, 1e-9);
    let touching = run(&thrown_over(drop - 1e-3));
    expect_carried(&touching);
    assert!(!touching.hits().touches().is_empty(), "a millimetre lower it touches");
}

#[test]
fn a_girder_laid_across_another_rests_on_the_crossings_of_their_edges() {
    // No corner of either is over the other. Square to it, in the middle and off it, and at 50°.
    for (heading, [x, y]) in [(90.0, [0.0, 0.0]), (90.0, [0.07, 0.03]), (50.0, [0.0, 0.0])] {
        let keys = format!("heading_deg = {heading}\n");
        let girders =
            [girder("base", [1.2, 0.3], [0.0; 3], FIXED), girder("across", [1.2, 0.3], [x, y, HEIGHT + 0.005], &keys)];
        let history = run(&stack(&girders, 1.0));
        expect_carried(&history);
        let rest = history.motion(1, 1.0);
        // It tilts on the crossings, 0.15 m from the middle of what is shared, a quarter of K each.
        let tilt = yields(1.0) * y / 0.15_f64.powi(2);
        within("rests", rest.displacement.z + 0.005 + yields(1.0) + tilt * y, 1e-7);
        within("tilt", (rest.attitude * DVec3::Z).truncate().length() - tilt, 1e-5);
        let pressed: f64 = history.contacts().at(1.0).iter().map(|c| c.normal_force * c.normal.z.abs()).sum();
        within("weight", pressed / (MASS * STANDARD_GRAVITY) - 1.0, 1e-3);
    }
}

#[test]
fn a_girder_that_hangs_over_the_side_of_another_rests_on_it() {
    // Half of its width beyond the side: two corners over the base, two crossings, and its weight at the edge between.
    let girders = [
        girder("base", [1.2, 0.3], [0.0; 3], FIXED),
        girder("beside", [0.5, 0.3], [0.05, 0.12, HEIGHT + 0.005], "held = [\"roll\", \"pitch\", \"yaw\"]\n"),
    ];
    let history = run(&stack(&girders, 1.0));
    expect_carried(&history);
    within("rests", history.motion(1, 1.0).displacement.z + 0.005 + yields(1.0), 1e-7);
}

/// Three blocks on each other, the upper two across, each `gap` above the one below \[m\]; the lowest is held. Heights are decimal, so that
/// without a gap rounding leaves some faces behind each other by 1e-17 m and others before.
fn across(gap: f64) -> Scene {
    let block = |name: &str, [length, width, height]: [f64; 3], z: f64, keys: &str| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = {length}\nwidth_m = {width}\nthickness_m = {height}\nmass_kg = 1.5\n\
             position_m = [0, 0, {z:?}]\n{keys}"
        )
    };
    scene(&format!(
        "name = \"across\"\nkind = \"spatial\"\nduration_s = 0.6\n[contact]\nstiffness_n_per_m = 5e4\nrestitution_normal = 0.4\n\
         mu_static = 0.4\nmu_kinetic = 0.3\n{}{}{}",
        block("base", [0.3, 0.2, 0.05], 0.0, FIXED),
        block("middle", [0.12, 0.1, 0.04], 0.045 + gap, ""),
        block("top", [0.2, 0.06, 0.04], 0.085 + 2.0 * gap, ""),
    ))
}

#[test]
fn what_touches_as_placed_lies_on_what_is_below() {
    let sunk = 1.5 * STANDARD_GRAVITY / 5e4;
    let [touching, apart] = [0.0, 1e-9].map(|gap| run(&across(gap)));
    for (girder, weights) in [(1, 2.0), (2, 3.0)] {
        let places = [&touching, &apart].map(|history| history.motion(girder, history.end()).displacement.z);
        within("at rest", places[0] + weights * sunk, 1e-3 * sunk);
        within("as from a nanometre above", places[0] - places[1], 1e-8);
    }
    assert_eq!(touching.hits().count(), apart.hits().count(), "touches of pairs");
    expect_carried(&touching);
}

/// Two decks of these widths \[m\] side by side, which touch as placed up to a gap \[m\], pushed against each other.
fn abreast(widths: [f64; 2], gap: f64) -> Scene {
    let deck = |name: &str, [length, width, height]: [f64; 3], y: f64, push: f64| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = {length}\nwidth_m = {width}\nthickness_m = {height}\nmass_kg = 2.0\n\
             position_m = [0, {y:?}, 0]\npush = {{ force_n = [0, {push:?}, 0] }}\n"
        )
    };
    scene(&format!(
        "name = \"abreast\"\nkind = \"spatial\"\ngravity_m_s2 = 0.0\nduration_s = 0.05\n[contact]\nstiffness_n_per_m = 5e4\n{}{}",
        deck("a", [0.4, widths[0], 0.03], 0.0, 20.0),
        deck("b", [0.2, widths[1], 0.06], 0.5 * (widths[0] + widths[1]) + gap, -20.0),
    ))
}

#[test]
fn decks_that_touch_side_by_side_as_placed_do_not_pass_through_each_other() {
    for widths in [[0.05, 0.17], [0.05, 0.1], [0.1, 0.17], [0.07, 0.19], [0.11, 0.13]] {
        let [touching, apart] = [0.0, 1e-9].map(|gap| run(&abreast(widths, gap)));
        assert!(touching.hits().count() > 0, "{widths:?}: they touch");
        let end = touching.end();
        let places = [&touching, &apart].map(|history| history.motion(0, end).displacement.y);
        within(&format!("{widths:?}"), places[0] - places[1], 1e-7);
        expect_carried(&touching);
    }
}

#[test]
fn the_order_of_girders_in_the_file_does_not_matter_where_a_block_lands_over_an_edge() {
    let base = format!(
        "[[girder]]\nname = \"base\"\nlength_m = 0.3\nwidth_m = 0.2\nthickness_m = 0.05\nmass_kg = 4.0\nposition_m = [0, 0, 0]\n{FIXED}"
    );
    let block = "[[girder]]\nname = \"block\"\nlength_m = 0.12\nwidth_m = 0.1\nthickness_m = 0.04\nmass_kg = 1.5\n\
                 position_m = [-0.02, -0.07, 0.06]\nheading_deg = 14.0\n\
                 initial = { velocity_m_s = [0.16, -0.05, -0.35], roll_deg = -0.2, pitch_deg = 0.6, spin_deg_s = 17.0 }\n";
    let lands = |girders: [&str; 2], own: usize| {
        let history = run(&scene(&format!(
            "name = \"landing\"\nkind = \"spatial\"\nduration_s = 0.15\n[contact]\nstiffness_n_per_m = 5e4\nrestitution_normal = 0.6\n\
             mu_static = 0.0\nmu_kinetic = 0.0\n{}{}",
            girders[0], girders[1]
        )));
        history.motion(own, history.end())
    };
    let (first, second) = (lands([&base, block], 1), lands([block, &base], 0));
    within("place", (first.displacement - second.displacement).length(), 1e-9);
    within("attitude", (first.attitude.xyz() - second.attitude.xyz()).length(), 1e-9);
}
