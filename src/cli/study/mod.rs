//! `girderbench study`: many runs, one question; one file per study.

mod stability;

use super::{Console, Failure};

/// Ask many runs one question, and write what they answer
#[derive(Debug, clap::Args)]
pub(super) struct StudyArgs {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, clap::Subcommand)]
enum What {
    Stability(stability::StabilityArgs),
}

/// Does it.
///
/// # Errors
/// What the study says.
pub(super) fn run(args: &StudyArgs, console: &mut Console) -> Result<(), Failure> {
    match &args.what {
        What::Stability(args) => stability::run(args, console),
    }
}
