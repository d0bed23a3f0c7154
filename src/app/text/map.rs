//! Words of what a sweep in the background shows: the map of a run's number over two keys, the angles of shaking.

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
pub(in crate::app) const SWEEP_STOPPED: &str = "stopped";
pub(in crate::app) const SWEEP_OF_OLD: &str = "of the scene as it was";
pub(in crate::app) const MAP_SCENE: &str = "the scene";
pub(in crate::app) const MAP_EMPTY: &str = "no value";
pub(in crate::app) const MAP_HINT: &str = "a click opens that run";
pub(in crate::app) const MAP_NOT_YET: &str = "not computed yet";
pub(in crate::app) const MAP_NO_VALUE: &str = "the run has no such value";

/// What computes a sweep again, and what stops it.
pub(in crate::app) struct Sweeping {
    pub(in crate::app) again: &'static str,
    pub(in crate::app) stop: &'static str,
}

pub(in crate::app) const OF_A_MAP: Sweeping = Sweeping { again: "Compute the map", stop: "Stop the map" };
pub(in crate::app) const OF_ANGLES: Sweeping = Sweeping { again: "Compute the angles", stop: "Stop the angles" };

pub(in crate::app) const ANGLES: &str = "Which way is worst?";
pub(in crate::app) const ANGLES_OPEN: &str = "Which way is worst?…";
pub(in crate::app) const ANGLES_OPEN_HINT: &str =
    "Rotation, peak force and least seat over the angle of the shaking, filled while you work (Shift W)";
pub(in crate::app) const ANGLES_STILL: &str = "The ground does not move: there is no angle to turn.";
pub(in crate::app) const ANGLES_HINT: &str =
    "Radius: the value. Ring: the worst. Ray: the scene. A click, or arrows and Enter, gives the scene that angle.";

/// What the polar plot of a measure is called.
pub(in crate::app) fn angles_of(measure: &str) -> String {
    format!("{measure} by angle of shaking")
}

/// The worst angle and its value.
pub(in crate::app) fn worst(angle: &str, value: &str) -> String {
    format!("Worst at {angle}: {value}")
}

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
    format!("{name}: {}", valued(value, unit))
}

/// A value in its unit; forces in the decimal multiple that people read.
pub(in crate::app) fn valued(value: f64, unit: &str) -> String {
    match unit {
        "N" => super::force(value),
        "" | "°" => format!("{}{unit}", short(value)),
        _ => format!("{} {unit}", short(value)),
    }
}

/// How many runs have come out.
pub(in crate::app) fn runs_of(done: usize, all: usize) -> String {
    format!("{done} of {all} runs")
}
