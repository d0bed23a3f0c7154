//! `girderbench run`: computes a scene, prints a summary, writes the tables.

use std::path::PathBuf;

use super::args::{SceneArgs, Threads, positive};
use super::compute::{Timed, compute};
use super::console::Console;
use super::domain;
use super::failure::Failure;
use super::output::write_answer;
use super::{limits, summary};
use crate::files;
use crate::sim::moving_ground::moved_supports;
use crate::tables::{DEFAULT_SAMPLE_HZ, Report};

/// Run a scene: a summary here, the tables into a folder
#[derive(Clone, Debug, clap::Args)]
pub(super) struct RunArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Rows per second in the tables [Hz]
    #[arg(long, value_name = "HZ", default_value_t = DEFAULT_SAMPLE_HZ, value_parser = positive, allow_negative_numbers = true)]
    sample: f64,
    #[command(flatten)]
    threads: Threads,
    /// Write trajectory.csv, contacts.csv, events.csv and summary.json into this folder, devices.csv where the scene has devices,
    /// bearings that yield, slide or can be lost, or soil; of the impact model also hits.csv and transitions.csv, and impact-….csv beside
    /// the contact model's where the scene asks for both
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print a hash of the whole answer and nothing else
    #[arg(long)]
    digest: bool,
}

/// Does it.
///
/// # Errors
/// Bad input; a run that gave up, after its answer has been printed and written.
pub(super) fn run(args: &RunArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    args.threads.start()?;
    // Before the run, so that no answer is lost for want of a place to write it.
    if let Some(folder) = &args.out {
        limits::check_trajectory(args.sample, &scene)?;
        files::check_folder(folder)?;
    }
    domain::warn(&scene, console);
    let timed = args.scene.of_its_file(compute(&scene))?;
    if args.digest {
        for timed in &timed {
            console.print(&format!("{:016x}\n", timed.history.digest()));
        }
    }
    if !args.digest || args.out.is_some() {
        report(args, &timed, console)?;
    }
    match timed.iter().find_map(|timed| timed.history.stop()) {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name, stop: stop.clone() }),
        None => Ok(()),
    }
}

/// Prints the summaries and writes the tables.
fn report(args: &RunArgs, timed: &[Timed], console: &mut Console) -> Result<(), Failure> {
    let mut all = Vec::new();
    for timed in timed {
        let options = timed.options(args.sample);
        domain::warn_of_balance(&timed.history, console);
        domain::warn_of_drift(&moved_supports(timed.history.scene(), timed.history.model()), console);
        if !args.digest {
            let report = Report::of(&timed.history, &options);
            domain::warn_of_error(&report, console);
            console.print(&summary::text(&report));
        }
        if args.out.is_some() {
            limits::check_contacts(args.sample, &timed.history)?;
            all.extend(timed.tables(&options));
        }
    }
    let Some(folder) = &args.out else { return Ok(()) };
    let written = write_answer(folder, &all, &[])?;
    if !args.digest {
        console.print(&written);
    }
    Ok(())
}
