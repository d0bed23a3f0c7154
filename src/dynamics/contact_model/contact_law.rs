//! Law of a contact: stiffness and dashpots of its pair, divided among the nodes that face each other when the pair
//! first closes (`docs/physics.md#sharing-of-a-pairs-stiffness`).

use crate::contact::{Law, parameters};
use crate::dynamics::contact_model::event_state::{EventBodies, EventContacts};
use crate::dynamics::world::{World, contact_points};
use crate::scene::{Kind, Sharing};

/// Law of a contact that closes. The parts of the pair's nodes in stiffness and dashpots are determined when its first
/// contact closes and kept until all of them are open.
pub(in crate::dynamics) fn of(world: &mut World, contact: usize, now: &EventBodies) -> Law {
    let number = world.contacts[contact].pair;
    if world.pairs[number].sharers == 0 {
        let (sharers, nodes) = sharers(EventContacts { world, now }, number);
        for (contact, nodes) in world.pairs[number].contacts.clone().zip(nodes) {
            let here = EventContacts { world, now }.local(contact).at;
            let face = &world.site(contact).face;
            let has_part = world.model.kind == Kind::Planar && parameters::is_over(face, here);
            let track = &mut world.contacts[contact];
            (track.divisor, track.has_part) = ((sharers * nodes) as f64, has_part);
        }
        world.pairs[number].sharers = sharers;
    }
    world.model_pair(number).law.shared(world.contacts[contact].divisor)
}

/// Number of nodes, in space of vertices, that share the law of a pair, and for each of its contacts the number of
/// nodes at its vertex, from the poses at the time of the event.
fn sharers(at: EventContacts<'_>, pair: usize) -> (usize, Vec<usize>) {
    let world = at.world;
    let track = &world.pairs[pair];
    let alone = vec![1; track.contacts.len()];
    match (world.model.pairs[track.model_pair].contact.sharing, world.model.kind) {
        (Sharing::PerNode, _) => (1, alone),
        (Sharing::Tributary, Kind::Planar) => {
            let node = |contact: usize| (&world.site(contact).face, at.local(contact).at);
            (parameters::sharers(track.contacts.clone().map(node)), alone)
        }
        (Sharing::Tributary, Kind::Spatial) => contact_points::sharers(world, pair, &|contact| at.sides(contact)),
    }
}
