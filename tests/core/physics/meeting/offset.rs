//! Neighbours whose ends overlap by half: two equal girders, the second shifted by half a width, in space by half a height too.
//!
//! Turned by 180° about the centre of the overlap each is where the other was, so that both turn alike and the gap is the same
//! all over the overlap: one oscillator with the mobility of both girders at that centre.

use girderbench::scene::Scene;
use girderbench::sim::History;
use glam::DVec3;

use super::{BODY, damping_ratio, expect_carried, momenta, restitution};
use crate::support::{run, scene, within};

const SPEED: f64 = 0.5;
const WIDTH: f64 = 0.07;
const HEIGHT: f64 = 0.02;

fn offset(kind: &str, stiffness: f64, [y, z]: [f64; 2]) -> Scene {
    scene(&format!(
        "name = \"offset\"\nkind = \"{kind}\"\ngravity_m_s2 = 0.0\nduration_s = 0.05\n[contact]\nstiffness_n_per_m = {stiffness:e}\n\
         restitution_normal = 0.6\nmu_static = 0.0\nmu_kinetic = 0.0\n[solver]\ntolerance = 1e-10\n\
         [[girder]]\nname = \"one\"\n{BODY}initial = {{ velocity_m_s = [{SPEED}, 0] }}\n\
         [[girder]]\nname = \"two\"\n{BODY}position_m = [0.2, {y}, {z}]\n"
    ))
}

/// Velocity along x and angular velocity of the first girder after the hit, for a touch too short to turn by.
fn after([y, z]: [f64; 2]) -> (f64, DVec3) {
    // A straight prism has a diagonal tensor of inertia.
    let squares = DVec3::new(0.19, WIDTH, HEIGHT).powf(2.0) / 12.0;
    let gyration2 = DVec3::splat(squares.element_sum()) - squares;
    let lever = DVec3::new(0.095, 0.5 * y, 0.5 * z).cross(-DVec3::X);
    let mobility = 2.0 * (1.0 + lever.dot(lever / gyration2)) / 2.0;
    let returned = restitution(damping_ratio(0.6) * mobility.sqrt());
    let impulse = (1.0 + returned) * SPEED / mobility;
    (SPEED - impulse / 2.0, impulse / 2.0 * lever / gyration2)
}

/// Difference from [`after`], velocity in parts of the speed and spin in those of the spin.
fn miss(history: &History, shift: [f64; 2]) -> f64 {
    expect_carried(history);
    let (velocity, spin) = after(shift);
    // Later a girder that turns about two axes precesses.
    let parted = history.hits().touches().iter().map(|touch| touch.end).fold(0.0, f64::max);
    let motion = history.motion(0, parted);
    let spun = (motion.spin - spin).length() / spin.length();
    spun.max((motion.velocity.x - velocity).abs() / SPEED)
}

#[test]
fn ends_that_overlap_by_half_answer_as_one_oscillator_at_the_middle_of_the_overlap() {
    let cases = [
        ("planar", [0.5 * WIDTH, 0.0]),
        ("spatial", [0.5 * WIDTH, 0.0]),
        ("spatial", [0.0, 0.5 * HEIGHT]),
        ("spatial", [0.5 * WIDTH, 0.5 * HEIGHT]),
        ("spatial", [-0.25 * WIDTH, 0.5 * HEIGHT]),
    ];
    for (kind, shift) in cases {
        let [soft, hard] = [1e6, 1e8].map(|stiffness| miss(&run(&offset(kind, stiffness, shift)), shift));
        // The girders turn by the time of the touch, which falls with the root of the stiffness.
        within("short touch", hard, 1e-3);
        assert!(hard < 0.2 * soft || soft < 1e-6, "{kind}, {shift:?}: {soft} and ten times as short {hard}");
    }
}

#[test]
fn both_girders_turn_alike_and_keep_their_momentum() {
    for (kind, shift) in [("planar", [0.5 * WIDTH, 0.0]), ("spatial", [0.5 * WIDTH, 0.5 * HEIGHT])] {
        let history = run(&offset(kind, 1e6, shift));
        let [one, two] = [0, 1].map(|girder| history.motion(girder, history.end()));
        within("spin", (one.spin - two.spin).length() / one.spin.length(), 1e-9);
        let [before, after] = [0.0, history.end()].map(|t| momenta(&history, t));
        within("momentum", (after.0 - before.0).length(), 1e-12);
    }
}
