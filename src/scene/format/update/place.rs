//! Properties of a place in the file: the path to it, its rank in the documentation, its unwritten value.

use toml::Value;

use crate::scene::{ImpactSettings, Initial, ModelSettings, Overlays, Push, STANDARD_GRAVITY};
use crate::scene::{SolverSettings, ViewSettings, keys};

/// The way to a key, `girder.initial`: the same for a table and for the tables of a list.
pub(super) fn below(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

/// Rank of a key in the documentation among those of its table; a key that is not listed comes last.
pub(super) fn rank(path: &str, key: &str) -> usize {
    let plain = |listed: &'static str| listed.split(" kind").next().map(|way| way.trim_end_matches("[]"));
    let listed_in = keys::as_of_motion(path.to_owned(), key);
    // What every ground has comes before the keys of its motion.
    let before = if listed_in == path { 0 } else { keys::GROUND.len() };
    let tables = keys::TABLES.iter().filter(|table| plain(table.path) == Some(listed_in.as_str()));
    let at = tables.flat_map(|table| table.keys).position(|listed| listed.name == key);
    at.map_or(usize::MAX, |at| before + at)
}

/// Default of a table that is left out of the file; `None` of a key without one.
pub(super) fn unwritten(path: &str) -> Option<Value> {
    match path {
        "gravity_m_s2" => Ok(Value::Float(STANDARD_GRAVITY)),
        "girder.initial" => Value::try_from(Initial::default()),
        "girder.push" => Value::try_from(Push::default()),
        "model" => Value::try_from(ModelSettings::default()),
        "impact" => Value::try_from(ImpactSettings::default()),
        "solver" => Value::try_from(SolverSettings::default()),
        "view" => Value::try_from(ViewSettings::default()),
        "view.overlays" => Value::try_from(Overlays::default()),
        _ => return None,
    }
    .ok()
}
