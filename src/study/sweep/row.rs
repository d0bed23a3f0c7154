//! What came out of a run of a sweep.

use super::plan::Plan;
use crate::sim::{History, Stop};

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// At the scene's duration.
    Complete,
    /// Before its time.
    GaveUp,
    /// It was not computed: its values do not make a scene together.
    Refused,
}

impl Status {
    /// Every status with the word that stands in the dataset.
    const WORDS: [(Self, &str); 3] =
        [(Self::Complete, "complete"), (Self::GaveUp, "gave up"), (Self::Refused, "refused")];

    /// The word that stands in the dataset.
    pub fn word(self) -> &'static str {
        Self::WORDS.iter().find(|(status, _)| *status == self).map_or("", |(_, word)| word)
    }

    /// The status of this word.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(_, known)| *known == word).map(|(status, _)| *status)
    }
}

/// What came out of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Number of the run in its [`Plan`].
    pub run: usize,
    /// How it ended.
    pub status: Status,
    /// One a measure, in its unit; none where the run has no such thing, and of a run that did not reach its end.
    pub values: Vec<Option<f64>>,
    /// Why it did not reach its end; empty where it did.
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
        if let Some(Stop { t, place, reason, .. }) = history.stop() {
            return without(Status::GaveUp, format!("at {t:?} s, {place}: {reason}"));
        }
        let values = plan.measures.iter().map(|measure| measure.of(&history)).collect();
        Self { run, status: Status::Complete, values, reason: String::new() }
    }
}
