//! Result of a search for the next closing, and the end of the planned steps that bound it.

use crate::dynamics::world::World;
use crate::dynamics::world::tracks::Trajectory;

/// Result of a search for the next closing of a pair, or for the next beginning of a link's force.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct NextClosing {
    /// Time of the closing or of the end of the search; infinite without either \[s\].
    pub due: f64,
    /// Evaluations of the gap in flight.
    pub evaluations: u64,
    /// Contribution to the work of the run, where the search ended at its bound of advances.
    pub work: usize,
}

impl NextClosing {
    pub(in crate::dynamics) fn at(due: f64) -> Self {
        Self { due, evaluations: 0, work: 0 }
    }
}

/// End of the first planned step of the bodies in two slots; `None` where neither is in a step \[s\].
pub(in crate::dynamics) fn first_step_end(world: &World, slots: [Option<usize>; 2]) -> Option<f64> {
    let mut first = None;
    for slot in slots.into_iter().flatten() {
        if let Trajectory::Island { island, .. } = &world.bodies[slot].now
            && let Some(island) = &world.islands[*island]
        {
            first = Some(island.step.until.min(first.unwrap_or(f64::INFINITY)));
        }
    }
    first
}
