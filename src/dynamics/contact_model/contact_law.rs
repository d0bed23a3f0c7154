//! Law of a contact: stiffness and dashpots of its pair, divided among the nodes that face each other when the pair
//! first closes (`docs/physics.md#sharing-of-a-pairs-stiffness`).

use crate::contact::{Law, locate, parameters};
use crate::dynamics::contact_model::event_poses::{ContactPoses, EventPoses};
use crate::dynamics::world::contact_points::Sharers;
use crate::dynamics::world::{World, contact_points};
use crate::scene::{Kind, Sharing};

/// Divides K and C of a pair among its nodes when its first contact closes; the parts are kept until all of them are open.
pub(super) fn divide(world: &mut World, pair: usize, now: &EventPoses) {
    if world.pairs[pair].sharers > 0 {
        return;
    }
    let Sharers { count, at_vertex } = sharers(ContactPoses { world, now }, pair);
    for (contact, nodes) in world.pairs[pair].contacts.clone().zip(at_vertex) {
        let here = ContactPoses { world, now }.local(contact).at;
        let face = &world.site(contact).face;
        let has_part = world.model.kind == Kind::Planar && parameters::is_over(face, here);
        let track = &mut world.contacts[contact];
        (track.divisor, track.has_part) = ((count * nodes) as f64, has_part);
    }
    world.pairs[pair].sharers = count;
}

/// Law of a contact with its part of K and C, as these are divided.
pub(super) fn of(world: &World, contact: usize) -> Law {
    let track = &world.contacts[contact];
    world.model_pair(track.pair).law.shared(track.divisor)
}

/// Divisor of K and C for each of the `nodes` that take over the part of a vertex from those in contact there `before`, of which `left`
/// leaves its face \[–\].
pub(super) fn divisor_taken_over(world: &World, nodes: &[usize], before: &[usize], left: usize) -> f64 {
    let (pair, tracks) = (world.pair_of(left), &world.contacts);
    let count = nodes.len() as f64;
    match (world.model_pair(tracks[left].pair).contact.sharing, world.model.kind) {
        // A vertex has its part of K whichever of its nodes have left.
        (Sharing::Tributary, Kind::Spatial) => pair.sharers as f64 * count,
        // In plan nodes share K, and the parts of all nodes at the vertex stay.
        (Sharing::Tributary, Kind::Planar) => {
            let open = nodes.iter().filter(|&&node| !world.is_closed(node) && tracks[node].has_part);
            // A node that closed without a part of its own, since its place came over the face only later, has that of an open one.
            let open = open.skip(before.iter().filter(|&&node| !tracks[node].has_part).count());
            count / before.iter().chain(open).map(|&node| 1.0 / tracks[node].divisor).sum::<f64>()
        }
        (Sharing::PerNode, _) => tracks[left].divisor,
    }
}

/// Nodes that share the law of a pair, from the poses at the time of the event.
fn sharers(at: ContactPoses<'_>, pair: usize) -> Sharers {
    let world = at.world;
    let track = &world.pairs[pair];
    let at_vertex = vec![1; track.contacts.len()];
    match (world.model_pair(pair).contact.sharing, world.model.kind) {
        (Sharing::PerNode, _) => Sharers { count: 1, at_vertex },
        (Sharing::Tributary, Kind::Planar) => {
            let node = |contact: usize| (&world.site(contact).face, at.local(contact).at);
            // The first contact is of a node of the first side.
            let [first, second] = at.sides(track.contacts.start);
            let beside = world.model_pair(pair).beside.iter();
            let beside = beside.map(|node| (&node.face, locate(&node.geometry, &second, &first).at));
            Sharers { count: parameters::sharers(track.contacts.clone().map(node).chain(beside)), at_vertex }
        }
        (Sharing::Tributary, Kind::Spatial) => contact_points::sharers(world, pair, &|contact| at.sides(contact)),
    }
}
