//! Eigenvalues and eigenvectors of `ξ̈ + C ξ̇ + K ξ = 0` with symmetric K and C.
//!
//! Coordinates that nothing couples are solved each by itself. A coupled part is written with the Cholesky factor `K = L Lᵀ` as
//! `(Lᵀξ, ξ̇)′ = [[0, Lᵀ], [−L, −C]] (Lᵀξ, ξ̇)`, whose matrix is skew but for the damping: its eigenvectors are nearly orthogonal, and
//! eigenvalues err by rounding of the largest, not of its square.

use nalgebra::{DMatrix, DVector, Schur};

use super::Complex;

/// Couplings below this part of the geometric mean of what they couple are rounding of sums.
const UNCOUPLED: f64 = 1e-16;
/// Largest condition of the eigenvectors: beyond it a pair is at critical damping, and the sum of exponentials cancels.
const WORST_CONDITION: f64 = 1e8;
/// Imaginary part below which an eigenvalue is real, in parts of the largest of its block.
const REAL: f64 = 1e-13;
/// Most sweeps of the QR iteration per row.
const SWEEPS: usize = 60;

/// The decomposition: coordinates that drift without a force, and exponentials.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// Number of coordinates.
    pub size: usize,
    /// Coordinates without stiffness and damping that nothing couples: double zeros.
    pub drifts: Vec<usize>,
    /// Exponents, of conjugate pairs the one with the positive imaginary part \[1/s\].
    pub exponents: Vec<Complex>,
    /// Displacements `v_k`, one column an exponent, of which [`share`](Self::share) are real parts; speeds are `λ_k v_k`.
    pub shapes: DMatrix<Complex>,
    /// Rows that give the coefficients `c = left (ξ, ξ̇)`.
    pub left: DMatrix<Complex>,
}

impl Spectrum {
    /// Of stiffness and damping per unit mass; `None` where the eigenvectors are ill-conditioned, or a coupled or damped part can move
    /// without a spring: an exponent 0 has no constant motion under a load.
    pub fn of(stiffness: &DMatrix<f64>, damping: &DMatrix<f64>) -> Option<Self> {
        let size = stiffness.nrows();
        let (mut drifts, mut all) = (Vec::new(), Vec::new());
        for part in parts(stiffness, damping) {
            match part[..] {
                [one] if stiffness[(one, one)] == 0.0 && damping[(one, one)] == 0.0 => drifts.push(one),
                [one] => all.extend(single(one, size, stiffness[(one, one)], damping[(one, one)])?),
                _ => all.extend(coupled(&part, stiffness, damping)?),
            }
        }
        let (mut shapes, mut left) = (DMatrix::zeros(size, all.len()), DMatrix::zeros(all.len(), 2 * size));
        for (k, pair) in all.iter().enumerate() {
            shapes.set_column(k, &pair.shape);
            left.set_row(k, &pair.left.transpose());
        }
        Some(Self { size, drifts, exponents: all.into_iter().map(|pair| pair.exponent).collect(), shapes, left })
    }

    /// Rounding of the displacements of motions that begin at 0 with unit speeds, where the exponentials should sum to 0, in parts of
    /// what these speeds move in a run of `duration` \[s\], or in `1/|λ|` of the slowest exponent. An exponential is as large as the speed
    /// over its exponent: of a motion that only the rounding of the stiffness holds, 1e7 and more times the displacement.
    pub fn start_error(&self, duration: f64) -> f64 {
        let n = self.size;
        let left = |i: usize, j: usize| -> f64 {
            let part = |k: usize| self.share(k) * (self.shapes[(i, k)] * self.left[(k, n + j)]).re;
            (0..self.exponents.len()).map(part).sum()
        };
        let left: f64 = (0..n * n).map(|place| left(place / n, place % n).powi(2)).sum();
        let rates = self.exponents.iter().map(|exponent| exponent.norm());
        let slowest = rates.reduce(f64::min).unwrap_or(0.0);
        left.sqrt() * slowest.max(duration.recip())
    }

    /// Factor of the real part of `v_k c_k` in the sum: 2 for one of a conjugate pair, else 1.
    pub fn share(&self, k: usize) -> f64 {
        if self.exponents[k].im > 0.0 { 2.0 } else { 1.0 }
    }
}

/// An eigenvalue \[1/s\] with its right and left eigenvectors.
struct Eigenpair {
    exponent: Complex,
    shape: DVector<Complex>,
    left: DVector<Complex>,
}

/// Groups of coordinates that are coupled, each in rising order.
fn parts(stiffness: &DMatrix<f64>, damping: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let size = stiffness.nrows();
    let joined = |i: usize, j: usize| {
        let firm = (stiffness[(i, i)] * stiffness[(j, j)]).sqrt();
        let by = |m: &DMatrix<f64>, scale: f64| m[(i, j)].abs() > UNCOUPLED * scale;
        by(stiffness, firm) || by(damping, firm.sqrt())
    };
    let mut found = vec![false; size];
    let mut parts = Vec::new();
    for first in 0..size {
        if std::mem::replace(&mut found[first], true) {
            continue;
        }
        let (mut part, mut next) = (vec![first], 0);
        while let Some(&i) = part.get(next) {
            for (j, found) in found.iter_mut().enumerate() {
                if !*found && joined(i, j) {
                    *found = true;
                    part.push(j);
                }
            }
            next += 1;
        }
        part.sort_unstable();
        parts.push(part);
    }
    parts
}

/// `λ² + c λ + k = 0` of one coordinate.
fn single(at: usize, size: usize, k: f64, c: f64) -> Option<Vec<Eigenpair>> {
    let half = 0.5 * c;
    let under = k - half * half;
    let pair = |exponent: Complex, other: Complex| {
        let (mut shape, mut left) = (DVector::zeros(size), DVector::zeros(2 * size));
        shape[at] = 1.0.into();
        // (ξ, ξ̇) = c (1, λ) + c′ (1, λ′).
        (left[at], left[size + at]) = (-other / (exponent - other), Complex::from(1.0) / (exponent - other));
        Eigenpair { exponent, shape, left }
    };
    // The condition of the two vectors is about |λ|/|λ − λ′|.
    if k == 0.0 || under.abs().sqrt() * WORST_CONDITION < k.sqrt().max(half) {
        return None;
    }
    if under > 0.0 {
        let exponent = Complex::new(-half, under.sqrt());
        return Some(vec![pair(exponent, exponent.conj())]);
    }
    let root = (-under).sqrt();
    let fast = -half - root;
    let [slow, fast] = [k / fast, fast].map(Complex::from);
    Some(vec![pair(slow, fast), pair(fast, slow)])
}

/// A part of several coordinates.
fn coupled(part: &[usize], stiffness: &DMatrix<f64>, damping: &DMatrix<f64>) -> Option<Vec<Eigenpair>> {
    let (n, size) = (part.len(), stiffness.nrows());
    let own = |m: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| m[(part[i], part[j])]);
    let factor = own(stiffness).cholesky()?.l();
    let mut matrix = DMatrix::zeros(2 * n, 2 * n);
    matrix.view_mut((0, n), (n, n)).copy_from(&factor.transpose());
    matrix.view_mut((n, 0), (n, n)).copy_from(&-&factor);
    matrix.view_mut((n, n), (n, n)).copy_from(&-own(damping));
    let (q, t) = Schur::try_new(matrix.map(Complex::from), f64::EPSILON, SWEEPS * 2 * n)?.unpack();
    let right = q * vectors(&t);
    let inverse = right.clone().try_inverse()?;
    let condition = right.norm() * inverse.norm() / (2 * n) as f64;
    if !condition.is_finite() || condition > WORST_CONDITION {
        return None;
    }
    let largest = t.diagonal().iter().map(|value| value.norm()).fold(0.0, f64::max);
    let mut pairs = Vec::with_capacity(n);
    for k in 0..2 * n {
        let mut exponent = t[(k, k)];
        if exponent.im.abs() <= REAL * largest {
            exponent.im = 0.0;
        }
        if exponent.im < 0.0 {
            continue;
        }
        let (mut shape, mut left) = (DVector::zeros(size), DVector::zeros(2 * size));
        // Rows of the inverse over (Lᵀξ, ξ̇), then over (ξ, ξ̇).
        for (i, &at) in part.iter().enumerate() {
            shape[at] = right[(n + i, k)] / exponent;
            left[at] = (0..n).map(|j| inverse[(k, j)] * factor[(i, j)]).sum();
            left[size + at] = inverse[(k, n + i)];
        }
        pairs.push(Eigenpair { exponent, shape, left });
    }
    // Conjugate pairs are complete.
    let count: usize = pairs.iter().map(|pair| if pair.exponent.im > 0.0 { 2 } else { 1 }).sum();
    (count == 2 * n && pairs.iter().all(|pair| pair.exponent != Complex::from(0.0))).then_some(pairs)
}

/// Eigenvectors of an upper triangular matrix, each of length 1.
fn vectors(t: &DMatrix<Complex>) -> DMatrix<Complex> {
    let n = t.nrows();
    let least = f64::EPSILON * t.norm();
    let mut all = DMatrix::zeros(n, n);
    for k in 0..n {
        let mut y = DVector::<Complex>::zeros(n);
        y[k] = 1.0.into();
        for i in (0..k).rev() {
            let sum: Complex = (i + 1..=k).map(|j| t[(i, j)] * y[j]).sum();
            let apart = t[(i, i)] - t[(k, k)];
            y[i] = -sum / if apart.norm() < least { Complex::from(least) } else { apart };
        }
        let length = y.norm();
        all.set_column(k, &(y / Complex::from(length)));
    }
    all
}
