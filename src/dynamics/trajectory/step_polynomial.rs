//! Dense output of one body over one step as stored in a history, without the components that are 0 throughout the
//! step.
//!
//! Of a girder that is hit head-on a third of the components remains: motion along one axis without rotation.

use crate::dynamics::integrator::dense_output::{DENSE_TERMS, DenseOutput};
use crate::dynamics::model::reference_pose::ReferencePose;

/// Number of components that can be left out: all of a rigid body, the first ones of a body with more.
const MASKED: usize = u32::BITS as usize;

/// Dense output of a body over one step.
#[derive(Clone, Debug, PartialEq)]
pub struct StepPolynomial {
    /// Beginning of the step \[s\].
    from: f64,
    /// Length of the step \[s\].
    step: f64,
    /// Stored ones of the first [`MASKED`] components, lowest bit first; the others of these are 0. All further ones
    /// are stored.
    stored_mask: u32,
    coefficients: Box<[[f64; DENSE_TERMS]]>,
    /// Numbers of the reference pose; empty for the placed pose.
    base: Box<[f64]>,
}

impl StepPolynomial {
    /// Components `range` of a dense output relative to a reference pose, `None` for the placed pose.
    pub(in crate::dynamics) fn of(
        dense: &DenseOutput,
        range: std::ops::Range<usize>,
        base: Option<&ReferencePose>,
    ) -> Self {
        let all = &dense.coefficients()[range];
        let moves = |c: &&[f64; DENSE_TERMS]| c.iter().any(|x| *x != 0.0);
        let (masked, whole) = all.split_at(all.len().min(MASKED));
        let bit = |(i, c): (usize, &[f64; DENSE_TERMS])| u32::from(moves(&c)) << i;
        let stored_mask = masked.iter().enumerate().map(bit).fold(0, |all, bit| all | bit);
        let coefficients = masked.iter().filter(moves).chain(whole).copied().collect();
        let base = base.map(ReferencePose::numbers).unwrap_or_default();
        Self { from: dense.from, step: dense.step, stored_mask, coefficients, base }
    }

    /// Writes all components at `t`, relative to the reference pose, to `out`; returns the numbers of the reference
    /// pose.
    pub fn read(&self, t: f64, out: &mut [f64]) -> &[f64] {
        let x = (t - self.from) / self.step;
        let mut stored = self.coefficients.iter();
        for (i, value) in out.iter_mut().enumerate() {
            let moving = i >= MASKED || self.stored_mask & (1 << i) != 0;
            *value = if moving { stored.next().map_or(0.0, |c| DenseOutput::value(c, x)) } else { 0.0 };
        }
        &self.base
    }

    /// Bounds of the Euclidean norms of first and second derivative of components `range` within the step.
    pub fn derivative_bounds(&self, range: std::ops::Range<usize>) -> [f64; 2] {
        DenseOutput::derivative_bounds_of(range.filter_map(|i| self.coefficients_of(i).copied()), self.step)
    }

    /// Bound of the Euclidean distance of components `range` from their values at the start of the step.
    pub fn displacement_bound(&self, range: std::ops::Range<usize>) -> f64 {
        DenseOutput::displacement_bound_of(range.filter_map(|i| self.coefficients_of(i)))
    }

    /// Coefficients of component `i`; `None` where it is 0 throughout the step.
    fn coefficients_of(&self, i: usize) -> Option<&[f64; DENSE_TERMS]> {
        let before = |mask: u32| (self.stored_mask & mask).count_ones() as usize;
        if i >= MASKED {
            return self.coefficients.get(before(u32::MAX) + i - MASKED);
        }
        (self.stored_mask & (1 << i) != 0).then(|| &self.coefficients[before((1 << i) - 1)])
    }

    /// Memory of the polynomial \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.coefficients) + size_of_val(&*self.base)
    }

    /// All numbers of the representation, for hashing.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let head = [self.from, self.step, f64::from(self.stored_mask)].into_iter();
        head.chain(self.base.iter().copied()).chain(self.coefficients.iter().flatten().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_piece_answers_as_the_step_did_and_keeps_what_moves() {
        let line = |start: f64, rise: f64| [start, rise, 0.1 * rise, -0.2, 0.0, 0.3, 0.0, 1e-3];
        let dense =
            DenseOutput::new(1.0, 0.5, vec![line(2.0, 3.0), [0.0; DENSE_TERMS], line(-1.0, 0.0), [0.0; DENSE_TERMS]]);
        let piece = StepPolynomial::of(&dense, 0..4, None);
        for t in [1.0, 1.1, 1.37, 1.5] {
            let (mut whole, mut part) = ([0.0; 4], [9.0; 4]);
            dense.read(0..4, t, &mut whole);
            piece.read(t, &mut part);
            assert_eq!(whole, part, "at {t}");
        }
        for range in [0..1, 0..2, 1..4, 2..3, 0..4] {
            assert_eq!(piece.derivative_bounds(range.clone()), dense.derivative_bounds(range.clone()), "{range:?}");
            assert_eq!(piece.displacement_bound(range.clone()), dense.displacement_bound(range.clone()), "{range:?}");
        }
        assert_eq!(piece.coefficients.len(), 2, "two components move");
    }
    #[test]
    fn of_a_wide_body_the_components_beyond_the_mask_are_kept_as_they_are() {
        let coefficients = |i: usize| [[0.0; DENSE_TERMS], [i as f64; DENSE_TERMS]][i % 2];
        let width = MASKED + 5;
        let dense = DenseOutput::new(0.0, 1.0, (0..width).map(coefficients).collect());
        let piece = StepPolynomial::of(&dense, 0..width, None);
        let (mut whole, mut part) = (vec![0.0; width], vec![9.0; width]);
        dense.read(0..width, 0.3, &mut whole);
        piece.read(0.3, &mut part);
        assert_eq!(whole, part, "every component");
        let wide = 0..width;
        assert_eq!(piece.derivative_bounds(wide.clone()), dense.derivative_bounds(wide), "masked and others");
        assert_eq!(piece.coefficients.len(), MASKED / 2 + 5, "half of the masked ones move");
    }
}
