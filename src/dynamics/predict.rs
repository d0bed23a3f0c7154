//! When the open contacts of a pair close next, on the trajectories that its bodies are on.

use super::agenda::Item;
use super::approach;
use super::engine::{Engine, Trajectory};
use super::search::root;
use super::track::Contact;
use crate::contact::{Frame, Local, locate};

/// Depth of a dip behind a face that may go unseen, in parts of the size of what moves: rounding.
pub(super) const RESOLUTION: f64 = 4e-16;
/// A node is in front of a face again when it is this many resolutions off it: at the crossing that it missed by, its gap is
/// rounding of either sign.
pub(super) const ARMED: f64 = 64.0;
/// Looks at a gap per planned step.
const LOOKS: usize = 5;

/// Looks at a pair anew from `t` and enters what is due.
pub(super) fn pair(engine: &mut Engine, pair: usize, t: f64) {
    engine.effort.searches += 1;
    let due = match planned(engine, pair) {
        Some(until) => in_steps(engine, pair, t, until),
        None => approach::search(engine, pair, t),
    };
    if due.is_finite() {
        engine.agenda.set(Item::Pair(pair), due);
    } else {
        engine.agenda.remove(Item::Pair(pair));
    }
}

/// Where the first planned step of a pair's bodies ends; nothing when both fly or stand \[s\].
fn planned(engine: &Engine, pair: usize) -> Option<f64> {
    let mut first = None;
    for slot in engine.pairs[pair].slots.into_iter().flatten() {
        if let Trajectory::Island { island, .. } = &engine.bodies[slot].now
            && let Some(island) = &engine.islands[*island]
        {
            first = Some(island.until.min(first.unwrap_or(f64::INFINITY)));
        }
    }
    first
}

/// The first closing of a pair within planned steps.
fn in_steps(engine: &mut Engine, pair: usize, t: f64, until: f64) -> f64 {
    let mut first = f64::INFINITY;
    let mut views = None;
    for contact in engine.pairs[pair].contacts.clone() {
        let Contact::Open { .. } = engine.contacts[contact].state else { continue };
        let views = views.get_or_insert_with(|| Views::of(engine, pair, t, until));
        let closing = open(engine, contact, t).and_then(|armed| in_step(engine, contact, views, armed));
        engine.contacts[contact].closing = closing;
        first = first.min(closing.unwrap_or(f64::INFINITY));
    }
    first
}

/// Whether an open contact is armed; nothing for a closed one. A node that has come out in front is armed again.
fn open(engine: &mut Engine, contact: usize, t: f64) -> Option<bool> {
    let Contact::Open { armed } = engine.contacts[contact].state else { return None };
    if !armed && look(engine, contact, t).gap > ARMED * resolution(engine, contact, t) {
        engine.contacts[contact].state = Contact::Open { armed: true };
        return Some(true);
    }
    Some(armed)
}

fn look(engine: &Engine, contact: usize, t: f64) -> Local {
    let site = &engine.model.contacts[engine.contacts[contact].site];
    locate(site.point, &engine.side(contact, 0, t), &site.face, &engine.side(contact, 1, t))
}

/// Depth of a dip of a contact's gap that is rounding from `t` on \[m\].
fn resolution(engine: &Engine, contact: usize, t: f64) -> f64 {
    let track = &engine.contacts[contact];
    // Places round with how far the bodies have come, too.
    let moved: f64 = track.slots.into_iter().flatten().map(|slot| engine.frame(slot, t).shift.length()).sum();
    RESOLUTION * (track.spot.size + moved)
}

/// Poses of a pair's bodies at the looks of a planned step, for all of its contacts.
struct Views {
    times: [f64; LOOKS],
    frames: [[Frame; 2]; LOOKS],
    slots: [Option<usize>; 2],
}

impl Views {
    fn of(engine: &Engine, pair: usize, t: f64, until: f64) -> Self {
        let slots = engine.pairs[pair].slots;
        let part = |i: usize| (until - t) * i as f64 / (LOOKS - 1) as f64;
        let times = std::array::from_fn(|i| if i == LOOKS - 1 { until } else { t + part(i) });
        let frame =
            |slot: Option<usize>, t: f64| slot.map_or(Frame::fixed(glam::DVec3::ZERO), |slot| engine.frame(slot, t));
        Self { times, frames: times.map(|t| slots.map(|slot| frame(slot, t))), slots }
    }

    fn look(&self, engine: &Engine, contact: usize, i: usize) -> Local {
        let track = &engine.contacts[contact];
        let site = &engine.model.contacts[track.site];
        let side = |slot: Option<usize>| match slot {
            Some(_) => self.frames[i][usize::from(slot == self.slots[1])],
            None => Frame::fixed(site.fixed),
        };
        locate(site.point, &side(track.slots[0]), &site.face, &side(track.slots[1]))
    }
}

/// How far a gap can go within the planned steps of its sides, at most \[m\].
fn excursion(engine: &Engine, contact: usize, here: &Local, from: f64, until: f64) -> f64 {
    let track = &engine.contacts[contact];
    let site = &engine.model.contacts[track.site];
    // The node as its body carries it, and as the face's body would.
    let arms = [site.point.length(), site.face.corners[0].length() + here.gap.abs() + here.at.length()];
    let along = |(slot, arm): (Option<usize>, f64)| {
        let Some(slot) = slot else { return 0.0 };
        match (&engine.bodies[slot].now, &engine.bodies[slot].system) {
            (Trajectory::Island { island, index }, _) => engine.islands[*island]
                .as_ref()
                .map_or(0.0, |island| island.excursion(&engine.model, *index, arm, from)),
            (Trajectory::Flight(flight), Some(system)) => {
                let (_, bound) = system.prospect(flight, from, until - from);
                if bound.window < until - from {
                    return f64::INFINITY;
                }
                (bound.speed + bound.spin * arm) * (until - from)
            }
            _ => f64::INFINITY,
        }
    };
    track.slots.into_iter().zip(arms).map(along).sum()
}

/// A side is in a planned step: five looks at gap and rate, closer where a dip shows between them; one look where the
/// steps are too short to close the gap.
fn in_step(engine: &Engine, contact: usize, views: &Views, armed: bool) -> Option<f64> {
    let (t, until) = (views.times[0], views.times[LOOKS - 1]);
    if until <= t {
        return None;
    }
    let ask = |at: f64| look(engine, contact, at);
    let (mut armed, mut before) = (armed, views.look(engine, contact, 0));
    let mut from = t;
    if armed && before.gap > excursion(engine, contact, &before, t, until) {
        return None;
    }
    let resolution = resolution(engine, contact, t);
    if armed && before.gap <= resolution && before.gap_rate < 0.0 {
        return Some(t);
    }
    for i in 1..LOOKS {
        let (to, here) = (views.times[i], views.look(engine, contact, i));
        // Where the gap turns round between two looks: a dip behind the face, or a node that comes out before it.
        let turns = (before.gap_rate < 0.0 && here.gap_rate > 0.0) || (before.gap_rate > 0.0 && here.gap_rate < 0.0);
        let way = if before.gap_rate < 0.0 { 1.0 } else { -1.0 };
        let turn = turns.then(|| root(|at| way * ask(at).gap_rate, from, to)).map(|at| (at, ask(at)));
        for (at, there) in turn.into_iter().chain([(to, here)]) {
            if armed && there.gap < 0.0 && (there.gap_rate < 0.0 || there.gap < -resolution) {
                return Some(root(|at| -ask(at).gap, from, at));
            }
            armed = armed || there.gap > ARMED * resolution;
            from = at;
        }
        before = here;
    }
    None
}
