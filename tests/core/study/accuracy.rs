//! What the study of work against error measures, held against what theory says: orders of the methods on smooth
//! problems and on contact, errors that fall with the tolerance, references that agree.

use crate::support::within;
use girderbench::study::accuracy::method::{self, Job};
use girderbench::study::accuracy::problem::{self, Problem};
use girderbench::study::accuracy::reference;
use girderbench::study::accuracy::{Answer, Instants, Options, study};

fn problem(name: &str) -> &'static Problem {
    problem::get(name).unwrap_or_else(|| panic!("{name} is a problem"))
}

/// The answer of a method, over `until` seconds of a problem.
fn answer(name: &str, method: &str, setting: f64, until: f64) -> Answer {
    let mut scene = problem(name).scene().unwrap_or_else(|errors| panic!("{errors}"));
    scene.duration = until;
    let instants = Instants { until };
    let method = method::get(method).unwrap_or_else(|| panic!("{method} is a method"));
    let job = Job { scene: &scene, instants, setting };
    method.work(&job).unwrap_or_else(|why| panic!("{why}")).answer(instants)
}

/// The reference of a problem over `until` seconds, and the last instant of the comparison.
fn known(name: &str, until: f64) -> reference::Reference {
    let problem = problem(name);
    let mut scene = problem.scene().unwrap_or_else(|errors| panic!("{errors}"));
    scene.duration = until;
    reference::of(problem.source, &scene).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Displacement errors at several settings.
fn errors(name: &str, method: &str, settings: &[f64], until: f64) -> Vec<f64> {
    let known = known(name, until);
    settings.iter().map(|&s| answer(name, method, s, until).errors(&known.answer, known.last).displacement).collect()
}

/// Observed order between the first and the last of errors at steps halved each time.
fn order(errors: &[f64]) -> f64 {
    (errors[0] / errors[errors.len() - 1]).log2() / (errors.len() - 1) as f64
}

#[test]
fn smooth_problems_show_the_order_in_the_textbook() {
    for problem in ["free-decay", "harmonic-response"] {
        for (method, expected, settings) in [
            ("semi-implicit-euler", 1.0, [4.0, 8.0, 16.0]),
            ("newmark", 2.0, [2.0, 4.0, 8.0]),
            // Small enough steps, errors still far above rounding.
            ("rk4", 4.0, [1.0, 2.0, 4.0]),
        ] {
            let seen = order(&errors(problem, method, &settings, 4.0));
            within(&format!("{problem}, {method}: order less {expected}"), seen - expected, 0.2);
        }
    }
}

#[test]
fn dormand_and_prince_are_of_order_five_in_their_steps() {
    let known = known("harmonic-response", 4.0);
    let at = |tolerance: f64| {
        let answer = answer("harmonic-response", "dormand-prince", tolerance, 4.0);
        (answer.steps as f64, answer.errors(&known.answer, known.last).displacement)
    };
    let ((coarse, large), (fine, small)) = (at(1e-7), at(1e-11));
    // Steps of its own choice: the slope of error against their number, not of a halved step.
    let seen = (large / small).ln() / (fine / coarse).ln();
    within("order less 5", seen - 5.0, 0.4);
}

#[test]
fn contact_takes_the_order_from_steps_that_look_for_no_event() {
    // An elastic hit is a kink of the force somewhere within a step: second order whatever the method's own, third-order
    // luck excluded by taking five steps' worth of halvings. With a dashpot the force jumps: first order.
    for (problem, expected) in [("P1", 2.0), ("P1d", 1.0)] {
        let seen = order(&errors(problem, "rk4", &[4.0, 8.0, 16.0, 32.0, 64.0], 3.0));
        within(&format!("{problem}, rk4: order less {expected}"), seen - expected, 0.6);
    }
    let euler = order(&errors("P1", "semi-implicit-euler", &[8.0, 16.0, 32.0, 64.0], 3.0));
    within("P1, semi-implicit Euler: order less 1", euler - 1.0, 0.4);
}

#[test]
fn the_event_driven_error_falls_with_its_tolerance_to_rounding() {
    for (problem, until) in [("P1", 5.0), ("P1d", 5.0), ("P2k", 3.0), ("block", 2.0)] {
        let errors = errors(problem, "event-driven", &[1e-6, 1e-8, 1e-10, 1e-12], until);
        assert!(errors[0] < 1e-7, "{problem}: 1e-6 gives a tenth of a micrometre, {errors:?}");
        assert!(errors[3] < 1e-12, "{problem}: 1e-12 gives picometres, {errors:?}");
        assert!(errors[0] > 100.0 * errors[2], "{problem}: the error falls, {errors:?}");
    }
}

#[test]
fn two_formulations_that_share_nothing_agree() {
    // The second one steps with an extrapolation of its own; both are at rounding times the number of steps.
    for (name, until) in [("P2", 2.0), ("P2k", 2.0), ("P2h", 2.0), ("skew45", 2.0), ("pair", 2.0), ("record", 8.0)] {
        let known = known(name, until);
        within(&format!("{name}: displacement [m]"), known.agreement.displacement, 1e-12);
        within(&format!("{name}: rotation [rad]"), known.agreement.rotation, 1e-11);
        within(&format!("{name}: peak force"), known.agreement.peak_force, 1e-8);
    }
}

#[test]
fn the_formulations_agree_on_the_deck_in_three_dimensions() {
    let known = known("deck-3d", 2.0);
    assert!(known.answer.peak_force > 1e6, "it hits: {} N", known.answer.peak_force);
    // Metres move, the slip's direction is stiff: parts in 1e10.
    within("displacement [m]", known.agreement.displacement, 1e-9);
    within("peak force", known.agreement.peak_force, 1e-8);
}

#[test]
fn the_formulations_agree_on_girders_on_piers() {
    let known = known("viaduct", 3.0);
    assert!(known.answer.peak_force > 1e5, "it hits: {} N", known.answer.peak_force);
    within("displacement [m]", known.agreement.displacement, 1e-10);
    within("rotation [rad]", known.agreement.rotation, 1e-11);
    within("peak force", known.agreement.peak_force, 1e-8);
}

#[test]
fn the_second_formulation_agrees_with_the_series_in_32_digits() {
    let problem = problem("P1d");
    let mut scene = problem.scene().unwrap_or_else(|errors| panic!("{errors}"));
    scene.duration = 3.0;
    let instants = Instants { until: 3.0 };
    let second = reference::second::answer(&scene, instants).unwrap_or_else(|errors| panic!("{errors}"));
    let errors = second.errors(&known("P1d", 3.0).answer, 2000);
    within("displacement [m]", errors.displacement, 1e-13);
    within("peak force", errors.peak_force, 1e-10);
}

#[test]
fn a_study_writes_every_measurement_into_its_table_and_page() {
    let problems = [problem("free-decay")];
    let methods = [method::all()[0], method::all()[2]];
    let study = study(&problems, &methods, Options { repeat: 1, quick: true }, &mut |_| ())
        .unwrap_or_else(|errors| panic!("{errors}"));
    let rows = study.parts[0].rows.len();
    assert!(rows >= 4, "two tolerances and several steps: {rows}");
    assert_eq!(study.csv().lines().count(), rows + 1, "a head and a line each");
    let page = study.page(&girderbench::study::Occasion::default(), "svg");
    assert!(page.contains("![free-decay: error against time](free-decay.svg)"), "the plot is on the page");
    let (name, plot) = &study.plots()[0];
    let svg = plot.svg();
    assert!(name == "free-decay" && svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "a plot");
    assert!(svg.contains("event-driven") && svg.contains("order 4"), "lines and slopes are named");
}

#[test]
fn elastic_bars_agree_with_closed_form_and_spectral_elements() {
    // They agree up to what the polynomials leave, of degree 24 and 16: waves with kinks converge like a power of the degree.
    let bars = known("F1", 0.05);
    within("F1: displacement [m]", bars.agreement.displacement, 1e-6);
    within("F1: peak force", bars.agreement.peak_force, 2e-3);
    let deck = known("F2", 3.0);
    assert!(deck.answer.peak_force > 1e7, "it hits: {} N", deck.answer.peak_force);
    within("F2: displacement [m]", deck.agreement.displacement, 1e-6);
    within("F2: peak force", deck.agreement.peak_force, 1e-4);
}

#[test]
fn newmarks_steps_with_elements_are_of_order_two_without_a_touch_and_less_across_touches() {
    // The deck comes to its abutment at 0.93 s.
    let seen = order(&errors("F2", "newmark-elements", &[1.0, 2.0, 4.0], 0.9));
    within("F2 before its touch: order less 2", seen - 2.0, 0.2);
    let across = order(&errors("F2", "newmark-elements", &[1.0, 2.0, 4.0, 8.0, 16.0], 4.0));
    assert!((0.7..2.6).contains(&across), "F2 across touches: order {across}");
    let kinks = order(&errors("F1", "newmark-elements", &[1.0, 2.0, 4.0], 0.05));
    assert!((0.7..2.8).contains(&kinks), "F1, whose kinks no damping smooths: order {kinks}");
}
