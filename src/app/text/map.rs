//! Words of what a sweep in the background shows: the map of a run's number over two keys, the angles of shaking.

use super::numbers::short;
use crate::language::{Text, values};

pub(in crate::app) const MAP_OPEN: Text = Text::new("map-open");
pub(in crate::app) const MAP_OPEN_HINT: Text = Text::new("map-open-hint");
pub(in crate::app) const MAP: Text = Text::new("map");
/// Name of a key, of its ends, and what equal ratios are: of the level axis.
pub(in crate::app) const MAP_ACROSS: [Text; 4] =
    [Text::new("map-across"), Text::new("map-across-from"), Text::new("map-across-to"), MAP_LOG_HINT];
/// The same of the upright axis.
pub(in crate::app) const MAP_UP: [Text; 4] =
    [Text::new("map-up"), Text::new("map-up-from"), Text::new("map-up-to"), MAP_LOG_HINT];
pub(in crate::app) const MAP_LOG: Text = Text::new("map-log");
const MAP_LOG_HINT: Text = Text::new("map-log-hint");
pub(in crate::app) const MAP_MEASURE: Text = Text::new("map-measure");
pub(in crate::app) const MAP_CELLS: Text = Text::new("map-cells");
pub(in crate::app) const SWEEP_STOPPED: Text = Text::new("sweep-stopped");
pub(in crate::app) const SWEEP_OF_OLD: Text = Text::new("sweep-of-old");
pub(in crate::app) const MAP_SCENE: Text = Text::new("map-scene");
pub(in crate::app) const MAP_EMPTY: Text = Text::new("map-empty");
pub(in crate::app) const MAP_HINT: Text = Text::new("map-hint");
pub(in crate::app) const MAP_NOT_YET: Text = Text::new("map-not-yet");
pub(in crate::app) const MAP_NO_VALUE: Text = Text::new("map-no-value");

/// Labels that repeat and stop a sweep.
pub(in crate::app) struct Sweeping {
    pub(in crate::app) again: Text,
    pub(in crate::app) stop: Text,
}

pub(in crate::app) const OF_A_MAP: Sweeping = Sweeping { again: Text::new("map-again"), stop: Text::new("map-stop") };
pub(in crate::app) const OF_ANGLES: Sweeping =
    Sweeping { again: Text::new("angles-again"), stop: Text::new("angles-stop") };

pub(in crate::app) const ANGLES: Text = Text::new("angles");
pub(in crate::app) const ANGLES_OPEN: Text = Text::new("angles-open");
pub(in crate::app) const ANGLES_OPEN_HINT: Text = Text::new("angles-open-hint");
pub(in crate::app) const ANGLES_STILL: Text = Text::new("angles-still");
pub(in crate::app) const ANGLES_HINT: Text = Text::new("angles-hint");

/// Name of the polar plot of a measure.
pub(in crate::app) fn angles_of(measure: &str) -> String {
    Text::new("angles-of").with(&values!["measure" => measure])
}

/// The worst angle and its value, of all runs or of those that have come out so far.
pub(in crate::app) fn worst(whole: bool, angle: &str, value: &str) -> String {
    let text = if whole { Text::new("worst") } else { Text::new("worst-so-far") };
    text.with(&values!["angle" => angle, "value" => value])
}

/// Name of the picture of a map.
pub(in crate::app) fn map_of(measure: &str) -> String {
    Text::new("map-of").with(&values!["measure" => measure])
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
    Text::new("runs-of").with(&values!["done" => done, "all" => all])
}
