//! The first closing of a pair within planned steps: subdivision with a bound on the gap's second derivative.

use crate::contact::gap;
use crate::dynamics::closing::constants::{CLOSING_INTERVAL, STEP_SAMPLES};
use crate::dynamics::closing::edge_in_step;
use crate::dynamics::closing::gap_curvature::GapCurvature;
use crate::dynamics::closing::shared::Shared;
use crate::dynamics::closing::step_samples::{StepSamples, excursion, rate_error, resolution};
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::subdivision::{GapClosing, GapSample, Subdivision};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::PairTrack;

/// Searches the first closing of a pair from `t` to `until`, the end of the first planned step; enters the closing of
/// each contact and returns the first, infinite without one \[s\].
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, [t, until]: [f64; 2], shared: &mut Shared) -> f64 {
    let contacts = world.pairs[pair].contacts.clone();
    for contact in contacts.clone() {
        world.contacts[contact].found = GapClosing::NONE;
    }
    if contacts.clone().all(|c| world.is_closed(c)) {
        return f64::INFINITY;
    }
    let samples = shared.samples(world, pair, [t, until]);
    let corners_stay = cannot_close(world, pair, samples);
    // Where the crossing of an edge reaches the plane of the face, one end of the edge, a corner, is behind that plane.
    let edges_stay = corners_stay
        && contacts
            .clone()
            .all(|c| world.edge(c).is_some() || world.contacts[c].state == Contact::Open { armed: true });
    if corners_stay && edges_stay {
        return f64::INFINITY;
    }
    let moved = if edges_stay { [0.0; 2] } else { edges_moved(world, pair, samples) };
    let edges_stay = edges_stay || faces_look_elsewhere(world, pair, samples);
    let mut first = f64::INFINITY;
    for contact in contacts {
        let edge = world.edge(contact);
        let is_edge = edge.is_some();
        let stays = edge.map_or(corners_stay, |edge| edges_stay || edge.stays_clear(moved));
        if stays {
            continue;
        }
        // An event ends the step: what would close after those that close with the first is found from there.
        let last = first + world.pairs[pair].simultaneity;
        let from = crossing_not_before(world, contact, t);
        if from > last || from == f64::INFINITY {
            continue;
        }
        let Some(armed) = open(world, contact, t) else { continue };
        let found = if is_edge {
            edge_in_step::search(world, contact, samples, armed, [from, last])
        } else {
            in_step(world, contact, samples, armed)
        };
        world.contacts[contact].found = found;
        first = first.min(found.closing.unwrap_or(f64::INFINITY));
    }
    first
}

/// Bound on the displacement, from where they were placed, of points of the edges of a pair's bodies relative to each other
/// until the last sample time \[m\], and on that of unit vectors \[–\].
fn edges_moved(world: &World, pair: usize, samples: &StepSamples) -> [f64; 2] {
    let PairTrack { slots, contacts, .. } = &world.pairs[pair];
    let lever = |c: usize| world.contacts[c].geometry.arm.max(world.contacts[c].geometry.lever);
    let arm = contacts.clone().filter(|&c| world.edge(c).is_some()).map(lever).fold(0.0, f64::max);
    let bodies = || slots.iter().flatten().copied();
    let moved: f64 = bodies().map(|slot| samples.side(Some(slot), 0).moved(arm)).sum();
    let turned: f64 = bodies().map(|slot| samples.side(Some(slot), 0).chord()).sum();
    let [t, until] = [samples.times[0], samples.times[STEP_SAMPLES - 1]];
    let on: f64 = bodies().map(|slot| excursion(world, slot, arm + moved, t, until)).sum();
    // The excursion at a lever is at least the rotation times the lever.
    [moved + on, turned + on / arm]
}

/// Whether no crossing of a pair of bodies that have met can belong to its two faces until the last sample time: they do not look at
/// each other.
fn faces_look_elsewhere(world: &World, pair: usize, samples: &StepSamples) -> bool {
    let contacts = world.pairs[pair].contacts.clone();
    let Some((last, edge)) = contacts.last().and_then(|last| Some((last, world.edge(last)?))) else {
        return false;
    };
    edge.looks_elsewhere(samples.sides(world, last, 0), samples.turned(world))
}

/// Whether the distance of every open corner before its plane, or behind it where the contact is disarmed, exceeds the
/// bound on the excursion of both bodies, by one sample.
fn cannot_close(world: &World, pair: usize, samples: &mut StepSamples) -> bool {
    let slots = world.pairs[pair].slots;
    let (mut least_gap, mut longest_arm) = (f64::INFINITY, [0.0f64; 2]);
    for contact in world.pairs[pair].contacts.clone() {
        let track = &world.contacts[contact];
        let Contact::Open { armed } = track.state else { continue };
        if world.edge(contact).is_some() {
            continue;
        }
        let here = samples.corner(world, contact, 0);
        // A disarmed node that stays behind the plane is not armed again.
        least_gap = least_gap.min(if armed { here.gap } else { -here.gap });
        for (slot, arm) in track.slots.into_iter().zip(world.model.sites[track.site].levers(&here)) {
            let side = usize::from(slot == slots[1]);
            longest_arm[side] = longest_arm[side].max(arm);
        }
    }
    let [t, until] = [samples.times[0], samples.times[STEP_SAMPLES - 1]];
    let excursions = |side: usize| slots[side].map_or(0.0, |slot| excursion(world, slot, longest_arm[side], t, until));
    least_gap > excursions(0) + excursions(1)
}

/// Time before which the crossing of an open edge node does not reach the plane of the face, by the searches of both ends of the edge:
/// where it does, one of them is behind that plane \[s\]. `t` where they do not tell; infinite where neither gets there.
fn crossing_not_before(world: &World, contact: usize, t: f64) -> f64 {
    let before = |contact: usize| world.contacts[contact].state == Contact::Open { armed: true };
    let track = &world.contacts[contact];
    let Some(ends) = track.corners.filter(|ends| before(contact) && ends.iter().all(|&corner| before(corner))) else {
        return t;
    };
    ends.into_iter().filter_map(|corner| world.contacts[corner].found.closing).fold(f64::INFINITY, f64::min)
}

/// Whether an open contact is armed; `None` for a closed one. A disarmed contact whose gap is positive is armed
/// again.
fn open(world: &mut World, contact: usize, t: f64) -> Option<bool> {
    let Contact::Open { armed } = world.contacts[contact].state else { return None };
    if armed {
        return Some(true);
    }
    let [gap, rate] = if let Some(edge) = world.edge(contact) {
        let ends = edge.ends(&world.side(contact, 0, t), &world.side(contact, 1, t));
        edge.gap(&ends, ends.sense())
    } else {
        let here = world.local(contact, t);
        [here.gap, here.gap_rate]
    };
    let out = is_positive_again(gap, rate, t, resolution(world, contact, t));
    if out {
        world.contacts[contact].state = Contact::Open { armed: true };
    }
    Some(out)
}

/// Closing of a contact, and time from which it is armed if it was not \[s\], where a body is in a planned step: from
/// the first sample alone where the bounds on excursion or curvature exclude a closing, otherwise by subdivision with
/// the curvature bound.
fn in_step(world: &World, contact: usize, samples: &mut StepSamples, armed: bool) -> GapClosing {
    let (t, until) = (samples.times[0], samples.times[STEP_SAMPLES - 1]);
    if until <= t {
        return GapClosing::NONE;
    }
    let before = samples.corner(world, contact, 0);
    let track = &world.contacts[contact];
    let arms = world.model.sites[track.site].levers(&before);
    let excursions =
        track.slots.into_iter().zip(arms).map(|(slot, arm)| slot.map_or(0.0, |s| excursion(world, s, arm, t, until)));
    if armed && before.gap > excursions.sum::<f64>() {
        return GapClosing::NONE;
    }
    let resolution = samples.resolution(world, contact);
    if armed
        && before.gap <= resolution
        && before.gap_rate < -rate_error(world, contact, samples.sides(world, contact, 0))
    {
        return GapClosing::at(t);
    }
    let node = usize::from(track.slots[0] == samples.slots[1]);
    let slots = samples.slots;
    let bounds = *samples.bounds(world);
    let span = until - t;
    // Over the whole step the distance of the node from the face's G is at most its distance at the start plus its
    // excursion.
    let curvature_bound = bounds.curvature(node, arms, span);
    if armed
        && bounds.holds(span)
        && before.gap > resolution + span * ((-before.gap_rate).max(0.0) + 0.5 * curvature_bound * span)
    {
        return GapClosing::NONE;
    }
    let curvature = |from: &GapSample, to: f64| {
        if bounds.holds(span) {
            return curvature_bound;
        }
        let part = GapCurvature::of(world, slots, from.t, to);
        let arms = world.model.sites[track.site].levers(&world.local(contact, from.t));
        if part.holds(to - from.t) { part.curvature(node, arms, to - from.t) } else { f64::INFINITY }
    };
    let site = &world.model.sites[track.site];
    let gap_at = |at: f64| {
        let [gap, rate] = gap(&site.geometry, &world.side(contact, 0, at), &world.side(contact, 1, at));
        GapSample { t: at, gap, rate }
    };
    let rate_error = |at: f64| rate_error(world, contact, [&world.side(contact, 0, at), &world.side(contact, 1, at)]);
    samples.fill(world);
    let gaps: [GapSample; STEP_SAMPLES] = std::array::from_fn(|i| samples.gap(world, contact, i));
    let interval = CLOSING_INTERVAL * world.pairs[track.pair].simultaneity;
    Subdivision::new((gap_at, curvature, rate_error), armed, resolution, interval).search(&gaps)
}
