//! The next closing of the open contacts of a pair on the present trajectories of its bodies.

use crate::dynamics::closing::found::{NextClosing, first_step_end};
use crate::dynamics::closing::shared::{Parted, Shared};
use crate::dynamics::closing::{collinear_pair, in_flight, in_steps};
use crate::dynamics::world::World;

/// Searches the next closing of a pair from `t` on; enters the closing of each contact in its track. `shared` is of searches at the
/// same time.
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64, shared: &mut Shared) -> NextClosing {
    let step_end = first_step_end(world, world.pairs[pair].slots);
    match shared.parted(world, pair, (t, step_end)) {
        Parted::Near => {}
        Parted::Until(from) => return in_flight::search(world, pair, from, shared),
        Parted::Throughout(until) => {
            // The first pair of the two bodies leads the search of all waiting pairs, unless its own search is due later.
            let leader = world.meeting_of(pair).start;
            let is_led = leader != pair && world.pairs[leader].due <= until;
            return NextClosing::at(if is_led { f64::INFINITY } else { until });
        }
    }
    for contact in world.pairs[pair].contacts.clone() {
        world.contacts[contact].rearm_if_positive(t);
    }
    collinear_pair::search(world, pair, t).unwrap_or_else(|| match step_end {
        Some(until) => NextClosing::at(in_steps::search(world, pair, [t, until], shared)),
        None => in_flight::search(world, pair, t, shared),
    })
}
