//! Law of a contact from the numbers of its pair, shared among the nodes that face each other when the pair first closes.

use crate::contact::{Law, law::Friction};
use crate::dynamics::contact_model::at_instant::{AtInstant, EventInstant};
use crate::dynamics::penalty3d::event_location::EDGE;
use crate::dynamics::world::World;
use crate::scene::{FrictionLaw, Sharing, Tension};

/// Sliding in two directions below this speed counts as stopped (`docs/physics.md#stop`) \[m/s\].
pub(in crate::dynamics) const V_STICK: f64 = 1e-6;

/// Law of a contact that closes; the number of nodes that share stiffness and damping is fixed until the pair opens.
pub(in crate::dynamics) fn of(world: &mut World, contact: usize, now: &EventInstant) -> Law {
    let number = world.contacts[contact].pair;
    if world.pairs[number].sharers == 0 {
        world.pairs[number].sharers = sharers(AtInstant { world, now }, number);
    }
    let pair = &world.model.pairs[world.pairs[number].pair];
    let (numbers, share) = (&pair.contact, world.pairs[number].sharers as f64);
    Law {
        k: numbers.stiffness / share,
        c_n: pair.c_n / share,
        c_t: pair.c_t / share,
        mu_s: numbers.mu_static,
        mu_k: numbers.mu_kinetic,
        friction: match numbers.law {
            FrictionLaw::Paper => Friction::Paper,
            FrictionLaw::ReturnMapping => Friction::ReturnMapping,
        },
        clamp: numbers.tension == Tension::Clamp,
        v_stick: if pair.one_way { 0.0 } else { V_STICK },
    }
}

/// Declared nodes of a pair whose projection lies inside the facing polygon, edges included; at least one.
fn sharers(at: AtInstant<'_>, pair: usize) -> usize {
    let world = at.world;
    let track = &world.pairs[pair];
    if world.model.pairs[track.pair].contact.sharing == Sharing::PerNode {
        return 1;
    }
    let inside = |contact: &usize| {
        let face = &world.model.contacts[world.contacts[*contact].site].face;
        face.inset_at(at.local(*contact).at) >= -EDGE * face.size()
    };
    track.contacts.clone().filter(inside).count().max(1)
}
