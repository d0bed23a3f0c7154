//! `girderbench report`: a run on one page of HTML.

use std::path::PathBuf;

use super::args::{SceneArgs, Threads};
use super::compute::compute_as_asked;
use super::console::Console;
use super::domain;
use super::failure::Failure;
use crate::files;
use crate::language::said;
use crate::report;
use crate::tables::DEFAULT_SAMPLE_HZ;

/// Run a scene and write one page to hand to a colleague: scene, assumptions, motion, hardest hit, seats and codes, errors
#[derive(Clone, Debug, clap::Args)]
pub(super) struct ReportArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    threads: Threads,
    /// The page, one HTML file with every picture inside
    #[arg(long, value_name = "FILE.html")]
    out: PathBuf,
}

/// Does it.
///
/// # Errors
/// Bad input, a file of another kind, no place to write; a run that gave up, after its page has been written.
pub(super) fn run(args: &ReportArgs, console: &mut Console) -> Result<(), Failure> {
    let is_html = args.out.extension().is_some_and(|e| e.eq_ignore_ascii_case("html") || e.eq_ignore_ascii_case("htm"));
    if !is_html {
        return Err(Failure::Input(said!("wrong-report-format", "out" => args.out.display().to_string())));
    }
    let scene = args.scene.load()?;
    args.threads.start()?;
    domain::warn(&scene, console);
    let timed = args.scene.of_its_file(compute_as_asked(&scene))?;
    let page = report::html(&timed.history, &timed.options(DEFAULT_SAMPLE_HZ));
    files::write_atomic(&args.out, page.as_bytes())?;
    console.print(&format!("{}\n", said!("report-written-to", "file" => args.out.display().to_string())));
    match timed.history.stop() {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name, stop: stop.clone() }),
        None => Ok(()),
    }
}
