//! `events.csv`: what happened to which contact, and when.

use super::{number, to_csv};
use crate::scene::FrictionLaw;
use crate::sim::{Event, History};

const HEADER: [&str; 7] = ["t", "pair", "kind", "node", "face", "released", "law"];

/// The table: one row an event, in order of time; `released` is the energy that a jump of the anchor set free \[J\].
pub fn events(history: &History) -> Vec<u8> {
    to_csv(&HEADER.map(str::to_owned), history.events().iter().map(|event| row(history, event)))
}

fn row(history: &History, event: &Event) -> Vec<String> {
    let model = history.model();
    let (pair, site) = (&model.pairs[event.pair], &model.contacts[event.contact]);
    vec![
        number(event.t),
        pair.name.clone(),
        event.kind.label().to_owned(),
        site.node.clone(),
        site.face_name.clone(),
        number(event.released),
        law_label(pair.contact.law).to_owned(),
    ]
}

/// The law as scene files spell it.
pub fn law_label(law: FrictionLaw) -> &'static str {
    match law {
        FrictionLaw::Paper => "paper",
        FrictionLaw::ReturnMapping => "return-mapping",
    }
}
