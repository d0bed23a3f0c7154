//! Spatial trajectories of an independent program, at several tolerances: the answers converge to its own and to one another,
//! and a run's estimated error is its error.

use crate::support::reference::rows;
use crate::support::{run, scene, within};
use girderbench::sim::{Comparison, ErrorEstimate, History};
use glam::DVec3;

const TOLERANCES: [f64; 4] = [1e-6, 1e-8, 1e-10, 1e-12];

/// The case at a tolerance.
fn at(name: &str, tolerance: f64) -> History {
    let text = std::fs::read_to_string(format!("tests/data/spatial/{name}.toml")).expect("a scene of the tests' data");
    let mut scene = scene(&text);
    scene.solver.tolerance = tolerance;
    run(&scene)
}

/// Largest distance of G from the samples, and its largest displacement \[m\].
fn apart(history: &History, samples: &[Vec<f64>]) -> [f64; 2] {
    let place = |row: &[f64]| DVec3::from_slice(&row[1..4]);
    let home = history.model().bodies[0].home;
    samples.iter().fold([0.0; 2], |[far, size], row| {
        let off = (history.motion(0, row[0]).place - place(row)).length();
        [far.max(off), size.max((place(row) - home).length())]
    })
}

/// Against the samples, which are good to `trusted` of the motion.
fn converges(name: &str, trusted: f64) {
    let samples = rows(&format!("spatial/{name}"));
    let answers = TOLERANCES.map(|tolerance| at(name, tolerance));
    let [.., finest] = &answers;
    for (history, tolerance) in answers.iter().zip(TOLERANCES) {
        let [far, size] = apart(history, &samples);
        within(&format!("{name} at {tolerance:e}: off the samples"), far / size, 0.1 * tolerance + trusted);
        assert_eq!(history.events().len(), finest.events().len(), "{name} at {tolerance:e}: the same events");
    }
    for (history, tolerance) in answers.iter().zip(TOLERANCES).take(3) {
        let [error, estimate] = [Comparison::of(history, finest).of_all().place, ErrorEstimate::of(history).error];
        assert!(
            estimate > 0.5 * error && estimate < 2.0 * error + 1e-13,
            "{name} at {tolerance:e}: {estimate:e} m estimated of {error:e} m"
        );
    }
}

#[test]
fn a_corner_on_bearings_and_gravity_at_a_leaning_wall() {
    converges("s2b-corner-bearings", 1e-10);
}

#[test]
fn four_smooth_nodes() {
    converges("s3b-flush-skew", 1e-10);
}

#[test]
fn a_node_that_slides_throughout_in_two_directions() {
    converges("s4-slip-r", 1e-10);
}

#[test]
fn a_pressed_face_that_sticks_and_slips_in_two_directions() {
    converges("s5c-pressed-r", 1e-7);
}

#[test]
fn a_pressed_face_under_law_paper() {
    let samples = rows("spatial/s5c-pressed-p");
    for tolerance in TOLERANCES {
        let [far, size] = apart(&at("s5c-pressed-p", tolerance), &samples);
        within(&format!("at {tolerance:e}"), far / size, 3.0 * tolerance + 1e-9);
    }
}
