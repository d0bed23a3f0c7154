//! Forecast of the next event of an island by linear extrapolation of switching functions and gaps from the start of
//! a step.
//!
//! Two nodes of one edge close microseconds after one another; the forecast ends an implicit step near the next
//! event, so that the part of it behind the event is not computed and discarded. It chooses the length of a step and
//! no event.

use crate::contact::{Frame, Local, locate};
use crate::dynamics::penalty3d::constants::{CONFIRMED_RISE, FORECAST_PHASE, SLOPE_PHASE};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::due::Reason;
use crate::dynamics::penalty3d::event_location::{reasons, switching_function};
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::world::World;

/// A candidate for the next event.
#[derive(Clone, Copy, Debug)]
enum Change {
    /// End of the state of the closed contact of this number in the island.
    State(usize, Reason),
    /// Closing of the open contact of this number in the group.
    Closing(usize),
}

/// Time from the start of an island's next step to its first event within `horizon` by linear extrapolation, infinite
/// without one \[s\]. The event is confirmed by a second evaluation at the forecast time; its location in the step is
/// independent of this estimate.
pub(in crate::dynamics) fn earliest_change(world: &World, island: &Island, horizon: f64) -> f64 {
    let (dt, horizon) = (SLOPE_PHASE / island.omega(), horizon.min(FORECAST_PHASE / island.omega()));
    if horizon <= dt {
        return f64::INFINITY;
    }
    let [now, then] = [0.0, dt].map(|ahead| island.frames_after(&world.model, ahead));
    let mut likely: Vec<(f64, f64, Change)> = Vec::new();
    for change in changes(world, island) {
        let Some(here) = local(world, island, change, &now) else { continue };
        let start = change_function(world, island, change, &here);
        // Rates of gaps are known at the start; switching functions are differenced.
        let rise = match change {
            Change::Closing(_) => -here.gap_rate,
            Change::State(_, Reason::Opening) => here.gap_rate,
            Change::State(_, Reason::Edge) if start + horizon * (here.rate.length() + here.gap_rate.abs()) < 0.0 => 0.0,
            Change::State(..) => local(world, island, change, &then)
                .map_or(0.0, |there| (change_function(world, island, change, &there) - start) / dt),
        };
        if start < 0.0 && rise > 0.0 && -start / rise < horizon {
            likely.push((-start / rise, start, change));
        }
    }
    likely.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Confirmed by its value at the forecast time; the time is that of the secant's zero where the value is still
    // negative.
    let confirmed = |&(after, start, change): &(f64, f64, Change)| {
        let there = local(world, island, change, &island.frames_after(&world.model, after))?;
        let there = change_function(world, island, change, &there);
        (there > CONFIRMED_RISE * start).then(|| if there < 0.0 { after * start / (start - there) } else { after })
    };
    likely.iter().find_map(confirmed).unwrap_or(f64::INFINITY)
}

/// Switching functions of the island's closed contacts, and the armed open contacts of its bodies.
fn changes(world: &World, island: &Island) -> Vec<Change> {
    let states = (0..island.system.active.len())
        .flat_map(|number| reasons(island, number).map(move |reason| Change::State(number, reason)));
    let is_corner = |contact: usize| world.edge(contact).is_none();
    let open = |contact: &usize| world.contacts[*contact].state == Contact::Open { armed: true } && is_corner(*contact);
    let pairs = world.pairs_of(&island.slots).into_iter();
    let closings = pairs.flat_map(|pair| world.pairs[pair].contacts.clone()).filter(open).map(Change::Closing);
    states.chain(closings).collect()
}

/// Position and velocity of a node relative to its face; `None` for a contact with a body outside the island.
fn local(world: &World, island: &Island, change: Change, frames: &[Frame]) -> Option<Local> {
    let contact = match change {
        Change::State(number, _) => return Some(island.system.active[number].look(&world.model, frames)),
        Change::Closing(contact) => &world.contacts[contact],
    };
    let site = &world.model.sites[contact.site];
    let frame = |which: usize| match contact.slots[which] {
        Some(slot) => {
            let index = island.slots.binary_search(&slot).ok()?;
            let section = island.system.layout.sections(index).start + contact.sections[which];
            Some(island.system.bases[index].whole(frames.get(section)?))
        }
        None => Some(site.stand),
    };
    Some(locate(&site.geometry, &frame(0)?, &frame(1)?))
}

/// Value of the switching function, negative before the event; of an open contact `−g`.
fn change_function(world: &World, island: &Island, change: Change, here: &Local) -> f64 {
    match change {
        Change::State(number, reason) => {
            switching_function(&world.model, island, number, reason, here, island.step.until)
        }
        Change::Closing(_) => -here.gap,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::contact_model::islands::assemble;
    use crate::dynamics::integrator::step_control::ControllerState;
    use crate::dynamics::model::body::Body;
    use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, row, wall};
    use crate::dynamics::world::example::planned;
    use crate::scene::Scene;

    /// Forecast within `horizon` for bodies at displacements and velocities along x, in an island of those in
    /// `slots`, with the contacts of the numbers in `open` open and armed and the others in stick.
    fn forecast(scene: &Scene, states: &[[f64; 2]], slots: &[usize], open: &[usize], horizon: f64) -> f64 {
        let states: Vec<_> = states.iter().map(|&[x, u]| [x, 0.0, 0.0, u, 0.0, 0.0]).collect();
        let mut world = planned(scene, &states);
        for &contact in open {
            world.contacts[contact].state = Contact::Open { armed: true };
        }
        let bases = slots.iter().map(|&slot| Body::placed(&world.model.bodies[slot])).collect();
        let y = slots.iter().flat_map(|&slot| states[slot]).collect();
        let island = assemble(&world, slots, bases, y, 0.0, ControllerState::default());
        earliest_change(&world, &island, horizon)
    }

    fn omega() -> f64 {
        (STIFFNESS / MASS).sqrt()
    }

    #[test]
    fn an_opening_is_forecast_from_gap_and_rate() {
        // x = (v/ω) sin φ before the end of the half sine by φ, moving out: it opens at φ/ω.
        let phase: f64 = 0.05;
        let state = [SPEED / omega() * phase.sin(), -SPEED * phase.cos()];
        let after = forecast(&wall(), &[state], &[0], &[], 0.1 / omega());
        assert!((omega() * after / phase - 1.0).abs() < 2e-3, "{} rad is not {phase}", omega() * after);
    }

    #[test]
    fn an_opening_that_a_push_delays_is_corrected_by_the_secant() {
        // Against the push P the girder comes out slower than it starts: x = p + (x₀ − p) cos φ + (v₀/ω) sin φ, p = P/K.
        let (depth, rest): (f64, f64) = (1e-5, 1e-2);
        // 10 % above the speed that just reaches the face.
        let rate = -1.1 * (2.0 * rest * depth).sqrt() * omega();
        let mut scene = wall();
        scene.girders[0].push.force[0] = STIFFNESS * rest;
        let place = |phase: f64| rest + (depth - rest) * phase.cos() + rate / omega() * phase.sin();
        let linear = -depth * omega() / rate;
        assert!(place(linear) > 0.1 * depth, "still in at the linear forecast");
        let exact = crate::dynamics::locate::root::root(|phase| -place(phase), 0.0, 3.0 * linear);
        let after = omega() * forecast(&scene, &[[depth, rate]], &[0], &[], 0.3 / omega());
        assert!(
            (after / exact - 1.0).abs() < 0.5 * (linear / exact - 1.0).abs(),
            "{after} rad, not {exact}; linear {linear}"
        );
    }

    #[test]
    fn nothing_is_forecast_beyond_the_horizon_or_on_the_way_in() {
        let phase: f64 = 0.05;
        let (depth, rate) = (SPEED / omega() * phase.sin(), SPEED * phase.cos());
        let at = |rate: f64, horizon: f64| forecast(&wall(), &[[depth, rate]], &[0], &[], horizon / omega());
        assert_eq!(at(-rate, 0.04), f64::INFINITY, "later than that");
        assert_eq!(at(-rate, 1e-5), f64::INFINITY, "too short a horizon to difference over");
        assert_eq!(at(rate, 0.1), f64::INFINITY, "it goes in");
    }

    #[test]
    fn a_closing_is_forecast_from_gap_and_rate() {
        let gap = 1e-4;
        let after = forecast(&wall(), &[[-gap, SPEED]], &[0], &[0, 1], 1.0);
        assert!((after * SPEED / gap - 1.0).abs() < 1e-9, "{after} s is not {}", gap / SPEED);
    }

    #[test]
    fn a_contact_with_a_body_outside_of_the_island_is_left_out() {
        let gap = 1e-4;
        let states = [[-gap, SPEED], [0.0, 0.0]];
        let [both, one] = [&[0, 1][..], &[0]].map(|slots| forecast(&row(), &states, slots, &[0, 1, 2, 3], 1.0));
        assert!((both * SPEED / gap - 1.0).abs() < 1e-9, "{both} s is not {}", gap / SPEED);
        assert_eq!(one, f64::INFINITY, "the closing search finds it");
    }
}
