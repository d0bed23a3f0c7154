//! Which of a run's steps are kept as polynomials, and which by their starts alone.
//!
//! A polynomial is read in nanoseconds and takes up to 400 bytes a body; a start takes a seventh of it and microseconds.
//! So a run keeps polynomials until they take what the model allows, and starts from then on.

use crate::contact::law::Friction;
use crate::dynamics::event_loop::contact_engine::Engine;
use crate::dynamics::model::reference_pose::Base;
use crate::dynamics::model::rigid_body;
use crate::dynamics::penalty3d::contact_state::Closed;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::record::recomputed_steps::{Member, Seat};

impl Engine {
    /// Whether polynomials take as much as they may.
    pub(in crate::dynamics) fn keeps_starts(&self) -> bool {
        self.polynomials >= self.model.polynomials / self.model.groups.len().max(1)
    }

    /// Keeps an island's planned step by its start, where that gives the same step; its number.
    pub(in crate::dynamics) fn keep_again(&mut self, island: &mut Island) -> Option<u32> {
        if !self.keeps_starts() {
            return None;
        }
        let (length, states) = island.again(&self.model)?;
        let (stretch, flown) = if let Some(stretch) = island.stretch {
            (stretch, false)
        } else {
            let (seats, members) = (self.seats(island)?, self.members(island)?);
            let flown = self.landed_at(island, &states);
            (self.replay.open(members, seats)?, flown)
        };
        island.stretch = Some(stretch);
        let width = rigid_body::width(self.model.kind);
        self.replay.push(stretch, length, (!flown).then(|| states.chunks_exact(width)))
    }

    /// An island's contacts by what their logs say; nothing where these do not say all.
    fn seats(&self, island: &Island) -> Option<Vec<Seat>> {
        let seat = |(active, &contact): (&crate::dynamics::penalty3d::equations_of_motion::Active, &usize)| {
            let track = &self.contacts[contact];
            let entry = track.log.latest()?;
            let same = track.log.closed(entry)
                == Some(Closed { again: 0, at_face: active.closed.law.friction == Friction::Paper, ..active.closed });
            same.then_some(Seat { site: u32::try_from(track.site).ok()?, entry })
        };
        island.active.iter().zip(&island.contacts).map(seat).collect()
    }

    /// An island's bodies with what their states are counted from, which is kept where no flight ended there.
    fn members(&mut self, island: &mut Island) -> Option<Vec<Member>> {
        let mut members = Vec::with_capacity(island.slots.len());
        for (&slot, base) in island.slots.iter().zip(&mut island.bases) {
            if base.flown.is_none() && base.kept.is_none() {
                base.kept = Some(self.replay.keep(base)?);
            }
            let body = u32::try_from(self.bodies[slot].body).ok()?;
            let member = base.flown.map(|number| Member::flown(body, number));
            members.push(member.or_else(|| base.kept.map(|number| Member::kept(body, number)))?);
        }
        Some(members)
    }

    /// Whether all of an island's bodies flew to where its planned step begins.
    fn landed_at(&self, island: &Island, states: &[f64]) -> bool {
        let states = states.chunks_exact(rigid_body::width(self.model.kind));
        island.slots.iter().zip(&island.bases).zip(states).all(|((&slot, base), state)| {
            base.flown.is_some() && base.flown == self.landing(slot, base, state, island.from)
        })
    }

    /// Number of the flight that ended at `t` in a base and a state counted from it, to the last bit.
    pub(in crate::dynamics) fn landing(&self, slot: usize, base: &Base, state: &[f64], t: f64) -> Option<u32> {
        let track = &self.bodies[slot];
        let ((number, from, start), system) = (track.path.flown_until(t)?, track.system.as_ref()?);
        let mut there = system.state(&system.fly(from, start), t);
        let other = Base::of(self.model.kind, &self.model.bodies[track.body], &mut there);
        let bits = |state: &[f64]| state.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        (bits(&other.state()) == bits(&base.state()) && bits(&there) == bits(state)).then_some(number)
    }
}
