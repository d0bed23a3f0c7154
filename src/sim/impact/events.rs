//! Hits and lasting contacts as events, and the stretches of lasting contacts.

use crate::dynamics::Model;
use crate::dynamics::impact2d::ImpactRecord;
use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, FrictionMode};
use crate::sim::{ContactState, Event, EventKind};

/// Hits, and what happened to lasting contacts.
pub(in crate::sim) fn of(record: &ImpactRecord, model: &Model) -> Vec<Event> {
    let mut all: Vec<Event> = Vec::new();
    for hit in &record.hits {
        let contact = hit.sites.first().copied().unwrap_or(model.pairs[hit.pair].sites.start);
        all.push(Event::new(hit.t, contact, EventKind::Hit, hit.impulses.lost));
    }
    for (_, site, spans) in spans(record) {
        let event = |t: f64, kind: EventKind| Event::new(t, site, kind, 0.0);
        for (i, &(from, until, state)) in spans.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|j| spans.get(j)).filter(|(_, end, _)| *end == from);
            match (before.map(|(_, _, state)| *state), state) {
                (None, ContactState::Stick) => all.push(event(from, EventKind::OpenToStick)),
                (None, _) => all.push(event(from, EventKind::OpenToSlip)),
                (Some(ContactState::Stick), ContactState::Slip) => all.push(event(from, EventKind::StickToSlip)),
                (Some(ContactState::Slip), ContactState::Stick) => all.push(event(from, EventKind::SlipToStick)),
                _ => {}
            }
            if until < record.end && spans.get(i + 1).is_none_or(|next| next.0 != until) {
                all.push(event(until, EventKind::Opened));
            }
        }
    }
    all
}

/// From, until and state of the stretches of a lasting contact.
pub(super) type Span = (f64, f64, ContactState);

/// Per declared contact that lasts: its pair, its number, its stretches in order of time.
pub(super) fn spans(record: &ImpactRecord) -> Vec<(usize, usize, Vec<Span>)> {
    let mut all: std::collections::BTreeMap<usize, (usize, Vec<Span>)> = std::collections::BTreeMap::new();
    for interval in &record.lasting {
        for mode in &interval.modes {
            for &site in &mode.sites {
                all.entry(site).or_insert((mode.pair, Vec::new())).1.push((
                    interval.from,
                    interval.until,
                    contact_state(mode),
                ));
            }
        }
    }
    all.into_iter().map(|(site, (pair, spans))| (pair, site, spans)).collect()
}

pub(super) fn contact_state(mode: &ContactMode) -> ContactState {
    match mode.friction {
        FrictionMode::Stick | FrictionMode::Wedged => ContactState::Stick,
        FrictionMode::Slip(_) | FrictionMode::SlipAtEnd { .. } | FrictionMode::Frictionless => ContactState::Slip,
    }
}
