//! Dense output: the interpolant of a step as eight coefficients per component, `u(x) = c₀ + x (c₁ + y (c₂ + x (c₃ +
//! …)))` with `x = (t − t₀)/h`, `y = 1 − x` (Hairer, Nørsett and Wanner, "Solving Ordinary Differential Equations I",
//! section II.6).

/// Coefficients of the interpolant per component.
pub const DENSE_TERMS: usize = 8;

/// Largest first and second derivatives of the interpolant's factors `x, xy, x²y, x²y², x³y², x³y³, x⁴y³`, y = 1 − x,
/// on \[0, 1\], rounded up.
const STEEPEST: [[f64; DENSE_TERMS - 1]; 2] =
    [[1.0, 1.0, 1.0, 0.193, 0.136, 0.0537, 0.0336], [0.0, 2.0, 4.0, 2.0, 2.0, 0.375, 0.243]];

/// Dense output of one step: `[component][coefficient]`.
#[derive(Clone, Debug, PartialEq)]
pub struct DenseOutput {
    /// Beginning of the step \[s\].
    pub from: f64,
    /// Length of the step \[s\].
    pub step: f64,
    coefficients: Vec<[f64; DENSE_TERMS]>,
}

impl DenseOutput {
    /// Dense output of a step from `from` of length `step` with these coefficients.
    pub(in crate::dynamics) fn new(from: f64, step: f64, coefficients: Vec<[f64; DENSE_TERMS]>) -> Self {
        Self { from, step, coefficients }
    }

    /// Writes components `range` at `t` to `out`.
    #[inline]
    pub fn read(&self, range: std::ops::Range<usize>, t: f64, out: &mut [f64]) {
        let x = (t - self.from) / self.step;
        for (value, c) in out.iter_mut().zip(&self.coefficients[range]) {
            *value = Self::value(c, x);
        }
    }

    /// Component `i` at `t`.
    #[inline]
    pub(in crate::dynamics) fn component(&self, i: usize, t: f64) -> f64 {
        Self::value(&self.coefficients[i], (t - self.from) / self.step)
    }

    /// Component with coefficients `c` at the part `x` of the step \[–\]: Horner's scheme, alternately in x and 1 −
    /// x.
    #[inline]
    pub(in crate::dynamics) fn value(c: &[f64; DENSE_TERMS], x: f64) -> f64 {
        let y = 1.0 - x;
        c[0] + x * (c[1] + y * (c[2] + x * (c[3] + y * (c[4] + x * (c[5] + y * (c[6] + x * c[7]))))))
    }

    /// Bound of the Euclidean distance of components `range` from their values at the start, within the step.
    pub(in crate::dynamics) fn displacement_bound(&self, range: std::ops::Range<usize>) -> f64 {
        Self::displacement_bound_of(self.coefficients[range].iter())
    }

    /// [`displacement_bound`](Self::displacement_bound) of components with these coefficients.
    pub(in crate::dynamics) fn displacement_bound_of<'a>(
        components: impl Iterator<Item = &'a [f64; DENSE_TERMS]>,
    ) -> f64 {
        // Every coefficient is multiplied by a product of factors between 0 and 1.
        let far = |c: &[f64; DENSE_TERMS]| c[1..].iter().map(|c| c.abs()).sum::<f64>();
        components.map(|c| far(c).powi(2)).sum::<f64>().sqrt()
    }

    /// Bounds of the Euclidean norms of first and second derivative of components `range` within the step.
    pub(in crate::dynamics) fn derivative_bounds(&self, range: std::ops::Range<usize>) -> [f64; 2] {
        Self::derivative_bounds_of(self.coefficients[range].iter().copied(), self.step)
    }

    /// Bounds of the Euclidean norms of first and second derivative of the difference between components `range` and
    /// as many components from `other` on, within the step.
    pub(in crate::dynamics) fn difference_derivative_bounds(
        &self,
        range: std::ops::Range<usize>,
        other: usize,
    ) -> [f64; 2] {
        let pairs = self.coefficients[range].iter().zip(&self.coefficients[other..]);
        Self::derivative_bounds_of(pairs.map(|(a, b)| std::array::from_fn(|k| a[k] - b[k])), self.step)
    }

    /// [`derivative_bounds`](Self::derivative_bounds) of components with these coefficients over a step of this length
    /// \[s\].
    pub(in crate::dynamics) fn derivative_bounds_of(
        components: impl Iterator<Item = [f64; DENSE_TERMS]>,
        step: f64,
    ) -> [f64; 2] {
        let mut squares = [0.0; 2];
        for c in components {
            for (square, most) in squares.iter_mut().zip(&STEEPEST) {
                let largest: f64 = c[1..].iter().zip(most).map(|(c, most)| most * c.abs()).sum();
                *square += largest * largest;
            }
        }
        [squares[0].sqrt() / step, squares[1].sqrt() / (step * step)]
    }

    /// Dense output of components `range` alone.
    #[must_use]
    pub fn slice(&self, range: std::ops::Range<usize>) -> Self {
        Self { from: self.from, step: self.step, coefficients: self.coefficients[range].to_vec() }
    }

    /// All coefficients, for hashing.
    pub fn coefficients(&self) -> &[[f64; DENSE_TERMS]] {
        &self.coefficients
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_a_step_is_faster_or_bends_more_than_its_bounds() {
        let wild = |seed: f64| std::array::from_fn(|k| (seed + 1.7 * k as f64).sin() * 3.0);
        let dense = DenseOutput::new(2.0, 0.3, vec![wild(0.4), wild(2.9), wild(5.1)]);
        let at = |i: usize, x: f64| {
            DenseOutput::value(&dense.coefficients[i], x) - DenseOutput::value(&dense.coefficients[2], x)
        };
        let [speed, bend] = dense.difference_derivative_bounds(0..1, 2);
        let (h, mut worst) = (1e-4, [0.0f64; 2]);
        for k in 1..9999 {
            let x = f64::from(k) * h;
            let (before, here, after) = (at(0, x - h), at(0, x), at(0, x + h));
            worst[0] = worst[0].max(((after - before) / (2.0 * h * dense.step)).abs());
            worst[1] = worst[1].max(((after - 2.0 * here + before) / (h * dense.step).powi(2)).abs());
        }
        assert!(worst[0] <= speed && worst[1] <= bend, "{worst:?} against {speed}, {bend}");
        assert!(worst[0] > 0.1 * speed && worst[1] > 0.1 * bend, "not far above: {worst:?}, {speed}, {bend}");
    }
}
