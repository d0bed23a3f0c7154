//! How a command fails, and the exit status that says so.

use std::process::ExitCode;

use super::digits::six;
use super::summary::name;
use crate::files::{ReadError, WriteError};
use crate::language::said;
use crate::scene::SceneErrors;
use crate::sim::Stop;

/// Why a command did not do what it was asked.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    /// The input cannot be used, or nothing can be written where it asks; each line names file or flag, place, value, remedy.
    #[error("{0}")]
    Input(String),
    /// The answer cannot be written, whatever the input: no space, a device that fails.
    #[error("{0}")]
    Output(String),
    /// Nothing draws pictures here, or the window not any more; the message says what is missing.
    #[error("{0}")]
    NoPicture(String),
    /// The run ended before its time; what it has was kept.
    #[error("{}", gave_up(scene, stop))]
    GaveUp {
        /// The scene's name.
        scene: String,
        /// Where and why.
        stop: Stop,
    },
    /// A signal came while files were written; the message says what was kept.
    #[error("{}", said!("failed-interrupted", "kept" => .0.as_str()))]
    Interrupted(String),
    /// A study found what it looked for; everything was written.
    #[error("{0}")]
    Study(String),
}

/// Text on the cause of a run's early end.
fn gave_up(scene: &str, stop: &Stop) -> String {
    said!(
        "failed-gave-up",
        "scene" => name(scene),
        "ended" => stop.cause.verb().as_str(),
        "t" => six(stop.t),
        "place" => stop.place.as_str(),
        "reason" => stop.reason.to_string()
    )
}

impl Failure {
    /// 2 for input that cannot be used (as for a mistyped flag), 1 for a run that gave up, 3 where nothing draws, 4 where the
    /// answer cannot be written.
    pub(super) fn exit_code(&self) -> ExitCode {
        match self {
            Self::Input(_) => ExitCode::from(2),
            Self::NoPicture(_) => ExitCode::from(3),
            Self::Output(_) => ExitCode::from(4),
            Self::GaveUp { .. } | Self::Study(_) => ExitCode::from(1),
            // Where the program does not end by the signal itself: what a shell makes of SIGINT.
            Self::Interrupted(_) => ExitCode::from(130),
        }
    }
}

impl From<SceneErrors> for Failure {
    fn from(errors: SceneErrors) -> Self {
        Self::Input(errors.to_string())
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        let said = error.to_string();
        if error.is_of_place() { Self::Input(said) } else { Self::Output(said) }
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        Self::Input(error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::Cause;

    #[test]
    fn a_run_that_gives_up_says_where_and_why() {
        let stop = Stop {
            cause: Cause::Computation,
            t: 0.25,
            place: "deck".into(),
            reason: "the step fell to 1e-20 s".into(),
        };
        let failure = Failure::GaveUp { scene: "bridge".into(), stop };
        let said = failure.to_string();
        assert_eq!(said, "the run of bridge gave up at t = 0.25 s, deck: the step fell to 1e-20 s", "all of it");
        assert_eq!(failure.exit_code(), ExitCode::from(1), "not bad input");
    }
}
