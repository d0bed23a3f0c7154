//! Warnings where a scene lies outside the domain in which the program is checked, and where an answer does not balance.

use super::console::Console;
use super::digits::six;
use super::summary::name;
use crate::scene::domain::outside;
use crate::scene::{Motion, Scene};
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
    warn_of_cut(scene, console);
}

/// Says that a record goes on after the end of the run.
fn warn_of_cut(scene: &Scene, console: &mut Console) {
    let Motion::Record(record) = &scene.motion else { return };
    let Some((_, dt, samples)) = record.extent() else { return };
    let length = dt * samples.saturating_sub(1) as f64;
    if length > scene.duration + dt {
        let [length, end] = [length, scene.duration].map(six);
        console.note(&format!("note: the record lasts {length} s, and the run ends at {end} s: duration_s"));
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
