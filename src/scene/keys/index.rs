//! Every table of the scene file, and the key that a place in a scene is about.

use super::key::Key;
use super::{
    ABUTMENT, BACKFILL, BEARING, BEARINGS, BUMPER, CODES, COMPONENT, CONTACT, DAMPER, DECK_BEARINGS, ELASTIC, GIRDER,
    GROUND, IMPACT, INITIAL, LIMITS, MODEL, MOTION, OVERLAYS, PAIR, PIER, PLOT, PROCESSING, PUSH, RAYLEIGH, RECORD,
    RESTRAINER, SEAT, SINE, SOLVER, STOPPER, SWEEP, SYNTHETIC, TOP, VIEW, WAVE,
};
use crate::scene::DeviceKind;

/// A table of the scene file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table {
    /// The way to it, without names and numbers: `girder.initial`; `[]` marks single bearings, `kind` bearings
    /// given by their kind, `kind =` the keys of one kind of motion.
    pub path: &'static str,
    /// Its keys, in the order of the documentation.
    pub keys: &'static [Key],
}

/// Every table; of those that are mixed by place (`girder.bearings` is a table or a list, `motion` depends on `kind`)
/// each form.
pub const TABLES: &[Table] = &[
    Table { path: "", keys: TOP },
    Table { path: "girder", keys: GIRDER },
    Table { path: "girder.bearings", keys: BEARINGS },
    Table { path: "girder.bearings kind", keys: DECK_BEARINGS },
    Table { path: "girder.bearings[]", keys: BEARING },
    Table { path: "girder.initial", keys: INITIAL },
    Table { path: "girder.push", keys: PUSH },
    Table { path: "girder.seat_m", keys: SEAT },
    Table { path: "girder.elastic", keys: ELASTIC },
    Table { path: "girder.elastic.rayleigh", keys: RAYLEIGH },
    Table { path: "abutment", keys: ABUTMENT },
    Table { path: "abutment.backfill", keys: BACKFILL },
    Table { path: "pier", keys: PIER },
    Table { path: "restrainer", keys: RESTRAINER },
    Table { path: "bumper", keys: BUMPER },
    Table { path: "damper", keys: DAMPER },
    Table { path: "stopper", keys: STOPPER },
    Table { path: "contact", keys: CONTACT },
    Table { path: "contact.pair", keys: PAIR },
    Table { path: "model", keys: MODEL },
    Table { path: "impact", keys: IMPACT },
    Table { path: "motion", keys: MOTION },
    Table { path: "motion kind = sine", keys: SINE },
    Table { path: "motion kind = record", keys: RECORD },
    Table { path: "motion kind = synthetic", keys: SYNTHETIC },
    Table { path: "motion kind = sweep", keys: SWEEP },
    Table { path: "motion.processing", keys: PROCESSING },
    Table { path: "motion.component", keys: COMPONENT },
    Table { path: "ground", keys: GROUND },
    Table { path: "wave", keys: WAVE },
    Table { path: "solver", keys: SOLVER },
    Table { path: "limits", keys: LIMITS },
    Table { path: "codes", keys: CODES },
    Table { path: "view", keys: VIEW },
    Table { path: "view.plot", keys: PLOT },
    Table { path: "view.overlays", keys: OVERLAYS },
];

/// The key of this name among those of a table.
pub fn find(keys: &'static [Key], name: &str) -> Option<&'static Key> {
    keys.iter().find(|key| key.name == name)
}

/// The key that a place in a scene is about, and its table: `girder.deck.initial.displacement_m[0]`,
/// `contact.pair[2].mu_static`, `motion.angle_deg`. A `[[ground]]` has, its name and kind apart, the keys
/// of `[motion]`.
pub fn of_place(place: &str) -> Option<(&'static Table, &'static Key)> {
    let mut steps: Vec<&str> = place.split('.').collect();
    if is_named(steps[0]) && steps.len() > 1 {
        steps.remove(1);
    }
    let last = steps.pop()?;
    let name = last.split('[').next().unwrap_or(last);
    let way: Vec<String> = steps.iter().map(|step| without_number(step)).collect();
    let way = as_of_motion(way.join("."), name);
    let mut tables = TABLES.iter().filter(|t| t.path.split(" kind").next() == Some(way.as_str()));
    tables.find_map(|table| Some((table, find(table.keys, name)?)))
}

/// The table that lists a key of a `[[ground]]`, `ground.component`: that of `[motion]`, but for those that every ground has.
pub(in crate::scene) fn as_of_motion(table: String, key: &str) -> String {
    match table.strip_prefix("ground") {
        Some("") if find(GROUND, key).is_some() => table,
        Some(below) if below.is_empty() || below.starts_with('.') => format!("motion{below}"),
        _ => table,
    }
}

/// Whether a list of tables is walked by name.
fn is_named(list: &str) -> bool {
    matches!(list, "girder" | "abutment" | "pier" | "ground") || DeviceKind::ALL.iter().any(|kind| kind.label() == list)
}

/// `pair[2]` is a pair, `bearings[2]` a bearing of its own and not all of them.
fn without_number(step: &str) -> String {
    match step.split_once('[') {
        Some(("bearings", _)) => "bearings[]".into(),
        Some((list, _)) => list.into(),
        None => step.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_leads_to_its_key() {
        let cases = [
            ("duration_s", "", "duration_s"),
            ("girder.deck.length_m", "girder", "length_m"),
            ("girder.deck.initial.displacement_m[1]", "girder.initial", "displacement_m"),
            ("girder.deck.bearings.at_skewed_m[3][0]", "girder.bearings", "at_skewed_m"),
            ("girder.deck.bearings[3].at_m", "girder.bearings[]", "at_m"),
            ("pier.p1.height_m", "pier", "height_m"),
            ("damper.north.exponent", "damper", "exponent"),
            ("girder.deck.seat_m.+x", "girder.seat_m", "+x"),
            ("contact.pair[0].mu_static", "contact.pair", "mu_static"),
            ("motion.frequency_hz", "motion kind = sine", "frequency_hz"),
            ("ground.east bank.scale", "motion kind = record", "scale"),
            ("ground.east bank.name", "ground", "name"),
            ("motion.scale", "motion kind = record", "scale"),
            ("view.overlays.grid", "view.overlays", "grid"),
        ];
        for (place, table, name) in cases {
            let (found, key) = of_place(place).expect(place);
            assert_eq!((found.path, key.name), (table, name), "{place}");
        }
        assert_eq!(of_place("girder.deck.colour"), None, "no such key");
        assert_eq!(of_place(""), None, "no key at all");
    }
}
