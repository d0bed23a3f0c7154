//! The next closing of the open contacts of a pair on the present trajectories of its bodies.

use crate::dynamics::closing::found::{NextClosing, first_step_end};
use crate::dynamics::closing::{collinear_pair, in_flight, in_steps};
use crate::dynamics::world::World;

/// Searches the next closing of a pair from `t` on; enters the closing of each contact in its track.
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64) -> NextClosing {
    for contact in world.pairs[pair].contacts.clone() {
        world.contacts[contact].rearm_if_positive(t);
    }
    collinear_pair::search(world, pair, t).unwrap_or_else(|| match first_step_end(world, world.pairs[pair].slots) {
        Some(until) => NextClosing::at(in_steps::search(world, pair, t, until)),
        None => in_flight::search(world, pair, t),
    })
}
