//! What the pages of all studies need: the occasion, as flags, and the files of their plots.

use crate::cli::failure::Failure;
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

/// A plot's files: its SVG, and its PNG where this build draws one.
#[cfg(feature = "study")]
pub(super) fn plot_files(name: &str, plot: &crate::study::plot::Plot) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let svg = plot.svg();
    let png = crate::study::plot::png(&svg).map_err(|error| Failure::NoPicture(format!("{name}.png: {error}")))?;
    Ok(vec![(format!("{name}.svg"), svg.into_bytes()), (format!("{name}.png"), png)])
}

/// A plot's files: its SVG; this build draws no PNG.
#[cfg(not(feature = "study"))]
#[expect(clippy::unnecessary_wraps, reason = "the same call as in a build with PNG")]
pub(super) fn plot_files(name: &str, plot: &crate::study::plot::Plot) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    Ok(vec![(format!("{name}.svg"), plot.svg().into_bytes())])
}

/// What pictures on a page end in.
pub(super) fn picture_extension() -> &'static str {
    if cfg!(feature = "study") { "png" } else { "svg" }
}
