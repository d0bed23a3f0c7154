//! A ramp: a corner that meets an oblique side and slides along it, against the momentum of the whole run in closed form.

use girderbench::scene::Scene;
use glam::DVec3;

use super::{BODY, damping_ratio, expect_carried, velocity};
use crate::support::{run, scene, within};

/// Direction of the ramp's axis \[°\], push along x \[N\], speed at the start \[m/s\], and friction.
const RAMP: f64 = 60.0;
const PUSH: f64 = 20.0;
const SPEED: f64 = 0.3;
const MU: f64 = 0.15;
const STIFFNESS: f64 = 1e6;
const RESTITUTION: [f64; 2] = [0.1, 0.9];

/// A girder that cannot turn is pushed along x against the side of one, 1 m long, that is held.
fn ramp(kind: &str, stiffness: f64, duration: f64) -> Scene {
    let (upright, [n, t]) = (if kind == "spatial" { ", \"z\", \"roll\", \"pitch\"" } else { "" }, RESTITUTION);
    scene(&format!(
        "name = \"ramp\"\nkind = \"{kind}\"\ngravity_m_s2 = 0.0\nduration_s = {duration}\n[contact]\nstiffness_n_per_m = {stiffness:e}\n\
         restitution_normal = {n}\nrestitution_tangential = {t}\nmu_static = 0.2\nmu_kinetic = {MU}\n[solver]\ntolerance = 1e-10\n\
         [[girder]]\nname = \"ram\"\n{BODY}held = [\"yaw\"{upright}]\npush = {{ force_n = [{PUSH}, 0] }}\n\
         initial = {{ velocity_m_s = [{SPEED}, 0] }}\n\
         [[girder]]\nname = \"ramp\"\nlength_m = 1.0\nwidth_m = 0.1\nthickness_m = 0.02\nmass_kg = 2.0\nposition_m = [0.3, 0.2, 0.0]\n\
         heading_deg = {RAMP}\nheld = [\"x\", \"y\", \"yaw\"{upright}]\n"
    ))
}

/// Outward normal of the side that is met, and the direction along it in which the corner slides.
fn directions() -> [DVec3; 2] {
    let angle = RAMP.to_radians();
    [DVec3::new(-angle.sin(), angle.cos(), 0.0), DVec3::new(angle.cos(), angle.sin(), 0.0)]
}

/// The corner slides from its first touch to the end. Over the run the normal impulse is that of push and approach; friction is
/// `μ K δ`, so that the impulse `C_n δ` of the normal dashpot at the penetration `δ` of the end has none, and the tangential
/// dashpot has stretched the spring by `μ δ`.
fn speed_along(stiffness: f64, duration: f64) -> f64 {
    let [normal, along] = directions();
    let (mass, push, start) = (2.0, PUSH * DVec3::X, SPEED * DVec3::X);
    let deep = -push.dot(normal) / stiffness;
    let [c_n, c_t] = RESTITUTION.map(|e| 2.0 * damping_ratio(e) * (stiffness * mass / 2.0).sqrt());
    let pressed = -(push * duration + mass * start).dot(normal) - c_n * deep;
    (start + push * duration / mass).dot(along) - MU * (pressed + c_t * deep) / mass
}

#[test]
fn a_corner_slides_along_an_oblique_side_as_on_an_inclined_plane() {
    for kind in ["planar", "spatial"] {
        let history = run(&ramp(kind, STIFFNESS, 0.2));
        expect_carried(&history);
        let [normal, along] = directions();
        let slid = velocity(&history, 0);
        within("across", slid.dot(normal), 1e-9);
        within("along", slid.dot(along) - speed_along(STIFFNESS, 0.2), 1e-7);
        let way = history.motion(0, 0.2).displacement;
        assert!(way.dot(along) > 0.03, "{kind}: it slides: {way}");
    }
}

/// Speed along the ramp at the end, beyond that of the slide and the flight after it \[m/s\].
fn gained_at_the_end(kind: &str, stiffness: f64) -> f64 {
    let history = run(&ramp(kind, stiffness, 0.8));
    expect_carried(&history);
    let left = history.hits().touches().iter().map(|touch| touch.end).fold(0.0, f64::max);
    assert!(left > 0.6 && left < 0.7, "{kind}: it leaves the ramp: {left}");
    let flown = DVec3::X * PUSH / 2.0 * (0.8 - left);
    (velocity(&history, 0) - flown).dot(directions()[1]) - speed_along(stiffness, left)
}

#[test]
fn a_corner_that_slides_past_the_end_of_the_ramp_flies_on() {
    // Where the corners pass, the ramp's is in the girder's end for as long as it takes to pass the overlap F/K, and is pushed by
    // the dashpot, C of √K: an impulse that falls as 1/√K.
    for kind in ["planar", "spatial"] {
        let [soft, hard] = [1e6, 1e8].map(|stiffness| gained_at_the_end(kind, stiffness));
        within("soft", soft, 1e-2);
        within("a tenth of it", hard / soft - 0.1, 2e-3);
    }
}
