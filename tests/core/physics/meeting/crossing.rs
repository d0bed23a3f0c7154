//! Crossing: a girder thrown at an angle into the middle of another's side. The impulse of one corner with friction is known
//! where the touch is too short to turn by.

use std::f64::consts::PI;

use girderbench::scene::Scene;
use girderbench::sim::History;
use glam::DVec3;

use super::{BODY, damping_ratio, expect_carried, momenta, restitution, site_sharers};
use crate::support::{run, scene, within};

const SPEED: f64 = 0.5;
/// So fast along the side that the slide keeps its direction while the corner is pressed \[m/s\].
const ALONG: f64 = 1.0;
const MU: f64 = 0.1;

/// A girder that lies along x and one that comes from above it (y), its axis `heading` degrees from x.
fn crossing(kind: &str, stiffness: f64, [heading, lateral]: [f64; 2]) -> Scene {
    let upright = if kind == "spatial" { "held = [\"z\", \"roll\", \"pitch\"]\n" } else { "" };
    scene(&format!(
        "name = \"crossing\"\nkind = \"{kind}\"\ngravity_m_s2 = 0.0\nduration_s = 0.12\n[contact]\nstiffness_n_per_m = {stiffness:e}\n\
         restitution_normal = 0.6\nrestitution_tangential = 1.0\nmu_static = {MU}\nmu_kinetic = {MU}\n[solver]\ntolerance = 1e-10\n\
         [[girder]]\nname = \"lying\"\n{BODY}{upright}[[girder]]\nname = \"thrown\"\n{BODY}{upright}\
         position_m = [-0.06, {lateral}, 0.0]\nheading_deg = {heading}\ninitial = {{ velocity_m_s = [{ALONG}, {}] }}\n",
        -SPEED * lateral.signum()
    ))
}

/// Impulses on the thrown girder along the side's normal and along the side \[N·s\], from the limit of a short touch.
fn impulses(history: &History) -> [f64; 2] {
    let touch = &history.hits().touches()[0];
    let pair = history.model().sites[touch.contact].pair;
    let node = history.contacts().contact_at(touch.contact, touch.start + 1e-7).expect("closed").point;
    let (m, i2) = (2.0, history.model().bodies[0].gyration2);
    let arms = [0, 1].map(|girder| node - history.motion(girder, touch.start).place);
    // Velocity along an axis at the point by a unit impulse along another; the girder slides towards +x.
    let mobility =
        |a: DVec3, b: DVec3| arms.iter().map(|arm| (a.dot(b) + arm.cross(a).z * arm.cross(b).z / i2) / m).sum::<f64>();
    let (normal, along) = (DVec3::Y, DVec3::X);
    let (w_n, w_ns) = (mobility(normal, normal), mobility(normal, along));
    let driven = w_n - MU * w_ns;
    // In space the edge of the corner has a node at its top and one at its foot.
    let nodes = site_sharers(history, pair, touch.start) / history.hits().touches().len() as f64;
    let returned = restitution(damping_ratio(0.6) * w_n / (nodes * 2.0 / m * driven).sqrt());
    let normal = (1.0 + returned) * SPEED / driven;
    [normal, -MU * normal]
}

/// Largest difference between the velocity of the thrown girder and the limit, in parts of its speed.
fn miss(history: &History) -> f64 {
    let [normal, along] = impulses(history);
    let motion = history.motion(1, history.end());
    let change = 2.0 * (motion.velocity - DVec3::new(ALONG, -SPEED, 0.0));
    (change - DVec3::new(along, normal, 0.0)).length() / (2.0 * SPEED)
}

#[test]
fn a_corner_with_friction_gives_the_impulse_of_a_short_touch() {
    for kind in ["planar", "spatial"] {
        let [soft, hard] = [1e6, 1e8].map(|stiffness| run(&crossing(kind, stiffness, [55.0, 0.17])));
        for history in [&soft, &hard] {
            expect_carried(history);
            let [before, after] = [0.0, history.end()].map(|t| momenta(history, t));
            within("momentum", (after.0 - before.0).length(), 1e-12);
        }
        // The girders turn by the time of the touch, which falls with the root of the stiffness.
        let [soft, hard] = [&soft, &hard].map(miss);
        within("short touch", hard, 1e-3);
        within("ten times as short", hard / soft - 0.1, 0.03);
    }
}

#[test]
fn crossing_from_the_other_side_is_the_mirror_image() {
    for kind in ["planar", "spatial"] {
        let [above, below] = [[55.0, 0.17], [-55.0, -0.17]].map(|from| run(&crossing(kind, 1e6, from)));
        expect_carried(&below);
        for girder in [0, 1] {
            let [a, b] = [&above, &below].map(|history| history.motion(girder, history.end()));
            within("place", (a.place - b.place * DVec3::new(1.0, -1.0, 1.0)).length(), 1e-12);
            within("velocity", (a.velocity - b.velocity * DVec3::new(1.0, -1.0, 1.0)).length(), 1e-10);
            within("turn", a.theta + b.theta, 1e-10);
            assert!(a.theta.abs() > 1e-2 && a.theta.abs() < PI, "it turns: {}", a.theta);
        }
    }
}

#[test]
fn a_girder_square_to_the_middle_of_a_longer_one_does_not_turn_it() {
    // Flush: both corners of the end in one instant, at the whole restitution.
    for kind in ["planar", "spatial"] {
        let mut scene = crossing(kind, 1e6, [90.0, 0.17]);
        scene.girders[1].position[0] = 0.0;
        scene.girders[1].initial.velocity[0] = 0.0;
        let history = run(&scene);
        expect_carried(&history);
        let [a, b] = [0, 1].map(|girder| history.motion(girder, history.end()));
        within("restitution", (b.velocity.y - a.velocity.y) / SPEED - 0.6, 1e-8);
        within("turn", a.theta.abs() + b.theta.abs(), 1e-10);
    }
}
