//! Observations of the paper (section 2(4), 3(3), 4(3)), each as checks of our runs of the same cases under both models.
//!
//! Nothing is fitted: the runs are those of the presets, and what the paper leaves open is scanned beside them
//! (`scan`).

pub mod rules;
mod verdict;

pub use verdict::{Check, Outcome, Verdict};

use super::cases::girder::{self, HALF_LENGTH};
use super::cases::{Case, Shaking, Specimen};
use super::results::{MODELS, Results};
use crate::contact::damping_ratio;
use crate::scene::presets;

/// A finding of the paper.
#[derive(Clone, Debug)]
pub struct Finding {
    /// Number in the report.
    pub number: usize,
    /// In a few words.
    pub title: &'static str,
    /// Observation of the paper.
    pub paper: &'static str,
    /// Under each model, in the order of [`MODELS`]; one where the model plays no part.
    pub verdicts: Vec<Verdict>,
    /// Names of the scans that show what it depends on.
    pub scans: &'static [&'static str],
}

impl Finding {
    /// Whether it is of the earthquake, El Centro or what stands for it.
    pub fn of_earthquake(&self) -> bool {
        self.number == EARTHQUAKE
    }

    /// Name of the model of a verdict; a finding of one verdict is no model's.
    pub fn model(&self, verdict: usize) -> &'static str {
        let names = ["contact model", "impact model"];
        if self.verdicts.len() == 1 { "both models" } else { names.get(verdict).copied().unwrap_or_default() }
    }
}

/// Number of the finding of the earthquake.
const EARTHQUAKE: usize = 6;

/// Period of the straight girder's sine \[s\].
fn period() -> f64 {
    1.0 / Specimen::Straight.sine_hz()
}

/// Half a period of the model girder on the spring of the contact, with its dashpot: how long a head-on hit lasts \[s\].
fn hit_time() -> f64 {
    let damping = damping_ratio(girder::RESTITUTION);
    std::f64::consts::PI / ((girder::STIFFNESS / girder::MASS).sqrt() * (1.0 - damping * damping).sqrt())
}

/// Checks of one finding under one model; none where a run is missing.
type Judge = fn(&Results, usize) -> Option<Vec<Check>>;

/// Title, what the paper saw, how it is judged, scans.
type Entry = (&'static str, &'static str, Judge, &'static [&'static str]);

const FINDINGS: [Entry; 9] = [
    (
        "Head-on sine: one hit or two",
        "Driven along the axis, the straight girder hits once a cycle at the small amplitude and twice in succession at the \
         large one.",
        head_on,
        &["hits-0.23g", "hits-0.40g"],
    ),
    (
        "Straight girder hit obliquely",
        "At small angles it is displaced across with almost no rotation (Fig. 9a); at large angles one corner hits first, then \
         the other (Fig. 9b).",
        oblique,
        &["end-movement-friction", "end-movement-legs", "end-movement-tangential"],
    ),
    (
        "45° against 60°",
        "Driven along the axis, the 45° girder turns a lot, the 60° girder hardly (Fig. 10).",
        skew,
        &["skew-friction", "skew-gap", "skew-legs", "skew-stiffness"],
    ),
    (
        "Leaving the axis",
        "The 60° girder turns more as the excitation leaves the axis (Fig. 11).",
        angle,
        &["axis-gap", "axis-legs", "skew-angle"],
    ),
    (
        "Restitution",
        "Displacements hardly depend on the coefficients of restitution (section 4(3)a, after a study of the authors').",
        restitution,
        &[],
    ),
    (
        "El Centro",
        "Both patterns of hits appear head-on (Fig. 16); obliquely the girder turns less than under the sine and there is no \
         sliding rotation (Fig. 18).",
        earthquake,
        &["record-hits", "record-rotation"],
    ),
    (
        "Sliding rotation",
        "The straight girder driven by the sine at 45° slides along the wall on a corner while it turns (Fig. 17).",
        sliding_rotation,
        &[],
    ),
    ("Transverse velocity", "The transverse velocity shows no visible jump at a hit (section 3(3)b).", jump, &[]),
    (
        "Two girders",
        "The rotations of the two girders are tiny (Fig. 26).",
        pair,
        &["pair-rotation", "pair-tangential"],
    ),
];

/// Every finding, as far as there are runs.
pub fn findings(results: &Results) -> Vec<Finding> {
    let finding = |(number, (title, paper, judge, scans)): (usize, Entry)| {
        let verdict = |model| Verdict { checks: judge(results, model).unwrap_or_default() };
        Finding { number: number + 1, title, paper, verdicts: (0..MODELS.len()).map(verdict).collect(), scans }
    };
    let mut all: Vec<Finding> = FINDINGS.into_iter().enumerate().map(finding).collect();
    all.push(Finding {
        number: all.len() + 1,
        title: "Rotation condition (6)",
        paper: "a0 sin 2β / (2 b0) is 1.18 for the 60° girder and 1.35 for the 45° one (printed): both can turn.",
        verdicts: vec![Verdict { checks: condition().unwrap_or_default() }],
        scans: &[],
    });
    all
}

fn straight(angle: f64, shaking: Shaking) -> Case {
    Case::new(Specimen::Straight, angle, shaking)
}

fn head_on(results: &Results, model: usize) -> Option<Vec<Check>> {
    let seen = |shaking| results.of(&straight(0.0, shaking), model);
    Some(rules::head_on(seen(Shaking::Small)?, seen(Shaking::Large)?, period()))
}

fn oblique(results: &Results, model: usize) -> Option<Vec<Check>> {
    let seen = |angle| results.of(&straight(angle, Shaking::Large), model);
    rules::oblique(seen(22.5)?, seen(67.5)?, HALF_LENGTH, period())
}

fn skew(results: &Results, model: usize) -> Option<Vec<Check>> {
    let seen = |specimen| results.of(&Case::new(specimen, 0.0, Shaking::Large), model);
    Some(rules::skew(seen(Specimen::Skew60)?, seen(Specimen::Skew45)?))
}

fn angle(results: &Results, model: usize) -> Option<Vec<Check>> {
    let turned = |&angle: &f64| {
        Some((angle, results.of(&Case::new(Specimen::Skew60, angle, Shaking::Large), model)?.rotation()))
    };
    rules::leaving_the_axis(&Specimen::Skew60.angles().iter().map(turned).collect::<Option<Vec<_>>>()?)
}

fn restitution(results: &Results, model: usize) -> Option<Vec<Check>> {
    Some(rules::restitution(&results.series.as_ref()?.models[model]))
}

fn earthquake(results: &Results, model: usize) -> Option<Vec<Check>> {
    let seen = |angle, shaking| results.of(&straight(angle, shaking), model);
    let (head_on, oblique) = (seen(0.0, Shaking::Record)?, seen(45.0, Shaking::Record)?);
    Some(rules::earthquake(head_on, oblique, seen(45.0, Shaking::Large)?, period(), hit_time()))
}

fn sliding_rotation(results: &Results, model: usize) -> Option<Vec<Check>> {
    Some(rules::sliding_rotation(results.of(&straight(45.0, Shaking::Large), model)?, hit_time()))
}

fn jump(results: &Results, model: usize) -> Option<Vec<Check>> {
    rules::transverse_jump(results.of(&straight(45.0, Shaking::Large), model)?)
}

fn pair(results: &Results, model: usize) -> Option<Vec<Check>> {
    Some(rules::tiny_rotations(results.of(&Case::new(Specimen::Pair, 22.5, Shaking::Large), model)?, HALF_LENGTH))
}

fn condition() -> Option<Vec<Check>> {
    let number = |name| Some(presets::load(name).ok()?.girders.first()?.prism().rotation_number());
    Some(rules::rotation_condition(number("skew60-abutment")?, number("skew45-abutment")?))
}
