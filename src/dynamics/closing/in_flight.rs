//! When a pair of which both sides fly or stand closes next: leaps over everything that cannot close a gap.
//!
//! All open contacts of the pair are searched together: each look asks both flights once, and the leap is the shortest
//! that any contact allows. A pair whose gaps are out of reach for good is not looked at again until somebody is hit.

use crate::contact::{Frame, Local, locate};
use crate::dynamics::event_loop::contact_engine::{Engine, Trajectory};
use crate::dynamics::free_flight::motion_bounds::Bound;
use crate::dynamics::free_flight::relative_bounds::{Apart, Flyer};
use crate::dynamics::locate::advancement::{Hunt, MOST, Outlook, Sight, polish};
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::positive_again::in_front;
use crate::dynamics::locate::root::root;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::{ContactSite, Model};
use crate::motion::Ground;

/// What a search that was cut short counts against the work bound.
const CUT_SHORT: usize = 5_000;
/// Samples of a record that one search covers.
const SAMPLES: f64 = 64.0;

/// Where the two sides of a contact stand as placed.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Spot {
    /// Gap \[m\].
    pub home_gap: f64,
    /// Node from its G \[m\].
    pub arm: f64,
    /// Node from the face body's G \[m\].
    pub apart: f64,
    /// Size of what moves, which its places round with \[m\].
    pub size: f64,
}

impl Spot {
    pub(in crate::dynamics) fn of(model: &Model, site: usize) -> Self {
        let site = &model.contacts[site];
        let (arm, apart) = (site.home.arm.length(), site.home.lever.length());
        Self { home_gap: site.home.gap(), arm, apart, size: arm + apart + site.face.size() }
    }

    /// What the gap can do at most.
    pub(in crate::dynamics) fn outlook(&self, here: &Local, node: &Bound, face: &Bound, between: &Apart) -> Outlook {
        let apart = self.apart + between.reach + node.turn * self.arm;
        let turn = |spin: f64, spin_rate: f64, arm: f64| (spin_rate + spin * spin) * arm;
        // g = n·r, r from the face's G to the node: n turns with the face.
        let curvature = between.acceleration
            + turn(node.spin, node.spin_rate, self.arm)
            + turn(face.spin, face.spin_rate, apart)
            + 2.0 * face.spin * (between.speed + node.spin * self.arm);
        let moved = between.reach + node.turn * self.arm + face.turn * apart;
        let window = between.window;
        Outlook { gap: here.gap, rate: here.gap_rate, curvature, window, out_of_reach: self.home_gap > moved }
    }
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
        // One ground shakes both.
        let phase = engine.model.ground.phase(t);
        let flyers = slots.map(|slot| slot.and_then(|slot| flyer(engine, slot, t, phase, horizon)));
        let frame = |side: usize| match (slots[side], &flyers[side]) {
            (Some(slot), Some(flyer)) => engine.model.bodies[engine.bodies[slot].body].planar_frame(&flyer.state),
            // An abutment's frame is that of its contact.
            _ => Frame::fixed(glam::DVec3::ZERO),
        };
        let frames = [frame(0), frame(1)];
        let bound = |side: usize| flyers[side].as_ref().map_or(Bound::still(horizon), |flyer| flyer.bound);
        Self { frames, bounds: [bound(0), bound(1)], between: Apart::of(&flyers, horizon) }
    }
}

fn flyer(engine: &Engine, slot: usize, t: f64, phase: [f64; 2], horizon: f64) -> Option<Flyer<'_>> {
    let track = &engine.bodies[slot];
    let (Trajectory::Flight(flight), Some(system)) = (&track.now, &track.system) else { return None };
    let (state, free) = system.parts_in(flight, t, phase);
    let bound = system.bound_from(t, &state, free.as_ref(), horizon);
    Some(Flyer { system, state, free, bound })
}

/// An open contact under search.
struct Quarry<'a> {
    contact: usize,
    site: &'a ContactSite,
    spot: Spot,
    /// Which side of the pair owns the node, and which the face.
    sides: [Option<usize>; 2],
    hunt: Hunt,
}

impl Quarry<'_> {
    fn look(&self, view: &View) -> Local {
        let frame = |which: usize| self.sides[which].map_or(&self.site.stand, |side| &view.frames[side]);
        locate(&self.site.home, frame(0), frame(1))
    }

    fn outlook(&self, view: &View) -> Outlook {
        let still = Bound::still(view.between.window);
        let bound = |which: usize| self.sides[which].map_or(&still, |side| &view.bounds[side]);
        self.spot.outlook(&self.look(view), bound(0), bound(1), &view.between)
    }
}

/// Searches a pair from `t` on: enters the closing of each contact that closes first, and returns when the pair is to be
/// met or searched on; infinite when neither is needed \[s\].
pub(in crate::dynamics) fn search(engine: &mut Engine, pair: usize, t: f64) -> f64 {
    let duration = engine.model.duration;
    let until = horizon(&engine.model.ground, t, duration);
    remember(engine, pair, until);
    let engine_now = &*engine;
    let mut looks = 1;
    let first = View::of(engine_now, pair, t, duration);
    let mut quarries = open(engine_now, pair, t, &first);
    // Those that are in front now; a hunt may find others come out later.
    let armed: Vec<usize> = quarries.iter().filter(|q| q.hunt.armed()).map(|q| q.contact).collect();
    let out = !quarries.iter().any(|q| !(q.hunt.out_of_reach() && first.between.window >= duration - t));
    let (due, closing) =
        if out { (f64::INFINITY, Vec::new()) } else { hunt(engine_now, pair, &mut quarries, [t, until], &mut looks) };
    let cut = closing.is_empty() && due < until;
    let out: Vec<(usize, Option<f64>)> = quarries.iter().map(|q| (q.contact, q.hunt.out())).collect();
    engine.effort.looks += looks;
    engine.work += if cut { CUT_SHORT } else { 0 };
    for contact in engine.pairs[pair].contacts.clone() {
        engine.contacts[contact].closing = None;
    }
    for (contact, at) in out {
        engine.contacts[contact].out = at;
    }
    for contact in armed {
        engine.contacts[contact].state = Contact::Open { armed: true };
    }
    for (contact, at) in closing {
        engine.contacts[contact].closing = Some(at);
    }
    due
}

/// How far one search goes \[s\].
pub(in crate::dynamics) fn horizon(ground: &Ground, t: f64, duration: f64) -> f64 {
    let stretch = match ground {
        Ground::Still => duration,
        Ground::Sine { omega, .. } => std::f64::consts::TAU / omega,
        Ground::Record { dt, .. } => SAMPLES * dt,
    };
    (t + stretch).min(duration)
}

/// Lets flights under a record keep the states that looks up to `until` start from.
fn remember(engine: &mut Engine, pair: usize, until: f64) {
    for slot in engine.pairs[pair].slots.into_iter().flatten() {
        let track = &mut engine.bodies[slot];
        if let (Trajectory::Flight(flight), Some(system)) = (&mut track.now, &track.system) {
            system.remember(flight, until);
        }
    }
}

/// The open contacts of a pair; a node that has come out in front is armed again.
fn open<'a>(engine: &'a Engine, pair: usize, t: f64, view: &View) -> Vec<Quarry<'a>> {
    let slots = engine.pairs[pair].slots;
    let moved: f64 = view.frames.iter().map(|frame| frame.shift.length()).sum();
    let quarry = |contact: usize| {
        let track = &engine.contacts[contact];
        let Contact::Open { armed } = track.state else { return None };
        let side = |slot: Option<usize>| slot.map(|slot| usize::from(Some(slot) == slots[1]));
        let (site, spot) = (&engine.model.contacts[track.site], track.spot);
        let unseen = Outlook { gap: 0.0, rate: 0.0, curvature: 0.0, window: 0.0, out_of_reach: false };
        let hunt = Hunt::begin(unseen, false, 0.0);
        let mut quarry = Quarry { contact, site, spot, sides: track.slots.map(side), hunt };
        let (here, resolution) = (quarry.outlook(view), RESOLUTION * (spot.size + moved));
        let armed = armed || in_front(here.gap, here.rate, t, resolution);
        quarry.hunt = Hunt::begin(here, armed, resolution);
        Some(quarry)
    };
    engine.pairs[pair].contacts.clone().filter_map(quarry).collect()
}

/// Leaps until a contact closes or the search has come to its end: when the pair is due, and who closes then.
fn hunt(
    engine: &Engine,
    pair: usize,
    quarries: &mut [Quarry<'_>],
    [mut t, until]: [f64; 2],
    looks: &mut u64,
) -> (f64, Vec<(usize, f64)>) {
    let at_once: Vec<(usize, f64)> = quarries.iter().filter(|q| q.hunt.at_once()).map(|q| (q.contact, t)).collect();
    if !at_once.is_empty() {
        return (t, at_once);
    }
    let mut views = Views { engine, pair, until, seen: Vec::new() };
    for _ in 0..MOST {
        if t >= until {
            break;
        }
        let leap = quarries.iter_mut().map(|q| q.hunt.leap()).enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((shortest, leap)) = leap else { break };
        let next = (t + leap).min(until);
        if next <= t {
            // Less than the clock can tell.
            let stuck = &quarries[shortest];
            return (t, if stuck.hunt.armed() { vec![(stuck.contact, t)] } else { Vec::new() });
        }
        views.seen.clear();
        let there = views.at(next);
        let closed: Vec<(usize, f64)> =
            quarries.iter_mut().filter_map(|q| arrive(q, &there, [t, next], &mut views)).collect();
        *looks += views.seen.len() as u64;
        if let Some(first) = closed.iter().map(|(_, at)| *at).min_by(f64::total_cmp) {
            return (first, with_those_who_follow(engine, pair, quarries, closed, first));
        }
        t = next;
    }
    (if t >= engine.model.duration { f64::INFINITY } else { t }, Vec::new())
}

/// Looks at a pair about one instant: contacts of a flush face ask for the same ones.
struct Views<'a> {
    engine: &'a Engine,
    pair: usize,
    until: f64,
    seen: Vec<(f64, View)>,
}

impl Views<'_> {
    fn at(&mut self, t: f64) -> View {
        if let Some((_, view)) = self.seen.iter().find(|(at, _)| *at == t) {
            return *view;
        }
        let view = View::of(self.engine, self.pair, t, self.until);
        self.seen.push((t, view));
        view
    }
}

/// When a contact closes, if the look at `next` shows that it does.
fn arrive(quarry: &mut Quarry<'_>, there: &View, [t, next]: [f64; 2], views: &mut Views<'_>) -> Option<(usize, f64)> {
    let look = quarry.outlook(there);
    let sight = quarry.hunt.arrive(look, next);
    let (quarry, until) = (&*quarry, views.until);
    let mut ask = |at: f64| quarry.outlook(&views.at(at));
    match sight {
        Sight::Open => None,
        Sight::Closed => Some((quarry.contact, root(|at| -ask(at).gap, t, next))),
        Sight::Closing => Some((quarry.contact, polish(&mut ask, next, &look, until))),
    }
}

/// Contacts that close within rounding of the first close with it.
fn with_those_who_follow(
    engine: &Engine,
    pair: usize,
    quarries: &[Quarry<'_>],
    mut closed: Vec<(usize, f64)>,
    first: f64,
) -> Vec<(usize, f64)> {
    if closed.len() < quarries.len() {
        let at = first + engine.pairs[pair].together;
        let view = View::of(engine, pair, at, at);
        for quarry in quarries.iter().filter(|q| q.hunt.armed()) {
            if closed.iter().all(|(contact, _)| *contact != quarry.contact) && quarry.look(&view).gap < 0.0 {
                closed.push((quarry.contact, at));
            }
        }
    }
    closed
}
