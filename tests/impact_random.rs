//! Random planar scenes by the impact model: they end, nothing is driven in, energy is accounted for and never made.

use girderbench::contact::{Frame, locate};
use girderbench::scene::{Flush, Kind, ModelKind, Scene};
use girderbench::sim::History;
use girderbench::study::stability::family;

/// Random scenes.
const SEEDS: u64 = 192;
/// Deepest that a point may be found behind a face which it has come to through its polygon, in parts of the face.
const DEEP: f64 = 1e-8;

fn scene(seed: u64) -> Option<Scene> {
    let (_, mut scene) = family::scene(seed);
    if scene.kind == Kind::Spatial || scene.duration > 30.0 {
        return None;
    }
    scene.model.kind = ModelKind::Impact;
    scene.solver.tolerance = 1e-10;
    scene.impact.restitution_normal = [0.0, 1.0, 0.01, 0.4, 0.8][usize::try_from(seed % 5).ok()?];
    scene.impact.restitution_tangential = [-1.0, 1.0, 0.0, -0.9][usize::try_from(seed % 4).ok()?];
    // Past the Painlevé bound there is no answer; that has a test of its own.
    scene.impact.mu_static = scene.contact.mu_static.min(0.4);
    scene.impact.mu_kinetic = scene.contact.mu_kinetic.min(0.4);
    scene.impact.flush = if seed.is_multiple_of(3) { Flush::TwoCorner } else { Flush::Paper };
    Some(scene)
}

#[test]
fn random_scenes_end_and_account_for_their_energy() {
    let (mut run, mut hits, mut stays, mut stopped, mut unbalanced) = (0, 0, 0, Vec::new(), Vec::new());
    for seed in 0..SEEDS {
        let Some(scene) = scene(seed) else { continue };
        let history = History::of(&scene).expect("families make sound scenes");
        let ledger = history.ledger(history.end());
        let record = history.impact().expect("the impact model");
        let scale = ledger.scale.max(f64::MIN_POSITIVE);
        // Pre-loaded scenes keep hardly any energy: a push times the rounding of a place counts in them.
        if ledger.residual.abs() > 1e-5 * scale {
            unbalanced.push((seed, ledger.residual / scale));
        }
        let made = record.hits.iter().map(|hit| -hit.lost).fold(0.0, f64::max);
        assert!(made <= 1e-12 * scale, "seed {seed}: a hit made {made} J");
        let deep = driven_in(&history);
        assert!(deep <= DEEP, "seed {seed}: {deep:e} of a face deep");
        if let Some(stop) = history.stop() {
            stopped.push((seed, stop.clone()));
        }
        run += 1;
        hits += record.hits.len();
        stays += record.stays.len();
    }
    assert!(run > 80 && hits > 5000 && stays > 300, "{run} scenes, {hits} hits, {stays} lasting contacts");
    assert!(unbalanced.is_empty(), "ledgers: {unbalanced:?}");
    // Several contacts with friction at once may have no consistent motion, which ends the run with a word.
    let allowed = |reason: &str| reason.contains("it starts") || reason.contains("several contacts together");
    let early: Vec<_> = stopped.iter().filter(|(_, stop)| !allowed(&stop.reason)).collect();
    assert!(early.is_empty(), "all run to their end: {early:?}");
    assert!(stopped.len() <= 8, "{} stop: {stopped:?}", stopped.len());
}

/// The deepest that a node is behind a face right after a hit there, in parts of the face.
fn driven_in(history: &History) -> f64 {
    let record = history.impact().expect("the impact model");
    let mut deepest = 0.0f64;
    for hit in &record.hits {
        for &site in &hit.sites {
            let site = &history.model().contacts[site];
            let frame = |body: Option<usize>| match body {
                Some(body) => {
                    let m = history.motion(body, hit.t);
                    let state = [m.displacement.x, m.displacement.y, m.theta, m.velocity.x, m.velocity.y, m.spin.z];
                    history.model().bodies[body].planar_frame(&state)
                }
                None => Frame::fixed(site.fixed),
            };
            let here = locate(site.point, &frame(site.node_body), &site.face, &frame(site.face_body));
            deepest = deepest.max(-here.gap / site.face.size());
        }
    }
    deepest
}

#[test]
fn a_corner_that_friction_drives_in_ends_the_run_with_a_word() {
    let (_, mut scene) = family::scene(248);
    scene.model.kind = ModelKind::Impact;
    scene.impact.mu_static = scene.contact.mu_static;
    scene.impact.mu_kinetic = scene.contact.mu_kinetic;
    scene.impact.restitution_normal = 0.4;
    scene.impact.restitution_tangential = -1.0;
    let history = History::of(&scene).expect("a sound scene");
    let stop = history.stop().expect("past the Painlevé bound");
    assert!(stop.reason.contains("Painlevé") && stop.reason.contains("state c"), "{stop:?}");
}
