//! Random planar scenes by the impact model: they end, nothing is driven in, energy is accounted for and never made.

use girderbench::contact::{Frame, locate};
use girderbench::dynamics::impact2d::lasting::constrained_motion::FrictionMode;
use girderbench::dynamics::impact2d::{GirderState, LastingInterval, Transition};
use girderbench::scene::{Flush, Kind, ModelKind, Scene};
use girderbench::sim::History;
use girderbench::study::stability::family;

use crate::support::within;

/// Random scenes with moderate friction, and with friction far past the Painlevé bound.
const SEEDS: [u64; 2] = [110, 80];
/// The most friction in each.
const FRICTION: [f64; 2] = [0.4, 2.0];
/// Deepest that a point may be found behind a face which it has come to through its polygon, in parts of the face.
const DEEP: f64 = 1e-8;
/// Energy that is none, in girders of kilograms to tonnes \[J\].
const LITTLE: f64 = 1e-9;

fn scene(seed: u64, most: f64) -> Option<Scene> {
    let (_, mut scene) = family::scene(seed);
    if scene.kind == Kind::Spatial || scene.duration > 30.0 {
        return None;
    }
    scene.model.kind = ModelKind::Impact;
    scene.solver.tolerance = 1e-10;
    scene.impact.restitution_normal = [0.0, 1.0, 0.01, 0.4, 0.8][usize::try_from(seed % 5).ok()?];
    scene.impact.restitution_tangential = [-1.0, 1.0, 0.0, -0.9][usize::try_from(seed % 4).ok()?];
    scene.impact.mu_static = scene.contact.mu_static.min(most);
    scene.impact.mu_kinetic = scene.contact.mu_kinetic.min(most);
    scene.impact.flush = if seed.is_multiple_of(3) { Flush::TwoCorner } else { Flush::Paper };
    Some(scene)
}

#[test]
fn random_scenes_end_and_account_for_their_energy() {
    let [run, hits, stays] = examine(SEEDS[0], FRICTION[0]);
    assert!(run > 50 && hits > 2500 && stays > 150, "{run} scenes, {hits} hits, {stays} lasting contacts");
}

#[test]
fn random_scenes_with_any_friction_end_and_account_for_their_energy() {
    let [run, hits, stays] = examine(SEEDS[1], FRICTION[1]);
    assert!(run > 35 && hits > 1500 && stays > 100, "{run} scenes, {hits} hits, {stays} lasting contacts");
}

/// Runs that many scenes; scenes, hits and lasting contacts.
fn examine(seeds: u64, most: f64) -> [usize; 3] {
    let (mut counts, mut unbalanced) = ([0; 3], Vec::new());
    for seed in 0..seeds {
        let Some(scene) = scene(seed, most) else { continue };
        let history = History::of(&scene).expect("families make sound scenes");
        let ledger = history.energy().ledger(history.end());
        let record = history.impact().expect("the impact model");
        let scale = ledger.scale.max(f64::MIN_POSITIVE);
        // Pre-loaded scenes keep hardly any energy: a push times the rounding of a place counts in them.
        if ledger.residual.abs() > (1e-5 * scale).max(LITTLE) {
            unbalanced.push((seed, ledger.residual, scale));
        }
        let made = record.hits.iter().map(|hit| -hit.impulses.lost).fold(0.0, f64::max);
        assert!(made <= 1e-12 * scale, "seed {seed}: a hit made {made} J");
        let deep = driven_in(&history);
        assert!(deep <= DEEP, "seed {seed}: {deep:e} of a face deep");
        // Who starts inside another cannot be computed; everybody else comes to the end.
        let early = history.stop().filter(|stop| !stop.reason.to_string().contains("it starts"));
        assert!(early.is_none(), "seed {seed}: {early:?}");
        for (count, more) in counts.iter_mut().zip([1, record.hits.len(), record.lasting.len()]) {
            *count += more;
        }
    }
    assert!(unbalanced.is_empty(), "ledgers: {unbalanced:?}");
    counts
}

/// The deepest that a node is behind a face right after a hit there, in parts of the face.
fn driven_in(history: &History) -> f64 {
    let record = history.impact().expect("the impact model");
    let mut deepest = 0.0f64;
    for hit in &record.hits {
        for &site in &hit.sites {
            let site = &history.model().sites[site];
            let frame = |body: Option<usize>| match body {
                Some(body) => {
                    let m = history.motion(body, hit.t);
                    let state = [m.displacement.x, m.displacement.y, m.theta, m.velocity.x, m.velocity.y, m.spin.z];
                    history.model().bodies[body].planar_frame(&state)
                }
                None => Frame::fixed(site.fixed),
            };
            let here = locate(&site.geometry, &frame(site.node_body), &frame(site.face_body));
            deepest = deepest.max(-here.gap / site.face.size());
        }
    }
    deepest
}

/// What slips once others are stopped, a stick of which only the reactions of least norm leave the cone, one that had ended beside other
/// modes, and a row of five that friction presses into each other.
#[test]
fn contacts_for_which_no_modes_are_found_at_first_keep_their_friction() {
    for (seed, most) in [(82, 2.0), (414, 2.0), (337, 2.0), (142, 0.4)] {
        let history = History::of(&scene(seed, most).expect("in plan")).expect("families make sound scenes");
        let record = history.impact().expect("the impact model");
        let words = history.contacts().without_friction();
        assert!(words.is_none(), "seed {seed}: {words:?}");
        let is_wedged = |interval: &&LastingInterval| interval.modes.iter().any(|m| m.friction == FrictionMode::Wedged);
        for interval in record.lasting.iter().filter(is_wedged) {
            let middle = interval.from.midpoint(interval.until);
            for &body in &interval.bodies {
                within("at rest while wedged [m/s]", history.motion(body, middle).velocity.length(), 1e-12);
            }
            for contact in history.contacts().at(middle) {
                let along = contact.tangential_force.length();
                assert!(along <= contact.mu_static * contact.normal_force * (1.0 + 1e-9), "in the cone: {contact:?}");
            }
        }
        assert_eq!(record.lasting.iter().any(|interval| is_wedged(&interval)), seed == 414, "wedged in seed 414");
    }
}

#[test]
fn a_corner_that_friction_drives_in_is_stopped_at_once() {
    let (_, mut scene) = family::scene(248);
    scene.model.kind = ModelKind::Impact;
    scene.impact.mu_static = scene.contact.mu_static;
    scene.impact.mu_kinetic = scene.contact.mu_kinetic;
    scene.impact.restitution_normal = 0.4;
    scene.impact.restitution_tangential = -1.0;
    let history = History::of(&scene).expect("a sound scene");
    assert!(history.stop().is_none(), "it goes on: {:?}", history.stop());
    let record = history.impact().expect("the impact model");
    let scale = history.energy().ledger(history.end()).scale;
    // The second impulse of a hit leaves the corner sliding; nothing agrees with that, and friction stops it.
    let stops = |change: &&Transition| change.from == GirderState::SlidingTurning && change.lost > 1e-6 * scale;
    let turns = |change: &Transition| change.to == GirderState::Turning;
    let stopped: Vec<&Transition> = record.transitions.iter().filter(stops).collect();
    assert!(stopped.into_iter().any(turns), "a slide is stopped, and that takes energy");
    // No energy is added, and the ledger knows what was lost.
    assert!(record.transitions.iter().all(|change| change.lost >= -1e-9 * scale), "never gained");
    assert!(history.energy().ledger(history.end()).residual.abs() <= 1e-8 * scale, "accounted for");
}
