//! The dataset of a sweep: a row a run in the order of their numbers, as CSV, and what its columns mean, as JSON.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use xxhash_rust::xxh3::xxh3_64;

use super::axis::{Axis, number};
use super::journal::Identity;
use super::measure::Measure;
use super::plan::Plan;
use super::row::Row;
use crate::scene::keys;

/// The rows of a sweep, each in its place.
#[derive(Debug)]
pub struct Dataset<'a> {
    /// The sweep.
    pub plan: &'a Plan,
    /// Every row, by the number of its run.
    pub rows: &'a BTreeMap<usize, Row>,
}

/// A column.
#[derive(Clone, Copy, Debug)]
pub enum Column<'a> {
    /// The number of the run.
    Run,
    /// A key that varies, and its place among them.
    Key(usize, &'a Axis),
    /// A measure, and its place among them.
    Measure(usize, &'static Measure),
    /// End of the run.
    Status,
    /// Why, where not at its end.
    Reason,
}

impl Column<'_> {
    /// Its heading.
    pub fn name(&self) -> &str {
        match self {
            Self::Run => "run",
            Self::Key(_, axis) => &axis.key,
            Self::Measure(_, measure) => measure.name,
            Self::Status => "status",
            Self::Reason => "reason",
        }
    }

    /// Whether it holds numbers; words else.
    pub fn is_number(&self) -> bool {
        match self {
            Self::Key(_, axis) => axis.numbers().is_some(),
            Self::Measure(..) => true,
            Self::Run | Self::Status | Self::Reason => false,
        }
    }

    fn about(&self) -> Value {
        match self {
            Self::Run => {
                json!({"name": "run", "type": "integer", "meaning": "number of the run, the last key varying first"})
            }
            Self::Key(_, axis) => {
                let meaning = keys::of_place(&axis.key).map_or("", |(_, key)| key.meaning);
                let kind = if self.is_number() { "number" } else { "text" };
                json!({"name": axis.key, "type": kind, "meaning": meaning})
            }
            Self::Measure(_, measure) => {
                json!({"name": measure.name, "type": "number", "unit": measure.unit, "meaning": measure.meaning})
            }
            Self::Status => {
                json!({"name": "status", "type": "text", "meaning": "complete, ended (where its model ends: a support is lost, bodies meet where there is no contact; values until then), gave up or refused"})
            }
            Self::Reason => json!({"name": "reason", "type": "text", "meaning": "why the run did not reach its end"}),
        }
    }
}

/// The columns of a plan's dataset.
pub fn columns(plan: &Plan) -> Vec<Column<'_>> {
    let keys = plan.axes.iter().enumerate().map(|(number, axis)| Column::Key(number, axis));
    let measures = plan.measures.iter().enumerate().map(|(number, measure)| Column::Measure(number, measure));
    let ends = [Column::Status, Column::Reason];
    std::iter::once(Column::Run).chain(keys).chain(measures).chain(ends).collect()
}

/// Description of a sweep as JSON: the parts of its identity, and the meaning of its dataset's columns.
pub fn about(plan: &Plan) -> Value {
    let vary: Vec<Value> = plan.axes.iter().map(|axis| json!({"key": axis.key, "values": axis.values})).collect();
    let measures: Vec<&str> = plan.measures.iter().map(|measure| measure.name).collect();
    json!({
        "girderbench": env!("CARGO_PKG_VERSION"),
        "runs": plan.runs(),
        "vary": vary,
        "measures": measures,
        "columns": columns(plan).iter().map(Column::about).collect::<Vec<_>>(),
        "records": format!("{:016x}", plan.records_hash()),
        "scene": plan.scene_text(),
    })
}

/// The identity of the sweep that this is.
pub fn identity(about: &Value) -> Identity {
    Identity(xxh3_64(about.to_string().as_bytes()))
}

impl Dataset<'_> {
    /// As CSV.
    ///
    /// # Errors
    ///
    /// Those of the writer.
    pub fn csv(&self) -> Result<Vec<u8>, csv::Error> {
        let columns = columns(self.plan);
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(columns.iter().map(Column::name))?;
        for row in self.rows.values() {
            let choice = self.plan.choice(row.run);
            writer.write_record(columns.iter().map(|column| cell(column, row, &choice)))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))
    }
}

/// A cell of CSV; a number with the fewest digits that read back as the same double, nothing where there is no value.
fn cell(column: &Column<'_>, row: &Row, choice: &[usize]) -> String {
    match column {
        Column::Run => row.run.to_string(),
        Column::Key(place, axis) => {
            let text = &axis.values[choice[*place]];
            number(text).filter(|_| column.is_number()).map_or(text.clone(), |number| format!("{number:?}"))
        }
        Column::Measure(place, _) => row.values[*place].map_or(String::new(), |value| format!("{value:?}")),
        Column::Status => row.status.word().to_owned(),
        Column::Reason => row.reason.clone(),
    }
}
