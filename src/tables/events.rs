//! `events.csv`: what happened to which contact, and when.

use std::io::Write;

use super::{number, to_csv};
use crate::sim::{Event, History};

const HEADER: [&str; 7] = ["t", "pair", "kind", "node", "face", "released", "law"];

/// The table: one row an event, in order of time; `released` is the energy that a jump of the anchor set free \[J\].
///
/// # Errors
///
/// Those of the writer.
pub fn events(history: &History, out: &mut dyn Write) -> std::io::Result<()> {
    to_csv(&HEADER.map(str::to_owned), history.events().iter().map(|event| row(history, event)), out)
}

fn row(history: &History, event: &Event) -> Vec<String> {
    let model = history.model();
    let site = &model.sites[event.site()];
    vec![
        number(event.t),
        model.pairs[site.pair].name.clone(),
        event.kind.label().to_owned(),
        site.node.clone(),
        site.face_name.to_string(),
        number(event.released),
        law_of(history, site.pair).to_owned(),
    ]
}

/// The law that a pair used; under the impact model there is none but its own.
pub(super) fn law_of(history: &History, pair: usize) -> &'static str {
    if history.impact().is_some() { "impact" } else { history.model().pairs[pair].contact.law.label() }
}
