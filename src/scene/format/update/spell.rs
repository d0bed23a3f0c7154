//! Values of a scene as pieces of an editable text.

use toml::{Table, Value};
use toml_edit::{Array, ArrayOfTables, InlineTable, Item};

use super::place::{below, rank};

/// A value that the text does not have yet: under a header of its own where its table has one, inside a girder and
/// inside an inline table on one line.
pub(super) fn item(path: &str, value: &Value, headed: bool) -> Item {
    let headed = headed && (path == "girder" || !path.starts_with("girder"));
    match value {
        Value::Table(table) if headed => Item::Table(under_header(path, table, true)),
        Value::Array(list) if headed && list.iter().any(Value::is_table) => {
            let tables = list.iter().filter_map(Value::as_table).map(|table| under_header(path, table, false));
            Item::ArrayOfTables(tables.collect::<ArrayOfTables>())
        }
        _ => Item::Value(plain(path, value)),
    }
}

/// A table with a header; an `implicit` one shows it only above keys of its own.
pub(super) fn under_header(path: &str, table: &Table, implicit: bool) -> toml_edit::Table {
    let mut made = toml_edit::Table::new();
    made.set_implicit(implicit);
    for (key, value) in in_order(path, table) {
        let path = below(path, key);
        // A girder's own tables stand on one line each.
        let own = !path.starts_with("girder.");
        made.insert(key, item(&path, value, own));
    }
    made
}

/// A value on one line.
pub(super) fn plain(path: &str, value: &Value) -> toml_edit::Value {
    match value {
        Value::String(text) => text.as_str().into(),
        Value::Integer(number) => (*number).into(),
        // Very large and very small ones with an exponent.
        Value::Float(number) => format!("{number:?}").parse().unwrap_or_else(|_| (*number).into()),
        Value::Boolean(on) => (*on).into(),
        Value::Datetime(date) => (*date).into(),
        Value::Array(list) => toml_edit::Value::Array(list.iter().map(|value| plain(path, value)).collect::<Array>()),
        Value::Table(table) => {
            let pairs = in_order(path, table).into_iter().map(|(key, value)| (key, plain(&below(path, key), value)));
            toml_edit::Value::InlineTable(pairs.collect::<InlineTable>())
        }
    }
}

/// The keys of a table in the order of the documentation.
pub(super) fn in_order<'t>(path: &str, table: &'t Table) -> Vec<(&'t str, &'t Value)> {
    let mut pairs: Vec<_> = table.iter().map(|(key, value)| (key.as_str(), value)).collect();
    pairs.sort_by_key(|(key, _)| rank(path, key));
    pairs
}
