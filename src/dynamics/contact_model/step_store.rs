//! Storage of integration steps: as polynomials, or by their initial states, from which a step is recomputed when read.
//!
//! A polynomial is read in nanoseconds and takes up to 400 bytes a body; an initial state takes a seventh of the
//! memory and microseconds to read. A run stores polynomials up to the memory limit of the model and initial states
//! from then on.

use crate::contact::FrictionLaw;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::record::recomputed_steps::{LoggedState, Member, Replay};
use crate::dynamics::trajectory::packed_states::PackedStates;
use crate::dynamics::world::World;

/// Steps of a run that are stored by their initial states, and the memory of the polynomials of the others.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct StepStore {
    /// Steps stored by their initial states.
    pub replay: Replay,
    /// Memory of polynomials \[bytes\].
    pub polynomials: usize,
}

impl StepStore {
    /// Whether the polynomials have reached the group's share of the memory limit.
    pub(in crate::dynamics) fn keeps_starts(&self, world: &World) -> bool {
        self.polynomials >= world.model.polynomials / world.model.groups.len().max(1)
    }

    /// Stores an island's planned step by its initial state; its number. `None` where polynomials are still stored,
    /// or where a recomputed step would not be equal to the last bit.
    pub(in crate::dynamics) fn keep_start(&mut self, world: &World, island: &mut Island) -> Option<u32> {
        if !self.keeps_starts(world)
            || island.system.bodies.iter().any(|&body| !PackedStates::fits(world.model.bodies[body].width()))
        {
            return None;
        }
        let (length, states) = island.again(&world.model)?;
        let (stretch, flown) = if let Some(stretch) = island.stretch {
            (stretch, false)
        } else {
            let (logged_states, members) = (logged_states(world, island)?, self.members(world, island)?);
            let flown = landed_at(world, island, &states);
            (self.replay.open(members, logged_states)?, flown)
        };
        island.stretch = Some(stretch);
        self.replay.push(stretch, length, (!flown).then(|| island.system.layout.states(&states)))
    }

    /// An island's bodies with their reference poses, each either the end of a flight or stored.
    fn members(&mut self, world: &World, island: &mut Island) -> Option<Vec<Member>> {
        let mut members = Vec::with_capacity(island.slots.len());
        for (&slot, base) in island.slots.iter().zip(&mut island.system.bases) {
            if base.flown.is_none() && base.kept.is_none() {
                base.kept = Some(self.replay.keep(base)?);
            }
            let body = u32::try_from(world.bodies[slot].body).ok()?;
            let member = base.flown.map(|number| Member::flown(body, number));
            members.push(member.or_else(|| base.kept.map(|number| Member::kept(body, number)))?);
        }
        Some(members)
    }

    /// Number of the flight that ended at `t` in this reference pose and this state relative to it, to the last bit;
    /// `None` without one.
    pub(in crate::dynamics) fn landing(
        world: &World,
        slot: usize,
        base: &ReferencePose,
        state: &[f64],
        t: f64,
    ) -> Option<u32> {
        let track = &world.bodies[slot];
        let ((number, from, start), system) = (track.path.flown_until(t)?, track.system.as_ref()?);
        let mut there = system.girder_state(from, start, t)?;
        let other = world.model.bodies[track.body].rebase(&mut there);
        let place = |base: &ReferencePose| base.planar().to_array().map(f64::to_bits);
        let bits = |state: &[f64]| state.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        (place(&other) == place(base) && bits(&there) == bits(state)).then_some(number)
    }
}

/// States of an island's contacts by their entries in the logs; `None` where an entry does not determine the state.
fn logged_states(world: &World, island: &Island) -> Option<Vec<LoggedState>> {
    let logged = |(active, &contact): (&crate::dynamics::penalty3d::active_contact::ActiveContact, &usize)| {
        let track = &world.contacts[contact];
        let entry = track.log.latest()?;
        let mut logged = active.closed;
        (logged.solver.retries, logged.solver.at_face) = (0, logged.law.friction == FrictionLaw::Paper);
        let same = track.log.closed(entry) == Some(logged);
        same.then_some(LoggedState { site: u32::try_from(track.site).ok()?, entry })
    };
    island.system.active.iter().zip(&island.contacts).map(logged).collect()
}

/// Whether the initial states of an island's planned step are the ends of flights, for all of its bodies.
fn landed_at(world: &World, island: &Island, states: &[f64]) -> bool {
    island.slots.iter().zip(&island.system.bases).zip(island.system.layout.states(states)).all(
        |((&slot, base), state)| {
            base.flown.is_some() && base.flown == StepStore::landing(world, slot, base, state, island.from)
        },
    )
}
