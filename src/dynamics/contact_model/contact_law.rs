//! Law of a contact from the numbers of its pair, shared among the nodes that face each other when the pair first closes.

use crate::contact::{Law, parameters};
use crate::dynamics::contact_model::at_instant::{AtInstant, EventInstant};
use crate::dynamics::world::World;
use crate::scene::Sharing;

/// Law of a contact that closes; the number of nodes that share stiffness and damping is fixed until the pair opens.
pub(in crate::dynamics) fn of(world: &mut World, contact: usize, now: &EventInstant) -> Law {
    let number = world.contacts[contact].pair;
    if world.pairs[number].sharers == 0 {
        world.pairs[number].sharers = sharers(AtInstant { world, now }, number);
    }
    world.model.pairs[world.pairs[number].pair].law.shared(world.pairs[number].sharers)
}

/// Number of nodes that share the law of a pair at the instant.
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
