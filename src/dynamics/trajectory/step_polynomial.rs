//! One body's part of a step, as a history keeps it: components that stay 0 are left out.
//!
//! A girder that is hit head-on moves along one axis and never turns: a third of its state is all there is to keep.

use crate::dynamics::integrator::dense_output::{DENSE_TERMS, DenseOutput};
use crate::dynamics::model::reference_pose::ReferencePose;

/// Components that may be left out: those of every rigid body, and the first of others.
const MASKED: usize = u32::BITS as usize;

/// A body's continuous answer over one step.
#[derive(Clone, Debug, PartialEq)]
pub struct StepPolynomial {
    /// Where the step begins \[s\].
    from: f64,
    /// Its length \[s\].
    step: f64,
    /// Which of the first [`MASKED`] components are kept, lowest bit first; the others of them stay 0. All further ones are.
    kept: u32,
    coefficients: Box<[[f64; DENSE_TERMS]]>,
    /// What they are counted from, if not from where the body was placed.
    base: Box<[f64]>,
}

impl StepPolynomial {
    /// Components `range` of a continuous answer that is counted from a base.
    pub(in crate::dynamics) fn of(
        dense: &DenseOutput,
        range: std::ops::Range<usize>,
        base: Option<&ReferencePose>,
    ) -> Self {
        let all = &dense.coefficients()[range];
        let moves = |c: &&[f64; DENSE_TERMS]| c.iter().any(|x| *x != 0.0);
        let (masked, whole) = all.split_at(all.len().min(MASKED));
        let bit = |(i, c): (usize, &[f64; DENSE_TERMS])| u32::from(moves(&c)) << i;
        let kept = masked.iter().enumerate().map(bit).fold(0, |all, bit| all | bit);
        let coefficients = masked.iter().filter(moves).chain(whole).copied().collect();
        let base = base.map(ReferencePose::numbers).unwrap_or_default();
        Self { from: dense.from, step: dense.step, kept, coefficients, base }
    }

    /// All components at `t` as they are counted, written to `out`; and the numbers of the reference pose that they are counted
    /// from.
    pub fn read(&self, t: f64, out: &mut [f64]) -> &[f64] {
        let x = (t - self.from) / self.step;
        let mut kept = self.coefficients.iter();
        for (i, value) in out.iter_mut().enumerate() {
            let moving = i >= MASKED || self.kept & (1 << i) != 0;
            *value = if moving { kept.next().map_or(0.0, |c| DenseOutput::value(c, x)) } else { 0.0 };
        }
        &self.base
    }

    /// What it takes \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.coefficients) + size_of_val(&*self.base)
    }

    /// Every number that the answer depends on, for hashing.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let head = [self.from, self.step, f64::from(self.kept)].into_iter();
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
        assert_eq!(piece.coefficients.len(), MASKED / 2 + 5, "half of the masked ones move");
    }
}
