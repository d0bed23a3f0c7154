//! Reads `trajectory.csv` and `events.csv` back, to compare runs that were written to disk.

use crate::language::{Message, Text, message, said};
use crate::scene::shown::shown;

/// A place or a value as a complaint shows it.
fn cut(text: &str) -> String {
    /// Characters that are shown.
    const LONGEST: usize = 200;
    shown(text, LONGEST)
}

/// A table of numbers against time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// Column `t` \[s\].
    pub t: Vec<f64>,
    /// The other columns, by name, in the order of the file.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// One row of `events.csv`, as far as a comparison needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct EventRow {
    /// Time \[s\].
    pub t: f64,
    /// The contact: pair, and node and face where the file has them.
    pub contact: String,
    /// What, as [`EventKind::label`](crate::sim::EventKind::label) spells it.
    pub kind: String,
}

/// Fault of a table, and its place.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", said!("table-error", "place" => cut(&place.to_string()), "value" => cut(&value.to_string()), "remedy" => *remedy))]
pub struct TableError {
    /// `line 3, column deck.x`.
    pub place: Message,
    /// Value found.
    pub value: Message,
    /// Remedy.
    pub remedy: Text,
}

/// Reads the bytes of a `trajectory.csv`; columns of states, `NAME.state`, are words and are passed over.
///
/// # Errors
///
/// Bytes that are not a table of finite numbers whose first column is `t`.
pub fn trajectory(bytes: &[u8]) -> Result<Trajectory, TableError> {
    let mut reader = csv::Reader::from_reader(bytes);
    let names: Vec<String> = reader.headers().map_err(not_csv)?.iter().map(str::to_owned).collect();
    if names.first().is_none_or(|name| name != "t") {
        let value = message!("columns-these", "names" => cut(&names.join(", ")));
        return Err(TableError { place: line(1), value, remedy: Text::new("table-first") });
    }
    let mut values = vec![Vec::new(); names.len()];
    for record in reader.records() {
        let record = record.map_err(not_csv)?;
        for ((field, name), column) in
            record.iter().zip(&names).zip(&mut values).filter(|((_, name), _)| !is_word(name))
        {
            column.push(number(field, name, &record)?);
        }
    }
    let mut columns = names.into_iter().zip(values);
    let t = columns.next().map(|(_, t)| t).unwrap_or_default();
    Ok(Trajectory { t, columns: columns.filter(|(name, _)| !is_word(name)).collect() })
}

/// Whether a column holds words.
fn is_word(name: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, quantity)| quantity == "state")
}

/// Reads the bytes of an `events.csv`; columns other than `t`, `pair`, `kind`, `node` and `face` are passed over.
///
/// # Errors
///
/// Bytes that are not a table with those first three columns.
pub fn events(bytes: &[u8]) -> Result<Vec<EventRow>, TableError> {
    let mut reader = csv::Reader::from_reader(bytes);
    let names = reader.headers().map_err(not_csv)?.clone();
    let find = |name: &str| names.iter().position(|have| have == name);
    let need = |name: &'static str| {
        let remedy = Text::new("table-needed");
        find(name).ok_or_else(|| TableError { place: line(1), value: message!("columns-none", "name" => name), remedy })
    };
    let (t, pair, kind) = (need("t")?, need("pair")?, need("kind")?);
    let contact = [Some(pair), find("node"), find("face")];
    let row = |record: Result<csv::StringRecord, csv::Error>| {
        let record = record.map_err(not_csv)?;
        let field = |column: usize| record.get(column).unwrap_or_default();
        let parts: Vec<&str> = contact.into_iter().flatten().map(field).collect();
        let time = number(field(t), "t", &record)?;
        Ok(EventRow { t: time, contact: parts.join(" "), kind: field(kind).to_owned() })
    };
    reader.records().map(row).collect()
}

fn number(field: &str, column: &str, record: &csv::StringRecord) -> Result<f64, TableError> {
    field.trim().parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| TableError {
        place: message!(
            "table-line-column",
            "line" => record.position().map_or(0, csv::Position::line),
            "column" => column
        ),
        value: format!("{field:?}").into(),
        remedy: Text::new("table-number"),
    })
}

#[expect(clippy::needless_pass_by_value, reason = "for map_err")]
fn not_csv(error: csv::Error) -> TableError {
    TableError {
        place: line(error.position().map_or(0, csv::Position::line)),
        value: error.to_string().into(),
        remedy: Text::new("table-fields"),
    }
}

fn line(number: u64) -> Message {
    message!("table-line", "line" => number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_for_a_number_is_refused_by_line_and_column() {
        let error = trajectory(b"t,deck.x\n0,0\n0.1,abc\n").expect_err("abc is no number");
        assert_eq!(error.place.to_string(), "line 3, column deck.x", "where it stands");
        assert!(error.to_string().contains("abc"), "what stands there: {error}");
    }

    #[test]
    fn a_short_line_is_refused() {
        assert!(trajectory(b"t,deck.x\n0\n").is_err(), "one field is missing");
    }

    #[test]
    fn events_are_told_apart_by_node_where_the_file_has_nodes() {
        let rows = events(b"t,pair,kind,node,face\n0.5,deck+x|wall,->open,deck.corner1,wall\n").expect("a table");
        assert_eq!(rows[0].contact, "deck+x|wall deck.corner1 wall", "pair, node, face");
        let rows = events(b"t,pair,kind\n0.5,deck+x|wall,->open\n").expect("the short form is a table too");
        assert_eq!(rows[0].contact, "deck+x|wall", "pair only");
    }
}
