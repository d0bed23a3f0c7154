//! Gaussian elimination of small dense systems, real or complex, in place and without allocating.

use crate::dynamics::integrator::constants::{REFINEMENTS, TIKHONOV};
use num_complex::Complex64;

/// Field of numbers for the elimination: real or complex.
pub(in crate::dynamics) trait Scalar:
    Copy
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Mul<f64, Output = Self>
    + std::ops::AddAssign
    + std::ops::SubAssign
    + PartialEq
{
    /// 0.
    const ZERO: Self;
    /// Magnitude, for the choice of pivots.
    fn size(self) -> f64;
    /// `1/self`.
    fn recip(self) -> Self;
    /// `self − x`.
    fn less(self, x: f64) -> Self;
    /// Factor stored in place of a pivot, by which [`Self::over`] divides.
    fn divisor(self) -> Self;
    /// Quotient of this number and the pivot with divisor `divisor`.
    fn over(self, divisor: Self) -> Self;
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;

    fn size(self) -> f64 {
        self.abs()
    }

    fn recip(self) -> Self {
        self.recip()
    }

    fn less(self, x: f64) -> Self {
        self - x
    }

    fn divisor(self) -> Self {
        self
    }

    fn over(self, divisor: Self) -> Self {
        self / divisor
    }
}

impl Scalar for Complex64 {
    const ZERO: Self = Self::new(0.0, 0.0);

    fn size(self) -> f64 {
        self.re.abs() + self.im.abs()
    }

    fn recip(self) -> Self {
        self.inv()
    }

    fn less(self, x: f64) -> Self {
        self - x
    }

    /// Multiplication by the stored reciprocal; a complex division costs four products.
    fn divisor(self) -> Self {
        self.inv()
    }

    fn over(self, divisor: Self) -> Self {
        self * divisor
    }
}

/// LU factors of a matrix in row order with the permutation of its rows; pivots are stored as their divisors.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct Lu<T> {
    entries: Vec<T>,
    rows: Vec<usize>,
}

impl<T> Default for Lu<T> {
    fn default() -> Self {
        Self { entries: Vec::new(), rows: Vec::new() }
    }
}

impl<T: Scalar> Lu<T> {
    /// Factors the matrix of `n` rows with the entries `entry(row, column)`; `false` for one that is singular or not
    /// finite.
    pub(in crate::dynamics) fn factor(&mut self, n: usize, entry: impl Fn(usize, usize) -> T) -> bool {
        self.entries.clear();
        for i in 0..n {
            self.entries.extend((0..n).map(|j| entry(i, j)));
        }
        self.rows.clear();
        self.rows.extend(0..n);
        (0..n).all(|k| self.eliminate(n, k))
    }

    fn eliminate(&mut self, n: usize, k: usize) -> bool {
        let size = |i: usize| self.entries[i * n + k].size();
        let mut pivot = k;
        for i in k + 1..n {
            if size(i) > size(pivot) {
                pivot = i;
            }
        }
        let largest = size(pivot);
        if !(largest > 0.0 && largest.is_finite()) {
            return false;
        }
        if pivot != k {
            for j in 0..n {
                self.entries.swap(k * n + j, pivot * n + j);
            }
            self.rows.swap(k, pivot);
        }
        let (above, below) = self.entries.split_at_mut((k + 1) * n);
        let row = &mut above[k * n..];
        row[k] = row[k].divisor();
        let row = &*row;
        for other in below.chunks_exact_mut(n) {
            if other[k] != T::ZERO {
                let factor = other[k].over(row[k]);
                other[k] = factor;
                for (entry, pivot) in other[k + 1..].iter_mut().zip(&row[k + 1..]) {
                    *entry -= factor * *pivot;
                }
            }
        }
        true
    }

    /// Solves for the right-hand side `right` and writes the solution to `out`.
    pub(in crate::dynamics) fn solve(&self, right: &[T], out: &mut [T]) {
        let n = self.rows.len();
        for i in 0..n {
            let mut sum = right[self.rows[i]];
            for (entry, x) in self.entries[i * n..i * n + i].iter().zip(out.iter()) {
                sum -= *entry * *x;
            }
            out[i] = sum;
        }
        for i in (0..n).rev() {
            let mut sum = out[i];
            for (entry, x) in self.entries[i * n + i + 1..(i + 1) * n].iter().zip(&out[i + 1..]) {
                sum -= *entry * *x;
            }
            out[i] = sum.over(self.entries[i * n + i]);
        }
    }
}

impl Lu<f64> {
    /// Magnitude of the smallest pivot, a measure of the distance from a singular matrix.
    pub(in crate::dynamics) fn least_pivot(&self) -> f64 {
        let n = self.rows.len();
        (0..n).map(|k| self.entries[k * n + k].abs()).fold(f64::INFINITY, f64::min)
    }
}

/// Solves as many equations as there are rows; a row holds its right-hand side behind its matrix, replaced by the
/// solution. `false` for singular equations.
pub(in crate::dynamics) fn eliminate<const N: usize>(rows: &mut [[f64; N]]) -> bool {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).fold(k, |best, i| if rows[i][k].abs() > rows[best][k].abs() { i } else { best });
        rows.swap(k, pivot);
        let row = rows[k];
        let inverse = row[k].recip();
        if !inverse.is_finite() {
            return false;
        }
        for other in &mut rows[k + 1..] {
            let factor = other[k] * inverse;
            other[k + 1..=n].iter_mut().zip(&row[k + 1..=n]).for_each(|(entry, above)| *entry -= factor * above);
        }
    }
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| rows[k][j] * rows[j][n]).sum();
        rows[k][n] = (rows[k][n] - sum) / rows[k][k];
    }
    true
}

/// Whether the matrix of these entries has a pivot of at most `least` times its largest entry.
pub(in crate::dynamics) fn is_singular(size: usize, entry: impl Fn(usize, usize) -> f64, least: f64) -> bool {
    let mut lu = Lu::default();
    let largest = (0..size * size).map(|i| entry(i / size, i % size).abs()).fold(0.0, f64::max);
    !lu.factor(size, &entry) || lu.least_pivot() <= least * largest
}

/// Solves `A x = b` for `A_rc = entry(r, c)`, `b_r = right(r)`; `None` for entries that are not finite. Where `A` is singular, `α` times its
/// largest entry is added on the diagonal, so that redundant rows share the load equally, and the solution is refined by its residuals
/// (iterated Tikhonov regularisation: Riley 1955): each refinement takes the error of the range of `A` by `α`, and round-off of `b` outside
/// of the range enters as `ε/α`. With `singular`, the least pivot of a regular `A` in parts of its largest entry.
pub(in crate::dynamics) fn solve_regularised(
    size: usize,
    entry: impl Fn(usize, usize) -> f64,
    right: impl Fn(usize) -> f64,
    singular: f64,
) -> Option<Vec<f64>> {
    let b: Vec<f64> = (0..size).map(right).collect();
    let mut x = vec![0.0; size];
    let mut lu = Lu::default();
    let largest = (0..size * size).map(|i| entry(i / size, i % size).abs()).fold(0.0, f64::max);
    if !lu.factor(size, &entry) || lu.least_pivot() <= singular * largest {
        let added = TIKHONOV * largest;
        let regular = |r: usize, c: usize| entry(r, c) + if r == c { added } else { 0.0 };
        if !lu.factor(size, regular) {
            return None;
        }
        let mut refined = vec![0.0; size];
        for _ in 0..REFINEMENTS {
            let residual: Vec<f64> =
                (0..size).map(|r| b[r] - (0..size).map(|c| entry(r, c) * x[c]).sum::<f64>()).collect();
            lu.solve(&residual, &mut refined);
            x.iter_mut().zip(&refined).for_each(|(x, more)| *x += more);
        }
        return x.iter().all(|v| v.is_finite()).then_some(x);
    }
    lu.solve(&b, &mut x);
    x.iter().all(|v| v.is_finite()).then_some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn residual<T: Scalar + std::ops::Neg<Output = T>>(
        n: usize,
        entry: impl Fn(usize, usize) -> T,
        right: &[T],
    ) -> f64 {
        let (mut lu, mut x) = (Lu::default(), vec![T::ZERO; n]);
        assert!(lu.factor(n, &entry), "regular");
        lu.solve(right, &mut x);
        let row = |i: usize| {
            let mut sum = right[i];
            (0..n).for_each(|j| sum -= entry(i, j) * x[j]);
            sum.size()
        };
        (0..n).map(row).fold(0.0, f64::max)
    }

    #[test]
    fn what_is_solved_satisfies_the_equations() {
        let real = |i: usize, j: usize| if i == j { 0.0 } else { ((3 * i + 7 * j) % 11) as f64 - 4.0 };
        assert!(residual(9, real, &[1.0, 2.0, -3.0, 4.0, 0.5, 6.0, -7.0, 8.0, 9.0]) < 1e-12, "real, zero diagonal");
        let complex = |i: usize, j: usize| Complex64::new(real(i, j), real(j, i) + if i == j { 2.0 } else { 0.0 });
        let right: Vec<Complex64> = (0..9).map(|i| Complex64::new(f64::from(i), 1.0)).collect();
        assert!(residual(9, complex, &right) < 1e-12, "complex");
    }

    #[test]
    fn both_eliminations_agree() {
        let (mut lu, mut x) = (Lu::default(), [0.0; 3]);
        let rows = [[0.0, 2.0, 1.0, 5.0], [3.0, 1.0, -1.0, 2.0], [1.0, -2.0, 4.0, -7.0]];
        assert!(lu.factor(3, |i, j| rows[i][j]), "regular");
        lu.solve(&rows.map(|row| row[3]), &mut x);
        let mut at_once = rows;
        assert!(eliminate(&mut at_once), "regular at once");
        (0..3).for_each(|i| assert!((at_once[i][3] - x[i]).abs() < 1e-14, "{at_once:?} against {x:?}"));
        assert!(!eliminate(&mut [[1.0, 2.0, 0.0], [2.0, 4.0, 0.0]]), "rows that are one");
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        assert!(!Lu::<f64>::default().factor(3, |i, _| i as f64), "equal columns");
        assert!(!Lu::<f64>::default().factor(2, |_, _| f64::NAN), "not numbers");
    }

    #[test]
    fn a_singular_system_is_solved_with_shared_loads_and_a_regular_one_exactly() {
        let regular = [[4.0, 1.0], [1.0, 3.0]];
        let x = solve_regularised(2, |r, c| regular[r][c], |r| [1.0, 2.0][r], 1e-12).expect("finite");
        assert!((x[0] - 1.0 / 11.0).abs() < 1e-15 && (x[1] - 7.0 / 11.0).abs() < 1e-15, "{x:?}");
        let x = solve_regularised(2, |_, _| 2.0, |_| 6.0, 1e-12).expect("finite");
        assert!((x[0] - 1.5).abs() < 1e-3 && (x[0] + x[1] - 3.0).abs() < 1e-11, "two equal rows share: {x:?}");
        assert_eq!(solve_regularised(2, |_, _| 0.0, |_| 1.0, 1e-12), None, "nothing can move");
        assert_eq!(solve_regularised(0, |_, _| 0.0, |_| 1.0, 1e-12), Some(Vec::new()), "no unknown");
    }

    #[test]
    fn rows_that_depend_on_each_other_have_the_solution_of_least_norm() {
        // A = J Jᵀ, b = J v; of all solutions that of least norm is J (JᵀJ)⁻¹ v.
        let rows = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let product = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let v = [0.3, -0.7];
        let entry = |r: usize, c: usize| product(rows[r], rows[c]);
        assert!(
            is_singular(3, entry, 1e-12) && !is_singular(2, entry, 1e-12),
            "the third row is the sum of the others"
        );
        let found = solve_regularised(3, entry, |r| product(rows[r], v), 1e-12).expect("a solution");
        let least = [(2.0 * v[0] - v[1]) / 3.0, (2.0 * v[1] - v[0]) / 3.0];
        for (found, row) in found.iter().zip(rows) {
            // ε/α.
            assert!((found - product(row, least)).abs() < 1e-8, "{found} against {}", product(row, least));
        }
    }

    #[test]
    fn a_known_system_is_solved() {
        let rows = [[0.0, 2.0, 1.0], [3.0, 1.0, -1.0], [1.0, -2.0, 4.0]];
        let (mut lu, mut x) = (Lu::default(), [0.0; 3]);
        assert!(lu.factor(3, |i, j| rows[i][j]), "regular");
        lu.solve(&[-1.0, -2.0, 17.0], &mut x);
        (0..3).for_each(|i| assert!((x[i] - [1.0, -2.0, 3.0][i]).abs() < 1e-14, "{x:?}"));
        // Pivots 3, −2 − 1/3 and 1 + (6/7)(4 + 1/3).
        assert!((lu.least_pivot() - 7.0 / 3.0).abs() < 1e-14, "{}", lu.least_pivot());
        let i = Complex64::I;
        let complex = [[i, Complex64::ONE], [Complex64::ONE, Complex64::ZERO]];
        let (mut lu, mut z) = (Lu::default(), [Complex64::ZERO; 2]);
        assert!(lu.factor(2, |row, column| complex[row][column]), "regular");
        lu.solve(&[Complex64::new(0.0, 3.0), Complex64::new(2.0, 0.0)], &mut z);
        assert!((z[0] - 2.0).norm() < 1e-15 && (z[1] - i).norm() < 1e-15, "{z:?}");
    }
}
