//! How many cells tables may have.

use super::digits::six;
use super::failure::Failure;
use crate::language::{Text, said};
use crate::scene::Scene;
use crate::sim::History;
use crate::tables;

/// Most cells of a table on the disk: a number of seventeen digits with its sign, exponent and comma takes 25 bytes, and a table
/// of 4 GiB is what `compare` reads.
const MOST_CELLS: f64 = 1.7e8;
/// Most cells of a table that is compared without being on the disk, as text and as numbers at once: 0.7 GB.
const MOST_IN_MEMORY: f64 = 2e7;

/// Most cells of a table that is drawn too: a picture of so many points is a document of 40 MB.
const MOST_DRAWN: f64 = 2e6;

/// Refuses a `plot.csv` of too many cells in so many columns, before anything is computed.
pub(super) fn check_plot(sample_hz: f64, scene: &Scene, columns: usize) -> Result<(), Failure> {
    check(sample_hz, ("plot.csv", sample_hz * scene.duration * columns as f64), MOST_DRAWN)
}

/// Refuses a `trajectory.csv` of too many cells, before anything is computed.
pub(super) fn check_trajectory(sample_hz: f64, scene: &Scene) -> Result<(), Failure> {
    let columns = tables::trajectory_columns(scene) as f64;
    check(sample_hz, ("trajectory.csv", sample_hz * scene.duration * columns), MOST_CELLS)
}

/// The same of one that is kept in memory.
pub(super) fn check_in_memory(sample_hz: f64, scene: &Scene) -> Result<(), Failure> {
    let columns = tables::trajectory_columns(scene) as f64;
    check(sample_hz, (Text::new("failed-trajectory").as_str(), sample_hz * scene.duration * columns), MOST_IN_MEMORY)
}

/// Refuses a `contacts.csv` of too many cells, by what was computed.
pub(super) fn check_contacts(sample_hz: f64, history: &History) -> Result<(), Failure> {
    check(sample_hz, ("contacts.csv", tables::contact_cells(history, sample_hz)), MOST_CELLS)
}

fn check(sample_hz: f64, (table, cells): (&str, f64), most: f64) -> Result<(), Failure> {
    if cells <= most {
        return Ok(());
    }
    let less = sample_hz * most / cells;
    Err(Failure::Input(said!(
        "failed-cells",
        "samplehz" => sample_hz,
        "table" => table,
        "cells" => format!("{cells:.1e}"),
        "most" => format!("{most:.1e}"),
        "less" => format!("{less:.3e}")
    )))
}

/// Failure by a time after the end of the run.
pub(super) fn after_end(flag: &str, t: f64, history: &History) -> Failure {
    let [t, end] = [t, history.end()].map(six);
    Failure::Input(said!("wrong-after-end", "flag" => flag, "t" => t, "end" => end))
}
