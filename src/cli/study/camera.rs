//! `girderbench study camera`: the error of a film of marks, as a page, CSV and plots.

use std::path::PathBuf;

use super::page::{OccasionArgs, written};
use crate::cli::args::Threads;
use crate::cli::console::Console;
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::cli::plot_files::plot_files;
use crate::study::camera;

/// Measure what a film of marks is worth: error against mark size, resolution, exposure, noise, quantisation
#[derive(Clone, Debug, clap::Args)]
pub(super) struct CameraArgs {
    /// Write camera.md, camera.csv and the plots into this folder
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    occasion: OccasionArgs,
}

/// Does it.
///
/// # Errors
/// Files that cannot be written.
pub(super) fn run(args: &CameraArgs, console: &mut Console) -> Result<(), Failure> {
    args.threads.start()?;
    crate::files::check_folder(&args.out)?;
    let rows = camera::study()?;
    let command = format!("girderbench study camera --out {}", args.out.display());
    let page = camera::page(&rows, &args.occasion.with(command));
    let csv = camera::csv(&rows);
    let mut all =
        vec![("camera.md".to_owned(), page.into_bytes()), ("camera.csv".to_owned(), csv.clone().into_bytes())];
    for (name, plot) in camera::plots(&rows) {
        all.extend(plot_files(name, plot.svg())?);
    }
    write_files(&args.out, &all)?;
    console.print(&csv);
    console.print(&written(&args.out, all.len()));
    Ok(())
}
