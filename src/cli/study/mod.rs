//! `girderbench study`: many runs, and what they show.

mod accuracy;
mod size;
mod stability;

use super::{Console, Failure};
use crate::study::Occasion;

/// Measure the program: work against error, cost against size, random scenes
#[derive(Clone, Debug, clap::Args)]
pub(super) struct StudyArgs {
    #[command(subcommand)]
    study: Study,
}

#[derive(Clone, Debug, clap::Subcommand)]
enum Study {
    Accuracy(accuracy::AccuracyArgs),
    Size(size::SizeArgs),
    Stability(stability::StabilityArgs),
}

/// What a page says of when and where it was measured.
#[derive(Clone, Debug, clap::Args)]
struct OccasionArgs {
    /// What the page calls the day of the measurement
    #[arg(long, value_name = "TEXT", default_value = "a day that was not given")]
    date: String,
    /// What the page calls the machine
    #[arg(long, value_name = "TEXT", default_value = "a machine that was not named")]
    machine: String,
}

impl OccasionArgs {
    fn with(&self, command: String) -> Occasion {
        Occasion { date: self.date.clone(), machine: self.machine.clone(), command }
    }
}

/// Does it.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub(super) fn run(args: &StudyArgs, console: &mut Console) -> Result<(), Failure> {
    match &args.study {
        Study::Accuracy(args) => accuracy::run(args, console),
        Study::Size(args) => size::run(args, console),
        Study::Stability(args) => stability::run(args, console),
    }
}

/// A plot's files: its SVG, and its PNG where this build draws one.
#[cfg(feature = "study")]
fn plot_files(name: &str, plot: &crate::study::plot::Plot) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let svg = plot.svg();
    let png = crate::study::plot::png(&svg).map_err(|error| Failure::NoPicture(format!("{name}.png: {error}")))?;
    Ok(vec![(format!("{name}.svg"), svg.into_bytes()), (format!("{name}.png"), png)])
}

/// A plot's files: its SVG; this build draws no PNG.
#[cfg(not(feature = "study"))]
#[expect(clippy::unnecessary_wraps, reason = "the same call as in a build with PNG")]
fn plot_files(name: &str, plot: &crate::study::plot::Plot) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    Ok(vec![(format!("{name}.svg"), plot.svg().into_bytes())])
}

/// What pictures on a page end in.
fn picture_extension() -> &'static str {
    if cfg!(feature = "study") { "png" } else { "svg" }
}

/// A count of at least one.
fn at_least_one(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(n) if n > 0 => Ok(n),
        _ => Err("give a whole number of at least 1".into()),
    }
}
