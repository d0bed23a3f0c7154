//! Leaving one face for another: past the end of a short wall and back against its side.

use girderbench::scene::Scene;
use girderbench::sim::History;

use super::{BODY, expect_carried};
use crate::support::{run, scene, within};

const MASS: f64 = 2.0;
const STIFFNESS: f64 = 1e6;
const RESTITUTION: f64 = 0.6;
/// Pushes towards the wall and back along it \[N\], speed along it \[m/s\].
const PUSH: [f64; 2] = [2.0, -4.0];
const SPEED: f64 = 0.7;
/// Half the widths of the wall and of the girder \[m\].
const HALVES: f64 = 0.05 + 0.035;

/// A girder that cannot turn lies against a wall 0.1 m wide, moves along it past its end, and is pushed back.
fn short_wall(kind: &str, duration: f64) -> Scene {
    let upright = if kind == "spatial" { ", \"z\", \"roll\", \"pitch\"" } else { "" };
    scene(&format!(
        "name = \"short wall\"\nkind = \"{kind}\"\ngravity_m_s2 = 0.0\nduration_s = {duration}\n[contact]\nstiffness_n_per_m = {STIFFNESS}\n\
         restitution_normal = {RESTITUTION}\nmu_static = 0.0\nmu_kinetic = 0.0\n[solver]\ntolerance = 1e-10\n\
         [[girder]]\nname = \"deck\"\n{BODY}held = [\"yaw\"{upright}]\npush = {{ force_n = [{}, {}] }}\n\
         initial = {{ velocity_m_s = [0, {SPEED}], displacement_m = [{}, 0] }}\n\
         [[abutment]]\nname = \"wall\"\nfaces = \"deck\"\ngap_m = 0.0\nwidth_m = 0.1\nheight_m = 0.06\ndepth_m = 0.5\n",
        PUSH[0],
        PUSH[1],
        PUSH[0] / STIFFNESS
    ))
}

/// When the lateral way of the girder is `way`, on the way out and on the way back \[s\].
fn passes(way: f64) -> [f64; 2] {
    let back = -PUSH[1] / MASS;
    let root = (SPEED * SPEED - 2.0 * back * way).sqrt();
    [(SPEED - root) / back, (SPEED + root) / back]
}

fn forces(history: &History, t: f64) -> f64 {
    history.contacts().at(t).iter().map(|contact| contact.force.dot(contact.normal)).sum()
}

/// Until when a node of the wall's edge holds on to the girder that has left it: a thousandth of the face \[s\].
fn slack(kind: &str, speed: f64) -> f64 {
    if kind == "spatial" { 1.1e-3 * 0.1_f64.hypot(0.06) / speed } else { 1e-9 }
}

#[test]
fn a_girder_goes_round_the_end_of_a_wall_and_comes_back_against_its_side() {
    for kind in ["planar", "spatial"] {
        let [out, back] = passes(HALVES);
        let history = run(&short_wall(kind, back + 0.2));
        expect_carried(&history);
        let late = slack(kind, history.motion(0, out).velocity.y);
        // Pressed by the push, then free, when its last corner has passed the edge.
        within("pressed", forces(&history, out - 1e-6) - PUSH[0], 1e-9);
        within("free", forces(&history, out + late + 1e-6), 0.0);
        let ends = history.hits().touches().iter().filter(|touch| touch.start < out).map(|touch| touch.end);
        within("leaves the front", ends.fold(0.0, f64::max) - out, late);
        // Past the wall it is pushed on beside it, by less than the push while nodes of the edge hold on.
        let flown = back - out;
        let deep = history.motion(0, back).displacement.x;
        let free = PUSH[0] / STIFFNESS + 0.5 * PUSH[0] / MASS * flown * flown;
        within("beside the wall", deep - free, 1e-9 + late * PUSH[0] / MASS * flown);
        let hit = history
            .hits()
            .touches()
            .iter()
            .map(|touch| touch.start)
            .find(|&start| start > out)
            .expect("the side is hit");
        within("meets the side", hit - back, 1e-9);
    }
}

#[test]
fn what_a_girder_meets_later_does_not_change_how_it_leaves_a_wall_before() {
    // Until it comes back against the side, contact between all faces adds nothing to the corners and edges of facing ones.
    let [_, back] = passes(HALVES);
    let [short, long] = [0.9 * back, back + 0.2].map(|duration| run(&short_wall("spatial", duration)));
    assert_eq!([&short, &long].map(|history| history.model().bodies_met().len()), [0, 1], "they meet later");
    let [a, b] = [&short, &long].map(|history| history.motion(0, 0.9 * back));
    within("place", (a.place - b.place).length(), 1e-12);
    within("velocity", (a.velocity - b.velocity).length(), 1e-12);
}

#[test]
fn the_side_of_the_wall_returns_the_restitution() {
    for kind in ["planar", "spatial"] {
        let [_, back] = passes(HALVES);
        let history = run(&short_wall(kind, back + 0.2));
        let parted = history
            .hits()
            .touches()
            .iter()
            .filter(|touch| touch.start >= back - 1e-6)
            .map(|touch| touch.end)
            .fold(f64::INFINITY, f64::min);
        let speed = |t: f64| history.motion(0, t).velocity.y;
        // The push against the wall adds to the approach during the touch: v² of the hit by the depth that it goes further.
        let ratio = -speed(parted) / speed(back);
        within("restitution", ratio - RESTITUTION, 1e-2);
    }
}
