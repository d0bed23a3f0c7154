//! Runs that end early because they would take too much: the bound that is exceeded, and the word that says so.

use girderbench::dynamics::Model;
use girderbench::scene::{Bearings, PerDirection, Scene, presets};
use girderbench::sim::{History, Session};

/// Why a run ends early, and when \[s\].
fn ended(history: &History) -> (f64, String) {
    let stop = history.stop().expect("it ends early");
    assert_eq!(history.end(), stop.t, "what is computed stays");
    (stop.t, stop.reason.to_string())
}

fn deck(change: impl Fn(&mut girderbench::scene::SharedBearings)) -> Scene {
    let mut scene = presets::load("deck-30m").expect("a preset");
    match &mut scene.girders[0].bearings {
        Some(Bearings::Shared(bearings)) => change(bearings),
        other => panic!("{other:?}"),
    }
    scene
}

#[test]
fn bearings_far_too_fast_for_a_long_run_end_it_at_once() {
    let across = deck(|bearings| bearings.frequency_hz = PerDirection::Both(1e5));
    let all = deck(|bearings| {
        (bearings.frequency_hz, bearings.vertical_frequency_hz) = (PerDirection::Both(1e5), Some(1e5));
    });
    for scene in [across, all] {
        let history = History::of(&scene).expect("a sound scene");
        let (t, reason) = ended(&history);
        assert!(t < 1.0, "after a twentieth of the run at the latest: {t} s");
        assert!(reason.contains("at this pace the run would take") && reason.contains("a bearing"), "{reason}");
    }
}

#[test]
fn a_run_that_takes_more_memory_than_it_may_ends_and_says_so() {
    let scene = presets::load("deck-30m").expect("a preset");
    let memory_bytes = 1 << 20;
    let model = Model { memory_bytes, ..Model::compile(&scene).expect("a scene") };
    let mut session = Session::of_model(&scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    let (t, reason) = ended(&history);
    assert!(t > 0.1 && t < scene.duration, "on the way: {t} s");
    assert!(reason.contains("MiB, more than the 1 MiB that a run may take"), "{reason}");
    // Looked at every 4096 steps, of less than 1 KiB each.
    assert!(history.bytes() < memory_bytes + (4 << 20), "{} bytes", history.bytes());
}
