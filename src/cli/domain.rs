//! Warnings where a scene lies outside the domain in which the program is checked, where an answer does not balance, and where supports drift apart.

use super::console::Console;
use super::summary::name;
use crate::language::{Text, said};
use crate::scene::Scene;
use crate::scene::domain::outside;
use crate::sim::History;
use crate::sim::moving_ground::{MovedSupport, drifting};

/// So many warnings are written out; a row of a thousand girders in the wrong unit would fill a screen with one fault.
const MOST_WARNINGS: usize = 10;

/// Warns on standard error of every quantity that lies outside, a line each; the exit status does not change.
pub(super) fn warn(scene: &Scene, console: &mut Console) {
    let found = outside(scene);
    for departure in found.iter().take(MOST_WARNINGS) {
        console.note(&said!("warning", "what" => departure.to_string()));
    }
    if let Some(more) = found.len().checked_sub(MOST_WARNINGS).filter(|more| *more > 0) {
        console.note(&said!("warning-more-outside", "more" => more));
    }
    for words in scene.cut_motions() {
        console.note(&said!("note", "words" => words.to_string()));
    }
}

/// Warns where the energy ledger of an answer does not balance; the exit status does not change.
pub(super) fn warn_of_balance(history: &History, console: &mut Console) {
    let balance = history.balance();
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
