//! An answer of the impact model in the terms of any answer: events, touches, forces of lasting contact, losses.

use glam::{DVec2, DVec3};

use super::{ContactNow, ContactState, Event, EventKind, History, Touch};
use crate::dynamics::Model;
use crate::dynamics::free_flight::flight::Planar;
use crate::dynamics::impact2d::delassus::centre;
use crate::dynamics::impact2d::kinematics::{Kinematics, ground_acceleration};
use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, FrictionMode, Reaction, solve_reactions};
use crate::dynamics::impact2d::{LastingInterval, Record};

/// Looks for the largest push of a lasting contact.
const LOOKS: u32 = 64;

/// Hits, and what happened to lasting contacts.
pub(super) fn events(record: &Record, model: &Model) -> Vec<Event> {
    let mut all: Vec<Event> = Vec::new();
    for hit in &record.hits {
        let contact = hit.sites.first().copied().unwrap_or(model.pairs[hit.pair].contacts.start);
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
type Span = (f64, f64, ContactState);

/// Per declared contact that lasts: its pair, its number, its stretches in order of time.
fn spans(record: &Record) -> Vec<(usize, usize, Vec<Span>)> {
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

fn contact_state(mode: &ContactMode) -> ContactState {
    match mode.friction {
        FrictionMode::Stick => ContactState::Stick,
        FrictionMode::Slip(_) | FrictionMode::Frictionless => ContactState::Slip,
    }
}

/// Every hit, without length, and every lasting contact.
pub(super) fn touches(history: &History, record: &Record) -> Vec<Touch> {
    let mut all: Vec<Touch> = Vec::new();
    for hit in &record.hits {
        let [normal, tangential] = hit.impulses.total();
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

/// Where a interval's bodies are at `t`, and its reactions.
fn reactions(history: &History, interval: &LastingInterval, t: f64) -> Option<(Kinematics, Vec<Reaction>)> {
    let model = history.model();
    let state = |body: &usize| -> Planar {
        let state = history.state(*body, t);
        std::array::from_fn(|i| state[i])
    };
    let states: Vec<Planar> = interval.bodies.iter().map(state).collect();
    let piece = model.ground.piece(model.ground.piece_number(t));
    let kinematics = Kinematics::new(model, &interval.bodies, &states, ground_acceleration(&model.ground, &piece, t));
    let points: Vec<_> = interval.modes.iter().map(|mode| mode.points(model, &kinematics)).collect();
    let motion = solve_reactions(&kinematics, &interval.modes, &points, &model.impact)?;
    Some((kinematics, motion.reactions))
}

/// Forces of all lasting contacts at `t`, on the body that owns the node.
pub(super) fn contacts(history: &History, record: &Record, t: f64) -> Vec<ContactNow> {
    let mut all = Vec::new();
    for interval in record.lasting_at(t) {
        let Some((kinematics, reactions)) = reactions(history, interval, t) else { continue };
        for (mode, reaction) in interval.modes.iter().zip(&reactions) {
            for (i, &site) in mode.sites.iter().enumerate() {
                all.push(now(history, &kinematics, mode, reaction, i, site));
            }
        }
    }
    all.sort_by_key(|now| now.contact);
    all
}

fn now(
    history: &History,
    kinematics: &Kinematics,
    mode: &ContactMode,
    reaction: &Reaction,
    end: usize,
    site: usize,
) -> ContactNow {
    let model = history.model();
    let contact = &model.contacts[site];
    let point = kinematics.point(model, site);
    // Forces and V are the first side's; where the face is, they are the opposite.
    let side = if contact.node_body == model.pairs[mode.pair].bodies[0] { 1.0 } else { -1.0 };
    let flat = |v: DVec2| (v * side).extend(0.0);
    let total = reaction.total();
    let share = if total > 0.0 { reaction.normal[end] / total } else { 1.0 / mode.sites.len() as f64 };
    let [normal_velocity, slide] = kinematics.cluster.speeds(&point);
    let node = history.model().contacts[site].node_body.and_then(|body| kinematics.bodies.binary_search(&body).ok());
    let place = match node {
        Some(place) => kinematics.frames[place].origin() + kinematics.frames[place].turn(contact.home.arm),
        None => contact.fixed + contact.point,
    };
    let normal = flat(point.n);
    let tangential = flat(point.s * (reaction.tangential * share));
    let [mu_static, mu_kinetic] = mode.friction_coefficients(&model.impact);
    ContactNow {
        contact: site,
        pair: mode.pair,
        state: contact_state(mode),
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

/// Power lost in the friction of a interval \[W\].
pub(super) fn friction_power(history: &History, interval: &LastingInterval, t: f64) -> f64 {
    let Some((kinematics, reactions)) = reactions(history, interval, t) else { return 0.0 };
    let model = history.model();
    let power = |(mode, reaction): (&ContactMode, &Reaction)| {
        let centre = centre(&mode.points(model, &kinematics));
        -reaction.tangential * kinematics.cluster.speed(&centre, centre.s)
    };
    interval.modes.iter().zip(&reactions).map(power).sum()
}
