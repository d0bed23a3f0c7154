//! The way to a value of a scene laid out as the table of its file: tables by key, lists by name or number.

use toml::{Table, Value};

/// Value at a path of a table.
pub(super) fn value_at<'t>(table: &'t Table, path: &str) -> Option<&'t Value> {
    let mut steps = path.split('.').map(str::trim);
    let mut here = table.get(steps.next()?)?;
    for step in steps {
        here = match here {
            Value::Array(list) => list.get(index_of(list, step)?)?,
            other => other.get(step)?,
        };
    }
    Some(here)
}

/// Names of the items of a list in a path: their own, or their numbers.
pub(super) fn items(list: &[Value]) -> Vec<String> {
    (0..list.len()).map(|number| item_at(list, number)).collect()
}

/// Name of the item at a number in a path: a name with a dot would be two steps.
pub(super) fn item_at(list: &[Value], number: usize) -> String {
    let name = list.get(number).and_then(|item| item.get("name")?.as_str()).filter(|name| !name.contains('.'));
    name.map_or_else(|| number.to_string(), str::to_owned)
}

/// The item of a list of this name or number.
pub(super) fn item_of<'l>(list: &'l mut [Value], item: &str) -> Option<&'l mut Value> {
    let index = index_of(list, item)?;
    list.get_mut(index)
}

/// Number of the item of this name or number.
fn index_of(list: &[Value], item: &str) -> Option<usize> {
    let named = list.iter().position(|value| value.get("name").and_then(Value::as_str) == Some(item));
    named.or_else(|| item.parse().ok())
}
