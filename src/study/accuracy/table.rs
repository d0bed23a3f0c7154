//! The study as CSV: one row a measurement, one a reference.

use super::study::{Row, Study};

/// The columns.
const HEAD: &str = "problem,method,setting_kind,setting,seconds,runs,steps,displacement_error_m,rotation_error_rad,peak_force_error_relative,note\n";

impl Study {
    /// Everything that was measured. Seconds are the least of the runs; a row without errors has no answer, its note
    /// says why.
    pub fn csv(&self) -> String {
        let rows = self.parts.iter().flat_map(|part| &part.rows).map(line);
        std::iter::once(HEAD.to_owned()).chain(rows).collect()
    }
}

fn line(row: &Row) -> String {
    let kind = if row.is_step { "step_s" } else { "tolerance" };
    let errors = row
        .errors
        .map_or(",,".to_owned(), |e| format!("{:.4e},{:.4e},{:.4e}", e.displacement, e.rotation, e.peak_force));
    let note = row.note.replace('"', "'");
    format!(
        "{},{},{kind},{:.6e},{:.4e},{},{},{errors},\"{note}\"\n",
        row.problem, row.method, row.setting, row.seconds, row.runs, row.steps
    )
}
