//! Result of a run of a sweep.

use super::plan::Plan;
use crate::sim::{Cause, History, Stop};

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// At the scene's duration.
    Complete,
    /// At the end of its scene's model: a vertical support is lost, or bodies meet where there is no contact.
    Ended,
    /// Before its time: a step or a count came to its bound.
    GaveUp,
    /// It was not computed: its values do not make a scene together.
    Refused,
}

impl Status {
    /// Every status with the word that stands in the dataset.
    const WORDS: [(Self, &str); 4] =
        [(Self::Complete, "complete"), (Self::Ended, "ended"), (Self::GaveUp, "gave up"), (Self::Refused, "refused")];

    /// The word that stands in the dataset.
    pub fn word(self) -> &'static str {
        Self::WORDS.iter().find(|(status, _)| *status == self).map_or("", |(_, word)| word)
    }

    /// The status of this word.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(_, known)| *known == word).map(|(status, _)| *status)
    }
}

/// Result of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Number of the run in its [`Plan`].
    pub run: usize,
    /// End of the run.
    pub status: Status,
    /// One a measure, in its unit; none where the run has no such thing, and of a run that gave up. Of one that ended where its model
    /// ends, until then.
    pub values: Vec<Option<f64>>,
    /// Reason of an early end; empty without one.
    pub reason: String,
}

impl Row {
    /// Computes a run.
    pub fn compute(plan: &Plan, run: usize) -> Self {
        let without = |status, reason| Self { run, status, values: vec![None; plan.measures.len()], reason };
        let history = match plan.scene_of(run).and_then(|scene| History::of(&scene)) {
            Ok(history) => history,
            Err(errors) => return without(Status::Refused, errors.to_string()),
        };
        let (status, reason) = match history.stop() {
            None => (Status::Complete, String::new()),
            Some(Stop { cause, t, place, reason }) => {
                let status = if *cause == Cause::Computation { Status::GaveUp } else { Status::Ended };
                (status, format!("at {t:?} s, {place}: {}", reason.english()))
            }
        };
        if status == Status::GaveUp {
            return without(status, reason);
        }
        let values = plan.measures.iter().map(|measure| measure.of(&history)).collect();
        Self { run, status, values, reason }
    }
}
