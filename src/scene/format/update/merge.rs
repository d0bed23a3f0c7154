//! Changes the tables and lists of the text, one inside of another.

use toml::{Table, Value};
use toml_edit::{Array, ArrayOfTables, InlineTable, Item, Key, TableLike};

use super::lists::{Layout, origins, reposition};
use super::place::{below, rank, unwritten};
use super::spell;

/// A table of the text.
pub(super) enum Node<'a> {
    /// With a header, or of dotted keys.
    Headed(&'a mut toml_edit::Table),
    /// In braces.
    Inline(&'a mut InlineTable),
}

impl Node<'_> {
    fn get_mut(&mut self, key: &str) -> Option<&mut Item> {
        match self {
            Self::Headed(table) => table.get_mut(key),
            Self::Inline(table) => (*table as &mut dyn TableLike).get_mut(key),
        }
    }

    fn names(&self) -> Vec<String> {
        match self {
            Self::Headed(table) => table.iter().map(|(key, _)| key.to_owned()).collect(),
            Self::Inline(table) => table.iter().map(|(key, _)| key.to_owned()).collect(),
        }
    }

    /// Whether a table may be put into it under a header.
    fn takes_headers(&self) -> bool {
        matches!(self, Self::Headed(table) if !table.is_dotted())
    }

    fn remove(&mut self, key: &str) {
        match self {
            Self::Headed(table) => drop(table.remove(key)),
            Self::Inline(table) => {
                table.remove(key);
                tidy(table);
            }
        }
    }

    /// Puts a key behind the last one that the documentation lists before it.
    fn insert(&mut self, path: &str, key: &str, item: Item) {
        let names = self.names();
        let own = rank(path, key);
        let at = names.iter().rposition(|name| rank(path, name) <= own).map_or(0, |before| before + 1);
        match self {
            Self::Headed(table) => {
                let later: Vec<_> = names[at..].iter().filter_map(|name| table.remove_entry(name)).collect();
                table.insert_formatted(&Key::new(key), item);
                for (key, item) in later {
                    table.insert_formatted(&key, item);
                }
            }
            Self::Inline(table) => {
                let later: Vec<_> = names[at..].iter().filter_map(|name| table.remove_entry(name)).collect();
                if let Ok(value) = item.into_value() {
                    table.insert_formatted(&Key::new(key), value);
                }
                for (key, value) in later {
                    table.insert_formatted(&key, value);
                }
                tidy(table);
            }
        }
    }
}

/// Spaces and commas of an inline table after a key has come or gone; one of several lines stays as it is laid out.
fn tidy(table: &mut InlineTable) {
    if !table.to_string().contains('\n') {
        table.fmt();
    }
}

/// Changes in the text what differs between two states of a table.
pub(super) fn merge_table(path: &str, text: &mut Node<'_>, before: &Table, after: &Table) {
    let gone = before.keys().filter(|key| !after.contains_key(*key));
    let defaults: Vec<_> = gone.map(|key| (key.as_str(), unwritten(&below(path, key)))).collect();
    for (key, default) in &defaults {
        match default {
            Some(default) => merge_key(path, text, key, before.get(*key), default),
            None => text.remove(key),
        }
    }
    for (key, value) in spell::in_order(path, after) {
        if before.get(key) != Some(value) {
            merge_key(path, text, key, before.get(key), value);
        }
    }
}

fn merge_key(path: &str, text: &mut Node<'_>, key: &str, before: Option<&Value>, after: &Value) {
    let here = below(path, key);
    let default = if before.is_none() { unwritten(&here) } else { None };
    let before = before.or(default.as_ref());
    if before == Some(after) {
        return;
    }
    let headed = text.takes_headers();
    if let Some(item) = text.get_mut(key) {
        if merge_item(&here, item, before, after) {
            return;
        }
        // Another shape: a list of bearings in place of a table.
        text.remove(key);
        return text.insert(path, key, spell::item(&here, after, headed));
    }
    let new = changed(before, after);
    text.insert(path, key, spell::item(&here, &new, headed));
}

/// Of a table that the text leaves out only the keys that are not the default any more.
fn changed(before: Option<&Value>, after: &Value) -> Value {
    match (before, after) {
        (Some(Value::Table(before)), Value::Table(after)) => {
            let differs = after.iter().filter(|(key, value)| before.get(*key) != Some(*value));
            differs.map(|(key, value)| (key.clone(), changed(before.get(key), value))).collect::<Table>().into()
        }
        _ => after.clone(),
    }
}

/// Changes what stands under a key; `false` where it has not the shape of the new value.
fn merge_item(path: &str, item: &mut Item, before: Option<&Value>, after: &Value) -> bool {
    match (item, before, after) {
        (Item::Table(table), Some(Value::Table(before)), Value::Table(after)) => {
            merge_table(path, &mut Node::Headed(table), before, after);
            true
        }
        (Item::ArrayOfTables(tables), Some(Value::Array(before)), Value::Array(after)) => {
            merge_tables(path, tables, before, after);
            true
        }
        (Item::Value(value), before, after) => {
            merge_value(path, value, before, after);
            true
        }
        _ => false,
    }
}

/// Changes a value that is no table with a header; what stands around it stays.
fn merge_value(path: &str, text: &mut toml_edit::Value, before: Option<&Value>, after: &Value) {
    match (&mut *text, before, after) {
        (toml_edit::Value::InlineTable(table), Some(Value::Table(before)), Value::Table(after)) => {
            merge_table(path, &mut Node::Inline(table), before, after);
        }
        (toml_edit::Value::Array(list), Some(Value::Array(before)), Value::Array(after)) => {
            merge_array(path, list, before, after);
        }
        _ => {
            let mut new = spell::plain(path, after);
            *new.decor_mut() = text.decor().clone();
            *text = new;
        }
    }
}

/// Changes a list of tables under headers, `[[girder]]`.
fn merge_tables(path: &str, text: &mut ArrayOfTables, before: &[Value], after: &[Value]) {
    let mut old: Vec<Option<toml_edit::Table>> = text.iter().cloned().map(Some).collect();
    let origins = origins(before, after);
    let mut tables: Vec<(toml_edit::Table, bool)> = Vec::new();
    for (origin, new) in origins.iter().zip(after) {
        let Value::Table(new) = new else { continue };
        let kept = origin.and_then(|n| Some((old.get_mut(n)?.take()?, before[n].as_table()?)));
        tables.push(match kept {
            Some((mut table, was)) => {
                merge_table(path, &mut Node::Headed(&mut table), was, new);
                (table, true)
            }
            None => (spell::under_header(path, new, false), false),
        });
    }
    if !origins.is_sorted() || origins.contains(&None) {
        reposition(&mut tables);
    }
    text.clear();
    for (table, _) in tables {
        text.push(table);
    }
}

/// Changes a list in brackets: numbers by place, tables as what they are.
fn merge_array(path: &str, text: &mut Array, before: &[Value], after: &[Value]) {
    let by_place = || (0..after.len()).map(|n| (n < text.len()).then_some(n)).collect();
    let origins: Vec<Option<usize>> =
        if after.iter().any(Value::is_table) { origins(before, after) } else { by_place() };
    let same_places = text.len() == after.len() && origins.iter().enumerate().all(|(n, origin)| *origin == Some(n));
    let several_lines = text.to_string().contains('\n');
    let layout = Layout::of(text);
    let mut old: Vec<_> = text.iter().cloned().map(Some).collect();
    text.clear();
    for (origin, new) in origins.iter().zip(after) {
        let kept = origin.and_then(|n| Some((old.get_mut(n)?.take()?, before.get(n))));
        text.push_formatted(match kept {
            Some((mut value, was)) => {
                if was != Some(new) {
                    merge_value(path, &mut value, was, new);
                }
                value
            }
            None => spell::plain(path, new),
        });
    }
    match (same_places, several_lines) {
        (true, _) => {}
        (false, true) => layout.lay_out(text, &origins),
        (false, false) => text.fmt(),
    }
}
