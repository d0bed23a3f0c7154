//! Assembly of islands (bodies joined by a chain of closed contacts and acting devices), their numbers, and reuse of
//! their implicit integrators.

use crate::dynamics::contact_model::step_store::StepStore;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::model::reference_pose::{self, ReferencePose};
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::coupled_system::Members;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{LinkTrack, Trajectory, flown};

/// Numbers and implicit integrators of ended islands, for reuse.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct IslandStock {
    vacant: Vec<usize>,
    #[expect(clippy::vec_box, reason = "an integrator is moved from island to island in its box")]
    spare: Vec<Box<Radau>>,
}

/// Initial state of an island: bodies, their reference poses, and their states relative to these.
#[derive(Debug)]
pub(in crate::dynamics) struct Start<'a> {
    /// Slots of the bodies, ascending.
    pub members: &'a [usize],
    /// Reference poses.
    pub bases: Vec<ReferencePose>,
    /// States in the order of the bodies.
    pub y: Vec<f64>,
    /// Time \[s\].
    pub t: f64,
}

impl IslandStock {
    /// Stores the number and the implicit integrator of an island that has ended.
    pub(in crate::dynamics) fn take_back(&mut self, number: usize, island: &mut Island) {
        self.vacant.push(number);
        self.spare.extend(island.stepper.give_back());
    }

    /// Creates an island at `start` and writes the flights of its bodies into their paths; returns its number. `controller`
    /// is the method and the length of its first step.
    pub(in crate::dynamics) fn create(
        &mut self,
        world: &mut World,
        store: &StepStore,
        start: Start<'_>,
        controller: ControllerState,
    ) -> usize {
        let Start { members, mut bases, y, t } = start;
        let number = self.vacant.pop().unwrap_or_else(|| {
            world.islands.push(None);
            world.islands.len() - 1
        });
        let layout = world.layout_of(members);
        for (index, &slot) in members.iter().enumerate() {
            end_flight(world, slot, t);
            world.bodies[slot].now = Trajectory::Island { island: number, index };
            if store.keeps_starts(world) && bases[index].stored_number.is_none() && bases[index].flown.is_none() {
                let state = &y[layout.range(index)];
                bases[index].flown = StepStore::landing(world, slot, &bases[index], state, t);
            }
        }
        let mut island = Box::new(assemble(world, members, bases, y, t, controller));
        island.stepper.borrow(self.spare.pop());
        world.islands[number] = Some(island);
        number
    }
}

/// The island of bodies with the closed contacts and acting devices between them.
pub(in crate::dynamics) fn assemble(
    world: &World,
    slots: &[usize],
    bases: Vec<ReferencePose>,
    y: Vec<f64>,
    t: f64,
    controller: ControllerState,
) -> Island {
    let index = |slot: Option<usize>| slot.and_then(|s| slots.binary_search(&s).ok());
    let (contacts, active) = world
        .pairs_of(slots)
        .into_iter()
        .flat_map(|pair| world.pairs[pair].contacts.clone())
        .filter_map(|contact| {
            let track = &world.contacts[contact];
            let closed = *track.state.closed()?;
            let ends = track.slots.map(index);
            let sides = ends.map(|i| bases.get(i?));
            let home = reference_pose::seen_from(&world.model.sites[track.site], &closed.place, sides);
            let active = ActiveContact::new(track.site, ends, closed, home);
            Some((contact, ActiveContact { tolerated: track.tolerated, ..active }))
        })
        .unzip();
    let bodies = slots.iter().map(|&slot| world.bodies[slot].body).collect();
    let members = Members { bodies, bases, active, links: acting_links(world, slots) };
    let mut island = Island::new(&world.model, slots.to_vec(), members, contacts, y, t, controller);
    island.steps_taken = slots.iter().map(|&slot| world.bodies[slot].path.len()).max().unwrap_or(0);
    island
}

/// Links of these bodies whose force acts.
fn acting_links(world: &World, slots: &[usize]) -> Vec<ActiveLink> {
    let index = |slot: Option<usize>| slot.and_then(|s| slots.binary_search(&s).ok());
    let active = |track: usize| {
        let LinkTrack { link, slots, phase, .. } = &world.links[track];
        let placed = world.model.links[*link].placed();
        ActiveLink {
            number: *link,
            track,
            ends: slots.map(index),
            sections: [0; 2],
            placed,
            phase: *phase,
            evolving: None,
        }
    };
    world.links_of(slots).into_iter().filter(|&link| world.link_acts(link)).map(active).collect()
}

/// Writes the flight of a body into its path, as far as `t`.
pub(in crate::dynamics) fn end_flight(world: &mut World, slot: usize, t: f64) {
    let track = &mut world.bodies[slot];
    if let Trajectory::Flight(flight) = &track.now
        && t > flight.start()
    {
        let segments = flown(flight, t);
        segments.into_iter().for_each(|segment| track.path.push(segment));
    }
}
