//! The answer as tables: bytes of CSV and JSON, for the command line, the window and other programs.
//!
//! Everything is SI and radians in the world frame; a number is written with the fewest digits that read back as the
//! same double, so a table loses nothing but the sign of zero. Displacements are those of G from where the girder was placed. Forces act on
//! the body that owns the node; the face's body gets the opposite.

pub mod compare;
mod contacts;
mod departures;
mod devices;
mod events;
mod flexible;
mod impact;
mod quantities;
pub mod read;
mod seats;
mod summary;
mod supports;
mod trajectory;
mod verdicts;

pub use contacts::{contact_cells, contacts};
pub use departures::{
    DroppedReport, LostReport, OutsideReport, OverlapReport, PassedReport, TooDeepReport, UpliftReport,
};
pub use devices::{DeviceReport, devices};
pub use events::events;
pub use flexible::{FlexibleReport, FlexibleRun};
pub use impact::{hits, transitions};
pub use quantities::quantities;
pub use seats::{CornerReport, DemandReport, SeatReport, corner_angle};
pub use summary::{PairReport, Report, Versions};
pub use supports::{BackfillReport, BearingsReport, PierReport, backfill, piers};
pub use trajectory::{trajectory, trajectory_columns};
pub use verdicts::VerdictReport;

use std::io::Write;

use crate::sim::{DegreeCheck, ErrorEstimate, History};

/// Samples per second unless told otherwise \[Hz\].
pub const DEFAULT_SAMPLE_HZ: f64 = 100.0;

/// Options of the tables beyond the run's results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableOptions {
    /// Rows per second in `trajectory.csv` and `contacts.csv` \[Hz\].
    pub sample_hz: f64,
    /// [`ErrorEstimate::of`], when it was asked for.
    pub estimated_error: Option<ErrorEstimate>,
    /// [`crate::sim::Sections::check_degree`], when it was asked for.
    pub degree_check: Option<DegreeCheck>,
    /// Time of the run's computation, when it was measured \[s\].
    pub run_time: Option<f64>,
}

impl Default for TableOptions {
    fn default() -> Self {
        Self { sample_hz: DEFAULT_SAMPLE_HZ, estimated_error: None, degree_check: None, run_time: None }
    }
}

/// A table of an answer, written on demand: it may be larger than what memory holds.
pub struct Table<'a> {
    /// Name of its file.
    pub name: String,
    write: Box<Writes<'a>>,
}

type Writes<'a> = dyn Fn(&mut dyn Write) -> std::io::Result<()> + 'a;

impl std::fmt::Debug for Table<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Table").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Table<'_> {
    /// Writes its bytes.
    ///
    /// # Errors
    ///
    /// Those of the writer.
    pub fn write(&self, out: &mut dyn Write) -> std::io::Result<()> {
        (self.write)(out)
    }
}

/// Tables of an answer that every model has, those that the impact model adds, and that of devices where a scene has any.
const NAMES: [&str; 4] = ["trajectory.csv", "contacts.csv", "events.csv", SUMMARY];
const OF_IMPACT: [&str; 2] = ["hits.csv", "transitions.csv"];
const DEVICES: &str = "devices.csv";
const SUMMARY: &str = "summary.json";
/// Names under which an answer has a summary, of the model that leads and of the one beside it.
pub const SUMMARIES: &[&str] = &[SUMMARY, "impact-summary.json", "contact-summary.json"];

/// Every table of an answer; the impact model adds its hits and transitions.
pub fn all<'a>(history: &'a History, options: &TableOptions) -> Vec<Table<'a>> {
    named(history, *options, str::to_owned)
}

/// The tables of the model that does not lead, beside the other's.
pub fn all_beside<'a>(history: &'a History, options: &TableOptions) -> Vec<Table<'a>> {
    named(history, *options, |name| format!("{}-{name}", history.scene().model.kind.label()))
}

fn named<'a>(history: &'a History, options: TableOptions, name: impl Fn(&str) -> String) -> Vec<Table<'a>> {
    let hz = options.sample_hz;
    let impact: &[&str] = if history.impact().is_some() { &OF_IMPACT } else { &[] };
    let has_links = history.impact().is_none() && !history.model().links.is_empty();
    let of_links = has_links.then_some(DEVICES);
    let all = || NAMES.iter().chain(impact).copied().chain(of_links);
    let files: Vec<String> = all().map(&name).collect();
    let write = |file: &str| -> Box<Writes<'a>> {
        let files = files.clone();
        match file {
            "trajectory.csv" => Box::new(move |out| trajectory(history, hz, out)),
            "contacts.csv" => Box::new(move |out| contacts(history, hz, out)),
            "events.csv" => Box::new(move |out| events(history, out)),
            "hits.csv" => Box::new(move |out| hits(history, out)),
            "transitions.csv" => Box::new(move |out| transitions(history, out)),
            DEVICES => Box::new(move |out| devices(history, out)),
            _ => Box::new(move |out| {
                out.write_all(&Report { files: files.clone(), ..Report::of(history, &options) }.to_json())
            }),
        }
    };
    all().map(|file| Table { name: name(file), write: write(file) }).collect()
}

/// The tables that a summary names as of its answer; none where the bytes are no summary of this program.
pub fn named_in(summary: &[u8]) -> Vec<String> {
    let summary: serde_json::Value = serde_json::from_slice(summary).unwrap_or_default();
    let own = summary["versions"]["girderbench"].is_string();
    let files = summary["files"].as_array().filter(|_| own).into_iter().flatten();
    files.filter_map(serde_json::Value::as_str).filter(|name| is_table(name)).map(str::to_owned).collect()
}

/// Whether an answer may have a table of that name.
fn is_table(name: &str) -> bool {
    let name = ["impact-", "contact-"].iter().find_map(|model| name.strip_prefix(model)).unwrap_or(name);
    NAMES.iter().chain(&OF_IMPACT).chain(&[DEVICES]).any(|own| *own == name)
}

/// The bytes of a table that fits into memory.
pub fn in_memory(write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Vec<u8> {
    let mut bytes = Vec::new();
    let written = write(&mut bytes);
    debug_assert!(written.is_ok(), "memory takes everything: {written:?}");
    bytes
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

/// Writes a header and rows of one width as CSV.
fn to_csv(header: &[String], rows: impl IntoIterator<Item = Vec<String>>, out: &mut dyn Write) -> std::io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    let written = writer.write_record(header);
    written.and_then(|()| rows.into_iter().try_for_each(|row| writer.write_record(row))).map_err(of_writer)?;
    writer.flush()
}

/// Error of the writer; any other would be a mistake of the table's own function.
fn of_writer(error: csv::Error) -> std::io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => std::io::Error::other(format!("{other:?}")),
    }
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
    fn a_summary_names_tables_and_nothing_else() {
        let own = |files: &str| format!(r#"{{"versions": {{"girderbench": "0.1.0"}}, "files": {files}}}"#);
        let files = r#"["hits.csv", "impact-events.csv", "../hits.csv", "my.csv", 3, "summary.json.toml"]"#;
        assert_eq!(named_in(own(files).as_bytes()), ["hits.csv", "impact-events.csv"], "names of tables");
        for other in [r#"{"files": ["hits.csv"]}"#, "[]", "", "{\"versions\": 3}"] {
            assert!(named_in(other.as_bytes()).is_empty(), "no summary of this program: {other}");
        }
    }

    #[test]
    fn samples_fall_on_whole_fractions_of_the_rate() {
        let times: Vec<f64> = sample_times(0.3, 10.0).collect();
        assert_eq!(times, [0.0, 0.1, 0.2, 0.3], "i / hz, the end included");
    }
}
