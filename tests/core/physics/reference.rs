//! The trajectories of an independent program, reproduced: the same places, the same events.

use crate::support::reference::{Case, load};
use crate::support::within;
use girderbench::sim::{EventKind, History};

/// Positions, in parts of their largest value. The program that made them agrees with itself to 1e-10.
const PLACES: f64 = 1e-10;

fn compare(name: &str) {
    let case = load(name);
    let history = History::of(&case.scene).expect("the case is a valid scene");
    assert!(history.stop().is_none(), "{name} runs to its end: {:?}", history.stop());
    places(&case, &history);
    events(&case, &history);
}

fn places(case: &Case, history: &History) {
    for body in 0..case.scene.girders.len() {
        let column = |k: usize| move |row: &Vec<f64>| row[1 + 6 * body + k];
        let largest = |k: usize| case.rows.iter().map(column(k)).fold(0.0f64, |m, v| m.max(v.abs()));
        // x and y share a scale: a component that stays at rounding level has none of its own. Likewise θ.
        let scale = [largest(0).max(largest(1)), largest(0).max(largest(1)), largest(2).max(1e-4)];
        for (k, label) in ["x", "y", "theta"].into_iter().enumerate() {
            let worst = case.rows.iter().map(|row| {
                let motion = history.motion(body, row[0]);
                let value = [motion.displacement.x, motion.displacement.y, motion.theta][k];
                (value - column(k)(row)).abs() / scale[k]
            });
            within(&format!("{} body{body}.{label}", case.name), worst.fold(0.0, f64::max), PLACES);
        }
    }
}

fn events(case: &Case, history: &History) {
    let mut ours: Vec<(f64, String, String)> = history
        .events()
        .iter()
        .filter(|e| e.kind != EventKind::Missed)
        .map(|e| {
            let site = &history.model().sites[e.site()];
            (e.t, format!("{}->{}", site.node, site.face_name), e.kind.label().to_owned())
        })
        .collect();
    let mut theirs = case.events.clone();
    // Events of one instant come in no order.
    let order = |a: &(f64, String, String), b: &(f64, String, String)| {
        ((a.0 * 1e7).round(), &a.1, &a.2).partial_cmp(&((b.0 * 1e7).round(), &b.1, &b.2)).expect("finite")
    };
    ours.sort_by(order);
    theirs.sort_by(order);
    for (a, b) in ours.iter().zip(&theirs) {
        assert!((a.0 - b.0).abs() < 2e-8 && a.1 == b.1 && a.2 == b.2, "{}: {a:?} against {b:?}", case.name);
    }
    assert_eq!(ours.len(), theirs.len(), "{}: number of events", case.name);
}

macro_rules! cases {
    ($($test:ident: $name:literal;)*) => {$(
        #[test]
        fn $test() {
            compare($name);
        }
    )*};
}

cases! {
    a_flush_free_hit: "c01_free_hit";
    an_oblique_free_hit: "c01_free_hit_oblique";
    two_offset_ends: "c01_pair_offset";
    head_on: "c02_headon_040_gap3";
    head_on_elastic: "c03_headon_040_C0";
    straight_at_45_degrees: "c04_straight_45_040";
    skew_45_along_the_axis: "c05_skew45_+0_040";
    skew_60_at_minus_30: "c05_skew60_-30_040";
    a_pair_at_22_5_degrees: "c06_pair_22.5_040";
    a_stick_slip_block_by_the_papers_law: "c07_stickslip_paper";
    a_stick_slip_block_by_return_mapping: "c07_stickslip_retmap";
    skew_45_at_minus_60_by_return_mapping: "c08_skew45_-60_040_retmap";
    a_full_scale_deck: "c09_full60_+0";
    a_record: "c10_record_straight";
}
