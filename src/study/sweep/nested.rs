//! Runs of a sweep over one or two keys from coarse to fine: nested grids, so that the whole map is seen from the first runs on.
//!
//! The grid of stride `s` has every `s`-th value of both keys, the first among them; each stride is half of the one before,
//! the last is 1. Each run is computed once, in the coarsest grid that has it.

use super::plan::Plan;

/// Most steps of the coarsest grid along a key.
const COARSEST: usize = 4;

/// The grid of a plan with one or two keys; a second key of one value stands for none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Nested {
    /// Values of each key.
    counts: [usize; 2],
    /// Stride of the coarsest grid, a power of two.
    coarsest: usize,
}

impl Nested {
    /// The grid of a plan; none of one that has neither one nor two keys.
    pub fn of(plan: &Plan) -> Option<Self> {
        match plan.axes.as_slice() {
            [x] => Some(Self::new([x.values.len(), 1])),
            [x, y] => Some(Self::new([x.values.len(), y.values.len()])),
            _ => None,
        }
    }

    fn new(counts: [usize; 2]) -> Self {
        let steps = counts.iter().copied().max().unwrap_or(1).saturating_sub(1);
        Self { counts, coarsest: steps.div_ceil(COARSEST).max(1).next_power_of_two() }
    }

    /// Values of each key.
    pub fn counts(self) -> [usize; 2] {
        self.counts
    }

    /// Every run, those of coarser grids first.
    pub fn order(self) -> Vec<usize> {
        let [nx, ny] = self.counts;
        let stride = |x: usize, y: usize| 1 << x.trailing_zeros().min(y.trailing_zeros()).min(self.coarsest.ilog2());
        let mut runs: Vec<(usize, usize)> =
            (0..nx).flat_map(|x| (0..ny).map(move |y| (x, y))).map(|(x, y)| (stride(x, y), x * ny + y)).collect();
        runs.sort_by_key(|(stride, run)| (std::cmp::Reverse(*stride), *run));
        runs.into_iter().map(|(_, run)| run).collect()
    }

    /// The run that stands for a place of the grid while finer ones are missing: that of the finest grid in which the run
    /// nearest to the place `is_there`.
    pub fn standing_for(self, [x, y]: [usize; 2], is_there: impl Fn(usize) -> bool) -> Option<usize> {
        let near = |index: usize, count: usize, stride: usize| {
            ((index + stride / 2) / stride * stride).min((count.max(1) - 1) / stride * stride)
        };
        let strides = (0..=self.coarsest.ilog2()).map(|power| 1_usize << power);
        let run = |stride| near(x, self.counts[0], stride) * self.counts[1] + near(y, self.counts[1], stride);
        strides.map(run).find(|&run| is_there(run))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_run_comes_once_and_coarser_grids_come_first() {
        for counts in [[1, 1], [2, 1], [72, 1], [5, 5], [9, 17], [33, 33], [61, 7], [10, 4]] {
            let grid = Nested::new(counts);
            let order = grid.order();
            let mut sorted = order.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, (0..counts[0] * counts[1]).collect::<Vec<_>>(), "{counts:?}: each once");
            let stride = |run: usize| {
                let powers = [run / counts[1], run % counts[1]].map(usize::trailing_zeros);
                powers[0].min(powers[1]).min(grid.coarsest.ilog2())
            };
            assert!(order.windows(2).all(|two| stride(two[0]) >= stride(two[1])), "{counts:?}: {order:?}");
        }
    }

    #[test]
    fn the_coarsest_grid_covers_every_place_and_the_finest_is_the_place_itself() {
        let grid = Nested::new([33, 17]);
        assert_eq!(grid.coarsest, 8, "four steps along the longer key");
        let first: Vec<usize> = grid.order().into_iter().take(5 * 3).collect();
        for place in (0..33).flat_map(|x| (0..17).map(move |y| [x, y])) {
            let coarse = grid.standing_for(place, |run| first.contains(&run));
            assert!(coarse.is_some(), "{place:?} is covered");
            assert_eq!(grid.standing_for(place, |_| true), Some(place[0] * 17 + place[1]), "itself");
            assert_eq!(grid.standing_for(place, |_| false), None, "nothing yet");
        }
        let half = |run: usize| (run / 17).is_multiple_of(4) && (run % 17).is_multiple_of(4);
        assert_eq!(grid.standing_for([5, 7], half), Some(4 * 17 + 8), "the nearest that is there");
    }
}
