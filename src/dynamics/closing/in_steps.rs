//! The first closing of a pair within planned steps: subdivision with a bound on the gap's second derivative.

use crate::contact::{Frame, Local, gap, locate};
use crate::dynamics::closing::constants::{CLOSING_INTERVAL, SPEED_ROUNDING, STEP_SAMPLES};
use crate::dynamics::closing::gap_curvature::GapCurvature;
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::subdivision::{GapSample, Subdivision};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::world::World;
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::dynamics::world::tracks::{PairTrack, Trajectory};

/// Searches the first closing of a pair from `t` to `until`, the end of the first planned step; enters the closing of
/// each contact and returns the first, infinite without one \[s\].
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64, until: f64) -> f64 {
    let contacts = world.pairs[pair].contacts.clone();
    for contact in contacts.clone() {
        (world.contacts[contact].closing, world.contacts[contact].rearmed_at) = (None, None);
    }
    if contacts.clone().all(|c| world.contacts[c].state.closed().is_some()) {
        return f64::INFINITY;
    }
    let mut samples = StepSamples::begin(world, pair, t, until);
    if cannot_close(world, pair, &samples) {
        return f64::INFINITY;
    }
    let mut first = f64::INFINITY;
    for contact in contacts {
        let (closing, out) =
            open(world, contact, t).map_or((None, None), |armed| in_step(world, contact, &mut samples, armed));
        (world.contacts[contact].closing, world.contacts[contact].rearmed_at) = (closing, out);
        first = first.min(closing.unwrap_or(f64::INFINITY));
    }
    first
}

/// Whether the distance of every open contact's node before its plane, or behind it where the contact is disarmed, exceeds the
/// bound on the excursion of both bodies, by one sample.
fn cannot_close(world: &World, pair: usize, samples: &StepSamples) -> bool {
    let slots = world.pairs[pair].slots;
    let (mut least_gap, mut longest_arm) = (f64::INFINITY, [0.0f64; 2]);
    for contact in world.pairs[pair].contacts.clone() {
        let track = &world.contacts[contact];
        let Contact::Open { armed } = track.state else { continue };
        let here = samples.local(world, contact, 0);
        // A disarmed node that stays behind the plane is not armed again.
        least_gap = least_gap.min(if armed { here.gap } else { -here.gap });
        for (slot, arm) in track.slots.into_iter().zip(world.model.contacts[track.site].levers(&here)) {
            let side = usize::from(slot == slots[1]);
            longest_arm[side] = longest_arm[side].max(arm);
        }
    }
    let [t, until] = [samples.times[0], samples.times[STEP_SAMPLES - 1]];
    let excursions = |side: usize| slots[side].map_or(0.0, |slot| excursion(world, slot, longest_arm[side], t, until));
    least_gap > excursions(0) + excursions(1)
}

/// Whether an open contact is armed; `None` for a closed one. A disarmed contact whose gap is positive is armed
/// again.
fn open(world: &mut World, contact: usize, t: f64) -> Option<bool> {
    let Contact::Open { armed } = world.contacts[contact].state else { return None };
    if armed {
        return Some(true);
    }
    let here = local_at(world, contact, t);
    let out = is_positive_again(here.gap, here.gap_rate, t, resolution(world, contact, t));
    if out {
        world.contacts[contact].state = Contact::Open { armed: true };
    }
    Some(out)
}

fn local_at(world: &World, contact: usize, t: f64) -> Local {
    let site = &world.model.contacts[world.contacts[contact].site];
    locate(&site.home, &world.side(contact, 0, t), &world.side(contact, 1, t))
}

/// Depth of an excursion of the gap below zero that is round-off at `t` \[m\].
fn resolution(world: &World, contact: usize, t: f64) -> f64 {
    let track = &world.contacts[contact];
    // The round-off of positions grows with the displacement of the bodies.
    let sides = track.slots.into_iter().zip(track.sections);
    let moved: f64 = sides.filter_map(|(slot, section)| Some(world.frame(slot?, section, t).shift.length())).sum();
    RESOLUTION * (track.geometry.size + moved)
}

/// Poses of a pair's bodies at the sample times of a planned step, shared by its contacts.
struct StepSamples {
    times: [f64; STEP_SAMPLES],
    /// Poses at the first sample time.
    first: [Frame; 2],
    /// Poses at the other sample times; empty until they are asked for.
    others: Vec<[Frame; 2]>,
    slots: [Option<usize>; 2],
    sections: [usize; 2],
}

impl StepSamples {
    /// With the poses of the first sample time.
    fn begin(world: &World, pair: usize, t: f64, until: f64) -> Self {
        let PairTrack { slots, sections, .. } = world.pairs[pair];
        let part = |i: usize| (until - t) * i as f64 / (STEP_SAMPLES - 1) as f64;
        let times = std::array::from_fn(|i| if i == STEP_SAMPLES - 1 { until } else { t + part(i) });
        Self { times, first: Self::frames(world, slots, sections, t), others: Vec::new(), slots, sections }
    }

    /// Computes the poses of the other sample times.
    fn fill(&mut self, world: &World) {
        if !self.others.is_empty() {
            return;
        }
        let frames = |&t: &f64| Self::frames(world, self.slots, self.sections, t);
        self.others.extend(self.times[1..].iter().map(frames));
    }

    fn frames(world: &World, slots: [Option<usize>; 2], sections: [usize; 2], t: f64) -> [Frame; 2] {
        let still = Frame::fixed(glam::DVec3::ZERO);
        [0, 1].map(|side| slots[side].map_or(still, |slot| world.frame(slot, sections[side], t)))
    }

    /// Pose of one of the pair's bodies at sample `i`.
    fn side(&self, slot: Option<usize>, i: usize) -> &Frame {
        let frames = i.checked_sub(1).map_or(&self.first, |other| &self.others[other]);
        &frames[usize::from(slot == self.slots[1])]
    }

    /// Poses of node's and face's body of a contact at sample `i`.
    fn sides<'a>(&'a self, world: &'a World, contact: usize, i: usize) -> [&'a Frame; 2] {
        let track = &world.contacts[contact];
        let site = &world.model.contacts[track.site];
        track.slots.map(|slot| if slot.is_some() { self.side(slot, i) } else { &site.stand })
    }

    fn local(&self, world: &World, contact: usize, i: usize) -> Local {
        let (site, [node, face]) = (&world.model.contacts[world.contacts[contact].site], self.sides(world, contact, i));
        locate(&site.home, node, face)
    }

    /// Gap and rate of a contact at sample `i`.
    fn gap(&self, world: &World, contact: usize, i: usize) -> GapSample {
        let (site, [node, face]) = (&world.model.contacts[world.contacts[contact].site], self.sides(world, contact, i));
        let [gap, rate] = gap(&site.home, node, face);
        GapSample { t: self.times[i], gap, rate }
    }
}

/// Error bound of the rate of a contact's gap \[m/s\]: the tolerance of the run, at least round-off, times the speeds
/// of node and face.
fn rate_error(world: &World, contact: usize, sides: [&Frame; 2]) -> f64 {
    let SiteGeometry { arm, apart, .. } = world.contacts[contact].geometry;
    let speed = |(side, arm): (&Frame, f64)| side.velocity.length() + side.spin.length() * arm;
    world.model.tolerance.max(SPEED_ROUNDING) * sides.into_iter().zip([arm, apart]).map(speed).sum::<f64>()
}

/// Bound on the displacement of a point at `arm` \[m\] from a body's G from `from` to `until` \[m\]; infinite where
/// no bound holds.
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

/// Closing of a contact, and time from which it is armed if it was not \[s\], where a body is in a planned step: from
/// the first sample alone where the bounds on excursion or curvature exclude a closing, otherwise by subdivision with
/// the curvature bound.
fn in_step(world: &World, contact: usize, samples: &mut StepSamples, armed: bool) -> (Option<f64>, Option<f64>) {
    let (t, until) = (samples.times[0], samples.times[STEP_SAMPLES - 1]);
    if until <= t {
        return (None, None);
    }
    let before = samples.local(world, contact, 0);
    let track = &world.contacts[contact];
    let arms = world.model.contacts[track.site].levers(&before);
    let excursions =
        track.slots.into_iter().zip(arms).map(|(slot, arm)| slot.map_or(0.0, |s| excursion(world, s, arm, t, until)));
    if armed && before.gap > excursions.sum::<f64>() {
        return (None, None);
    }
    let moved: f64 = track.slots.iter().map(|&slot| slot.map_or(0.0, |_| samples.side(slot, 0).shift.length())).sum();
    let resolution = RESOLUTION * (track.geometry.size + moved);
    if armed
        && before.gap <= resolution
        && before.gap_rate < -rate_error(world, contact, samples.sides(world, contact, 0))
    {
        return (Some(t), None);
    }
    let node = usize::from(track.slots[0] == samples.slots[1]);
    let slots = samples.slots;
    let bounds = GapCurvature::of(world, slots, t, until);
    let span = until - t;
    // Over the whole step the distance of the node from the face's G is at most its distance at the start plus its
    // excursion.
    let curvature_bound = bounds.curvature(node, arms, span);
    if armed
        && bounds.holds(span)
        && before.gap > resolution + span * ((-before.gap_rate).max(0.0) + 0.5 * curvature_bound * span)
    {
        return (None, None);
    }
    let curvature = |from: &GapSample, to: f64| {
        if bounds.holds(span) {
            return curvature_bound;
        }
        let part = GapCurvature::of(world, slots, from.t, to);
        let arms = world.model.contacts[track.site].levers(&local_at(world, contact, from.t));
        if part.holds(to - from.t) { part.curvature(node, arms, to - from.t) } else { f64::INFINITY }
    };
    let site = &world.model.contacts[track.site];
    let gap_at = |at: f64| {
        let [gap, rate] = gap(&site.home, &world.side(contact, 0, at), &world.side(contact, 1, at));
        GapSample { t: at, gap, rate }
    };
    let rate_error = |at: f64| rate_error(world, contact, [&world.side(contact, 0, at), &world.side(contact, 1, at)]);
    samples.fill(world);
    let gaps: [GapSample; STEP_SAMPLES] = std::array::from_fn(|i| samples.gap(world, contact, i));
    let interval = CLOSING_INTERVAL * world.pairs[track.pair].simultaneity;
    let mut subdivision = Subdivision::new((gap_at, curvature, rate_error), armed, resolution, interval);
    let closing = subdivision.first_closing(&gaps);
    (closing, subdivision.rearmed_at())
}
