//! An answer of the impact model in the terms of any answer: events, touches, forces of lasting contact, losses.

use glam::{DVec2, DVec3};

use super::{ContactNow, ContactState, Event, EventKind, History, Touch};
use crate::dynamics::Model;
use crate::dynamics::free_flight::flight::Planar;
use crate::dynamics::impact2d::lasting::constrained_motion::{Reaction, Scenery, Seat, Way, middle, react, shaking};
use crate::dynamics::impact2d::{Record, Stay};

/// Looks for the largest push of a lasting contact.
const LOOKS: u32 = 64;

/// Hits, and what happened to lasting contacts.
pub(super) fn events(record: &Record, model: &Model) -> Vec<Event> {
    let mut all: Vec<Event> = Vec::new();
    for hit in &record.hits {
        let contact = hit.sites.first().copied().unwrap_or(model.pairs[hit.pair].contacts.start);
        all.push(Event::new(hit.t, contact, EventKind::Hit, hit.lost));
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
type Span = (f64, f64, ContactState);

/// Per declared contact that lasts: its pair, its number, its stretches in order of time.
fn spans(record: &Record) -> Vec<(usize, usize, Vec<Span>)> {
    let mut all: std::collections::BTreeMap<usize, (usize, Vec<Span>)> = std::collections::BTreeMap::new();
    for stay in &record.stays {
        for seat in &stay.seats {
            for &site in &seat.sites {
                all.entry(site).or_insert((seat.pair, Vec::new())).1.push((stay.from, stay.until, way(seat)));
            }
        }
    }
    all.into_iter().map(|(site, (pair, spans))| (pair, site, spans)).collect()
}

fn way(seat: &Seat) -> ContactState {
    match seat.way {
        Way::Held => ContactState::Stick,
        Way::Slides(_) => ContactState::Slip,
    }
}

/// Every hit, without length, and every lasting contact.
pub(super) fn touches(history: &History, record: &Record) -> Vec<Touch> {
    let mut all: Vec<Touch> = Vec::new();
    for hit in &record.hits {
        let [normal, tangential] = hit.total();
        let contact = hit.sites.first().copied().unwrap_or(history.model().pairs[hit.pair].contacts.start);
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
            for look in 0..=LOOKS {
                // Just inside: at its very end the next state begins.
                let t = from + length * (f64::from(look) / f64::from(LOOKS)) * (1.0 - 1e-9);
                let force = history.contact_at(contact, t).map_or(0.0, |now| now.force.length());
                if force > touch.peak_force {
                    (touch.peak_time, touch.peak_force) = (t, force);
                }
            }
        }
        all.extend(open);
    }
    all.sort_by(|a, b| a.start.total_cmp(&b.start).then(a.contact.cmp(&b.contact)));
    all
}

/// Where a stay's bodies are at `t`, and its reactions.
fn reactions(history: &History, stay: &Stay, t: f64) -> Option<(Scenery, Vec<Reaction>)> {
    let model = history.model();
    let state = |body: &usize| -> Planar {
        let state = history.state(*body, t);
        std::array::from_fn(|i| state[i])
    };
    let states: Vec<Planar> = stay.bodies.iter().map(state).collect();
    let piece = model.ground.piece(model.ground.piece_number(t));
    let scenery = Scenery::new(model, &stay.bodies, &states, shaking(&model.ground, &piece, t));
    let points: Vec<_> = stay.seats.iter().map(|seat| scenery.points(model, seat)).collect();
    let answer = react(&scenery, &stay.seats, &points, &model.impact)?;
    Some((scenery, answer.reactions))
}

/// Forces of all lasting contacts at `t`, on the body that owns the node.
pub(super) fn contacts(history: &History, record: &Record, t: f64) -> Vec<ContactNow> {
    let mut all = Vec::new();
    for stay in record.stays_at(t) {
        let Some((scenery, reactions)) = reactions(history, stay, t) else { continue };
        for (seat, reaction) in stay.seats.iter().zip(&reactions) {
            for (i, &site) in seat.sites.iter().enumerate() {
                all.push(now(history, &scenery, seat, reaction, i, site));
            }
        }
    }
    all.sort_by_key(|now| now.contact);
    all
}

fn now(history: &History, scenery: &Scenery, seat: &Seat, reaction: &Reaction, end: usize, site: usize) -> ContactNow {
    let model = history.model();
    let contact = &model.contacts[site];
    let point = scenery.point(model, site);
    // Forces and V are the first side's; where the face is, they are the opposite.
    let side = if contact.node_body == model.pairs[seat.pair].bodies[0] { 1.0 } else { -1.0 };
    let flat = |v: DVec2| (v * side).extend(0.0);
    let total = reaction.total();
    let share = if total > 0.0 { reaction.normal[end] / total } else { 1.0 / seat.sites.len() as f64 };
    let [normal_velocity, slide] = scenery.cluster.speeds(&point);
    let node = history.model().contacts[site].node_body.and_then(|body| scenery.bodies.binary_search(&body).ok());
    let place = match node {
        Some(place) => scenery.frames[place].origin() + scenery.frames[place].turn(contact.home.arm),
        None => contact.fixed + contact.point,
    };
    let normal = flat(point.n);
    let tangential = flat(point.s * (reaction.tangential * share));
    let [mu_static, mu_kinetic] = seat.friction(&model.impact);
    ContactNow {
        contact: site,
        pair: seat.pair,
        state: way(seat),
        point: place,
        anchor: place - normal * point.gap,
        normal,
        penetration: -point.gap,
        normal_velocity,
        sliding: flat(point.s * slide),
        normal_force: reaction.normal[end],
        tangential_force: tangential,
        normal_damping: 0.0,
        tangential_damping: DVec3::ZERO,
        force: normal * reaction.normal[end] + tangential,
        mu_static,
        mu_kinetic,
    }
}

/// Power lost in the friction of a stay \[W\].
pub(super) fn friction_power(history: &History, stay: &Stay, t: f64) -> f64 {
    let Some((scenery, reactions)) = reactions(history, stay, t) else { return 0.0 };
    let model = history.model();
    let seat_power = |(seat, reaction): (&Seat, &Reaction)| {
        let middle = middle(&scenery.points(model, seat));
        -reaction.tangential * scenery.cluster.speed(&middle, middle.s)
    };
    stay.seats.iter().zip(&reactions).map(seat_power).sum()
}
