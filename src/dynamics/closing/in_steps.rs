//! The first closing of a pair within planned steps: subdivision with a bound on the gap's second derivative.

use crate::contact::{Frame, Local, gap, locate};
use crate::dynamics::closing::constants::{INSTANT, LOOKS, SPEED};
use crate::dynamics::closing::gap_curvature::GapCurvature;
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::subdivision::{GapSample, Subdivision};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::world::World;
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::dynamics::world::tracks::Trajectory;

/// The first closing of a pair within planned steps.
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64, until: f64) -> f64 {
    let contacts = world.pairs[pair].contacts.clone();
    for contact in contacts.clone() {
        (world.contacts[contact].closing, world.contacts[contact].out) = (None, None);
    }
    if contacts.clone().all(|c| world.contacts[c].state.closed().is_some()) {
        return f64::INFINITY;
    }
    let mut views = Views::begin(world, pair, t, until);
    if too_short(world, pair, &views) {
        return f64::INFINITY;
    }
    let mut first = f64::INFINITY;
    for contact in contacts {
        let (closing, out) =
            open(world, contact, t).map_or((None, None), |armed| in_step(world, contact, &mut views, armed));
        (world.contacts[contact].closing, world.contacts[contact].out) = (closing, out);
        first = first.min(closing.unwrap_or(f64::INFINITY));
    }
    first
}

/// Whether the planned steps are too short for any open contact of the pair to close, by one look at all of them.
fn too_short(world: &World, pair: usize, views: &Views) -> bool {
    let slots = world.pairs[pair].slots;
    let (mut least, mut longest) = (f64::INFINITY, [0.0f64; 2]);
    for contact in world.pairs[pair].contacts.clone() {
        let track = &world.contacts[contact];
        let Contact::Open { armed } = track.state else { continue };
        if !armed {
            return false;
        }
        let here = views.look(world, contact, 0);
        least = least.min(here.gap);
        for (slot, arm) in track.slots.into_iter().zip(world.model.contacts[track.site].levers(&here)) {
            let side = usize::from(slot == slots[1]);
            longest[side] = longest[side].max(arm);
        }
    }
    let [t, until] = [views.times[0], views.times[LOOKS - 1]];
    let far = |side: usize| slots[side].map_or(0.0, |slot| excursion(world, slot, longest[side], t, until));
    least > far(0) + far(1)
}

/// Whether an open contact is armed; nothing for a closed one. A node that has come out in front is armed again.
fn open(world: &mut World, contact: usize, t: f64) -> Option<bool> {
    let Contact::Open { armed } = world.contacts[contact].state else { return None };
    if armed {
        return Some(true);
    }
    let here = look(world, contact, t);
    let out = is_positive_again(here.gap, here.gap_rate, t, resolution(world, contact, t));
    if out {
        world.contacts[contact].state = Contact::Open { armed: true };
    }
    Some(out)
}

fn look(world: &World, contact: usize, t: f64) -> Local {
    let site = &world.model.contacts[world.contacts[contact].site];
    locate(&site.home, &world.side(contact, 0, t), &world.side(contact, 1, t))
}

/// Depth of a dip of a contact's gap that is rounding from `t` on \[m\].
fn resolution(world: &World, contact: usize, t: f64) -> f64 {
    let track = &world.contacts[contact];
    // Places round with how far the bodies have come, too.
    let moved: f64 = track.slots.into_iter().flatten().map(|slot| world.frame(slot, t).shift.length()).sum();
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
    fn begin(world: &World, pair: usize, t: f64, until: f64) -> Self {
        let slots = world.pairs[pair].slots;
        let part = |i: usize| (until - t) * i as f64 / (LOOKS - 1) as f64;
        let times = std::array::from_fn(|i| if i == LOOKS - 1 { until } else { t + part(i) });
        Self { times, frames: [Self::frames(world, slots, t); LOOKS], filled: false, slots }
    }

    /// The other looks.
    fn fill(&mut self, world: &World) {
        if std::mem::replace(&mut self.filled, true) {
            return;
        }
        for i in 1..LOOKS {
            self.frames[i] = Self::frames(world, self.slots, self.times[i]);
        }
    }

    fn frames(world: &World, slots: [Option<usize>; 2], t: f64) -> [Frame; 2] {
        slots.map(|slot| slot.map_or(Frame::fixed(glam::DVec3::ZERO), |slot| world.frame(slot, t)))
    }

    /// Pose of one of the pair's bodies at a look.
    fn side(&self, slot: Option<usize>, i: usize) -> &Frame {
        &self.frames[i][usize::from(slot == self.slots[1])]
    }

    /// Poses of a contact's node and face at a look.
    fn sides<'a>(&'a self, world: &'a World, contact: usize, i: usize) -> [&'a Frame; 2] {
        let track = &world.contacts[contact];
        let site = &world.model.contacts[track.site];
        track.slots.map(|slot| if slot.is_some() { self.side(slot, i) } else { &site.stand })
    }

    fn look(&self, world: &World, contact: usize, i: usize) -> Local {
        let (site, [node, face]) = (&world.model.contacts[world.contacts[contact].site], self.sides(world, contact, i));
        locate(&site.home, node, face)
    }

    /// The gap alone.
    fn gap(&self, world: &World, contact: usize, i: usize) -> GapSample {
        let (site, [node, face]) = (&world.model.contacts[world.contacts[contact].site], self.sides(world, contact, i));
        let [gap, rate] = gap(&site.home, node, face);
        GapSample { t: self.times[i], gap, rate }
    }
}

/// What the rate of a contact's gap may err by: its bodies' steps, or their rounding \[m/s\].
fn noise(world: &World, contact: usize, sides: [&Frame; 2]) -> f64 {
    let SiteGeometry { arm, apart, .. } = world.contacts[contact].spot;
    let speed = |(side, arm): (&Frame, f64)| side.velocity.length() + side.spin.length() * arm;
    world.model.tolerance.max(SPEED) * sides.into_iter().zip([arm, apart]).map(speed).sum::<f64>()
}

/// How far a point at `arm` from a body's G can go within its planned step, at most \[m\].
fn excursion(world: &World, slot: usize, arm: f64, from: f64, until: f64) -> f64 {
    match (&world.bodies[slot].now, &world.bodies[slot].system) {
        (Trajectory::Island { island, index }, _) => {
            world.islands[*island].as_ref().map_or(0.0, |island| island.excursion(&world.model, *index, arm, from))
        }
        (Trajectory::Flight(flight), Some(system)) => {
            let bound = system.bounds(flight, from, until - from);
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
fn in_step(world: &World, contact: usize, views: &mut Views, armed: bool) -> (Option<f64>, Option<f64>) {
    let (t, until) = (views.times[0], views.times[LOOKS - 1]);
    if until <= t {
        return (None, None);
    }
    let before = views.look(world, contact, 0);
    let track = &world.contacts[contact];
    let arms = world.model.contacts[track.site].levers(&before);
    let far =
        track.slots.into_iter().zip(arms).map(|(slot, arm)| slot.map_or(0.0, |s| excursion(world, s, arm, t, until)));
    if armed && before.gap > far.sum::<f64>() {
        return (None, None);
    }
    let moved: f64 = track.slots.iter().map(|&slot| slot.map_or(0.0, |_| views.side(slot, 0).shift.length())).sum();
    let resolution = RESOLUTION * (track.spot.size + moved);
    if armed && before.gap <= resolution && before.gap_rate < -noise(world, contact, views.sides(world, contact, 0)) {
        return (Some(t), None);
    }
    let node = usize::from(track.slots[0] == views.slots[1]);
    let slots = views.slots;
    let whole = GapCurvature::of(world, slots, t, until);
    let span = until - t;
    // Over the whole step a node is no further from its face's G than that and all its way.
    let most = whole.curvature(node, arms, span);
    if armed && whole.holds(span) && before.gap > resolution + span * ((-before.gap_rate).max(0.0) + 0.5 * most * span)
    {
        return (None, None);
    }
    let bend = |from: &GapSample, to: f64| {
        if whole.holds(span) {
            return most;
        }
        let part = GapCurvature::of(world, slots, from.t, to);
        let arms = world.model.contacts[track.site].levers(&look(world, contact, from.t));
        if part.holds(to - from.t) { part.curvature(node, arms, to - from.t) } else { f64::INFINITY }
    };
    let site = &world.model.contacts[track.site];
    let ask = |at: f64| {
        let [gap, rate] = gap(&site.home, &world.side(contact, 0, at), &world.side(contact, 1, at));
        GapSample { t: at, gap, rate }
    };
    let noise = |at: f64| noise(world, contact, [&world.side(contact, 0, at), &world.side(contact, 1, at)]);
    views.fill(world);
    let looks: [GapSample; LOOKS] = std::array::from_fn(|i| views.gap(world, contact, i));
    let instant = INSTANT * world.pairs[track.pair].together;
    let mut subdivision = Subdivision::new((ask, bend, noise), armed, resolution, instant);
    let closing = subdivision.first_closing(&looks);
    (closing, subdivision.rearmed_at())
}
