//! Quantities of a run over time as a table.

use std::io::Write;

use super::{number, sample_times, to_csv};
use crate::sim::{History, Quantity};

/// The table: `t`, then a column a quantity under its name, SI, at a constant rate \[Hz\].
///
/// # Errors
///
/// Those of the writer.
pub fn quantities(
    history: &History,
    columns: &[(String, Quantity)],
    sample_hz: f64,
    out: &mut dyn Write,
) -> std::io::Result<()> {
    let header: Vec<String> =
        std::iter::once("t".to_owned()).chain(columns.iter().map(|(name, _)| name.clone())).collect();
    let rows = sample_times(history.end(), sample_hz).map(|t| {
        let values = columns.iter().map(|(_, quantity)| number(quantity.at(history, t)));
        std::iter::once(number(t)).chain(values).collect()
    });
    to_csv(&header, rows, out)
}
