//! Warnings where a scene lies outside the domain in which the program is checked, where an answer does not balance, and where supports drift apart.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;

use super::console::Console;
use super::digits::six;
use super::summary::name;
use crate::language::{Text, said};
use crate::scene::Scene;
use crate::scene::domain::{BesideGirder, Departure, beside_girders, outside};
use crate::scene::seating::{self, BeyondCap};
use crate::scene::shown::escaped;
use crate::sim::History;
use crate::sim::moving_ground::{MovedSupport, drifting};
use crate::study::sweep::Plan;
use crate::tables::Report;

/// So many warnings are written out; a row of a thousand girders in the wrong unit would fill a screen with one fault.
const MOST_WARNINGS: usize = 10;

/// Warns on standard error of every quantity that lies outside and notes what the run does not use, a line each; the exit status does not
/// change.
pub(super) fn warn(scene: &Scene, console: &mut Console) {
    let found = outside(scene);
    for departure in found.iter().take(MOST_WARNINGS) {
        console.note(&said!("warning", "what" => departure.to_string()));
    }
    if let Some(more) = found.len().checked_sub(MOST_WARNINGS).filter(|more| *more > 0) {
        console.note(&said!("warning-more-outside", "more" => more));
    }
    off_their_seats(scene, console);
    let unused = scene.unused_values();
    for words in unused.iter().take(MOST_WARNINGS) {
        console.note(&said!("note", "words" => words.to_string()));
    }
    if let Some(more) = unused.len().checked_sub(MOST_WARNINGS).filter(|more| *more > 0) {
        console.note(&said!("note", "words" => said!("more", "count" => more)));
    }
}

/// Most runs of a sweep whose scenes are looked at, spread over all of them where there are more: a second's work.
const MOST_RUNS: usize = 2000;

/// Warns of quantities that lie outside in runs of a sweep where its scene itself lies inside: in how many of those looked at, and the first.
pub(super) fn warn_of_runs(plan: &Plan, console: &mut Console) {
    let key = |departure: &Departure| (departure.place.clone(), departure.limit.quantity.as_str());
    let known: BTreeSet<_> = outside(&plan.scene).iter().map(key).collect();
    let looked_at: Vec<usize> = (0..plan.runs()).step_by(plan.runs().div_ceil(MOST_RUNS).max(1)).collect();
    // A combination that makes no scene is reported when its run comes.
    let of_run = |run: &usize| plan.scene_of(*run).map_or(Vec::new(), |scene| outside(&scene));
    let all: Vec<Vec<Departure>> = looked_at.par_iter().map(of_run).collect();
    let mut found: BTreeMap<_, (usize, Departure)> = BTreeMap::new();
    for departure in all.into_iter().flatten().filter(|departure| !known.contains(&key(departure))) {
        found.entry(key(&departure)).or_insert((0, departure)).0 += 1;
    }
    for (count, first) in found.into_values().take(MOST_WARNINGS) {
        let what = said!("sweep-outside", "count" => count, "runs" => looked_at.len(), "first" => first.to_string());
        console.note(&said!("warning", "what" => what));
    }
}

/// Warns of bearings that do not stand on the seats that the scene gives.
fn off_their_seats(scene: &Scene, console: &mut Console) {
    for (girder, off) in seating::all_off(scene).into_iter().take(MOST_WARNINGS) {
        let words = said!("off-seats", "girder" => escaped(girder), "bearings" => numbers(&off));
        console.note(&said!("warning", "what" => words));
    }
    for BeyondCap { pier, ends, length, cap } in seating::beyond_caps(scene).into_iter().take(MOST_WARNINGS) {
        let ends = ends.join(", ");
        let (pier, ends) = (escaped(pier), escaped(&ends));
        let words =
            said!("seat-beyond-cap", "pier" => pier, "ends" => ends, "length" => six(length), "cap" => six(cap));
        console.note(&said!("warning", "what" => words));
    }
    for BesideGirder { key, girder, by } in beside_girders(scene).into_iter().take(MOST_WARNINGS) {
        let words = said!("device-beside", "key" => escaped(&key), "girder" => escaped(&girder), "by" => six(by));
        console.note(&said!("warning", "what" => words));
    }
}

fn numbers(numbers: &[usize]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// Warns of an answer whose estimated error is large; the exit status does not change.
pub(super) fn warn_of_error(report: &Report, console: &mut Console) {
    if let Some(words) = report.uncertain() {
        console.note(&said!("warning", "what" => format!("{}: {words}", name(&report.scene))));
    }
}

/// Warns where the energy ledger of an answer does not balance, and where contacts of the impact model went on without friction; the exit
/// status does not change.
pub(super) fn warn_of_balance(history: &History, console: &mut Console) {
    if let Some(words) = history.contacts().without_friction() {
        console.note(&said!("warning", "what" => format!("{}: {words}", name(&history.scene().name))));
    }
    let balance = history.energy().balance();
    if !balance.holds() {
        let remedy = Text::new("warning-untrusted");
        console.note(&said!(
            "warning-balance",
            "name" => name(&history.scene().name),
            "balance" => balance.to_string(),
            "remedy" => remedy
        ));
    }
}

/// Warns of supports that the ends of records leave moving against the ground of reference, a line each.
pub(super) fn warn_of_drift(supports: &[MovedSupport], console: &mut Console) {
    let drifting = drifting(supports);
    for words in drifting.iter().take(MOST_WARNINGS) {
        console.note(&said!("warning-drift", "words" => words.as_str()));
    }
    if let Some(more) = drifting.len().checked_sub(MOST_WARNINGS).filter(|more| *more > 0) {
        console.note(&said!("warning-more-drift", "more" => more));
    }
}
