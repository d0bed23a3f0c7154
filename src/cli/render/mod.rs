//! `girderbench render`: pictures of a run, one device for all of them.

mod args;
mod choices;
mod film;
mod mark_args;
mod marks;

pub(super) use args::RenderArgs;

use super::compute::compute_as_asked;
use super::console::Console;
use super::domain;
use super::failure::Failure;
use crate::language::Text;
use crate::render::GpuError;
use crate::sim::History;
use crate::snapshot::{Instant, Studio};
use args::{Wanted, reaches};

/// Runs the scene and writes its pictures: all of them, or none.
///
/// # Errors
/// Bad input, a time that the run does not reach, nothing that draws, a file that cannot be written; a run that gave up,
/// after its pictures have been written.
pub(super) fn run(args: &RenderArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    args.check_out()?;
    args.force_of(&scene)?;
    args.threads.start()?;
    // Before the run, so that a machine that cannot draw says so at once.
    let mut studio = Studio::open(args.quality.quality()).map_err(Failure::from)?;
    domain::warn(&scene, console);
    let history = args.scene.of_its_file(compute_as_asked(&scene))?.history;
    std::iter::once(&history).chain(history.beside()).for_each(|history| domain::warn_of_balance(history, console));
    let wanted = wanted(args, &history, console)?;
    console.print(&film::take(args, &mut studio, &history, &wanted)?);
    if args.marks.given() {
        console.print(&marks::write_layout(args, &history, &wanted)?);
    }
    match history.stop() {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name.clone(), stop: stop.clone() }),
        None => Ok(()),
    }
}

fn reached(history: &History, at: Instant, console: &mut Console) -> Result<(), Failure> {
    match at {
        Instant::At(t) => reaches(history, "--at", t),
        Instant::Peak => {
            if history.hits().hardest().is_none() {
                console.note(&Text::new("note-no-peak"));
            }
            Ok(())
        }
    }
}

/// Every picture that is asked for.
fn wanted(args: &RenderArgs, history: &History, console: &mut Console) -> Result<Vec<Wanted>, Failure> {
    match args.frames {
        Some(count) => film::frames(args, history, count),
        None if args.marks.given() => marks::frames(args, history),
        None => args.at.iter().map(|&at| still(args, history, at, console)).collect(),
    }
}

fn still(args: &RenderArgs, history: &History, at: Instant, console: &mut Console) -> Result<Wanted, Failure> {
    reached(history, at, console)?;
    let when = match at {
        Instant::Peak => "peak".to_owned(),
        Instant::At(t) => format!("{t}s"),
    };
    Ok(Wanted { path: args.path(history, &when), shot: args.shot(at, history.scene()) })
}

impl From<GpuError> for Failure {
    fn from(error: GpuError) -> Self {
        match error {
            GpuError::Size(..) => Self::Input(format!("--size: {error}")),
            other => Self::NoPicture(other.to_string()),
        }
    }
}
