//! Modes of a free beam in space: those along the axis and in plan of [`Modes`], and those of vertical bending and torsion, which the
//! inertia of oblique sections couples.

use glam::{DMat3, DVec3};
use nalgebra::{DMatrix, SymmetricEigen};

use super::fields::Fields;
use super::legendre::{derivative_product, half_product, square, values};
use super::modes::Modes;
use super::space_beam::SpaceBeam;

/// Elastic modes of unit modal mass, orthogonal in mass to all rigid motions.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceModes {
    /// The beam.
    pub beam: SpaceBeam,
    /// Degree n of the polynomials of u, v, w and ψ; `φ_y` and `φ_z` have one less.
    pub degree: usize,
    all: Vec<Mode>,
}

#[derive(Clone, Debug, PartialEq)]
struct Mode {
    omega: f64,
    /// Coefficients of `P_k`.
    coefficients: Vec<Fields>,
}

/// A field of vertical bending and torsion.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Field {
    /// w, upwards.
    Up,
    /// `φ_y`, about the axis across.
    Pitch,
    /// ψ, about the axis along.
    Roll,
}

/// A coordinate of the space: coefficients of some polynomials.
type Shape = Vec<(Field, usize, f64)>;

impl SpaceModes {
    /// Of a beam with polynomials of this degree, at least 2: `6n − 2` of them in order of frequency.
    pub fn of(beam: SpaceBeam, degree: usize) -> Self {
        let plan = Modes::of(beam.plan, degree);
        let n = plan.degree;
        let in_plan = |j: usize| {
            let coefficients = plan.coefficients(j).iter().map(|c| Fields::plane(*c)).collect();
            Mode { omega: plan.omega(j), coefficients }
        };
        let mut all: Vec<Mode> = (0..plan.count()).map(in_plan).collect();
        all.extend(blocks(&beam, n).iter().flat_map(|block| solve(&beam, n, block)));
        all.sort_by(|a, b| a.omega.total_cmp(&b.omega));
        Self { beam, degree: n, all }
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

    /// Coefficients of `P_k` of mode j.
    pub fn coefficients(&self, j: usize) -> &[Fields] {
        &self.all[j].coefficients
    }

    /// Motion of the section at ξ = 2s/a0 in every mode \[1/√kg, 1/(m√kg)\].
    pub fn section(&self, xi: f64) -> Vec<Fields> {
        let p = values(self.degree, xi);
        let at = |mode: &Mode| mode.coefficients.iter().zip(&p).map(|(c, p)| *c * *p).sum();
        self.all.iter().map(at).collect()
    }

    /// Displacement of a point in every mode: of the section at ξ, at the offset `r` from its centre.
    pub fn point(&self, xi: f64, r: DVec3) -> Vec<DVec3> {
        self.section(xi).into_iter().map(|fields| fields.displacement(r)).collect()
    }

    /// Elastic flexibility `F = Σ φ_j φ_jᵀ/ω_j²` of a point whose displacements in the modes are `point` \[m/N\].
    pub fn flexibility(&self, point: &[DVec3]) -> DMat3 {
        let outer = |d: &DVec3, omega: f64| DMat3::from_cols(*d * d.x, *d * d.y, *d * d.z) * (1.0 / (omega * omega));
        point.iter().zip(self.frequencies()).fold(DMat3::ZERO, |sum, (d, omega)| sum + outer(d, omega))
    }
}

/// The space of w, `φ_y` and ψ without rigid motions, in parts that neither mass nor stiffness couples: w by the parity of its polynomials
/// with those of `φ_y` that are its derivatives; ψ with the `φ_y` of its own parity, or alone where the sections are square to the axis.
fn blocks(beam: &SpaceBeam, n: usize) -> Vec<Vec<Shape>> {
    let one = |field: Field, k: usize| vec![(field, k, 1.0)];
    let coupling = beam.rotary.x_axis.y;
    let mut blocks = Vec::new();
    for parity in [0, 1] {
        let up = (2..=n).filter(|k| k % 2 == parity).map(|k| one(Field::Up, k));
        let pitch = (1..n).filter(|k| k % 2 != parity).map(|k| one(Field::Pitch, k));
        let roll: Vec<Shape> = (1..=n).filter(|k| k % 2 != parity).map(|k| one(Field::Roll, k)).collect();
        let bend = up.chain(pitch).chain((parity == 1).then(|| slant(beam)));
        if coupling == 0.0 {
            blocks.push(bend.collect());
            blocks.push(roll);
        } else {
            blocks.push(bend.chain(roll).collect());
        }
    }
    blocks.retain(|block| !block.is_empty());
    blocks
}

/// Mean axes: of ψ₀, `φ_y0` and `w₁` only what has no moment of momentum about the axis (roll ψ = 1) nor across it (pitch `φ_y` = 1, w = −s).
fn slant(beam: &SpaceBeam) -> Shape {
    let DMat3 { x_axis, y_axis, .. } = beam.rotary;
    let sixth = beam.plan.length / 6.0;
    vec![
        (Field::Up, 1, y_axis.y - x_axis.y * x_axis.y / x_axis.x),
        (Field::Pitch, 0, sixth),
        (Field::Roll, 0, -sixth * x_axis.y / x_axis.x),
    ]
}

/// Modes of one part: of `K x = ω² M x` with the mass as `L Lᵀ`.
fn solve(beam: &SpaceBeam, n: usize, block: &[Shape]) -> Vec<Mode> {
    let sum = |i: usize, j: usize, of: &dyn Fn(Entry, Entry) -> f64| {
        let pairs =
            block[i].iter().flat_map(|&(f, k, a)| block[j].iter().map(move |&(g, l, b)| ((f, k), (g, l), a * b)));
        pairs.map(|(one, other, factor)| factor * of(one, other)).sum::<f64>()
    };
    let mass = |i: usize, j: usize| sum(i, j, &|one, other| inertia(beam, one, other));
    let root: Vec<f64> = (0..block.len()).map(|i| mass(i, i).sqrt()).collect();
    let scaled = |of: &dyn Fn(usize, usize) -> f64| {
        DMatrix::from_fn(block.len(), block.len(), |i, j| of(i, j) / (root[i] * root[j]))
    };
    let stiff = scaled(&|i, j| sum(i, j, &|one, other| stiffness(beam, one, other)));
    // The coupling of sections thinner than 1e-8 of their width, which rounding makes indefinite, is left out.
    let lower = scaled(&mass).cholesky().map_or_else(|| DMatrix::identity(block.len(), block.len()), |c| c.l());
    let half = lower.solve_lower_triangular(&stiff).unwrap_or_else(|| stiff.clone());
    let reduced = lower.solve_lower_triangular(&half.transpose()).unwrap_or(half);
    let eigen = SymmetricEigen::new(0.5 * (&reduced + reduced.transpose()));
    let vectors = lower.tr_solve_lower_triangular(&eigen.eigenvectors).unwrap_or_else(|| eigen.eigenvectors.clone());
    let mode = |j: usize| {
        let mut coefficients = vec![Fields::default(); n + 1];
        for (i, shape) in block.iter().enumerate() {
            for &(field, k, c) in shape {
                *field.of(&mut coefficients[k]) += c * vectors[(i, j)] / root[i];
            }
        }
        // The +x end goes up, or turns to the positive side.
        let end: Fields = coefficients.iter().copied().sum();
        let sign = if end.moved.z + end.turned.x < 0.0 { -1.0 } else { 1.0 };
        for c in &mut coefficients {
            *c = *c * sign;
        }
        Mode { omega: eigen.eigenvalues[j].max(0.0).sqrt(), coefficients }
    };
    (0..block.len()).map(mode).collect()
}

/// A polynomial of a field.
type Entry = (Field, usize);

impl Field {
    fn of(self, fields: &mut Fields) -> &mut f64 {
        match self {
            Self::Up => &mut fields.moved.z,
            Self::Pitch => &mut fields.turned.y,
            Self::Roll => &mut fields.turned.x,
        }
    }
}

/// Entry of the mass matrix: `m/(2k + 1)`, of φ times J.
fn inertia(beam: &SpaceBeam, (one, j): Entry, (other, k): Entry) -> f64 {
    if j != k {
        return 0.0;
    }
    let rotary = &beam.rotary;
    let factor = match (one, other) {
        (Field::Up, Field::Up) => 1.0,
        (Field::Pitch, Field::Pitch) => rotary.y_axis.y,
        (Field::Roll, Field::Roll) => rotary.x_axis.x,
        (Field::Roll, Field::Pitch) | (Field::Pitch, Field::Roll) => rotary.x_axis.y,
        (Field::Up, _) | (_, Field::Up) => 0.0,
    };
    0.5 * beam.plan.mass * square(k) * factor
}

/// Entry of the stiffness matrix of `E I_y φ_y'² + k_s G A (w' + φ_y)² + G J_t ψ'²`.
fn stiffness(beam: &SpaceBeam, (one, j): Entry, (other, k): Entry) -> f64 {
    let per_length = 2.0 / beam.plan.length;
    match (one, other) {
        (Field::Up, Field::Up) => beam.shear * per_length * derivative_product(j, k),
        (Field::Pitch, Field::Pitch) => {
            let sheared = if j == k { beam.shear / per_length * square(k) } else { 0.0 };
            beam.bending * per_length * derivative_product(j, k) + sheared
        }
        (Field::Up, Field::Pitch) => beam.shear * half_product(j, k),
        (Field::Pitch, Field::Up) => beam.shear * half_product(k, j),
        (Field::Roll, Field::Roll) => beam.torsion * per_length * derivative_product(j, k),
        (Field::Roll, _) | (_, Field::Roll) => 0.0,
    }
}

#[cfg(test)]
pub(in crate::dynamics) mod tests;
