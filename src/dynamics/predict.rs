//! When the open contacts of a pair close next, on the trajectories that its bodies are on.

use super::agenda::Item;
use super::bound::Bound;
use super::engine::{Engine, Trajectory};
use super::search::{Found, Outlook, first_crossing, root};
use super::track::Contact;
use crate::contact::{Frame, Local, locate};
use crate::motion::Ground;

/// Depth of a dip behind a face that may go unseen, in parts of the size of what moves: rounding.
const RESOLUTION: f64 = 4e-16;
/// A node is in front of a face again when it is this many resolutions off it: at the crossing that it missed by, its gap is
/// rounding of either sign.
pub(super) const ARMED: f64 = 64.0;
/// What a search that was cut short counts against the work bound.
const CUT_SHORT: usize = 5_000;
/// Looks at a gap per planned step.
const LOOKS: usize = 5;

/// Looks at a pair anew from `t` and enters what is due.
pub(super) fn pair(engine: &mut Engine, pair: usize, t: f64) {
    let until = horizon(engine, pair, t);
    let flying = until.1;
    let views = (!flying).then(|| Views::of(engine, pair, t, until.0));
    let (mut first, mut searched) = (f64::INFINITY, until.0);
    for contact in engine.pairs[pair].contacts.clone() {
        let closing = open(engine, contact, t).and_then(|armed| match &views {
            Some(views) => in_step(engine, contact, views, armed),
            None => in_flight(engine, contact, t, until.0, armed, &mut searched),
        });
        engine.contacts[contact].closing = closing;
        first = first.min(closing.unwrap_or(f64::INFINITY));
    }
    if first.is_finite() {
        engine.agenda.set(Item::Pair(pair), first);
    } else if flying && searched < engine.model.duration {
        engine.agenda.set(Item::Pair(pair), searched);
    } else {
        engine.agenda.remove(Item::Pair(pair));
    }
}

/// How far the pair's trajectories reach from `t`, and whether both are flights \[s\].
fn horizon(engine: &Engine, pair: usize, t: f64) -> (f64, bool) {
    let duration = engine.model.duration;
    let mut planned = f64::INFINITY;
    for slot in engine.pairs[pair].slots.into_iter().flatten() {
        if let Trajectory::Island { island, .. } = &engine.bodies[slot].now
            && let Some(island) = &engine.islands[*island]
        {
            planned = planned.min(island.until);
        }
    }
    if planned.is_finite() {
        return (planned, false);
    }
    let stretch = match &engine.model.ground {
        Ground::Still => duration,
        Ground::Sine { omega, .. } => std::f64::consts::TAU / omega,
        Ground::Record { dt, .. } => 64.0 * dt,
    };
    let until = t + stretch;
    (if until >= duration { duration } else { until }, true)
}

/// Whether an open contact is armed; nothing for a closed one. A node that has come out in front is armed again.
fn open(engine: &mut Engine, contact: usize, t: f64) -> Option<bool> {
    let Contact::Open { armed } = engine.contacts[contact].state else { return None };
    let face = &engine.model.contacts[engine.contacts[contact].site].face;
    let in_front = ARMED * RESOLUTION * face.size();
    if !armed && look(engine, contact, t).gap > in_front {
        engine.contacts[contact].state = Contact::Open { armed: true };
        return Some(true);
    }
    Some(armed)
}

fn look(engine: &Engine, contact: usize, t: f64) -> Local {
    let site = &engine.model.contacts[engine.contacts[contact].site];
    locate(site.point, &engine.side(contact, 0, t), &site.face, &engine.side(contact, 1, t))
}

/// Both sides fly or stand: leaps that cannot miss a touch.
fn in_flight(engine: &mut Engine, contact: usize, t: f64, until: f64, armed: bool, searched: &mut f64) -> Option<f64> {
    for slot in engine.contacts[contact].slots.into_iter().flatten() {
        let track = &mut engine.bodies[slot];
        if let (Trajectory::Flight(flight), Some(system)) = (&mut track.now, &track.system) {
            system.remember(flight, until);
        }
    }
    let reach = Reach::of(engine, contact);
    let ask = |at: f64| reach.outlook(engine, contact, at, until);
    match first_crossing(ask, t, until, armed, reach.resolution) {
        Found::Crossing(at) => Some(at),
        Found::NoneUntil(at) => {
            if at < until {
                engine.work += CUT_SHORT;
            }
            *searched = searched.min(at);
            None
        }
    }
}

/// What the gap of a contact can do at most, from the bounds of both flights.
struct Reach {
    /// Gap with both bodies as placed \[m\].
    home_gap: f64,
    /// Node from its G \[m\].
    arm: f64,
    /// Node from the face body's G, as placed \[m\].
    apart: f64,
    resolution: f64,
}

impl Reach {
    fn of(engine: &Engine, contact: usize) -> Self {
        let track = &engine.contacts[contact];
        let site = &engine.model.contacts[track.site];
        let placed = |slot: Option<usize>| match slot {
            Some(slot) => {
                let body = &engine.model.bodies[engine.bodies[slot].body];
                body.planar_frame(&[0.0; 6])
            }
            None => Frame::fixed(site.fixed),
        };
        let (node, face) = (placed(track.slots[0]), placed(track.slots[1]));
        let apart = (node.home - face.home + node.rotation * site.point).length();
        let arm = site.point.length();
        let size = arm + apart + site.face.size();
        Self { home_gap: locate(site.point, &node, &site.face, &face).gap, arm, apart, resolution: RESOLUTION * size }
    }

    fn outlook(&self, engine: &Engine, contact: usize, t: f64, until: f64) -> Outlook {
        let track = &engine.contacts[contact];
        let site = &engine.model.contacts[track.site];
        let side = |which: usize| prospect(engine, track.slots[which], site.fixed, t, until);
        let ((node_frame, node), (face_frame, face)) = (side(0), side(1));
        let here = locate(site.point, &node_frame, &site.face, &face_frame);
        let apart = self.apart + node.reach + face.reach;
        let turn = |spin: f64, spin_rate: f64, arm: f64| (spin_rate + spin * spin) * arm;
        let moving = node.speed + node.spin * self.arm + face.speed + face.spin * apart;
        let coriolis = if face.spin > 0.0 { 2.0 * face.spin * moving } else { 0.0 };
        let curvature = node.acceleration
            + turn(node.spin, node.spin_rate, self.arm)
            + face.acceleration
            + turn(face.spin, face.spin_rate, apart)
            + coriolis;
        let moved = node.reach + node.turn * self.arm + face.reach + face.turn * apart;
        Outlook {
            gap: here.gap,
            rate: here.gap_rate,
            curvature,
            window: node.window.min(face.window),
            out_of_reach: self.home_gap > moved,
        }
    }
}

/// Pose of a side at `t` and what its motion can do from there until `until`.
fn prospect(engine: &Engine, slot: Option<usize>, fixed: glam::DVec3, t: f64, until: f64) -> (Frame, Bound) {
    let horizon = (until - t).max(f64::MIN_POSITIVE);
    let Some(slot) = slot else { return (Frame::fixed(fixed), Bound::still(horizon)) };
    let track = &engine.bodies[slot];
    match (&track.now, &track.system) {
        (Trajectory::Flight(flight), Some(system)) => {
            let (state, bound) = system.prospect(flight, t, horizon);
            (engine.model.bodies[track.body].planar_frame(&state), bound)
        }
        _ => (engine.frame(slot, t), Bound::still(horizon)),
    }
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
    let size = engine.model.contacts[engine.contacts[contact].site].face.size();
    if armed && before.gap <= RESOLUTION * size && before.gap_rate < 0.0 {
        return Some(t);
    }
    if armed && before.gap > excursion(engine, contact, &before, t, until) {
        return None;
    }
    for i in 1..LOOKS {
        let (to, here) = (views.times[i], views.look(engine, contact, i));
        if armed && here.gap < 0.0 && here.gap_rate < 0.0 {
            return Some(root(|at| -ask(at).gap, from, to));
        }
        if armed && before.gap_rate < 0.0 && here.gap_rate > 0.0 {
            let lowest = root(|at| ask(at).gap_rate, from, to);
            if ask(lowest).gap < -RESOLUTION * size {
                return Some(root(|at| -ask(at).gap, from, lowest));
            }
        }
        armed = armed || here.gap > ARMED * RESOLUTION * size;
        (from, before) = (to, here);
    }
    None
}
