//! How soon something will change, by the slopes at the start of a step: two nodes of one edge touch microseconds after
//! one another, and a step that reaches far beyond would be taken, or tried and refused, for nothing.

use crate::contact::{Frame, Local, locate};
use crate::dynamics::Model;
use crate::dynamics::penalty3d::constants::{CONFIRMED_RISE, FORECAST_PHASE, SLOPE_PHASE};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::due::Reason;
use crate::dynamics::penalty3d::event_location::{function, reasons};
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::world::World;

/// What may change: an active contact's state, or an open contact.
#[derive(Clone, Copy, Debug)]
enum Change {
    State(usize, Reason),
    Closing(usize),
}

/// Time from the start of an island's next step to the first change of a contact that its slopes point to, if that comes
/// within `horizon`; infinite where they point to none \[s\]. A guess: whatever the step meets is found as ever.
pub(in crate::dynamics) fn soonest(world: &World, island: &Island, horizon: f64) -> f64 {
    let (dt, horizon) = (SLOPE_PHASE / island.omega(), horizon.min(FORECAST_PHASE / island.omega()));
    if horizon <= dt {
        return f64::INFINITY;
    }
    let [now, then] = [0.0, dt].map(|ahead| frames_after(island, &world.model, ahead));
    let mut likely: Vec<(f64, f64, Change)> = Vec::new();
    for change in changes(world, island) {
        let Some(here) = look(world, island, change, &now) else { continue };
        let start = value(world, island, change, &here);
        // What is told by the look alone needs no second one.
        let rise = match change {
            Change::Closing(_) => -here.gap_rate,
            Change::State(_, Reason::Opening) => here.gap_rate,
            Change::State(_, Reason::Edge) if start + horizon * (here.rate.length() + here.gap_rate.abs()) < 0.0 => 0.0,
            Change::State(..) => look(world, island, change, &then)
                .map_or(0.0, |there| (value(world, island, change, &there) - start) / dt),
        };
        if start < 0.0 && rise > 0.0 && -start / rise < horizon {
            likely.push((-start / rise, start, change));
        }
    }
    likely.sort_by(|a, b| a.0.total_cmp(&b.0));
    let comes = |&(after, start, change): &(f64, f64, Change)| {
        let there = look(world, island, change, &frames_after(island, &world.model, after))?;
        let there = value(world, island, change, &there);
        (there > CONFIRMED_RISE * start).then(|| if there < 0.0 { after * start / (start - there) } else { after })
    };
    likely.iter().find_map(comes).unwrap_or(f64::INFINITY)
}

/// All that may change.
fn changes(world: &World, island: &Island) -> Vec<Change> {
    let states = (0..island.active.len())
        .flat_map(|number| reasons(island, number).map(move |reason| Change::State(number, reason)));
    let open = |contact: &usize| world.contacts[*contact].state == Contact::Open { armed: true };
    let pairs = world.pairs_of(&island.slots).into_iter();
    let closings = pairs.flat_map(|pair| world.pairs[pair].contacts.clone()).filter(open).map(Change::Closing);
    states.chain(closings).collect()
}

/// The node against its face; nothing for a contact with somebody who is not in the island.
fn look(world: &World, island: &Island, change: Change, frames: &[Frame]) -> Option<Local> {
    let contact = match change {
        Change::State(number, _) => return Some(island.active[number].look(&world.model, frames)),
        Change::Closing(contact) => &world.contacts[contact],
    };
    let site = &world.model.contacts[contact.site];
    let frame = |slot: Option<usize>| match slot {
        Some(slot) => island.slots.binary_search(&slot).ok().and_then(|i| Some(island.bases[i].whole(frames.get(i)?))),
        None => Some(site.stand),
    };
    Some(locate(&site.home, &frame(contact.slots[0])?, &frame(contact.slots[1])?))
}

/// What is negative while nothing has changed.
fn value(world: &World, island: &Island, change: Change, here: &Local) -> f64 {
    match change {
        Change::State(number, reason) => function(&world.model, island, number, reason, here, island.until),
        Change::Closing(_) => -here.gap,
    }
}

/// Poses of its bodies, counted from their bases, a moment after the start of the next step, by its slope alone.
pub(in crate::dynamics) fn frames_after(island: &Island, model: &Model, dt: f64) -> Vec<Frame> {
    let slope = island.stepper.slope();
    let mut moved: Vec<f64> = island.y.iter().zip(slope).map(|(y, rate)| y + dt * rate).collect();
    let frame = |(i, &body): (usize, &usize)| {
        let (part, body) = (island.layout.range(i), &model.bodies[body]);
        body.add_accelerations(&mut moved[part.clone()], &slope[part.clone()], dt);
        body.frame_since(&moved[part])
    };
    island.bodies.iter().enumerate().map(frame).collect()
}
