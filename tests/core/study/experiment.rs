//! The paper's experiment: verdicts on histories made by hand, and a few cases as they are run.

use girderbench::study::experiment::findings::{Check, Outcome, Verdict, findings, rules};
use girderbench::study::experiment::{
    Case, Earthquake, GirderSeen, HitSeen, Observed, Results, Shaking, Specimen, Stretch, Unit, report,
};

/// Period of the sine of a history made by hand \[s\].
const PERIOD: f64 = 0.5;
const HALF_LENGTH: f64 = 0.095;

fn hit(from: f64, corners: [Option<f64>; 2]) -> HitSeen {
    HitSeen { from, until: from + 0.01, corners, jump: [0.4, 0.0] }
}

/// Twenty cycles with hits at these times after the beginning of each.
fn cycles(hits: &[f64]) -> Observed {
    let of_cycle = |cycle: usize| hits.iter().map(move |t| hit(PERIOD * cycle as f64 + t, [None; 2]));
    Observed { end: 20.0 * PERIOD, hits: (0..20).flat_map(of_cycle).collect(), ..Observed::default() }
}

/// A girder with these largest x and y \[m\] and θ \[rad\].
fn moved(largest: [f64; 3]) -> Observed {
    let girder = GirderSeen { largest, late_rotation: largest[2], fastest: [1.0, 1.0], ..GirderSeen::default() };
    Observed { girders: vec![girder], ..Observed::default() }
}

fn held(checks: &[Check]) -> Vec<bool> {
    checks.iter().map(|check| check.holds).collect()
}

#[test]
fn a_finding_comes_out_with_all_of_its_checks_and_in_part_with_some() {
    let outcome = |holds: &[bool]| {
        let checks = holds.iter().map(|&holds| Check::new("claim", "found", holds)).collect();
        Verdict { checks }.outcome()
    };
    assert_eq!(outcome(&[true, true]), Outcome::ComesOut, "all");
    assert_eq!(outcome(&[true, false]), Outcome::InPart, "one");
    assert_eq!(outcome(&[false, false]), Outcome::DoesNot, "none");
    assert_eq!(outcome(&[]), Outcome::Open, "nothing was run");
}

#[test]
fn hits_less_than_half_a_period_apart_are_in_succession() {
    let (one, two) = (cycles(&[0.1]), cycles(&[0.1, 0.2]));
    assert_eq!(held(&rules::head_on(&one, &two, PERIOD)), [true, true], "as the paper saw it");
    assert_eq!(held(&rules::head_on(&two, &one, PERIOD)), [false, false], "the other way round");
    let three = [0.0, 0.2, 0.2 + 0.01 + 0.5 * PERIOD + 1e-9].map(|t| hit(t, [None; 2]));
    let sizes: Vec<usize> = rules::successions(&three, PERIOD).iter().map(|hits| hits.len()).collect();
    assert_eq!(sizes, [2, 1], "the third half a period after the end of the second");
    let nothing = Observed { end: 10.0, ..Observed::default() };
    assert_eq!(held(&rules::head_on(&nothing, &nothing, PERIOD)), [false, false], "no hit at all");
    assert_eq!(
        [rules::hits_a_cycle(&one, PERIOD), rules::hits_a_cycle(&two, PERIOD)],
        [Some(1.0), Some(2.0)],
        "counted"
    );
}

#[test]
fn one_irregular_cycle_among_the_last_ten_is_enough_to_fail() {
    let mut seen = cycles(&[0.1]);
    seen.hits.insert(16, hit(PERIOD * 15.0 + 0.3, [None; 2]));
    assert_eq!(held(&rules::head_on(&seen, &cycles(&[0.1, 0.2]), PERIOD)), [false, true], "two in the sixteenth");
    let mut early = cycles(&[0.1]);
    early.hits.insert(3, hit(PERIOD * 2.0 + 0.3, [None; 2]));
    assert_eq!(held(&rules::head_on(&early, &cycles(&[0.1, 0.2]), PERIOD)), [true, true], "in the third: the start");
}

#[test]
fn an_oblique_hit_is_judged_by_its_ends_and_its_corners() {
    // 5 mrad move an end of 95 mm by 0.475 mm, less than a tenth of 5 mm.
    let (mut near, mut far) = (moved([0.02, 0.005, 0.005]), moved([0.01, 0.02, 0.01]));
    near.end = 10.0;
    far.hits = vec![hit(1.0, [Some(1.0), None]), hit(1.05, [None, Some(1.05)])];
    let checks = rules::oblique(&near, &far, HALF_LENGTH, PERIOD).expect("girders");
    assert_eq!(held(&checks), [true; 4], "as the paper saw it: {checks:?}");
    far.hits = vec![hit(1.0, [Some(1.0), Some(1.0005)])];
    near.girders[0].largest = [0.02, 0.005, 0.02];
    let checks = rules::oblique(&near, &far, HALF_LENGTH, PERIOD).expect("girders");
    assert_eq!(held(&checks), [true, false, false, false], "turns, and both corners within a frame: {checks:?}");
    assert!(checks[3].found.contains("0.50 ms"), "{checks:?}");
    assert!(rules::oblique(&Observed::default(), &far, HALF_LENGTH, PERIOD).is_none(), "nothing was seen");
}

#[test]
fn more_is_not_much_more() {
    let turned = |theta: f64| moved([0.0, 0.0, theta]);
    assert_eq!(held(&rules::skew(&turned(0.01), &turned(0.025))), [true; 4], "two and a half times");
    assert_eq!(held(&rules::skew(&turned(0.01), &turned(0.015))), [true, false, true, false], "half as much again");
    let mut late = turned(0.009);
    late.girders[0].late_rotation = 0.03;
    assert_eq!(held(&rules::skew(&turned(0.01), &late)), [false, false, true, true], "after the start alone");
}

#[test]
fn both_sides_of_the_axis_count() {
    let both = [(-60.0, 0.04), (-15.0, 0.01), (0.0, 0.02), (60.0, 0.03)];
    assert_eq!(held(&rules::leaving_the_axis(&both).expect("an axis")), [true, true], "more on both sides");
    let one = [(-60.0, 0.04), (0.0, 0.02), (15.0, 0.01), (60.0, 0.0)];
    assert_eq!(held(&rules::leaving_the_axis(&one).expect("an axis")), [true, false], "on one side");
    assert!(rules::leaving_the_axis(&[(-60.0, 0.04)]).is_none(), "nothing to compare with");
}

#[test]
fn restitution_is_judged_by_the_worst_case_and_not_by_what_never_moves() {
    let steady = vec![[0.010, 0.0, 0.01], [0.011, 0.0, 0.02]];
    let checks = rules::restitution(std::slice::from_ref(&steady));
    assert_eq!(held(&checks), [true, true, false], "10 %, none, 100 %: {checks:?}");
    let wild = vec![[0.010, 0.001, 0.01], [0.013, 0.001, 0.01]];
    assert_eq!(held(&rules::restitution(&[steady, wild])), [false, true, false], "30 % in the other");
}

#[test]
fn sliding_rotation_has_to_outlast_a_hit() {
    let mut seen = moved([0.0, 0.0, 0.01]);
    let stretch = |from: f64, until: f64, letter: char| Stretch { from, until, letter };
    seen.girders[0].states = vec![stretch(0.0, 1.0, 'a'), stretch(1.0, 1.02, 'c'), stretch(1.02, 1.5, 'e')];
    assert_eq!(held(&rules::sliding_rotation(&seen, 0.012)), [true], "20 ms against 12");
    assert_eq!(held(&rules::sliding_rotation(&seen, 0.03)), [false], "against 30; e is not c");
    let (one, two) = (cycles(&[0.1]), cycles(&[0.1, 0.2]));
    let mut mixed = one.clone();
    mixed.hits.insert(1, hit(0.2, [None; 2]));
    let judge =
        |head_on: &Observed, hit: f64| held(&rules::earthquake(head_on, &seen, &moved([0.0, 0.0, 0.02]), PERIOD, hit));
    assert_eq!(judge(&mixed, 0.03), [true, true, true], "both patterns, half the rotation, no slide");
    assert_eq!(judge(&one, 0.012), [false, true, false], "single hits alone, and a slide");
    assert_eq!(judge(&two, 0.03), [false, true, true], "successions alone");
}

#[test]
fn jumps_and_rotations_are_judged_against_the_motion() {
    let mut seen = moved([0.01, 0.01, 0.001]);
    seen.hits = vec![HitSeen { jump: [1.5, 0.05], ..HitSeen::default() }];
    assert_eq!(held(&rules::transverse_jump(&seen).expect("a girder")), [true], "a twentieth");
    seen.hits.push(HitSeen { jump: [0.1, 0.11], ..HitSeen::default() });
    assert_eq!(held(&rules::transverse_jump(&seen).expect("a girder")), [false], "more than a tenth");
    assert_eq!(held(&rules::tiny_rotations(&seen, HALF_LENGTH)), [true], "0.0095 of 10 mm");
    assert_eq!(held(&rules::tiny_rotations(&seen, 2.0)), [false], "0.2 of 10 mm");
    assert_eq!(held(&rules::rotation_condition(1.175, 1.357)), [true, true], "as printed, to its last digit");
    assert_eq!(held(&rules::rotation_condition(1.175, 0.9)), [true, false], "cannot turn");
}

fn run(case: Case, results: &mut Results) {
    let (unit, earthquake) = (Unit::Case(case), Earthquake::synthetic(1.0));
    let text = unit.run(&earthquake).expect("a case of the study is valid");
    let fingerprint = unit.fingerprint(&earthquake).expect("valid");
    assert!(unit.take(&text, &fingerprint, results), "its own result");
    let louder = unit.fingerprint(&Earthquake::synthetic(2.0)).expect("valid");
    let of_record = case.shaking == Shaking::Record;
    assert_eq!(louder != fingerprint, of_record, "the earthquake is part of what a record case is the result of");
    assert!(!unit.take(&text, "another", &mut Results::default()), "of something else");
    assert!(!unit.take(&text[..text.len() / 2], &fingerprint, &mut Results::default()), "half a file");
}

#[test]
fn head_on_hits_come_out_under_both_models_and_the_rest_is_open() {
    let mut results = Results::default();
    for shaking in Shaking::ALL {
        run(Case::new(Specimen::Straight, 0.0, shaking), &mut results);
    }
    for model in 0..2 {
        let seen = results.of(&Case::new(Specimen::Straight, 0.0, Shaking::Large), model).expect("it was run");
        assert!(seen.rotation() < 1e-9 && seen.girders[0].largest[1] < 1e-12, "it goes straight: {model}");
        // v_x turns round at a hit with e = 0.4: the jump is 1.4 times the approach, which is at most the largest speed.
        let fastest = seen.girders[0].fastest[0];
        let jumps: Vec<f64> = seen.hits.iter().map(|hit| hit.jump[0]).collect();
        let largest = jumps.iter().copied().fold(0.0, f64::max);
        assert!(largest > 1.2 * fastest && largest < 1.6 * fastest, "{model}: {largest} of {fastest} m/s");
        let states: Vec<_> = seen.girders[0].states.iter().map(|stretch| stretch.letter).collect();
        assert!(states.iter().all(|&letter| "bef".contains(letter)), "never turning: {states:?}");
        let covered: f64 = seen.girders[0].states.iter().map(Stretch::length).sum();
        assert!((covered - seen.end).abs() < 1e-9, "states cover the run: {covered} of {} s", seen.end);
    }
    let all = findings(&results);
    let outcomes = |number: usize| all[number - 1].verdicts.iter().map(Verdict::outcome).collect::<Vec<_>>();
    assert_eq!(outcomes(1), [Outcome::ComesOut; 2], "one hit, then two");
    assert_eq!(outcomes(3), [Outcome::Open; 2], "the skewed girders were not run");
    assert_eq!(outcomes(10), [Outcome::ComesOut], "(6) needs no run");
}

#[test]
fn the_page_of_the_experiment_states_what_is_found() {
    let (mut results, earthquake) = (Results::default(), Earthquake::synthetic(1.0));
    for unit in Unit::all().iter().filter(|unit| !matches!(unit, Unit::Scan(_))) {
        let needed = match unit {
            Unit::Case(case) if case.specimen == Specimen::Straight => true,
            Unit::Case(case) => case.shaking == Shaking::Large,
            _ => true,
        };
        if needed {
            let text = unit.run(&earthquake).expect("valid");
            assert!(unit.take(&text, &unit.fingerprint(&earthquake).expect("valid"), &mut results), "its own");
        }
    }
    let page = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/experiment.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let table = report::markdown(&results);
    assert_eq!(table.lines().count(), 2 + 2 * (2 + 4 + 4 + 2 + 3 + 3 + 1 + 1 + 2) + 2, "every check: {table}");
    for line in table.lines() {
        assert!(page.contains(line), "docs/experiment.md: {line}");
    }
}

#[test]
fn the_pair_pushes_both_ways_and_units_have_names_of_their_own() {
    let mut results = Results::default();
    let case = Case::new(Specimen::Pair, 22.5, Shaking::Large);
    run(case, &mut results);
    for model in 0..2 {
        let seen = results.of(&case, model).expect("it was run");
        assert_eq!(seen.girders.len(), 2, "two girders");
        assert!(seen.stopped.is_none() && seen.hits.len() > 20, "a hit a cycle at least: {}", seen.hits.len());
        assert!(seen.hits.iter().all(|hit| hit.corners != [None; 2]), "each hit has a corner");
    }
    let names: std::collections::BTreeSet<String> = Unit::all().iter().map(Unit::name).collect();
    assert_eq!(names.len(), Unit::all().len(), "one file each");
    assert!(Unit::KINDS.iter().all(|kind| !names.contains(*kind)), "a kind is no name");
}
