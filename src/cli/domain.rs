//! Warnings where a scene lies outside the domain in which the program is checked, and where an answer does not balance.

use super::console::Console;
use super::summary::name;
use crate::scene::Scene;
use crate::scene::domain::outside;
use crate::sim::History;

/// So many warnings are written out; a row of a thousand girders in the wrong unit would fill a screen with one fault.
const MOST: usize = 10;

/// Warns on standard error of every quantity that lies outside, a line each; the exit status does not change.
pub(super) fn warn(scene: &Scene, console: &mut Console) {
    let found = outside(scene);
    for departure in found.iter().take(MOST) {
        console.note(&format!("warning: {departure}"));
    }
    if let Some(more) = found.len().checked_sub(MOST).filter(|more| *more > 0) {
        console.note(&format!("warning: {more} more quantities outside the domain"));
    }
}

/// Warns where the energy ledger of an answer does not balance; the exit status does not change.
pub(super) fn warn_of_balance(history: &History, console: &mut Console) {
    let balance = history.balance();
    if !balance.holds() {
        let remedy = "do not trust this answer: heed the other warnings, or lower solver.tolerance";
        console.note(&format!("warning: {}: {balance}: {remedy}", name(&history.scene().name)));
    }
}
