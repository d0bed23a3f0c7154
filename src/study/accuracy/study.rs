//! The study itself: every chosen method on every chosen problem, swept over its setting.

use super::answer::INTERVALS;
use super::method::{Job, Method, SettingKind};
use super::problem::Problem;
use super::reference::{self, Reference};
use super::{Errors, Instants};
use crate::scene::{Scene, SceneErrors};
use crate::study::clock::fastest;

/// A sweep of steps ends with the first run that takes longer than this \[s\].
const LONGEST: f64 = 1.0;
/// That limit in a quick study \[s\].
const LONGEST_QUICK: f64 = 0.05;
/// Most steps to an interval of comparison, as a power of two.
const FINEST: u32 = 12;

/// Settings of a study.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Runs that are timed, after a warm-up.
    pub repeat: usize,
    /// Fewer settings, shorter sweeps.
    pub quick: bool,
}

/// One method on one problem at one setting.
#[derive(Clone, Debug)]
pub struct Row {
    /// The problem's name.
    pub problem: &'static str,
    /// The method's name.
    pub method: &'static str,
    /// A tolerance, or a step \[s\].
    pub setting: f64,
    /// Whether `setting` is a step.
    pub is_step: bool,
    /// Steps; 0 where the method does not count them.
    pub steps: usize,
    /// Least time of a run \[s\].
    pub seconds: f64,
    /// Runs that were timed.
    pub runs: usize,
    /// Errors against the reference; nothing when there is no answer.
    pub errors: Option<Errors>,
    /// Note: the reason of a missing result, steps refused, iterations that did not converge.
    pub note: String,
}

/// A problem with its reference and its rows.
#[derive(Debug)]
pub struct Part {
    /// The problem.
    pub problem: &'static Problem,
    /// Reference of the errors.
    pub reference: Reference,
    /// Duration of the run, and end of its comparison \[s\].
    pub until: (f64, f64),
    /// Girders in it.
    pub girders: usize,
    /// Largest displacement in the reference \[m\].
    pub largest: f64,
    /// The measurements, by method.
    pub rows: Vec<Row>,
}

/// Everything that was measured.
#[derive(Debug)]
pub struct Study {
    /// Problem by problem.
    pub parts: Vec<Part>,
}

/// Measures; `said` is called with the name of the next run.
///
/// # Errors
/// A scene that does not validate.
pub fn study(
    problems: &[&'static Problem],
    methods: &[&'static dyn Method],
    options: Options,
    said: &mut dyn FnMut(&str),
) -> Result<Study, SceneErrors> {
    let mut parts = Vec::new();
    for problem in problems {
        said(&format!("{}: the reference", problem.name));
        let scene = problem.scene()?;
        let reference = reference::of(problem.source, &scene)?;
        let mut rows = Vec::new();
        for method in methods.iter().filter(|method| method.knows(&scene)) {
            said(&format!("{}: {}", problem.name, method.name()));
            sweep(problem, *method, &scene, &reference, options, &mut rows);
        }
        let until = (scene.duration, Instants { until: scene.duration }.at(reference.last));
        let largest = reference.answer.largest();
        parts.push(Part { problem, reference, until, girders: scene.girders.len(), largest, rows });
    }
    Ok(Study { parts })
}

/// The settings of a kind, coarse to fine.
fn settings(setting_kind: SettingKind, quick: bool) -> Vec<f64> {
    let tolerance = |n: i32| 10.0_f64.powi(-n);
    match (setting_kind, quick) {
        (SettingKind::Tolerance, false) => (4..=13).map(tolerance).collect(),
        (SettingKind::Tolerance, true) => [6, 10].map(tolerance).to_vec(),
        (SettingKind::StepsPerInterval, _) => (0..=FINEST).map(|n| f64::from(1_u32 << n)).collect(),
    }
}

fn sweep(
    problem: &'static Problem,
    method: &'static dyn Method,
    scene: &Scene,
    reference: &Reference,
    options: Options,
    rows: &mut Vec<Row>,
) {
    let longest = if options.quick { LONGEST_QUICK } else { LONGEST };
    for setting in settings(method.setting_kind(), options.quick) {
        let row = measure(problem, method, scene, setting, reference, options.repeat);
        let seconds = row.seconds;
        rows.push(row);
        if seconds > longest {
            return;
        }
    }
}

/// Times a method, then measures its error.
fn measure(
    problem: &'static Problem,
    method: &'static dyn Method,
    scene: &Scene,
    setting: f64,
    reference: &Reference,
    repeat: usize,
) -> Row {
    let instants = Instants { until: scene.duration };
    let job = Job { scene, instants, setting };
    let timed = fastest(repeat, || method.work(&job));
    let is_step = method.setting_kind() == SettingKind::StepsPerInterval;
    let mut row = Row {
        problem: problem.name,
        method: method.name(),
        setting: if is_step { scene.duration / (INTERVALS as f64 * setting) } else { setting },
        is_step,
        steps: 0,
        seconds: timed.seconds,
        runs: timed.runs,
        errors: None,
        note: String::new(),
    };
    match timed.value {
        Err(why) => row.note = why,
        Ok(work) => {
            let answer = work.answer(instants);
            let errors = answer.errors(&reference.answer, reference.last);
            (row.steps, row.note) = (answer.steps, answer.note);
            row.errors = errors.displacement.is_finite().then_some(errors);
        }
    }
    row
}
