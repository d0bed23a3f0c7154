//! A record of ground motion as read, and what a format of record files is.

use std::path::Path;

/// A format of record files.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// What it is called.
    pub name: &'static str,
    /// Usual extensions of its files, lower case, without the dot.
    pub extensions: &'static [&'static str],
    /// What such a file holds, with units.
    pub contents: &'static str,
    /// Whether the first lines of a file are in this format.
    pub(super) sniff: fn(&[u8]) -> bool,
    /// Reads a whole file.
    pub(super) read: fn(&[u8]) -> Result<Series, RecordError>,
}

/// An evenly sampled acceleration.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Interval \[s\].
    pub dt: f64,
    /// Samples from t = 0 on \[m/s²\].
    pub samples: Vec<f64>,
}

/// What is wrong with a record.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: found {value}; {remedy}")]
pub struct RecordError {
    /// Line in the file, from 1.
    pub line: u64,
    /// What stands there.
    pub value: String,
    /// What would be right.
    pub remedy: String,
}

impl Format {
    /// Whether the name of a file has one of the extensions, in either case.
    pub fn fits_name(&self, path: &Path) -> bool {
        let extension = path.extension().and_then(|extension| extension.to_str());
        extension.is_some_and(|extension| self.extensions.iter().any(|own| own.eq_ignore_ascii_case(extension)))
    }

    /// Name, extensions and contents in one line: `CSV (.csv, .txt): two columns, …`.
    pub fn words(&self) -> String {
        let extensions: Vec<String> = self.extensions.iter().map(|extension| format!(".{extension}")).collect();
        format!("{} ({}): {}", self.name, extensions.join(", "), self.contents)
    }
}
