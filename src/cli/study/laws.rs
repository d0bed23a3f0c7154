//! `girderbench study laws`: every normal law on one hit and on ten seconds, as a page, CSV and plots.

use std::path::PathBuf;

use super::page::{OccasionArgs, picture_extension, written};
use crate::cli::args::Threads;
use crate::cli::console::Console;
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::cli::plot_files::plot_files;
use crate::study::laws;

/// Compare the normal contact laws: one hit, ten seconds, force against penetration
#[derive(Clone, Debug, clap::Args)]
pub(super) struct LawsArgs {
    /// Write laws.md, laws.csv and the plots into this folder
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
pub(super) fn run(args: &LawsArgs, console: &mut Console) -> Result<(), Failure> {
    args.threads.start()?;
    crate::files::check_folder(&args.out)?;
    let outcomes = laws::study()?;
    let command = format!("girderbench study laws --out {}", args.out.display());
    let page = laws::page(&outcomes, &args.occasion.with(command), picture_extension());
    let csv = laws::csv(&outcomes);
    let mut all = vec![("laws.md".to_owned(), page.into_bytes()), ("laws.csv".to_owned(), csv.clone().into_bytes())];
    for (name, svg) in laws::pictures(&outcomes) {
        all.extend(plot_files(name, svg)?);
    }
    write_files(&args.out, &all)?;
    console.print(&csv);
    console.print(&written(&args.out, all.len()));
    Ok(())
}
