//! Words of the map of a run's number over two keys.

use super::numbers::short;

pub(in crate::app) const MAP_OPEN: &str = "Map…";
pub(in crate::app) const MAP_OPEN_HINT: &str = "A number of the run over two values of the scene, as colours (Shift M)";
pub(in crate::app) const MAP: &str = "Map over two values";
/// Name of a key, of its ends, and what equal ratios are: of the level axis.
pub(in crate::app) const MAP_ACROSS: [&str; 4] = ["Across", "Across from", "Across to", MAP_LOG_HINT];
/// The same of the upright axis.
pub(in crate::app) const MAP_UP: [&str; 4] = ["Upwards", "Upwards from", "Upwards to", MAP_LOG_HINT];
pub(in crate::app) const MAP_LOG: &str = "log";
const MAP_LOG_HINT: &str = "Values grow in equal ratios; both ends need one sign";
pub(in crate::app) const MAP_MEASURE: &str = "Shows";
pub(in crate::app) const MAP_CELLS: &str = "Values";
pub(in crate::app) const MAP_CANCEL: &str = "Stop the map";
pub(in crate::app) const MAP_AGAIN: &str = "Compute the map";
pub(in crate::app) const MAP_STOPPED: &str = "stopped";
pub(in crate::app) const MAP_OF_OLD: &str = "of the scene as it was";
pub(in crate::app) const MAP_SCENE: &str = "the scene";
pub(in crate::app) const MAP_EMPTY: &str = "no value";
pub(in crate::app) const MAP_HINT: &str = "a click opens that run";
pub(in crate::app) const MAP_NOT_YET: &str = "not computed yet";
pub(in crate::app) const MAP_NO_VALUE: &str = "the run has no such value";

/// What the picture of a map is called.
pub(in crate::app) fn map_of(measure: &str) -> String {
    format!("Map of {measure}")
}

/// A name with the unit of its numbers, which may begin with a space.
pub(in crate::app) fn with_unit(name: &str, suffix: &str) -> String {
    if suffix.is_empty() { name.to_owned() } else { format!("{name} [{}]", suffix.trim()) }
}

/// A number of a run.
pub(in crate::app) fn measured(name: &str, value: f64, unit: &str) -> String {
    let space = if unit.is_empty() || unit == "°" { "" } else { " " };
    format!("{name}: {}{space}{unit}", short(value))
}

/// How many runs have come out.
pub(in crate::app) fn runs_of(done: usize, all: usize) -> String {
    format!("{done} of {all} runs")
}
