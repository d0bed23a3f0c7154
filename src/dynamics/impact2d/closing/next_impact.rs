//! When an open point of a pair next meets its face.
//!
//! In flight by leaps that no gap can outrun, all points of the pair together; in planned steps of lasting contact by
//! looks at gap and rate.

use smallvec::SmallVec;

use crate::dynamics::impact2d::closing::cubic_advancement::{Cubic, crossing};
use crate::dynamics::impact2d::closing::gap_derivatives::{View, gap, poses};
use crate::dynamics::impact2d::engine::Engine;
use crate::dynamics::impact2d::tracks::Going;
use crate::dynamics::locate::advancement::{Hunt, MOST, Outlook, Sight};
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::positive_again::in_front;
use crate::dynamics::locate::root::root;
use crate::motion::Ground;

/// Periods of a sine that one search covers: girders in step with the ground hit once in a period.
const PERIODS: f64 = 2.0;
/// Samples of a record that one search covers.
const SAMPLES: f64 = 64.0;
/// Looks at a gap per planned step.
const LOOKS: usize = 12;

/// What a search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics::impact2d) struct Found {
    /// When the pair is to be met, or searched on; infinite when neither is needed \[s\].
    pub due: f64,
    /// Whether it is met then.
    pub meets: bool,
}

/// An open point under search.
struct Quarry {
    site: usize,
    /// Depth that counts as the face: a point that has just lifted off is met where it has clearly come back in \[m\].
    depth: f64,
    resolution: f64,
    hunt: Hunt,
    /// How it goes on at least from the last look, where its third derivative is bounded.
    least: Option<Cubic>,
    /// When a point that has lifted off was first seen in front \[s\].
    out: Option<f64>,
}

fn outlook(engine: &Engine, site: usize, depth: f64, view: &View) -> (Outlook, Option<Cubic>) {
    let track = &engine.sites[site];
    view.outlook(&track.aim, &track.spot, track.sides, depth)
}

/// `[g, ġ]` of a site at `t`, with this depth.
fn gap_at(engine: &Engine, pair: usize, site: usize, depth: f64, t: f64) -> [f64; 2] {
    let track = &engine.sites[site];
    let [gap, rate] = gap(&track.aim, track.sides, &poses(engine, engine.pairs[pair].slots, t));
    [gap + depth, rate]
}

/// Searches a pair from `t` on.
pub(in crate::dynamics::impact2d) fn pair(engine: &mut Engine, pair: usize, t: f64) -> Found {
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
    engine.schedule.effort.searches += 1;
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
        Ground::Sine { omega, .. } => PERIODS * std::f64::consts::TAU / omega,
        Ground::Record { dt, .. } => SAMPLES * dt,
    };
    (t + stretch).min(duration)
}

/// The open points of a pair; one that has come out in front counts again.
fn open(engine: &mut Engine, pair: usize, t: f64, view: &View) -> SmallVec<[Quarry; 4]> {
    let moved = view.moved();
    let mut all = SmallVec::new();
    for site in engine.pairs[pair].sites.clone() {
        if engine.sites[site].kept {
            continue;
        }
        let resolution = RESOLUTION * (engine.sites[site].spot.size + moved);
        let (mut here, mut least) = outlook(engine, site, 0.0, view);
        let track = &mut engine.sites[site];
        if !track.armed && in_front(here.gap, here.rate, t, resolution) {
            track.arm();
        }
        let (depth, armed) = (if track.lifted { track.sink } else { 0.0 }, track.armed || track.lifted);
        if depth > 0.0 {
            (here, least) = outlook(engine, site, depth, view);
        }
        all.push(Quarry { site, depth, resolution, hunt: Hunt::begin(here, armed, resolution), least, out: None });
    }
    all
}

fn in_flight(engine: &mut Engine, pair: usize, t: f64, until: f64) -> Found {
    let (duration, slots) = (engine.model.duration, engine.pairs[pair].slots);
    let mut view = View::of(engine, slots, t, duration);
    let mut quarries = open(engine, pair, t, &view);
    let reachable = |q: &Quarry| !(q.hunt.out_of_reach() && view.window >= duration - t);
    if !quarries.iter().any(reachable) {
        return Found { due: f64::INFINITY, meets: false };
    }
    if view.is_straight() {
        leave_to_the_nearest(engine, &mut quarries);
    }
    let (mut at, mut looks) = (t, 1);
    let mut found = quarries.iter().any(|q| q.hunt.at_once()).then_some(t);
    for _ in 0..MOST {
        if at >= until || found.is_some() {
            break;
        }
        let leap = leap(&mut quarries);
        let next = (at + leap).min(until);
        if next <= at {
            found = Some(at);
            break;
        }
        let there = view.then(engine, slots, next, until);
        looks += 1;
        for quarry in &mut quarries {
            found = arrive(engine, pair, quarry, &there, [at, next], found).or(found);
        }
        (at, view) = (next, there);
    }
    engine.schedule.effort.looks += looks;
    for quarry in &quarries {
        engine.sites[quarry.site].out = quarry.out.or(quarry.hunt.out());
    }
    match found {
        Some(due) => Found { due, meets: true },
        None => Found { due: if at >= duration { f64::INFINITY } else { at }, meets: false },
    }
}

/// Where nothing turns, points of one face keep their distances: the nearest comes first, and who comes with it is seen
/// where it is met.
fn leave_to_the_nearest(engine: &Engine, quarries: &mut SmallVec<[Quarry; 4]>) {
    let waits = |far: &Quarry, near: &Quarry| {
        let (a, b) = (&engine.sites[far.site], &engine.sites[near.site]);
        let alike = far.hunt.armed() && near.hunt.armed() && (far.depth > 0.0) == (near.depth > 0.0);
        let clear = |quarry: &Quarry| quarry.hunt.gap() - quarry.depth;
        alike && a.sides == b.sides && a.aim.shares_face(&b.aim) && clear(far) >= clear(near)
    };
    let mut i = 0;
    while i < quarries.len() {
        if (0..quarries.len()).any(|j| j != i && waits(&quarries[i], &quarries[j])) {
            quarries.remove(i);
        } else {
            i += 1;
        }
    }
}

/// How far the next look may be \[s\].
fn leap(quarries: &mut [Quarry]) -> f64 {
    let mut shortest = f64::INFINITY;
    let mut worst: Option<(Cubic, f64)> = None;
    for quarry in quarries {
        let open = match (quarry.least.filter(|_| quarry.hunt.armed()), worst) {
            (None, _) => 0.0,
            (Some(cubic), Some((other, leap))) if cubic.is_above(&other) => leap,
            (Some(cubic), _) => cubic.leap(),
        };
        worst = quarry.least.map(|cubic| (cubic, open)).or(worst);
        shortest = shortest.min(quarry.hunt.leap_past(open));
    }
    shortest
}

/// When a point meets the face before `sooner`, if the look at `next` shows that it does.
fn arrive(
    engine: &Engine,
    pair: usize,
    quarry: &mut Quarry,
    there: &View,
    [t, next]: [f64; 2],
    sooner: Option<f64>,
) -> Option<f64> {
    let site = quarry.site;
    let mut from = t;
    if quarry.depth > 0.0
        && let Some(out) = comes_out(engine, pair, quarry, there, [t, next])
    {
        // Out in front it is met at the face itself.
        (quarry.depth, quarry.out, from) = (0.0, Some(out), out.min(next));
    }
    let depth = quarry.depth;
    let (here, least) = outlook(engine, site, depth, there);
    quarry.least = least;
    let mut ask = |at: f64| gap_at(engine, pair, site, depth, at);
    match quarry.hunt.arrive(here, next) {
        Sight::Open => None,
        Sight::Closed if sooner.is_some_and(|at| ask(at)[0] > -quarry.resolution) => None,
        Sight::Closed => Some(crossing(&mut ask, from, next)),
        Sight::Closing => {
            let at = polish(&mut ask, next, &here);
            sooner.is_none_or(|sooner| at < sooner).then_some(at)
        }
    }
}

/// When a point that has lifted off is in front of the face, by the look at `next` or, where one leap may have gone over
/// the whole hop, one on the way.
fn comes_out(engine: &Engine, pair: usize, quarry: &Quarry, there: &View, [t, next]: [f64; 2]) -> Option<f64> {
    let track = &engine.sites[quarry.site];
    let [clear, rate] = gap(&track.aim, track.sides, &there.poses);
    if in_front(clear, rate, next, quarry.resolution) {
        return Some(next);
    }
    let middle = f64::midpoint(t, next);
    let [clear, on_the_way] = gap_at(engine, pair, quarry.site, 0.0, middle);
    (rate < 0.0 && in_front(clear, on_the_way, middle, quarry.resolution)).then_some(middle)
}

/// Newton's method from inside the resolution.
fn polish(ask: &mut impl FnMut(f64) -> [f64; 2], t: f64, here: &Outlook) -> f64 {
    let (mut t, mut gap, mut rate) = (t, here.gap, here.rate);
    for _ in 0..3 {
        let next = t - gap / rate;
        if next == t || !next.is_finite() {
            break;
        }
        t = next;
        [gap, rate] = ask(t);
        if rate >= 0.0 {
            break;
        }
    }
    t
}

/// A side is in a planned step: looks at gap and rate, and where the gap turns round between two of them.
fn in_steps(engine: &mut Engine, pair: usize, t: f64, until: f64, planned: f64) -> Found {
    let first = View::of(engine, engine.pairs[pair].slots, t, until);
    let quarries = open(engine, pair, t, &first);
    let first = quarries.iter().filter_map(|quarry| in_step(engine, pair, quarry, t, until)).reduce(f64::min);
    // The step's own end calls for the next search.
    let next = if until < planned.min(engine.model.duration) { until } else { f64::INFINITY };
    Found { due: first.unwrap_or(next), meets: first.is_some() }
}

fn in_step(engine: &Engine, pair: usize, quarry: &Quarry, t: f64, until: f64) -> Option<f64> {
    let ask = |at: f64| gap_at(engine, pair, quarry.site, quarry.depth, at);
    let mut armed = quarry.hunt.armed();
    let resolution = RESOLUTION * engine.sites[quarry.site].spot.size;
    let (mut from, mut before) = (t, ask(t));
    if armed && before[0] <= resolution && before[1] < 0.0 {
        return Some(t);
    }
    for i in 1..=LOOKS {
        let to = if i == LOOKS { until } else { t + (until - t) * i as f64 / LOOKS as f64 };
        let here = ask(to);
        let turns = before[1] * here[1] < 0.0;
        let way = if before[1] < 0.0 { 1.0 } else { -1.0 };
        let turn = turns.then(|| root(|at| way * ask(at)[1], from, to)).map(|at| (at, ask(at)));
        for (at, [gap, rate]) in turn.into_iter().chain([(to, here)]) {
            if armed && gap < 0.0 && (rate < 0.0 || gap < -resolution) {
                return Some(crossing(ask, from, at));
            }
            armed = armed || in_front(gap, rate, at, resolution);
            from = at;
        }
        before = here;
    }
    None
}
