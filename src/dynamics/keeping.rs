//! Which of a run's steps are kept as polynomials, and which by their starts alone.
//!
//! A polynomial is read in nanoseconds and takes up to 400 bytes a body; a start takes a seventh of it and microseconds.
//! So a run keeps polynomials until they take what the model allows, and starts from then on.

use super::engine::Engine;
use super::flight::Planar;
use super::island::Island;
use super::replay::{Member, Seat};
use super::track::Closed;
use crate::contact::law::Friction;

impl Engine {
    /// Keeps an island's planned step by its start, where that gives the same step; its number.
    pub(super) fn keep_again(&mut self, island: &mut Island) -> Option<u32> {
        if self.polynomials < self.model.polynomials / self.model.groups.len().max(1) {
            return None;
        }
        let (length, states) = island.again()?;
        let (stretch, flown) = if let Some(stretch) = island.stretch {
            (stretch, false)
        } else {
            let (seats, members) = (self.seats(island)?, self.members(island)?);
            (self.replay.open(members, seats)?, self.landed_at(island, &states))
        };
        island.stretch = Some(stretch);
        self.replay.push(stretch, length, (!flown).then_some(states.as_slice()))
    }

    /// An island's contacts by what their logs say; nothing where these do not say all.
    fn seats(&self, island: &Island) -> Option<Vec<Seat>> {
        let seat = |(active, &contact): (&super::field::Active, &usize)| {
            let track = &self.contacts[contact];
            let entry = track.log.latest()?;
            let same = track.log.closed(entry)
                == Some(Closed { again: 0, at_face: active.closed.law.friction == Friction::Paper, ..active.closed });
            same.then_some(Seat { site: u32::try_from(track.site).ok()?, entry })
        };
        island.active.iter().zip(&island.contacts).map(seat).collect()
    }

    fn members(&self, island: &Island) -> Option<Vec<Member>> {
        let member = |&slot: &usize| {
            let track = &self.bodies[slot];
            let flown = track.path.len().saturating_sub(1);
            Some(Member { body: u32::try_from(track.body).ok()?, flown: u32::try_from(flown).ok()? })
        };
        island.slots.iter().map(member).collect()
    }

    /// Whether all of an island's bodies flew to where its planned step begins, to the last bit.
    fn landed_at(&self, island: &Island, states: &[Planar]) -> bool {
        island.slots.iter().zip(states).all(|(&slot, state)| {
            let track = &self.bodies[slot];
            let (Some((_, from, start)), Some(system)) = (track.path.flown_until(island.from), &track.system) else {
                return false;
            };
            system.state(&system.fly(from, start), island.from).map(f64::to_bits) == state.map(f64::to_bits)
        })
    }
}
