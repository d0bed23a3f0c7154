//! `girderbench study`: many runs, and what they show.

mod accuracy;
mod camera;
mod experiment;
mod laws;
mod page;
mod size;
mod stability;

use super::console::Console;
use super::failure::Failure;

/// Measure the program: work against error, cost against size, random scenes, the paper's experiment, films
#[derive(Clone, Debug, clap::Args)]
pub(super) struct StudyArgs {
    #[command(subcommand)]
    study: Study,
}

#[derive(Clone, Debug, clap::Subcommand)]
enum Study {
    Accuracy(accuracy::AccuracyArgs),
    Camera(camera::CameraArgs),
    Experiment(experiment::ExperimentArgs),
    Laws(laws::LawsArgs),
    Size(size::SizeArgs),
    Stability(stability::StabilityArgs),
}

/// Does it.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub(super) fn run(args: &StudyArgs, console: &mut Console) -> Result<(), Failure> {
    match &args.study {
        Study::Accuracy(args) => accuracy::run(args, console),
        Study::Camera(args) => camera::run(args, console),
        Study::Experiment(args) => experiment::run(args, console),
        Study::Laws(args) => laws::run(args, console),
        Study::Size(args) => size::run(args, console),
        Study::Stability(args) => stability::run(args, console),
    }
}
