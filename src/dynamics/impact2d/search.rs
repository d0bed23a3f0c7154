//! When an open point of a pair next meets its face.
//!
//! In flight by leaps that no gap can outrun, all points of the pair together; in planned steps of lasting contact by
//! looks at gap and rate.

use super::engine::Engine;
use super::track::Going;
use crate::contact::{Frame, Local, locate};
use crate::dynamics::bound::Bound;
use crate::dynamics::predict::{RESOLUTION, in_front};
use crate::dynamics::relative::{Apart, Flyer};
use crate::dynamics::search::{Hunt, MOST, Outlook, Sight, polish, root};
use crate::motion::Ground;

/// Samples of a record that one search covers.
const SAMPLES: f64 = 64.0;
/// Looks at a gap per planned step.
const LOOKS: usize = 12;

/// What a search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Found {
    /// When the pair is to be met, or searched on; infinite when neither is needed \[s\].
    pub due: f64,
    /// Whether it is met then.
    pub meets: bool,
}

/// Both sides of a pair at an instant.
#[derive(Clone, Copy)]
struct View {
    frames: [Frame; 2],
    bounds: [Bound; 2],
    between: Apart,
}

impl View {
    fn of(engine: &Engine, pair: usize, t: f64, until: f64) -> Self {
        let horizon = (until - t).max(f64::MIN_POSITIVE);
        let slots = engine.pairs[pair].slots;
        let flyers = slots.map(|slot| slot.and_then(|slot| flyer(engine, slot, t, horizon)));
        let frame = |side: usize| match (slots[side], &flyers[side]) {
            (Some(slot), Some(flyer)) => engine.model.bodies[engine.bodies[slot].body].planar_frame(&flyer.state),
            (Some(slot), None) => engine.frame(slot, t),
            _ => Frame::fixed(glam::DVec3::ZERO),
        };
        let frames = [frame(0), frame(1)];
        let bound = |side: usize| flyers[side].as_ref().map_or(Bound::still(horizon), |flyer| flyer.bound);
        Self { frames, bounds: [bound(0), bound(1)], between: Apart::of(&flyers, horizon) }
    }
}

fn flyer(engine: &Engine, slot: usize, t: f64, horizon: f64) -> Option<Flyer<'_>> {
    let track = &engine.bodies[slot];
    let Going::Flight(flight) = &track.now else { return None };
    let (state, free) = track.system.parts(flight, t);
    let bound = track.system.bound_from(t, &state, free.as_ref(), horizon);
    Some(Flyer { system: &track.system, state, free, bound })
}

/// An open point under search.
struct Quarry {
    site: usize,
    /// Depth that counts as the face: a point that has just lifted off is met where it has clearly come back in \[m\].
    depth: f64,
    resolution: f64,
    hunt: Hunt,
}

fn look(engine: &Engine, site: usize, view: &View) -> Local {
    let track = &engine.sites[site];
    let contact = &engine.model.contacts[track.number];
    let frame = |which: usize| track.sides[which].map_or(Frame::fixed(contact.fixed), |side| view.frames[side]);
    locate(contact.point, &frame(0), &contact.face, &frame(1))
}

fn outlook(engine: &Engine, site: usize, depth: f64, view: &View) -> Outlook {
    let track = &engine.sites[site];
    let bound = |which: usize| track.sides[which].map_or(Bound::still(view.between.window), |s| view.bounds[s]);
    let seen = track.spot.outlook(&look(engine, site, view), &bound(0), &bound(1), &view.between);
    Outlook { gap: seen.gap + depth, ..seen }
}

/// Searches a pair from `t` on.
pub(super) fn pair(engine: &mut Engine, pair: usize, t: f64) -> Found {
    let slots = engine.pairs[pair].slots;
    let planned = slots.into_iter().flatten().filter_map(|slot| engine.planned(slot)).fold(f64::INFINITY, f64::min);
    let mut until = horizon(&engine.model.ground, t, engine.model.duration).min(planned);
    if planned.is_finite() {
        // The step of a body at rest may span many swings of one that flies.
        until = until.min(t + sight(engine, slots));
    }
    for slot in slots.into_iter().flatten() {
        engine.remember(slot, until);
    }
    engine.effort.searches += 1;
    if planned.is_finite() { in_steps(engine, pair, t, until, planned) } else { in_flight(engine, pair, t, until) }
}

/// How far ahead the looks at a pair see all that moves: half of the shortest swing of who flies \[s\].
fn sight(engine: &Engine, slots: [Option<usize>; 2]) -> f64 {
    let ground = if let Ground::Sine { omega, .. } = engine.model.ground { omega } else { 0.0 };
    let fastest = |slot: usize| match engine.bodies[slot].now {
        Going::Flight(_) => {
            let [omega, damping] = engine.bodies[slot].system.rates;
            std::f64::consts::PI / omega.max(damping).max(ground)
        }
        Going::Grip(..) => f64::INFINITY,
    };
    slots.into_iter().flatten().map(fastest).fold(f64::INFINITY, f64::min)
}

/// How far one search goes \[s\].
fn horizon(ground: &Ground, t: f64, duration: f64) -> f64 {
    let stretch = match ground {
        Ground::Still => duration,
        Ground::Sine { omega, .. } => std::f64::consts::TAU / omega,
        Ground::Record { dt, .. } => SAMPLES * dt,
    };
    (t + stretch).min(duration)
}

/// The open points of a pair; one that has come out in front counts again.
fn open(engine: &mut Engine, pair: usize, t: f64, view: &View) -> Vec<Quarry> {
    let moved: f64 = view.frames.iter().map(|frame| frame.shift.length()).sum();
    let mut all = Vec::new();
    for site in engine.pairs[pair].sites.clone() {
        if engine.sites[site].kept {
            continue;
        }
        let resolution = RESOLUTION * (engine.sites[site].spot.size + moved);
        let here = outlook(engine, site, 0.0, view);
        let track = &mut engine.sites[site];
        if !track.armed && in_front(here.gap, here.rate, t, resolution) {
            track.arm();
        }
        let depth = if track.lifted { track.sink } else { 0.0 };
        let here = Outlook { gap: here.gap + depth, ..here };
        all.push(Quarry { site, depth, resolution, hunt: Hunt::begin(here, track.armed || track.lifted, resolution) });
    }
    all
}

fn in_flight(engine: &mut Engine, pair: usize, t: f64, until: f64) -> Found {
    let duration = engine.model.duration;
    let first = View::of(engine, pair, t, duration);
    let mut quarries = open(engine, pair, t, &first);
    let reachable = |q: &Quarry| !(q.hunt.out_of_reach() && first.between.window >= duration - t);
    if !quarries.iter().any(reachable) {
        return Found { due: f64::INFINITY, meets: false };
    }
    let (mut at, mut looks) = (t, 1);
    let mut found = quarries.iter().any(|q| q.hunt.at_once()).then_some(t);
    for _ in 0..MOST {
        if at >= until || found.is_some() {
            break;
        }
        let leap = quarries.iter_mut().map(|q| q.hunt.leap()).fold(f64::INFINITY, f64::min);
        let next = (at + leap).min(until);
        if next <= at {
            found = Some(at);
            break;
        }
        let there = View::of(engine, pair, next, until);
        looks += 1;
        found = quarries.iter_mut().filter_map(|q| arrive(engine, pair, q, &there, [at, next], until)).reduce(f64::min);
        at = next;
    }
    engine.effort.looks += looks;
    for quarry in &quarries {
        engine.sites[quarry.site].out = quarry.hunt.out();
    }
    match found {
        Some(due) => Found { due, meets: true },
        None => Found { due: if at >= duration { f64::INFINITY } else { at }, meets: false },
    }
}

/// When a point meets the face, if the look at `next` shows that it does.
fn arrive(
    engine: &Engine,
    pair: usize,
    quarry: &mut Quarry,
    there: &View,
    [t, next]: [f64; 2],
    until: f64,
) -> Option<f64> {
    let here = outlook(engine, quarry.site, quarry.depth, there);
    let sight = quarry.hunt.arrive(here, next);
    let (site, depth) = (quarry.site, quarry.depth);
    let mut ask = |at: f64| outlook(engine, site, depth, &View::of(engine, pair, at, until));
    if sight != Sight::Open && depth > 0.0 {
        // One leap may go over the whole hop: who was clearly out on the way comes back in at the face itself.
        let true_gap = |at: f64| outlook(engine, site, 0.0, &View::of(engine, pair, at, until));
        let middle = f64::midpoint(t, next);
        let way = true_gap(middle);
        if in_front(way.gap, way.rate, middle, quarry.resolution) {
            return Some(root(|at| -true_gap(at).gap, middle, next));
        }
    }
    match sight {
        Sight::Open => {
            // Out in front it is met at the face itself.
            if quarry.depth > 0.0 && in_front(here.gap - quarry.depth, here.rate, next, quarry.resolution) {
                quarry.depth = 0.0;
            }
            None
        }
        Sight::Closed => Some(root(|at| -ask(at).gap, t, next)),
        Sight::Closing => Some(polish(&mut ask, next, &here, until)),
    }
}

/// A side is in a planned step: looks at gap and rate, and where the gap turns round between two of them.
fn in_steps(engine: &mut Engine, pair: usize, t: f64, until: f64, planned: f64) -> Found {
    let first = View::of(engine, pair, t, until);
    let quarries = open(engine, pair, t, &first);
    let first = quarries.iter().filter_map(|quarry| in_step(engine, pair, quarry, t, until)).reduce(f64::min);
    // The step's own end calls for the next search.
    let next = if until < planned.min(engine.model.duration) { until } else { f64::INFINITY };
    Found { due: first.unwrap_or(next), meets: first.is_some() }
}

fn in_step(engine: &Engine, pair: usize, quarry: &Quarry, t: f64, until: f64) -> Option<f64> {
    let ask = |at: f64| outlook(engine, quarry.site, quarry.depth, &View::of(engine, pair, at, until));
    let mut armed = quarry.hunt.armed();
    let resolution = RESOLUTION * engine.sites[quarry.site].spot.size;
    let (mut from, mut before) = (t, ask(t));
    if armed && before.gap <= resolution && before.rate < 0.0 {
        return Some(t);
    }
    for i in 1..=LOOKS {
        let to = if i == LOOKS { until } else { t + (until - t) * i as f64 / LOOKS as f64 };
        let here = ask(to);
        let turns = before.rate * here.rate < 0.0;
        let way = if before.rate < 0.0 { 1.0 } else { -1.0 };
        let turn = turns.then(|| root(|at| way * ask(at).rate, from, to)).map(|at| (at, ask(at)));
        for (at, there) in turn.into_iter().chain([(to, here)]) {
            if armed && there.gap < 0.0 && (there.rate < 0.0 || there.gap < -resolution) {
                return Some(root(|at| -ask(at).gap, from, at));
            }
            armed = armed || in_front(there.gap, there.rate, at, resolution);
            from = at;
        }
        before = here;
    }
    None
}
