//! The answer as tables: bytes of CSV and JSON, for the command line, the window and other programs.
//!
//! Everything is SI and radians in the world frame; a number is written with the fewest digits that read back as the
//! same double, so a table loses nothing but the sign of zero. Displacements are those of G from where the girder was placed. Forces act on
//! the body that owns the node; the face's body gets the opposite.

pub mod compare;
mod contacts;
mod events;
mod impact;
pub mod read;
mod summary;
mod trajectory;

pub use contacts::contacts;
pub use events::events;
pub use impact::{hits, transitions};
pub use summary::{OutsideReport, PairReport, Report, SeatReport, Versions};
pub use trajectory::trajectory;

use crate::sim::History;

/// Samples per second unless told otherwise \[Hz\].
pub const DEFAULT_SAMPLE_HZ: f64 = 100.0;

/// What the tables cannot know from the answer alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableOptions {
    /// Rows per second in `trajectory.csv` and `contacts.csv` \[Hz\].
    pub sample_hz: f64,
    /// [`History::estimate_error`], when it was asked for \[m\].
    pub estimated_error: Option<f64>,
    /// How long the run took to compute, when it was timed \[s\].
    pub run_time: Option<f64>,
}

impl Default for TableOptions {
    fn default() -> Self {
        Self { sample_hz: DEFAULT_SAMPLE_HZ, estimated_error: None, run_time: None }
    }
}

/// Every table of an answer, as (file name, bytes); the impact model adds its hits and transitions.
pub fn all(history: &History, options: &TableOptions) -> Vec<(String, Vec<u8>)> {
    let mut all = vec![
        ("trajectory.csv", trajectory(history, options.sample_hz)),
        ("contacts.csv", contacts(history, options.sample_hz)),
        ("events.csv", events(history)),
        ("summary.json", Report::of(history, options).to_json()),
    ];
    if history.impact().is_some() {
        all.extend([("hits.csv", hits(history)), ("transitions.csv", transitions(history))]);
    }
    all.into_iter().map(|(name, bytes)| (name.to_owned(), bytes)).collect()
}

/// The tables of the model that does not lead, beside the other's.
pub fn all_beside(history: &History, options: &TableOptions) -> Vec<(String, Vec<u8>)> {
    let name = |name: String| format!("{}-{name}", history.scene().model.kind.label());
    all(history, options).into_iter().map(|(file, bytes)| (name(file), bytes)).collect()
}

/// The instants `0, 1/hz, 2/hz, …` up to `end`, each `i / hz` to the last bit \[s\].
pub fn sample_times(end: f64, hz: f64) -> impl Iterator<Item = f64> {
    (0_u32..).map(move |i| f64::from(i) / hz).take_while(move |&t| (0.0..=end).contains(&t))
}

/// The fewest digits that read back as the same double; −0 is 0, since no reader of a table means it.
fn number(value: f64) -> String {
    format!("{:?}", value + 0.0)
}

/// A vector as three columns.
fn xyz(v: glam::DVec3) -> [String; 3] {
    [number(v.x), number(v.y), number(v.z)]
}

/// CSV bytes of a header and rows of one width.
fn to_csv(header: &[String], rows: impl IntoIterator<Item = Vec<String>>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory cannot fail, and a row of another width would be a mistake of the table's own function.
    let written =
        writer.write_record(header).and_then(|()| rows.into_iter().try_for_each(|row| writer.write_record(row)));
    debug_assert!(written.is_ok(), "rows as wide as the header: {written:?}");
    writer.into_inner().unwrap_or_default()
}

/// Columns called `name.x`, `name.y`, `name.z`.
fn xyz_header(name: &str) -> [String; 3] {
    ["x", "y", "z"].map(|axis| format!("{name}.{axis}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_bit_for_bit() {
        for value in [0.1, 1.0 / 3.0, 1e-300, -2.5e17, f64::MIN_POSITIVE, 0.0] {
            let back: f64 = number(value).parse().expect("a number");
            assert_eq!(back.to_bits(), value.to_bits(), "{value:?} comes back as {back:?}");
        }
        assert_eq!(number(-0.0), "0.0", "nothing has no sign");
    }

    #[test]
    fn samples_fall_on_whole_fractions_of_the_rate() {
        let times: Vec<f64> = sample_times(0.3, 10.0).collect();
        assert_eq!(times, [0.0, 0.1, 0.2, 0.3], "i / hz, the end included");
    }
}
