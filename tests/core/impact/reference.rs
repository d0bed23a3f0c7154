//! The trajectories of an independent program of the rigid-body impact model, reproduced: the same places, the same hits.

use crate::support::reference::{Case, load};
use crate::support::within;
use girderbench::sim::History;

/// Positions, in parts of their largest value. The program that made them agrees with itself to 1e-10.
const PLACES: f64 = 1e-8;

fn compare(name: &str) {
    let case = load(name);
    let history = History::of(&case.scene).expect("the case is a valid scene");
    assert!(history.stop().is_none(), "{name} runs to its end: {:?}", history.stop());
    hits(&case, &history);
    places(&case, &history);
    let ledger = history.energy().ledger(history.end());
    within(&format!("{name} ledger"), ledger.residual.abs() / ledger.scale, 1e-12);
}

fn places(case: &Case, history: &History) {
    let column = |k: usize| move |row: &Vec<f64>| row[1 + k];
    let largest = |k: usize| case.rows.iter().map(column(k)).fold(0.0f64, |m, v| m.max(v.abs()));
    // x and y share a scale: a component that stays at rounding level has none of its own. Likewise θ.
    let plan = largest(0).max(largest(1));
    for (k, scale, label) in [(0, plan, "x"), (1, plan, "y"), (2, largest(2).max(1e-4), "theta")] {
        let worst = case.rows.iter().map(|row| {
            let motion = history.motion(0, row[0]);
            let value = [motion.displacement.x, motion.displacement.y, motion.theta][k];
            (value - column(k)(row)).abs() / scale
        });
        within(&format!("{} {label}", case.name), worst.fold(0.0, f64::max), PLACES);
    }
}

fn hits(case: &Case, history: &History) {
    let record = history.impact().expect("the impact model computed it");
    let mass = case.scene.girders[0].mass;
    for (ours, theirs) in record.hits.iter().zip(&case.hits) {
        let [normal, tangential] = ours.impulses.first.map(|p| p / mass);
        assert!(
            (ours.t - theirs.t).abs() < 2e-9
                && ours.is_flush() == theirs.flush
                && (normal - theirs.impulse[0]).abs() < 1e-8
                && (tangential - theirs.impulse[1]).abs() < 1e-8,
            "{}: {ours:?} against {theirs:?}",
            case.name
        );
    }
    assert_eq!(record.hits.len(), case.hits.len(), "{}: number of hits", case.name);
}

#[test]
fn head_on() {
    compare("i02_headon_040");
}

#[test]
fn straight_at_45_degrees() {
    compare("i04_straight_45_040");
}

#[test]
fn skew_45_along_the_axis() {
    compare("i05_skew45_+0_040");
}

#[test]
fn skew_60_at_minus_30() {
    compare("i05_skew60_-30_040");
}

#[test]
fn the_head_on_girder_is_right_to_rounding() {
    use girderbench::study::accuracy::{Answer, Instants, problem, reference};
    let problem = problem::get("P3").expect("the study knows it");
    let scene = problem.scene().expect("a sound scene");
    let exact = reference::of(problem.source, &scene).expect("a sound scene");
    let history = History::of(&scene).expect("a sound scene");
    let answer = Answer::of(&history, Instants { until: scene.duration });
    let errors = answer.errors(&exact.answer, exact.last);
    // 25 hits on a path of 30 mm; a hit found a hair behind the face would show as 1e-13 and more.
    assert!(errors.displacement < 1e-14 && errors.rotation == 0.0, "{errors:?}");
}
