//! When the open contacts of a pair close next, on the trajectories that its bodies are on.

use crate::dynamics::closing::{collinear_pair, in_flight};

use crate::contact::{Frame, Local, gap, locate};
use crate::dynamics::ContactSite;
use crate::dynamics::closing::gap_curvature::Swing;
use crate::dynamics::closing::in_flight::Spot;
use crate::dynamics::event_loop::contact_engine::{Engine, Trajectory};
use crate::dynamics::event_loop::event_queue::Item;
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::positive_again::in_front;
use crate::dynamics::locate::subdivision::{Look, Prowl};
use crate::dynamics::penalty3d::contact_state::Contact;

/// Rounding of a speed, in parts of it, with room.
const SPEED: f64 = 64.0 * f64::EPSILON;
/// Time over which a contact shows how it closes, in units of that within which contacts of its pair close together.
pub(in crate::dynamics) const INSTANT: f64 = 100.0;
/// Looks at a gap per planned step.
const LOOKS: usize = 5;

/// Looks at a pair anew from `t` and enters what is due.
pub(in crate::dynamics) fn pair(engine: &mut Engine, pair: usize, t: f64) {
    engine.effort.searches += 1;
    for contact in engine.pairs[pair].contacts.clone() {
        engine.contacts[contact].take_note(t);
    }
    let due = collinear_pair::search(engine, pair, t).unwrap_or_else(|| match planned(engine, pair) {
        Some(until) => in_steps(engine, pair, t, until),
        None => in_flight::search(engine, pair, t),
    });
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
    let contacts = engine.pairs[pair].contacts.clone();
    for contact in contacts.clone() {
        (engine.contacts[contact].closing, engine.contacts[contact].out) = (None, None);
    }
    if contacts.clone().all(|c| engine.contacts[c].state.closed().is_some()) {
        return f64::INFINITY;
    }
    let mut views = Views::begin(engine, pair, t, until);
    if too_short(engine, pair, &views) {
        return f64::INFINITY;
    }
    let mut first = f64::INFINITY;
    for contact in contacts {
        let (closing, out) =
            open(engine, contact, t).map_or((None, None), |armed| in_step(engine, contact, &mut views, armed));
        (engine.contacts[contact].closing, engine.contacts[contact].out) = (closing, out);
        first = first.min(closing.unwrap_or(f64::INFINITY));
    }
    first
}

/// Whether the planned steps are too short for any open contact of the pair to close, by one look at all of them.
fn too_short(engine: &Engine, pair: usize, views: &Views) -> bool {
    let slots = engine.pairs[pair].slots;
    let (mut least, mut longest) = (f64::INFINITY, [0.0f64; 2]);
    for contact in engine.pairs[pair].contacts.clone() {
        let track = &engine.contacts[contact];
        let Contact::Open { armed } = track.state else { continue };
        if !armed {
            return false;
        }
        let here = views.look(engine, contact, 0);
        least = least.min(here.gap);
        for (slot, arm) in track.slots.into_iter().zip(arms(&engine.model.contacts[track.site], &here)) {
            let side = usize::from(slot == slots[1]);
            longest[side] = longest[side].max(arm);
        }
    }
    let [t, until] = [views.times[0], views.times[LOOKS - 1]];
    let far = |side: usize| slots[side].map_or(0.0, |slot| excursion(engine, slot, longest[side], t, until));
    least > far(0) + far(1)
}

/// Whether an open contact is armed; nothing for a closed one. A node that has come out in front is armed again.
fn open(engine: &mut Engine, contact: usize, t: f64) -> Option<bool> {
    let Contact::Open { armed } = engine.contacts[contact].state else { return None };
    if armed {
        return Some(true);
    }
    let here = look(engine, contact, t);
    let out = in_front(here.gap, here.gap_rate, t, resolution(engine, contact, t));
    if out {
        engine.contacts[contact].state = Contact::Open { armed: true };
    }
    Some(out)
}

fn look(engine: &Engine, contact: usize, t: f64) -> Local {
    let site = &engine.model.contacts[engine.contacts[contact].site];
    locate(&site.home, &engine.side(contact, 0, t), &engine.side(contact, 1, t))
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
    /// Whether the frames are those of all looks, not of the first alone.
    filled: bool,
    slots: [Option<usize>; 2],
}

impl Views {
    /// With the first look only.
    fn begin(engine: &Engine, pair: usize, t: f64, until: f64) -> Self {
        let slots = engine.pairs[pair].slots;
        let part = |i: usize| (until - t) * i as f64 / (LOOKS - 1) as f64;
        let times = std::array::from_fn(|i| if i == LOOKS - 1 { until } else { t + part(i) });
        Self { times, frames: [Self::frames(engine, slots, t); LOOKS], filled: false, slots }
    }

    /// The other looks.
    fn fill(&mut self, engine: &Engine) {
        if std::mem::replace(&mut self.filled, true) {
            return;
        }
        for i in 1..LOOKS {
            self.frames[i] = Self::frames(engine, self.slots, self.times[i]);
        }
    }

    fn frames(engine: &Engine, slots: [Option<usize>; 2], t: f64) -> [Frame; 2] {
        slots.map(|slot| slot.map_or(Frame::fixed(glam::DVec3::ZERO), |slot| engine.frame(slot, t)))
    }

    /// Pose of one of the pair's bodies at a look.
    fn side(&self, slot: Option<usize>, i: usize) -> &Frame {
        &self.frames[i][usize::from(slot == self.slots[1])]
    }

    /// Poses of a contact's node and face at a look.
    fn sides<'a>(&'a self, engine: &'a Engine, contact: usize, i: usize) -> [&'a Frame; 2] {
        let track = &engine.contacts[contact];
        let site = &engine.model.contacts[track.site];
        track.slots.map(|slot| if slot.is_some() { self.side(slot, i) } else { &site.stand })
    }

    fn look(&self, engine: &Engine, contact: usize, i: usize) -> Local {
        let (site, [node, face]) =
            (&engine.model.contacts[engine.contacts[contact].site], self.sides(engine, contact, i));
        locate(&site.home, node, face)
    }

    /// The gap alone.
    fn gap(&self, engine: &Engine, contact: usize, i: usize) -> Look {
        let (site, [node, face]) =
            (&engine.model.contacts[engine.contacts[contact].site], self.sides(engine, contact, i));
        let [gap, rate] = gap(&site.home, node, face);
        Look { t: self.times[i], gap, rate }
    }
}

/// What the rate of a contact's gap may err by: its bodies' steps, or their rounding \[m/s\].
fn noise(engine: &Engine, contact: usize, sides: [&Frame; 2]) -> f64 {
    let Spot { arm, apart, .. } = engine.contacts[contact].spot;
    let speed = |(side, arm): (&Frame, f64)| side.velocity.length() + side.spin.length() * arm;
    engine.model.tolerance.max(SPEED) * sides.into_iter().zip([arm, apart]).map(speed).sum::<f64>()
}

/// A contact's node as its own body carries it, and as the face's body would: distances from G \[m\].
pub(in crate::dynamics) fn arms(site: &ContactSite, here: &Local) -> [f64; 2] {
    [site.point.length(), site.face.corners[0].length() + here.gap.abs() + here.at.length()]
}

/// How far a point at `arm` from a body's G can go within its planned step, at most \[m\].
fn excursion(engine: &Engine, slot: usize, arm: f64, from: f64, until: f64) -> f64 {
    match (&engine.bodies[slot].now, &engine.bodies[slot].system) {
        (Trajectory::Island { island, index }, _) => {
            engine.islands[*island].as_ref().map_or(0.0, |island| island.excursion(&engine.model, *index, arm, from))
        }
        (Trajectory::Flight(flight), Some(system)) => {
            let (_, bound) = system.prospect(flight, from, until - from);
            if bound.window < until - from {
                return f64::INFINITY;
            }
            (bound.speed + bound.spin * arm) * (until - from)
        }
        _ => f64::INFINITY,
    }
}

/// A side is in a planned step: looks at gap and rate, as many as it takes to know that nothing hides between two; one
/// look where the steps are too short to close the gap. When it closes, and when it comes out in front if it was behind.
fn in_step(engine: &Engine, contact: usize, views: &mut Views, armed: bool) -> (Option<f64>, Option<f64>) {
    let (t, until) = (views.times[0], views.times[LOOKS - 1]);
    if until <= t {
        return (None, None);
    }
    let before = views.look(engine, contact, 0);
    let track = &engine.contacts[contact];
    let arms = arms(&engine.model.contacts[track.site], &before);
    let far =
        track.slots.into_iter().zip(arms).map(|(slot, arm)| slot.map_or(0.0, |s| excursion(engine, s, arm, t, until)));
    if armed && before.gap > far.sum::<f64>() {
        return (None, None);
    }
    let moved: f64 = track.slots.iter().map(|&slot| slot.map_or(0.0, |_| views.side(slot, 0).shift.length())).sum();
    let resolution = RESOLUTION * (track.spot.size + moved);
    if armed && before.gap <= resolution && before.gap_rate < -noise(engine, contact, views.sides(engine, contact, 0)) {
        return (Some(t), None);
    }
    let node = usize::from(track.slots[0] == views.slots[1]);
    let slots = views.slots;
    let whole = Swing::of(engine, slots, t, until);
    let span = until - t;
    // Over the whole step a node is no further from its face's G than that and all its way.
    let most = whole.curvature(node, arms, span);
    if armed && whole.holds(span) && before.gap > resolution + span * ((-before.gap_rate).max(0.0) + 0.5 * most * span)
    {
        return (None, None);
    }
    let bend = |from: &Look, to: f64| {
        if whole.holds(span) {
            return most;
        }
        let part = Swing::of(engine, slots, from.t, to);
        let arms = self::arms(&engine.model.contacts[track.site], &look(engine, contact, from.t));
        if part.holds(to - from.t) { part.curvature(node, arms, to - from.t) } else { f64::INFINITY }
    };
    let site = &engine.model.contacts[track.site];
    let ask = |at: f64| {
        let [gap, rate] = gap(&site.home, &engine.side(contact, 0, at), &engine.side(contact, 1, at));
        Look { t: at, gap, rate }
    };
    let noise = |at: f64| noise(engine, contact, [&engine.side(contact, 0, at), &engine.side(contact, 1, at)]);
    views.fill(engine);
    let looks: [Look; LOOKS] = std::array::from_fn(|i| views.gap(engine, contact, i));
    let instant = INSTANT * engine.pairs[track.pair].together;
    let mut prowl = Prowl::new((ask, bend, noise), armed, resolution, instant);
    let closing = prowl.closing(&looks);
    (closing, prowl.out())
}
