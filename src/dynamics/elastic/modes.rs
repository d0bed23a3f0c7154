//! Modes of a free beam in the space of Legendre polynomials, (F4): all of them, in mean axes.
//!
//! The upper ones are no frequencies of a beam; they hold the static remainder of the flexibility of its ends.

use glam::{DMat2, DVec2, DVec3};
use nalgebra::{DMatrix, SymmetricEigen};

use super::beam::Beam;
use super::legendre::{derivative_product, half_product, square, values};

/// Elastic modes of unit modal mass, orthogonal in mass to translation and rotation.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// The beam.
    pub beam: Beam,
    /// Degree n of the polynomials of u and v; φ has one less.
    pub degree: usize,
    all: Vec<Mode>,
}

#[derive(Clone, Debug, PartialEq)]
struct Mode {
    omega: f64,
    /// Coefficients of `P_k` in u, v, φ.
    coefficients: Vec<DVec3>,
}

/// A field of the section's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Field {
    /// u, along the axis.
    Along,
    /// v, across it.
    Across,
    /// φ, turn of the section.
    Turn,
}

/// A coordinate of the space: coefficients of some polynomials.
type Shape = Vec<(Field, usize, f64)>;

impl Modes {
    /// Of a beam with polynomials of this degree, at least 2: `3n − 1` of them in order of frequency.
    pub fn of(beam: Beam, degree: usize) -> Self {
        let n = degree.max(2);
        let mut modes: Vec<Mode> = blocks(&beam, n).iter().flat_map(|block| solve(&beam, n, block)).collect();
        modes.sort_by(|a, b| a.omega.total_cmp(&b.omega));
        Self { beam, degree: n, all: modes }
    }

    /// Number of modes, `N_e`.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// Circular frequency of mode j \[rad/s\].
    pub fn omega(&self, j: usize) -> f64 {
        self.all[j].omega
    }

    /// Circular frequencies, rising \[rad/s\].
    pub fn frequencies(&self) -> impl DoubleEndedIterator<Item = f64> + '_ {
        self.all.iter().map(|mode| mode.omega)
    }

    /// Coefficients of `P_k` in u, v, φ of mode j.
    pub fn coefficients(&self, j: usize) -> &[DVec3] {
        &self.all[j].coefficients
    }

    /// u, v, φ of every mode at the section ξ = 2s/a0 \[1/√kg, 1/(m√kg)\].
    pub fn section(&self, xi: f64) -> Vec<DVec3> {
        let p = values(self.degree, xi);
        let at = |mode: &Mode| mode.coefficients.iter().zip(&p).map(|(c, p)| *c * *p).sum();
        self.all.iter().map(at).collect()
    }

    /// Displacement (F1) of a point in every mode: of the section at ξ, at the offset `r` from its centre.
    pub fn point(&self, xi: f64, r: DVec2) -> Vec<DVec2> {
        self.section(xi).into_iter().map(|field| displacement(field, r)).collect()
    }

    /// Elastic flexibility `F = Σ φ_j φ_jᵀ/ω_j²` of a point whose displacements in the modes are `point` \[m/N\].
    pub fn flexibility(&self, point: &[DVec2]) -> DMat2 {
        let outer = |d: &DVec2, omega: f64| DMat2::from_cols(*d * d.x, *d * d.y) * (1.0 / (omega * omega));
        point.iter().zip(self.frequencies()).fold(DMat2::ZERO, |sum, (d, omega)| sum + outer(d, omega))
    }
}

/// `(u − φ r_y, v + φ r_x)`, (F1).
pub fn displacement(field: DVec3, r: DVec2) -> DVec2 {
    field.truncate() + r.perp() * field.z
}

/// The space without rigid motions, in parts that neither mass nor stiffness couples: u and v by the parity of their
/// polynomials, φ with those of v that are its own derivatives.
fn blocks(beam: &Beam, n: usize) -> [Vec<Shape>; 4] {
    let one = |field: Field, k: usize| vec![(field, k, 1.0)];
    let along = |parity: usize| (1..=n).filter(|k| k % 2 == parity).map(|k| one(Field::Along, k)).collect();
    let bend = |parity: usize| {
        let across = (2..=n).filter(|k| k % 2 == parity).map(|k| one(Field::Across, k));
        let turn = (1..n).filter(|k| k % 2 != parity).map(|k| one(Field::Turn, k));
        // Mean axes: of v₁ and φ₀ only what has no moment of momentum.
        let slant = vec![(Field::Across, 1, -beam.rotary), (Field::Turn, 0, beam.length / 6.0)];
        across.chain(turn).chain((parity == 1).then_some(slant)).collect()
    };
    [along(0), along(1), bend(0), bend(1)]
}

/// Modes of one part.
fn solve(beam: &Beam, n: usize, block: &[Shape]) -> Vec<Mode> {
    let mass = |shape: &Shape| shape.iter().map(|&(field, k, c)| inertia(beam, field, k) * c * c).sum::<f64>();
    let root: Vec<f64> = block.iter().map(|shape| mass(shape).sqrt()).collect();
    let entry = |i: usize, j: usize| {
        let products = block[i]
            .iter()
            .flat_map(|&(f, k, a)| block[j].iter().map(move |&(g, l, b)| a * b * stiffness(beam, (f, k), (g, l))));
        products.sum::<f64>() / (root[i] * root[j])
    };
    let eigen = SymmetricEigen::new(DMatrix::from_fn(block.len(), block.len(), entry));
    let mode = |j: usize| {
        let mut coefficients = vec![DVec3::ZERO; n + 1];
        for (i, shape) in block.iter().enumerate() {
            let weight = eigen.eigenvectors[(i, j)] / root[i];
            for &(field, k, c) in shape {
                coefficients[k][field as usize] += weight * c;
            }
        }
        // The +x end goes to the positive side.
        let end: DVec3 = coefficients.iter().sum();
        let sign = if end.x + end.y < 0.0 { -1.0 } else { 1.0 };
        for c in &mut coefficients {
            *c *= sign;
        }
        Mode { omega: eigen.eigenvalues[j].max(0.0).sqrt(), coefficients }
    };
    (0..block.len()).map(mode).collect()
}

/// Mass of `P_k` in a field: `m/(2k + 1)`, of φ times `J_z`.
fn inertia(beam: &Beam, field: Field, k: usize) -> f64 {
    let own = 0.5 * beam.mass * square(k);
    if field == Field::Turn { own * beam.rotary } else { own }
}

/// Entry of the stiffness matrix (F4).
fn stiffness(beam: &Beam, (one, j): (Field, usize), (other, k): (Field, usize)) -> f64 {
    let per_length = 2.0 / beam.length;
    match (one, other) {
        (Field::Along, Field::Along) => beam.axial * per_length * derivative_product(j, k),
        (Field::Across, Field::Across) => beam.shear * per_length * derivative_product(j, k),
        (Field::Turn, Field::Turn) => {
            let sheared = if j == k { beam.shear / per_length * square(k) } else { 0.0 };
            beam.bending * per_length * derivative_product(j, k) + sheared
        }
        (Field::Across, Field::Turn) => -beam.shear * half_product(j, k),
        (Field::Turn, Field::Across) => -beam.shear * half_product(k, j),
        (Field::Along, _) | (_, Field::Along) => 0.0,
    }
}

#[cfg(test)]
pub(super) mod tests;
