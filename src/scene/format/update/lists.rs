//! Lists of the text: which item of the new list is which of the old one, and how items are set off from each other.

use toml::Value;
use toml_edit::{Array, Item, Table};

/// For each new item the old one that it was, by name; without names by being equal, then by place.
pub(super) fn origins(before: &[Value], after: &[Value]) -> Vec<Option<usize>> {
    let mut free: Vec<usize> = (0..before.len()).collect();
    let mut take = |wanted: &dyn Fn(&Value) -> bool| {
        let at = free.iter().position(|&old| wanted(&before[old]))?;
        Some(free.remove(at))
    };
    let mut found: Vec<_> = after.iter().map(|new| take(&|old| is_same(old, new))).collect();
    for (new, origin) in after.iter().zip(&mut found) {
        *origin = origin.or_else(|| take(&|old| is_like(old, new)));
    }
    found
}

/// Key that identifies an item among the others: the name of a body, the ends of a pair.
fn identity(item: &Value) -> Option<[Option<&Value>; 2]> {
    let keys = if item.get("name").is_some() { ["name", ""] } else { ["between", "ends"] };
    let identity = keys.map(|key| item.get(key));
    identity[0].is_some().then_some(identity)
}

fn is_same(old: &Value, new: &Value) -> bool {
    if identity(new).is_some() { identity(old) == identity(new) } else { old == new }
}

/// Whether one item is the other under another name or with a few other values: half of its values or more are equal.
fn is_like(old: &Value, new: &Value) -> bool {
    let (Value::Table(old), Value::Table(new)) = (old, new) else { return true };
    let equal = new.iter().filter(|(key, value)| old.get(*key) == Some(*value)).count();
    2 * equal >= new.len()
}

/// Tables are printed in the order of their positions in the text: the old positions, in the new order of the list. A
/// new table and what stands below a table come directly behind, at the same position.
pub(super) fn reposition(tables: &mut [(Table, bool)]) {
    let mut positions: Vec<isize> = tables.iter().filter_map(|(table, _)| table.position()).collect();
    positions.sort_unstable();
    let mut next = positions.iter().copied();
    let mut position = positions.first().copied();
    for (table, kept) in tables {
        if *kept {
            position = next.next().or(position);
        }
        table.set_position(position);
        table.iter_mut().for_each(|(_, item)| unplace(item));
    }
}

fn unplace(item: &mut Item) {
    let clear = |table: &mut Table| {
        table.set_position(None);
        table.iter_mut().for_each(|(_, item)| unplace(item));
    };
    match item {
        Item::Table(table) => clear(table),
        Item::ArrayOfTables(tables) => tables.iter_mut().for_each(clear),
        Item::Value(_) | Item::None => {}
    }
}

/// Text between the items of a list of several lines. A comment after an item, on its line, belongs to the item.
pub(super) struct Layout {
    /// Behind the opening bracket.
    open: String,
    /// Of each item: its line break, the comments above it and its indentation; what stands behind it on its line.
    items: Vec<[String; 2]>,
    /// Before the closing bracket.
    end: String,
}

impl Layout {
    pub(super) fn of(text: &Array) -> Self {
        let mut gaps: Vec<[String; 2]> = text
            .iter()
            .map(|item| split_at_line(item.decor().prefix().and_then(|prefix| prefix.as_str()).unwrap_or_default()))
            .collect();
        gaps.push(split_at_line(text.trailing().as_str().unwrap_or_default()));
        let behind: Vec<String> = gaps.iter_mut().map(|[behind, _]| std::mem::take(behind)).collect();
        let end = gaps.pop().map(|[_, before]| before).unwrap_or_default();
        let items = gaps.into_iter().zip(&behind[1..]).map(|([_, above], behind)| [above, behind.clone()]).collect();
        Self { open: behind[0].clone(), items, end }
    }

    /// Sets the items off from each other as each of them was; new ones as the last one was.
    pub(super) fn lay_out(&self, text: &mut Array, origins: &[Option<usize>]) {
        let indentation = self.items.last().map_or("", |[above, _]| above.rsplit('\n').next().unwrap_or_default());
        let new = [format!("\n{indentation}"), String::new()];
        let mut behind = &self.open;
        for (item, origin) in text.iter_mut().zip(origins) {
            let [above, after] = origin.and_then(|n| self.items.get(n)).unwrap_or(&new);
            item.decor_mut().set_prefix(joined(behind, above));
            behind = after;
        }
        text.set_trailing(joined(behind, &self.end));
    }
}

/// Two gaps, one behind the other; a comment ends with its line.
fn joined(behind: &str, above: &str) -> String {
    let line_end = if behind.contains('#') && !above.starts_with('\n') { "\n" } else { "" };
    format!("{behind}{line_end}{above}")
}

/// Text before the first line break, and the rest with the break.
fn split_at_line(gap: &str) -> [String; 2] {
    let (line, rest) = gap.split_at(gap.find('\n').unwrap_or(0));
    [line.to_owned(), rest.to_owned()]
}
