//! Touches: hits, which have no length, and lasting contacts.

use super::events::spans;
use crate::dynamics::impact2d::ImpactRecord;
use crate::sim::peaks;
use crate::sim::{ContactState, History, Touch};

/// Looks for the largest push of a lasting contact.
const LOOKS: u32 = 64;

/// Times at which what pushes in a lasting contact is looked at, in rising order.
pub(in crate::sim) fn looks(from: f64, until: f64) -> impl Iterator<Item = f64> {
    // Just inside: at its very end the next state begins.
    (0..=LOOKS).map(move |look| from + (until - from) * (f64::from(look) / f64::from(LOOKS)) * (1.0 - 1e-9))
}

/// Every hit, without length, and every lasting contact.
pub(in crate::sim) fn of(history: &History, record: &ImpactRecord) -> Vec<Touch> {
    let mut all: Vec<Touch> = Vec::new();
    for hit in &record.hits {
        let [normal, tangential] = hit.impulses.total();
        let contact = hit.sites.first().copied().unwrap_or(history.model().pairs[hit.pair].sites.start);
        all.push(Touch {
            pair: hit.pair,
            contact,
            start: hit.t,
            end: hit.t,
            peak_time: hit.t,
            peak_force: 0.0,
            impulse: normal.hypot(tangential),
            stick: 0.0,
            slip: 0.0,
        });
    }
    for (pair, contact, spans) in spans(record) {
        let mut open: Option<Touch> = None;
        for (from, until, state) in spans {
            if open.is_some_and(|touch| touch.end != from) {
                all.extend(open.take());
            }
            let touch = open.get_or_insert(Touch {
                pair,
                contact,
                start: from,
                end: until,
                peak_time: from,
                peak_force: 0.0,
                impulse: 0.0,
                stick: 0.0,
                slip: 0.0,
            });
            touch.end = until;
            let length = until - from;
            if state == ContactState::Stick {
                touch.stick += length;
            } else {
                touch.slip += length;
            }
            let times: Vec<f64> = looks(from, until).collect();
            let force = |t: f64| history.contacts().contact_at(contact, t).map_or(0.0, |now| now.force.length());
            let most = peaks::largest(&times, &force);
            if most.value > touch.peak_force {
                (touch.peak_time, touch.peak_force) = (most.t, most.value);
            }
        }
        all.extend(open);
    }
    all.sort_by(|a, b| a.start.total_cmp(&b.start).then(a.contact.cmp(&b.contact)));
    all
}
