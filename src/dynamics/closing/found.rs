//! Result of a search for the next closing, and the end of the planned steps that bound it.

use crate::dynamics::closing::constants::CUT_SEARCH_WORK;
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
    /// Contribution to the work of the run, where the search ended at its bound of advances.
    pub work: usize,
}

impl NextClosing {
    /// A closing at a time that is known without an evaluation.
    pub(in crate::dynamics) fn at(due: f64) -> Self {
        Self { due, evaluations: 0, work: 0 }
    }

    /// Result of a search up to `until` \[s\] in a run of `duration` \[s\], after this number of evaluations.
    pub(in crate::dynamics) fn of(found: FirstZero, until: f64, duration: f64, evaluations: u64) -> Self {
        let cut = matches!(found, FirstZero::NoneUntil(end) if end < until.min(duration));
        Self { due: found.due(duration), evaluations, work: if cut { CUT_SEARCH_WORK } else { 0 } }
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
    fn a_search_that_was_cut_goes_on_where_it_ended_and_counts_as_work() {
        let of = |found| NextClosing::of(found, 2.0, 10.0, 7);
        let cases = [
            (of(FirstZero::Crossing(0.5)), 0.5, 0),
            (of(FirstZero::NoneUntil(2.0)), 2.0, 0),
            (of(FirstZero::NoneUntil(0.5)), 0.5, CUT_SEARCH_WORK),
            (of(FirstZero::NoneUntil(10.0)), f64::INFINITY, 0),
        ];
        for (found, due, work) in cases {
            assert_eq!((found.due, found.work, found.evaluations), (due, work, 7), "{found:?}");
        }
    }
}
