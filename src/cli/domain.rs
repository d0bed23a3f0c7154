//! Warnings where a scene lies outside the domain in which the program is checked.

use super::console::Console;
use crate::scene::Scene;
use crate::scene::domain::outside;

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
