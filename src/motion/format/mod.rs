//! Records of ground motion from the bytes of a file: the formats that are read, and which of them a file is in.
//!
//! A new format is one file beside `csv.rs`, its `mod` and its line in [`FORMATS`]: file dialog and files dropped on the window follow
//! from that list, and a test holds `docs/scene-format.md` against it. What it refuses is said by texts of its own, `record-…`.

mod at2;
mod cosmos;
mod csmip;
mod csv;
mod fortran;
mod heading;
mod knet;
mod one_column;
mod record;
mod text;
mod unit;

use std::path::Path;

pub(crate) use csv::number as decimal;
pub use record::{Channel, Format, Orientation, Record, RecordError, Supplement};
pub use unit::{STANDARD_GRAVITY, Unit};

use crate::language::message;

/// Every format that is read. Where the contents fit several, the first whose extensions fit the name counts.
pub const FORMATS: &[Format] =
    &[at2::FORMAT, knet::FORMAT, cosmos::FORMAT, csmip::FORMAT, csv::FORMAT, one_column::FORMAT];

/// Whether a file of that name is a record of ground motion, by its extension.
pub fn is_record(path: &Path) -> bool {
    FORMATS.iter().any(|format| format.fits_name(path))
}

/// Every format in words, one a line.
pub fn formats_in_words() -> String {
    FORMATS.iter().map(|format| format.words().to_string()).collect::<Vec<_>>().join("\n")
}

/// Reads a record of any of the [`FORMATS`]. `name`, the name or path of the file, counts only where the contents fit no
/// format or several. `beside` is what is stated beside the file.
///
/// # Errors
/// Contents of no known format; else the first line that is not as the format has it.
pub fn read(bytes: &[u8], name: &Path, beside: &Supplement) -> Result<Record, RecordError> {
    read_as(FORMATS, bytes, name, beside)
}

/// Reads with these formats.
fn read_as(formats: &[Format], bytes: &[u8], name: &Path, beside: &Supplement) -> Result<Record, RecordError> {
    let by_contents: Vec<&Format> = formats.iter().filter(|format| (format.sniff)(bytes)).collect();
    let by_name = |among: &[&Format]| among.iter().copied().find(|format| format.fits_name(name)).copied();
    let format = by_name(&by_contents).or(by_contents.first().map(|first| **first));
    let format = format.or_else(|| by_name(&formats.iter().collect::<Vec<_>>()));
    let format = format.ok_or_else(|| unknown(formats, bytes))?;
    Ok(Record { format: format.name, channels: (format.read)(bytes, beside)? })
}

fn unknown(formats: &[Format], bytes: &[u8]) -> RecordError {
    let first = text::Lines::of(bytes).next().unwrap_or_default();
    let both = |one, more| message!("record-formats", "one" => one, "more" => more);
    let known = formats.iter().map(Format::words).reduce(both).unwrap_or_else(|| String::new().into());
    let remedy = message!("record-format", "formats" => known);
    RecordError::new(1, text::quoted(&first), remedy)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Text;

    /// A second format: its interval on a line of its own, then samples in gal, several a line.
    const GAL: Format = Format {
        name: "gal table",
        extensions: &["gal", "txt"],
        contents: Text::new("record-csv"),
        sniff: |bytes| bytes.starts_with(b"DT "),
        read: read_gal,
    };

    fn read_gal(bytes: &[u8], _: &Supplement) -> Result<Vec<Channel>, RecordError> {
        let wrong = |line| RecordError { line, value: "no number".into(), remedy: "give numbers".into() };
        let text = std::str::from_utf8(bytes).map_err(|_| wrong(1))?;
        let mut lines = text.lines();
        let first = lines.next().and_then(|first| first.strip_prefix("DT ")?.trim().parse().ok());
        let samples: Option<Vec<f64>> = lines.flat_map(str::split_whitespace).map(|word| word.parse().ok()).collect();
        let gal_in_si = |samples: Vec<f64>| samples.into_iter().map(|gal| gal / 100.0).collect();
        let samples = samples.map(gal_in_si).ok_or_else(|| wrong(2))?;
        Ok(vec![Channel::plain(first.ok_or_else(|| wrong(1))?, samples)])
    }

    fn read_either(text: &str, name: &str) -> Result<Channel, RecordError> {
        let record = read_as(&[csv::FORMAT, GAL], text.as_bytes(), Path::new(name), &Supplement::default())?;
        Ok(record.channels[0].clone())
    }

    const TABLE: &str = "t_s,a_m_s2\n0,1\n0.5,2\n";
    const IN_GAL: &str = "DT 0.5\n100 200\n";

    #[test]
    fn contents_choose_the_format_whatever_the_name() {
        let wanted = Channel::plain(0.5, vec![1.0, 2.0]);
        for name in ["quake.csv", "quake.gal", "quake.txt", "quake", "QUAKE.GAL"] {
            assert_eq!(read_either(TABLE, name).as_ref(), Ok(&wanted), "a table called {name}");
            assert_eq!(read_either(IN_GAL, name).as_ref(), Ok(&wanted), "samples in gal called {name}");
        }
    }

    #[test]
    fn the_name_chooses_where_the_contents_fit_none() {
        let error = |text, name| read_either(text, name).expect_err("no record").to_string();
        assert!(error("0,1\n", "quake.CSV").contains("at least 2 samples"), "the table's own complaint");
        assert_eq!(error("0.5\n1\n", "a/quake.gal"), "line 1: found no number; give numbers", "the other's");
        let unknown = error("Origin Time 2011/03/11\n", "quake.ew");
        let start =
            "line 1: found `Origin Time 2011/03/11`; give a record in a format that is read: CSV (.csv, .txt): ";
        assert!(unknown.starts_with(start) && unknown.contains("gal table (.gal, .txt): "), "{unknown}");
        assert!(error("", "quake.ew").starts_with("line 1: found nothing"), "an empty file");
    }

    #[test]
    fn extensions_are_known_in_either_case() {
        assert!(is_record(Path::new("a/QUAKE.CSV")) && is_record(Path::new("quake.txt")), "of a table");
        assert!(!is_record(Path::new("bridge.toml")) && !is_record(Path::new("csv")), "of no record");
    }
}
