//! `girderbench study size`: cost against the number of girders, as CSV and a plot.

use std::path::PathBuf;

use super::page::{OccasionArgs, picture_extension, written};
use crate::cli::args::at_least_one;
use crate::cli::console::Console;
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::cli::plot_files::plot_files;
use crate::study::size;

/// Measure cost against size: rows of 1 to 1000 girders
#[derive(Clone, Debug, clap::Args)]
pub(super) struct SizeArgs {
    /// Write size.md, size.csv and the plot into this folder
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Runs that are timed, after a warm-up; the least counts
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = at_least_one, allow_negative_numbers = true)]
    repeat: usize,
    /// Rows of up to 100 girders only
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    occasion: OccasionArgs,
}

/// Does it.
///
/// # Errors
/// Files that cannot be written.
pub(super) fn run(args: &SizeArgs, console: &mut Console) -> Result<(), Failure> {
    let rows = size::study(args.quick, args.repeat, &mut |what| console.note(what))?;
    let csv = size::csv(&rows);
    let quick = if args.quick { " --quick" } else { "" };
    let command = format!("girderbench study size --repeat {}{quick} --out {}", args.repeat, args.out.display());
    let page = size::page(&rows, &args.occasion.with(command), picture_extension());
    let mut all = vec![("size.csv".to_owned(), csv.clone().into_bytes()), ("size.md".to_owned(), page.into_bytes())];
    all.extend(plot_files("size", size::plot(&rows).svg())?);
    write_files(&args.out, &all)?;
    console.print(&csv);
    console.print(&written(&args.out, all.len()));
    Ok(())
}
