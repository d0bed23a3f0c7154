//! Whether girders stay on their seats, in `summary.json`.

use serde::Serialize;

use crate::language::Language;
use crate::scene::Girder;
use crate::sim::History;

/// Whether a girder stays on its seats.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VerdictReport {
    /// The girder.
    pub girder: String,
    /// Whether every corner stays over its seat.
    pub stays: bool,
    /// The moment that decides it \[s\].
    pub t: f64,
    /// The verdict in words, which are English in a file.
    pub words: String,
    /// The verdict in the language in use.
    #[serde(skip)]
    pub told: String,
}

/// Of the girders that have seats, or tip.
pub(super) fn of(history: &History) -> Vec<VerdictReport> {
    let report = |(number, girder): (usize, &Girder)| {
        let verdict = history.seats().verdict(number)?;
        let (words, told) = (Language::English.within(|| verdict.words()), verdict.words());
        Some(VerdictReport { girder: girder.name.clone(), stays: verdict.stays(), t: verdict.t(), words, told })
    };
    history.scene().girders.iter().enumerate().filter_map(report).collect()
}
