//! The keys in which two scenes differ.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use toml::{Table, Value};

use super::Scene;
use super::path::item_at;

/// Tables and keys that change nothing of a run: what is drawn, what the scene is called, which values are assumed.
const NO_PHYSICS: [&str; 4] = ["view", "name", "format", "assumed"];

/// Every value of a scene as it is written, by its place: `girder.deck.skew_deg`, `contact.pair[2].mu_static`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values(BTreeMap<String, Value>);

/// A key in which two scenes differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference<'a> {
    /// Its place.
    pub place: &'a str,
    /// Values in the first scene and in the second; `None` in a scene without the key.
    pub values: [Option<&'a Value>; 2],
}

impl Values {
    /// Those of a scene that change its run; none of a scene that cannot be written.
    pub fn of(scene: &Scene) -> Self {
        let mut all = BTreeMap::new();
        let table = Table::try_from(scene).unwrap_or_default();
        for (key, value) in table.iter().filter(|(key, _)| !NO_PHYSICS.contains(&key.as_str())) {
            gather(key.clone(), value, &mut all);
        }
        Self(all)
    }

    /// Differences of this scene from another one: those of the largest tables first, of girders before all others, so that a skew comes
    /// before the bearings that follow from it.
    pub fn differences<'a>(&'a self, other: &'a Self) -> Vec<Difference<'a>> {
        let here = self.0.iter().map(|(place, value)| (place, [Some(value), other.0.get(place)]));
        let there = other.0.iter().filter(|(place, _)| !self.0.contains_key(*place));
        let all: BTreeMap<&String, _> = here.chain(there.map(|(place, value)| (place, [None, Some(value)]))).collect();
        let differ = all.into_iter().filter(|(_, [one, other])| one != other);
        let mut differ: Vec<Difference<'a>> = differ.map(|(place, values)| Difference { place, values }).collect();
        differ.sort_by_key(|found| (found.place.split(['.', '[']).count().max(3), !found.place.starts_with("girder.")));
        differ
    }
}

/// The keys in which one of several tables of the scene file differs from any other, with those of the tables below and the numbers of
/// lists: `length_m`, `bearings.frequency_hz`, `position_m` and `position_m[0]`; without `name`.
pub fn differing_keys<'a, T: Serialize + 'a>(one: &T, others: impl Iterator<Item = &'a T>) -> Vec<String> {
    let values = |table: &T| {
        let mut all = BTreeMap::new();
        for (key, value) in Table::try_from(table).unwrap_or_default() {
            gather(key, &value, &mut all);
        }
        all.remove("name");
        Values(all)
    };
    let mut others = others.peekable();
    if others.peek().is_none() {
        return Vec::new();
    }
    let (own, mut found) = (values(one), BTreeSet::new());
    for other in others.map(values) {
        for Difference { place, values } in own.differences(&other) {
            found.extend(components(values).map(|i| format!("{place}[{i}]")));
            found.insert(place.to_owned());
        }
    }
    found.into_iter().collect()
}

/// Numbers of two lists that differ; none of values that are no lists.
fn components(values: [Option<&Value>; 2]) -> impl Iterator<Item = usize> {
    let lists = values.map(|value| value.and_then(Value::as_array).map_or(&[][..], Vec::as_slice));
    let count = lists[0].len().max(lists[1].len());
    (0..count).filter(move |&i| lists[0].get(i) != lists[1].get(i)).collect::<Vec<_>>().into_iter()
}

/// Notes every value at a place and below, lists of tables by the names of their items.
fn gather(place: String, value: &Value, all: &mut BTreeMap<String, Value>) {
    match value {
        Value::Table(table) => table.iter().for_each(|(key, value)| gather(format!("{place}.{key}"), value, all)),
        Value::Array(list) if list.iter().any(Value::is_table) => {
            for (number, item) in list.iter().enumerate() {
                let name = item_at(list, number);
                let named = item.get("name").is_some_and(|own| own.as_str() == Some(&name));
                let step = if named { format!(".{name}") } else { format!("[{number}]") };
                gather(format!("{place}{step}"), item, all);
            }
        }
        _ => drop(all.insert(place, value.clone())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{overrides, presets};

    #[test]
    fn what_has_been_set_is_what_differs() {
        let one = presets::load(presets::OPENING).expect("ships");
        let set = ["girder.deck.skew_deg=60", "motion.angle_deg=10", "view.overlays.grid=false"];
        let other = overrides::apply_all(&one, &set).expect("can be set");
        let [one, other] = [&one, &other].map(Values::of);
        assert_eq!(one.differences(&one), [], "nothing");
        let found = one.differences(&other);
        let places: Vec<&str> = found.iter().map(|difference| difference.place).collect();
        assert_eq!(places, ["girder.deck.skew_deg", "motion.angle_deg"], "what changes the run");
        assert_eq!(found[0].values[1].and_then(Value::as_float), Some(60.0), "the second scene's");
    }

    #[test]
    fn girders_differ_by_the_keys_of_their_own_tables() {
        let scene = presets::load("viaduct-5").expect("ships");
        let [one, other, ..] = &scene.girders[..] else { panic!("five spans") };
        assert_eq!(differing_keys(one, [one, &one.clone()].into_iter()), Vec::<String>::new(), "alike");
        let longer = crate::scene::Girder { length: 25.0, ..other.clone() };
        let found = differing_keys(one, [other, &longer].into_iter());
        assert!(found.contains(&"length_m".to_owned()) && found.contains(&"position_m".to_owned()), "{found:?}");
        let both = ["position_m[0]", "position_m[1]"].map(|key| found.iter().any(|found| found == key));
        assert_eq!(both, [true, false], "one after the other along x: {found:?}");
        assert!(!found.iter().any(|key| key == "name" || key == "width_m"), "{found:?}");
    }

    #[test]
    fn what_one_scene_lacks_differs_too() {
        let one = presets::load(presets::OPENING).expect("ships");
        let mut other = one.clone();
        other.abutments.clear();
        let [one, other] = [&one, &other].map(Values::of);
        let found = other.differences(&one);
        assert!(!found.is_empty(), "an abutment");
        for difference in found {
            assert!(difference.place.starts_with("abutment."), "{difference:?}");
            assert!(difference.values[0].is_none() && difference.values[1].is_some(), "{difference:?}");
        }
    }
}
