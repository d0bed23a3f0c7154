//! What the presets promise, run.

use girderbench::scene::presets;
use girderbench::sim::History;

fn run(name: &str) -> History {
    let scene = presets::load(name).unwrap_or_else(|errors| panic!("{errors}"));
    History::of(&scene).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn every_preset_runs_to_its_end_and_every_pair_of_it_pounds() {
    for preset in presets::all() {
        let history = run(preset.name);
        assert_eq!((history.stop(), history.end()), (None, history.scene().duration), "{}", preset.name);
        for pair in history.hits().listed_pairs().into_iter().map(|number| &history.model().pairs[number]) {
            let touches =
                history.events().iter().filter(|e| pair.sites.contains(&e.site()) && e.kind.is_touch()).count();
            assert!(touches > 0, "{}: {} never touches", preset.name, pair.name);
        }
    }
}

#[test]
fn the_flush_free_hit_returns_the_restitution_asked_for() {
    let history = run("flush-free-hit");
    let after = history.motion(0, history.end());
    let ratio = -after.velocity.x / 0.5;
    // The tolerance that the run is computed to is 1e-10 a step, and there are a few dozen steps.
    assert!((ratio - 0.4).abs() < 1e-9, "e_n = 0.4, found {ratio}, off by {:e}", ratio - 0.4);
    assert_eq!((after.spin.z, history.summary().hits), (0.0, 1), "flush: it does not turn, and hits once");
}

#[test]
fn the_straight_girder_hits_twice_a_cycle_at_the_large_input() {
    // The paper, for 0.40 g: two hits in succession each cycle; 24 cycles in 10 s.
    assert_eq!(run("straight-abutment").summary().hits, 48, "docs/physics.md#model-girders, item 1");
}

#[test]
fn the_skewed_girder_of_the_opening_scene_hits_slides_and_turns() {
    let summary = run(presets::OPENING).summary();
    assert!(summary.slip_time > 0.0 && summary.stick_time > 0.0, "sticks and slips: {summary:?}");
    assert!(summary.max_rotation.to_degrees() > 1.0, "turns: {}°", summary.max_rotation.to_degrees());
}
