//! When the open contacts of a pair close next, on the trajectories that its bodies are on.

use crate::dynamics::closing::found::{NextClosing, planned};
use crate::dynamics::closing::{collinear_pair, in_flight, in_steps};
use crate::dynamics::world::World;

/// Searches the next closing of a pair from `t` on; the closing of each contact is entered in its track.
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64) -> NextClosing {
    for contact in world.pairs[pair].contacts.clone() {
        world.contacts[contact].take_note(t);
    }
    collinear_pair::search(world, pair, t).unwrap_or_else(|| match planned(world, world.pairs[pair].slots) {
        Some(until) => NextClosing::at(in_steps::search(world, pair, t, until)),
        None => in_flight::search(world, pair, t),
    })
}
