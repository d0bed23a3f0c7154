//! Law of a contact: stiffness and dashpots of its pair, divided among the nodes that face each other when the pair
//! first closes (`docs/physics.md#sharing-of-a-pairs-stiffness`).

use crate::contact::{Law, parameters};
use crate::dynamics::contact_model::at_instant::{AtInstant, EventInstant};
use crate::dynamics::world::World;
use crate::scene::Sharing;

/// Law of a contact that closes. The number of nodes that share stiffness and dashpots is determined when the first
/// contact of the pair closes and kept until all of them are open.
pub(in crate::dynamics) fn of(world: &mut World, contact: usize, now: &EventInstant) -> Law {
    let number = world.contacts[contact].pair;
    if world.pairs[number].sharers == 0 {
        world.pairs[number].sharers = sharers(AtInstant { world, now }, number);
    }
    world.model.pairs[world.pairs[number].pair].law.shared(world.pairs[number].sharers)
}

/// Number of nodes that share the law of a pair, from their projections at the time of the event.
fn sharers(at: AtInstant<'_>, pair: usize) -> usize {
    let world = at.world;
    let track = &world.pairs[pair];
    match world.model.pairs[track.pair].contact.sharing {
        Sharing::PerNode => 1,
        Sharing::Tributary => parameters::sharers(track.contacts.clone().map(|contact| {
            let face = &world.model.contacts[world.contacts[contact].site].face;
            (face, at.local(contact).at)
        })),
    }
}
