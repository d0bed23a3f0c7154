//! Storage of integration steps: as polynomials, or by their initial states, from which a step is recomputed when read.
//!
//! A polynomial is read in nanoseconds and takes 64 bytes a component, 400 bytes a planar girder; an initial state takes a seventh of
//! that and microseconds to read. A group stores polynomials up to its share of `Model::polynomials`, then initial states of all steps
//! that are recomputed to the last bit and have at most 16 components a body.

use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::record::recomputed_steps::{LoggedState, RecomputedSteps, StepBody};
use crate::dynamics::trajectory::packed_states::PackedStates;
use crate::dynamics::trajectory::segment::{Segment, SegmentMotion};
use crate::dynamics::trajectory::stored_path::{StoredFlight, Swept};
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{Trajectory, flown};

/// Steps of a run that are stored by their initial states, and the memory of the polynomials of the others.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct StepStore {
    /// Steps stored by their initial states.
    pub recomputed: RecomputedSteps,
    /// Memory of polynomials \[bytes\].
    pub polynomial_bytes: usize,
}

impl StepStore {
    /// Whether the polynomials have reached the group's share of the memory limit.
    pub(in crate::dynamics) fn keeps_starts(&self, world: &World) -> bool {
        self.polynomial_bytes >= world.model.polynomial_bytes / world.model.groups.len().max(1)
    }

    /// Stores an island's planned step by its initial state; its number. `None` where polynomials are still stored,
    /// or where a recomputed step would not be equal to the last bit.
    fn keep_start(&mut self, world: &World, island: &mut Island) -> Option<u32> {
        if !self.keeps_starts(world)
            || island.system.bodies.iter().any(|&body| !PackedStates::fits(world.model.bodies[body].width()))
        {
            return None;
        }
        let (length, states) = island.repeated(&world.model)?;
        let (sequence, flown) = if let Some(sequence) = island.sequence {
            (sequence, false)
        } else {
            let (logged_states, members) = (logged_states(world, island)?, self.members(world, island)?);
            let flown = landed_at(world, island, &states);
            (self.recomputed.open(members, logged_states)?, flown)
        };
        island.sequence = Some(sequence);
        self.recomputed.push(sequence, length, (!flown).then(|| island.system.layout.states(&states)))
    }

    /// Writes all trajectories up to `t` into the paths of their bodies.
    pub(in crate::dynamics) fn commit_all(&mut self, world: &mut World, t: f64) {
        for track in &mut world.bodies {
            if let Trajectory::Flight(flight) = &track.now {
                for segment in flown(flight, t) {
                    if track.path.is_empty() { track.path.push_only(segment) } else { track.path.push(segment) }
                }
            }
        }
        for number in 0..world.islands.len() {
            if let Some(mut island) = world.islands[number].take() {
                self.commit(world, &mut island, t);
            }
        }
    }

    /// Writes an island's planned step up to `until` \[s\] into the paths of its bodies, and its slip angles into the
    /// logs of their contacts.
    pub(in crate::dynamics) fn commit(&mut self, world: &mut World, island: &mut Island, until: f64) {
        let from = island.step.from;
        if until <= from {
            return;
        }
        if let Some(number) = self.keep_start(world, island) {
            for (index, &slot) in island.slots.iter().enumerate() {
                let body = &world.model.bodies[world.bodies[slot].body];
                if let Some(piece) = body.has_heading().then(|| island.path(index)).flatten() {
                    world.bodies[slot].path.follow(body, &piece, [from, until]);
                }
                let stands = island.frame(&world.model, index, 0, from);
                let reach = stands.shift.length() + island.excursion(&world.model, index, 0.0, from);
                world.bodies[slot].path.sweep(Swept { reach, chord: stands.chord() });
                world.bodies[slot].path.push(Segment { from, until, path: SegmentMotion::Recomputed(number) });
            }
            return;
        }
        for (index, &slot) in island.slots.iter().enumerate() {
            if let Some(piece) = island.path(index) {
                self.polynomial_bytes += piece.bytes();
                let body = &world.model.bodies[world.bodies[slot].body];
                if body.has_heading() {
                    world.bodies[slot].path.follow(body, &piece, [from, until]);
                }
                world.bodies[slot].path.push(Segment { from, until, path: SegmentMotion::Step(piece) });
            }
        }
        for (number, &contact) in island.contacts.iter().enumerate() {
            if let Some(angle) = island.angle_path(number) {
                world.contacts[contact].log.angles.push((from, angle));
            }
        }
        for (index, link) in island.system.links.iter().enumerate() {
            if let Some(memory) = island.memory_path(index) {
                self.polynomial_bytes += size_of::<(f64, DenseOutput)>() + size_of_val(memory.coefficients());
                world.links[link.track].log.memories.push((from, memory));
            }
        }
    }

    /// An island's bodies with their reference poses, each either the end of a flight or stored.
    fn members(&mut self, world: &World, island: &mut Island) -> Option<Vec<StepBody>> {
        let mut members = Vec::with_capacity(island.slots.len());
        for (&slot, base) in island.slots.iter().zip(&mut island.system.bases) {
            if base.flown.is_none() && base.stored_number.is_none() {
                base.stored_number = Some(self.recomputed.keep(base)?);
            }
            let body = u32::try_from(world.bodies[slot].body).ok()?;
            let member = base.flown.map(|number| StepBody::flown(body, number));
            members.push(member.or_else(|| base.stored_number.map(|number| StepBody::kept(body, number)))?);
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
        let StoredFlight { number, from, start } = track.path.flown_until(t)?;
        let free_motion = track.free_motion.as_ref()?;
        let mut there = free_motion.girder_state(from, start, t)?;
        let other = world.model.bodies[track.body].rebase(&mut there);
        let place = |base: &ReferencePose| base.planar().to_array().map(f64::to_bits);
        let bits = |state: &[f64]| state.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        (place(&other) == place(base) && bits(&there) == bits(state)).then_some(number)
    }
}

/// States of an island's contacts by their entries in the logs; `None` where an entry does not determine the state.
fn logged_states(world: &World, island: &Island) -> Option<Vec<LoggedState>> {
    let logged = |(active, &contact): (&ActiveContact, &usize)| {
        let track = &world.contacts[contact];
        let entry = track.log.latest()?;
        let mut logged = active.closed;
        // What these decide are events, not the forces of a step.
        (logged.solver.retries, logged.solver.handover_distance, logged.solver.beside) = (0, None, 0.0);
        let same = track.log.closed(entry) == Some(logged);
        same.then_some(LoggedState { site: u32::try_from(track.site).ok()?, entry })
    };
    island.system.active.iter().zip(&island.contacts).map(logged).collect()
}

/// Whether the initial states of an island's planned step are the ends of flights, for all of its bodies.
fn landed_at(world: &World, island: &Island, states: &[f64]) -> bool {
    island.slots.iter().zip(&island.system.bases).zip(island.system.layout.states(states)).all(
        |((&slot, base), state)| {
            base.flown.is_some() && base.flown == StepStore::landing(world, slot, base, state, island.step.from)
        },
    )
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec2;

    use super::*;
    use crate::dynamics::penalty3d::example::{SPEED, wall};
    use crate::dynamics::trajectory::stored_path::StoredMotion;
    use crate::dynamics::world::example::planned;

    #[test]
    fn a_step_is_written_as_far_as_it_is_asked_for() {
        let mut world = planned(&wall(), &[[0.0, 0.0, 0.0, SPEED, 0.0, 0.0]]);
        let (mut store, mut island) = (StepStore::default(), world.islands[0].take().expect("the island"));
        let from = island.step.from;
        store.commit(&mut world, &mut island, from);
        assert!(world.bodies[0].path.is_empty(), "nothing of no length");
        let until = 0.5 * (island.step.from + island.step.until);
        store.commit(&mut world, &mut island, until);
        let path = &world.bodies[0].path;
        let spans: Vec<_> = path.spans().map(|span| (span.from, span.until)).collect();
        assert_eq!(spans, [(island.step.from, until)]);
        assert!(matches!(path.motion_of(0).1, StoredMotion::Step(_)), "as a polynomial");
        assert!(store.polynomial_bytes > 0, "its memory is counted");
    }

    #[test]
    fn beyond_the_memory_limit_a_step_is_written_by_its_start() {
        let mut world = planned(&wall(), &[[0.0, 0.0, 0.0, SPEED, 0.0, 0.0]]);
        Arc::get_mut(&mut world.model).expect("one owner").polynomial_bytes = 0;
        for track in &mut world.contacts {
            track.log.push(0.0, track.state, DVec2::ZERO);
        }
        let (mut store, mut island) = (StepStore::default(), world.islands[0].take().expect("the island"));
        let until = island.step.until;
        store.commit(&mut world, &mut island, until);
        let path = &world.bodies[0].path;
        assert!(matches!(path.motion_of(0).1, StoredMotion::Recomputed(_)), "as {:?}", path.motion_of(0).1);
        assert_eq!(store.polynomial_bytes, 0, "no polynomial");
        let (swept, way) = (path.swept(), SPEED * until);
        assert!(swept.reach > 0.1 * way && swept.reach < 10.0 * way, "{swept:?} over {way} m");
        assert_eq!(swept.chord, 0.0, "it does not turn");
    }
}
