//! Common parts of the pages of all studies: the circumstances, as flags, and the extension of their pictures.

use std::path::Path;

use crate::language::said;
use crate::study::Occasion;

/// What a page says of when and where it was measured.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct OccasionArgs {
    /// What the page calls the day of the measurement
    #[arg(long, value_name = "TEXT", default_value = "a day that was not given")]
    date: String,
    /// What the page calls the machine
    #[arg(long, value_name = "TEXT", default_value = "a machine that was not named")]
    machine: String,
}

impl OccasionArgs {
    pub(super) fn with(&self, command: String) -> Occasion {
        Occasion { date: self.date.clone(), machine: self.machine.clone(), command }
    }
}

/// Extension of pictures on a page.
pub(super) fn picture_extension() -> &'static str {
    if cfg!(feature = "study") { "png" } else { "svg" }
}

/// How many files were written where, a line.
pub(super) fn written(folder: &Path, count: usize) -> String {
    format!("{}\n", said!("study-written", "folder" => folder.display().to_string(), "count" => count))
}
