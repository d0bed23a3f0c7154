//! `assumed = ["restrainer.east-left", "contact.stiffness_n_per_m"]`: values that stand in the file without having been given, as
//! paths of `--set`. A path to a table stands for every number in it, and of a body or device for every rule that it names by a word,
//! as `column_top`.
//!
//! The window marks their fields and the report lists them; a value that is changed is assumed no more.

use crate::language::{Text, six};
use toml::{Table, Value};

use super::keys::{Range, of_place};
use super::path::{item_at, value_at};
use super::{Backfill, Bearings, DeviceKind, ModelKind, Scene, SceneError};

/// Whether a path is listed, by itself or with the table that it stands in.
pub fn is_assumed(listed: &[String], path: &str) -> bool {
    listed.iter().any(|listed| is_within(path, listed))
}

fn is_within(path: &str, table: &str) -> bool {
    path.strip_prefix(table).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

/// A value of a scene as a text: numbers to six digits.
fn told(value: &Value) -> String {
    match value {
        Value::Float(number) => six(*number),
        Value::Array(list) => format!("[{}]", list.iter().map(told).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    }
}

impl Scene {
    /// Every number that is assumed, by its path, as it stands in the file.
    pub fn assumed_numbers(&self) -> Vec<(String, String)> {
        let Ok(table) = Table::try_from(self) else { return Vec::new() };
        let leaves = self.assumed.iter().flat_map(|path| numbers(&table, path));
        leaves
            .filter_map(|path| Some((told(value_at(&table, &path)?), path)))
            .map(|(value, path)| (path, value))
            .collect()
    }

    /// Paths of numbers in force that the file leaves out and the program chooses: contact stiffness, the loop of equal bearings of a
    /// whole deck, soil and backwall.
    pub fn chosen_numbers(&self) -> Vec<String> {
        let stiffness = self.contact.stiffness.is_none() && self.model.kind != ModelKind::Impact;
        let bearings = self.girders.iter().flat_map(|girder| {
            let Some(Bearings::Deck(deck)) = &girder.bearings else { return Vec::new() };
            let path = |(key, _)| format!("girder.{}.bearings.{key}", girder.name);
            deck.assumed().into_iter().map(path).collect()
        });
        let soil = self.abutments.iter().flat_map(|abutment| {
            let path = |key| format!("abutment.{}.backfill.{key}", abutment.name);
            abutment.backfill.iter().flat_map(Backfill::assumed).map(path).collect::<Vec<_>>()
        });
        let stiffness = stiffness.then(|| "contact.stiffness_n_per_m".to_owned());
        stiffness.into_iter().chain(bearings).chain(soil).collect()
    }

    /// Paths of the assumed values that another state of the same table leaves as they were; of a table of which a part has changed, the
    /// unchanged numbers.
    pub fn still_assumed(&self, after: &Self) -> Vec<String> {
        if self.assumed.is_empty() {
            return Vec::new();
        }
        match (Table::try_from(self), Table::try_from(after)) {
            (Ok(before), Ok(after)) => left(&self.assumed, &before, &after),
            _ => Vec::new(),
        }
    }

    /// Paths of the assumed values, less a number that is given.
    pub fn assumed_without(&self, given: &str) -> Vec<String> {
        let Ok(table) = Table::try_from(self) else { return self.assumed.clone() };
        let rest = |path: &String| {
            let whole = if is_within(given, path) { numbers(&table, path) } else { vec![path.clone()] };
            whole.into_iter().filter(|path| path != given)
        };
        self.assumed.iter().flat_map(rest).collect()
    }

    /// The numbers and rules that bodies and devices have which `before` does not know, but for where they are placed.
    pub fn new_numbers(&self, before: &Self) -> Vec<String> {
        let (Ok(table), Ok(old)) = (Table::try_from(self), Table::try_from(before)) else { return Vec::new() };
        let mut found = Vec::new();
        for (list, items) in table.iter().filter_map(|(key, value)| Some((key, value.as_array()?))) {
            let names = items.iter().filter_map(|item| item.get("name")?.as_str());
            for path in names.map(|name| format!("{list}.{name}")).filter(|path| value_at(&old, path).is_none()) {
                found.extend(numbers(&table, &path).into_iter().filter(|path| !is_place(path)));
            }
        }
        found
    }

    /// Complaints about paths that lead to nothing.
    pub(super) fn unknown_assumed(&self) -> Vec<SceneError> {
        let Ok(table) = Table::try_from(self) else { return Vec::new() };
        let lost = self.assumed.iter().filter(|path| value_at(&table, path).is_none());
        let complaint = |path: &String| SceneError {
            file: "scene".to_owned(),
            place: "assumed".into(),
            value: format!("\"{path}\"").into(),
            remedy: Text::new("wrong-assumed").into(),
        };
        lost.map(complaint).collect()
    }
}

/// Whether a number says where something was put, which whoever put it has given.
fn is_place(path: &str) -> bool {
    let key = path.rsplit('.').next().unwrap_or(path);
    ["position_m", "heading_deg", "at_m", "at_skewed_m", "to_m", "direction", "end"].contains(&key)
}

/// Whether a path leads to a rule of a body or device that is one of a few words.
fn is_rule(path: &str) -> bool {
    let is_of_body = ["girder.", "abutment.", "pier."].iter().any(|list| path.starts_with(list));
    let is_of_device = DeviceKind::ALL.iter().any(|kind| is_within(path, kind.label()));
    let is_word = || of_place(path).is_some_and(|(_, key)| matches!(key.range, Range::Words(_)));
    (is_of_body || is_of_device) && !is_place(path) && is_word()
}

/// [`Scene::still_assumed`] of tables.
pub(super) fn left(listed: &[String], before: &Table, after: &Table) -> Vec<String> {
    let same = |path: &str| value_at(after, path).is_some_and(|value| Some(value) == value_at(before, path));
    let mut left = Vec::new();
    for path in listed {
        if same(path) {
            left.push(path.clone());
        } else {
            left.extend(numbers(before, path).into_iter().filter(|path| same(path)));
        }
    }
    left
}

/// Paths of the numbers, lists of numbers and rules at a path and below it.
fn numbers(table: &Table, path: &str) -> Vec<String> {
    let mut found = Vec::new();
    if let Some(value) = value_at(table, path) {
        gather(value, path, &mut found);
    }
    found
}

fn gather(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Integer(_) | Value::Float(_) => found.push(path.to_owned()),
        Value::String(_) if is_rule(path) => found.push(path.to_owned()),
        Value::Array(list) if list.iter().any(|item| !item.is_table() && !item.is_str()) => found.push(path.to_owned()),
        Value::Array(list) => {
            for (number, item) in list.iter().enumerate() {
                gather(item, &format!("{path}.{}", item_at(list, number)), found);
            }
        }
        Value::Table(table) => {
            for (key, value) in table {
                gather(value, &format!("{path}.{key}"), found);
            }
        }
        _ => {}
    }
}

/// Paths after a body or device was renamed.
pub(super) fn rename(listed: &mut [String], from: &str, to: &str) {
    for path in listed {
        let mut steps: Vec<&str> = path.split('.').collect();
        if let Some(name) = steps.get_mut(1).filter(|name| **name == from) {
            *name = to;
            *path = steps.join(".");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    fn scene() -> Scene {
        let mut scene = presets::load("span-as-built").expect("ships");
        scene.assumed = vec!["restrainer.east-left".into(), "contact.stiffness_n_per_m".into()];
        scene
    }

    #[test]
    fn a_table_stands_for_its_numbers() {
        let numbers = scene().assumed_numbers();
        let value = |path: &str| numbers.iter().find(|(known, _)| known == path).map(|(_, value)| value.as_str());
        assert_eq!(value("restrainer.east-left.slack_m"), Some("0.025"), "{numbers:?}");
        assert_eq!(value("contact.stiffness_n_per_m"), Some("1000000000"), "{numbers:?}");
        assert_eq!(value("restrainer.east-left.girder"), None, "a name is given");
        assert!(is_assumed(&scene().assumed, "restrainer.east-left.slack_m"), "with its table");
        assert!(!is_assumed(&scene().assumed, "restrainer.east-left2.slack_m"), "another's");
    }

    #[test]
    fn what_is_changed_is_assumed_no_more() {
        let before = scene();
        let mut after = before.clone();
        after.restrainers[0].slack = 0.03;
        let left = before.still_assumed(&after);
        assert!(!is_assumed(&left, "restrainer.east-left.slack_m"), "{left:?}");
        assert!(is_assumed(&left, "restrainer.east-left.stiffness_n_per_m"), "{left:?}");
        after.restrainers.remove(0);
        assert_eq!(before.still_assumed(&after), ["contact.stiffness_n_per_m"], "what is gone");
    }

    #[test]
    fn what_is_new_is_assumed_but_for_its_place() {
        let after = scene();
        let mut before = after.clone();
        before.restrainers.remove(1);
        let new = after.new_numbers(&before);
        assert!(new.contains(&"restrainer.east-right.slack_m".to_owned()), "{new:?}");
        assert!(
            new.iter().all(|path| path.starts_with("restrainer.east-right.") && !path.ends_with("at_m")),
            "{new:?}"
        );
    }

    #[test]
    fn what_is_said_to_be_right_is_taken_from_its_table() {
        let left = scene().assumed_without("restrainer.east-left.slack_m");
        assert!(!is_assumed(&left, "restrainer.east-left.slack_m"), "{left:?}");
        assert!(is_assumed(&left, "restrainer.east-left.stiffness_n_per_m"), "{left:?}");
        assert!(is_assumed(&left, "contact.stiffness_n_per_m"), "{left:?}");
    }

    #[test]
    fn a_name_goes_along() {
        let mut listed = scene().assumed;
        rename(&mut listed, "east-left", "cable");
        assert_eq!(listed, ["restrainer.cable", "contact.stiffness_n_per_m"], "by its name");
    }

    #[test]
    fn a_path_to_nothing_is_complained_about() {
        let mut scene = scene();
        assert!(scene.unknown_assumed().is_empty(), "all are there");
        scene.assumed.push("girder.nobody.mass_kg".into());
        assert_eq!(scene.unknown_assumed()[0].value.plain(), "\"girder.nobody.mass_kg\"", "by its path");
    }
}
