//! What a search for the next closing found, and where planned steps bound it.

use crate::dynamics::world::World;
use crate::dynamics::world::tracks::Trajectory;

/// What a search for the next closing of a pair found.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct NextClosing {
    /// When the pair closes or is to be searched on; infinite when neither is needed \[s\].
    pub due: f64,
    /// Evaluations of the gap in flight.
    pub looks: u64,
    /// Counted against the work bound: searches that were cut short.
    pub work: usize,
}

impl NextClosing {
    pub(in crate::dynamics) fn at(due: f64) -> Self {
        Self { due, looks: 0, work: 0 }
    }
}

/// Where the first planned step of bodies in two slots ends; nothing when both fly or stand \[s\].
pub(in crate::dynamics) fn planned(world: &World, slots: [Option<usize>; 2]) -> Option<f64> {
    let mut first = None;
    for slot in slots.into_iter().flatten() {
        if let Trajectory::Island { island, .. } = &world.bodies[slot].now
            && let Some(island) = &world.islands[*island]
        {
            first = Some(island.until.min(first.unwrap_or(f64::INFINITY)));
        }
    }
    first
}
