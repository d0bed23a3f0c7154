//! Result of a search for the next closing, and the end of the planned steps that bound it.

use crate::dynamics::locate::advancement::FirstZero;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::Trajectory;

/// Result of a search for the next closing of a pair, or for the next beginning of a link's force.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct NextClosing {
    /// Time of the closing or of the end of the search; infinite without either \[s\].
    pub due: f64,
    /// Evaluations of the gap in flight.
    pub evaluations: u64,
}

impl NextClosing {
    /// A closing at a time that is known without an evaluation.
    pub(in crate::dynamics) fn at(due: f64) -> Self {
        Self { due, evaluations: 0 }
    }

    /// Result of a search in a run of `duration` \[s\], after this number of evaluations.
    pub(in crate::dynamics) fn of(found: FirstZero, duration: f64, evaluations: u64) -> Self {
        Self { due: found.due(duration), evaluations }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_that_found_nothing_before_the_end_goes_on_where_it_ended() {
        let of = |found| NextClosing::of(found, 10.0, 7);
        let cases = [
            (of(FirstZero::Crossing(0.5)), 0.5),
            (of(FirstZero::NoneUntil(2.0)), 2.0),
            (of(FirstZero::NoneUntil(10.0)), f64::INFINITY),
        ];
        for (found, due) in cases {
            assert_eq!((found.due, found.evaluations), (due, 7), "{found:?}");
        }
    }
}
