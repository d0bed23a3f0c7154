//! Whether girders stay on their seats, in `summary.json`.

use serde::Serialize;

use crate::language::Language;
use crate::scene::Girder;
use crate::sim::{History, verdict};

/// Whether a girder stays on its seats.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VerdictReport {
    /// The girder.
    pub girder: String,
    /// Whether every corner stays over its seat.
    pub stays: bool,
    /// The moment that decides it \[s\].
    pub t: f64,
    /// The same in words.
    pub words: String,
}

/// Of the girders that have seats.
pub(super) fn of(history: &History) -> Vec<VerdictReport> {
    let report = |(number, girder): (usize, &Girder)| {
        let verdict = verdict::verdict(history, number)?;
        let (girder, words) = (girder.name.clone(), Language::English.within(|| verdict.words()));
        Some(VerdictReport { girder, stays: verdict.stays(), t: verdict.t(), words })
    };
    history.scene().girders.iter().enumerate().filter_map(report).collect()
}
