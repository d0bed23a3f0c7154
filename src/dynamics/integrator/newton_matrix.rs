//! The linear systems of an implicit step: `(s − J) x = r` for the shifts `s = λ/h` of the method's matrix.
//!
//! Positions of a mechanical system obey `ṗ = B v`. Eliminated by hand, they halve the system: with the displacements
//! `u`, `p = B u`, the velocities obey `(s − D − K/s) v = r_v + K B⁺ r_p / s`, and `p = (r_p + B v)/s`. The
//! derivative of `B` by the positions is left out of the Jacobian: attitudes turn slowly against a step.

use std::ops::Range;

use num_complex::Complex64;

use crate::dynamics::integrator::dense_lu::{Lu, Scalar};
use crate::dynamics::integrator::radau_tableau::{
    COMPLEX, COMPLEX_LEFT, COMPLEX_RIGHT, PAIRS, REAL, REAL_LEFT, REAL_RIGHT,
};
use crate::dynamics::integrator::system::{ImplicitSystem, PositionBlock};

/// An entry of `B`: a position component moved by a velocity.
#[derive(Clone, Copy, Debug)]
struct PositionRate {
    /// Index of the position component in the state.
    place: usize,
    /// Index of the velocity among the unknowns.
    speed: usize,
    value: f64,
}

/// Jacobian of a system after the elimination of its positions.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Jacobian {
    blocks: Vec<PositionBlock>,
    /// Components of the state that are unknowns.
    speeds: Vec<usize>,
    /// Components of the state that are eliminated.
    places: Vec<usize>,
    carry: Vec<PositionRate>,
    /// `|B_j|⁻²` for each velocity; 0 for one that moves no position.
    inverse: Vec<f64>,
    damping: Vec<f64>,
    stiffness: Vec<f64>,
}

impl Jacobian {
    /// Number of unknowns.
    pub(in crate::dynamics) fn size(&self) -> usize {
        self.speeds.len()
    }

    /// Numbers the unknowns among `n` components, with zero matrices.
    pub(in crate::dynamics) fn number(&mut self, system: &impl ImplicitSystem, n: usize) {
        self.blocks.clear();
        self.blocks.extend(system.position_blocks());
        if self.blocks.is_empty() {
            self.blocks.push(PositionBlock { from: 0, velocities: 0, until: n });
        }
        self.speeds.clear();
        self.speeds.extend(self.blocks.iter().flat_map(|block| block.velocities..block.until));
        self.places.clear();
        self.places.extend(self.blocks.iter().flat_map(|block| block.from..block.velocities));
        let m = self.size();
        self.carry.clear();
        self.inverse.clear();
        self.inverse.resize(m, 0.0);
        for matrix in [&mut self.damping, &mut self.stiffness] {
            matrix.clear();
            matrix.resize(m * m, 0.0);
        }
    }

    /// Evaluates the Jacobian of the numbered unknowns by difference quotients at `(t, y)` with slope `slope`; each
    /// unknown, and then each displacement, is changed by the root of the machine epsilon times its scale.
    pub(in crate::dynamics) fn differentiate(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        [y, slope]: [&[f64]; 2],
        [state, moved]: [&mut [f64]; 2],
    ) {
        let (m, small) = (self.size(), f64::EPSILON.sqrt());
        let mut block = 0;
        state.copy_from_slice(y);
        for j in 0..m {
            let at = self.speeds[j];
            state[at] = y[at] + small * system.increment_scale(at, y[at]);
            let step = state[at] - y[at];
            system.slope(t, state, moved);
            let change = |i: usize| (moved[i] - slope[i]) / step;
            for (i, &to) in self.speeds.iter().enumerate() {
                self.damping[i * m + j] = change(to);
            }
            while at >= self.blocks[block].until {
                block += 1;
            }
            let PositionBlock { from, velocities, .. } = self.blocks[block];
            let carried = (from..velocities).map(|place| PositionRate { place, speed: j, value: change(place) });
            self.carry.extend(carried.filter(|c| c.value != 0.0));
            state[at] = y[at];
        }
        self.carry.iter().for_each(|c| self.inverse[c.speed] += c.value * c.value);
        self.inverse.iter_mut().filter(|i| **i > 0.0).for_each(|i| *i = i.recip());
        let mut from = 0;
        while from < self.carry.len() {
            let speed = self.carry[from].speed;
            let until = self.carry[from..].iter().position(|c| c.speed != speed).map_or(self.carry.len(), |k| from + k);
            self.displace(system, t, [y, slope], [state, moved], from..until);
            from = until;
        }
    }

    /// Column of the stiffness for the displacement with these entries of `B`.
    fn displace(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        [y, slope]: [&[f64]; 2],
        [state, moved]: [&mut [f64]; 2],
        entries: Range<usize>,
    ) {
        let (m, entries) = (self.size(), &self.carry[entries]);
        let Some(largest) = entries.iter().max_by(|a, b| a.value.abs().total_cmp(&b.value.abs())) else { return };
        let (j, length2) = (largest.speed, self.inverse[largest.speed]);
        let step = f64::EPSILON.sqrt() * system.increment_scale(largest.place, y[largest.place]) * length2.sqrt();
        let mut gone = 0.0;
        for c in entries {
            state[c.place] = y[c.place] + step * c.value;
            gone += length2 * c.value * (state[c.place] - y[c.place]);
        }
        system.slope(t, state, moved);
        for (i, &to) in self.speeds.iter().enumerate() {
            self.stiffness[i * m + j] = (moved[to] - slope[to]) / gone;
        }
        for c in entries {
            state[c.place] = y[c.place];
        }
    }

    /// Writes `J x` to `out`.
    pub(in crate::dynamics) fn times(&self, x: &[f64], out: &mut [f64]) {
        let m = self.size();
        out.fill(0.0);
        let mut displacement = vec![0.0; m];
        for c in &self.carry {
            out[c.place] += c.value * x[self.speeds[c.speed]];
            displacement[c.speed] += self.inverse[c.speed] * c.value * x[c.place];
        }
        for (i, &to) in self.speeds.iter().enumerate() {
            let damping = self.damping[i * m..(i + 1) * m].iter().zip(&self.speeds).map(|(d, &at)| d * x[at]);
            let stiffness = self.stiffness[i * m..(i + 1) * m].iter().zip(&displacement).map(|(k, u)| k * u);
            out[to] = damping.chain(stiffness).sum();
        }
    }

    /// Components of a vector that are unknowns.
    pub(in crate::dynamics) fn gather(&self, from: &[f64]) -> impl Iterator<Item = f64> {
        self.speeds.iter().map(|&i| from[i])
    }
}

/// A factored stage system for one shift.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct NewtonMatrix<T> {
    lu: Lu<T>,
    /// `1/s`.
    inverse: T,
    right: Vec<T>,
    /// Velocities of the solution.
    pub found: Vec<T>,
}

impl<T: Scalar> NewtonMatrix<T> {
    /// Factors the system for the shift `s`; `false` for a singular one.
    pub(in crate::dynamics) fn factor(&mut self, linear: &Jacobian, s: T) -> bool {
        let (m, inverse) = (linear.size(), s.recip());
        self.inverse = inverse;
        self.found.resize(m, T::ZERO);
        let held = linear.carry.is_empty();
        self.lu.factor(m, |i, j| {
            let own = if i == j { s } else { T::ZERO };
            let (damping, stiffness) = (linear.damping[i * m + j], linear.stiffness[i * m + j]);
            if held { own.less(damping) } else { own.less(damping) - inverse * stiffness }
        })
    }

    /// Solves for the velocities with the right-hand side `r`.
    pub(in crate::dynamics) fn solve(&mut self, linear: &Jacobian, r: &[T]) {
        let m = linear.size();
        self.right.clear();
        self.right.resize(2 * m, T::ZERO);
        let (right, displacement) = self.right.split_at_mut(m);
        right.iter_mut().zip(&linear.speeds).for_each(|(to, &from)| *to = r[from]);
        if !linear.carry.is_empty() {
            for c in &linear.carry {
                displacement[c.speed] += r[c.place] * (linear.inverse[c.speed] * c.value);
            }
            for d in displacement.iter_mut() {
                *d = *d * self.inverse;
            }
            for (to, row) in right.iter_mut().zip(linear.stiffness.chunks_exact(m)) {
                row.iter().zip(displacement.iter()).for_each(|(k, u)| *to += *u * *k);
            }
        }
        self.lu.solve(right, &mut self.found);
    }

    /// Replaces the right-hand side `r` by the full solution, from the velocities.
    pub(in crate::dynamics) fn complete(&self, linear: &Jacobian, r: &mut [T]) {
        for (speed, &at) in self.found.iter().zip(&linear.speeds) {
            r[at] = *speed;
        }
        // Every eliminated component is its residual divided by the shift.
        for &place in &linear.places {
            r[place] = r[place] * self.inverse;
        }
        for c in &linear.carry {
            r[c.place] += self.found[c.speed] * self.inverse * c.value;
        }
    }

    /// Velocities of the solution for a right-hand side in the velocities alone.
    pub(in crate::dynamics) fn respond(&self, right: &[T], out: &mut [T]) {
        self.lu.solve(right, out);
    }
}

/// Stage systems of a step in the eigenvectors of the method's matrix: a real one, and a complex one for every two
/// further stages.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct StageSystems {
    /// Jacobian of the system.
    pub linear: Jacobian,
    /// Stage system of the real eigenvalue.
    pub real: NewtonMatrix<f64>,
    /// Stage systems of the complex eigenvalues.
    pub complex: [NewtonMatrix<Complex64>; PAIRS],
    right: Vec<f64>,
    rights: [Vec<Complex64>; PAIRS],
}

impl StageSystems {
    /// Factors the systems for a step of length `h`; `false` for a singular one.
    pub(in crate::dynamics) fn factor(&mut self, h: f64) -> bool {
        let mut done = self.real.factor(&self.linear, REAL / h);
        for (system, (re, im)) in self.complex.iter_mut().zip(COMPLEX) {
            done &= system.factor(&self.linear, Complex64::new(re, im) * h.recip());
        }
        done
    }

    /// Solves for the velocities of a Newton correction from slopes and increments of the stages, with `leading` of
    /// `width` components per stage.
    pub(in crate::dynamics) fn project(&mut self, h: f64, [slopes, stages]: [&[f64]; 2], [width, leading]: [usize; 2]) {
        let rows = || slopes.chunks_exact(width).zip(stages.chunks_exact(width));
        self.right.clear();
        self.right.resize(leading, 0.0);
        for (left, (slopes, stages)) in REAL_LEFT.iter().zip(rows()) {
            let value = REAL / h;
            self.right.iter_mut().zip(slopes).zip(stages).for_each(|((r, f), z)| *r += left * (f - value * z));
        }
        self.real.solve(&self.linear, &self.right);
        for (m, (right, system)) in self.rights.iter_mut().zip(&mut self.complex).enumerate() {
            right.clear();
            right.resize(leading, Complex64::ZERO);
            let (re, im) = (COMPLEX[m].0 / h, COMPLEX[m].1 / h);
            for (&(a, b), (slopes, stages)) in COMPLEX_LEFT[m].iter().zip(rows()) {
                for ((r, f), z) in right.iter_mut().zip(slopes).zip(stages) {
                    let (x, y) = (f - re * z, im * z);
                    r.re += a * x + b * y;
                    r.im += b * x - a * y;
                }
            }
            system.solve(&self.linear, right);
        }
    }

    /// Writes the correction of the stages, `width` components each, from the velocities found.
    pub(in crate::dynamics) fn expand(&mut self, correction: &mut [f64], width: usize) {
        self.real.complete(&self.linear, &mut self.right);
        for (right, system) in self.rights.iter_mut().zip(&self.complex) {
            system.complete(&self.linear, right);
        }
        for (k, row) in correction.chunks_exact_mut(width).enumerate() {
            let weight = REAL_RIGHT[k];
            row.iter_mut().zip(&self.right).for_each(|(d, w)| *d = weight * w);
            for (right, found) in COMPLEX_RIGHT.iter().zip(&self.rights) {
                // The conjugate eigenvector adds the complex conjugate.
                let (a, b) = (2.0 * right[k].0, 2.0 * right[k].1);
                row.iter_mut().zip(found).for_each(|(d, w)| *d += a * w.re - b * w.im);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::integrator::system::System;

    /// Two oscillators coupled by linear springs and dashpots: blocks of one position and one velocity.
    struct Springs;

    const STIFFNESS_MATRIX: [[f64; 2]; 2] = [[30.0, -8.0], [-8.0, 20.0]];
    const DAMPING_MATRIX: [[f64; 2]; 2] = [[0.5, -0.2], [-0.1, 0.9]];
    /// Factors of `ṗ = B v`.
    const B: [f64; 2] = [1.0, 2.0];

    impl System for Springs {
        fn slope(&mut self, _: f64, y: &[f64], out: &mut [f64]) {
            for i in 0..2 {
                out[2 * i] = B[i] * y[2 * i + 1];
                out[2 * i + 1] =
                    (0..2).map(|j| -STIFFNESS_MATRIX[i][j] * y[2 * j] - DAMPING_MATRIX[i][j] * y[2 * j + 1]).sum();
            }
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d.iter().map(|x| x * x).sum()
        }
    }

    impl ImplicitSystem for Springs {
        fn position_blocks(&self) -> impl Iterator<Item = PositionBlock> {
            [0, 2].into_iter().map(|from| PositionBlock { from, velocities: from + 1, until: from + 2 })
        }
    }

    fn jacobian() -> Jacobian {
        let (mut linear, y) = (Jacobian::default(), [0.3, -0.2, 0.1, 0.4]);
        let (mut slope, mut state, mut moved) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        Springs.slope(0.0, &y, &mut slope);
        linear.number(&Springs, 4);
        linear.differentiate(&mut Springs, 0.0, [&y, &slope], [&mut state, &mut moved]);
        linear
    }

    #[test]
    fn the_jacobian_multiplies_as_the_equations_say() {
        let (linear, x) = (jacobian(), [0.7, -0.5, -0.3, 0.9]);
        let (mut product, mut wanted) = ([0.0; 4], [0.0; 4]);
        linear.times(&x, &mut product);
        Springs.slope(0.0, &x, &mut wanted);
        assert_eq!(linear.size(), 2, "velocities are the unknowns");
        // Difference quotients of a linear function err by round-off over the increment, the root of the machine
        // epsilon.
        (0..4).for_each(|i| assert!((product[i] - wanted[i]).abs() < 1e-6, "{product:?} against {wanted:?}"));
    }

    #[test]
    fn the_eliminated_system_solves_the_whole_one() {
        let (linear, r) = (jacobian(), [0.4, -1.0, 0.2, 0.6]);
        let (mut real, mut x) = (NewtonMatrix::<f64>::default(), r);
        assert!(real.factor(&linear, 3.0), "regular");
        real.solve(&linear, &x);
        real.complete(&linear, &mut x);
        let mut product = [0.0; 4];
        linear.times(&x, &mut product);
        (0..4).for_each(|i| assert!((3.0 * x[i] - product[i] - r[i]).abs() < 1e-14, "(s − J) x = r, component {i}"));
        let shift = Complex64::new(2.0, 5.0);
        let (mut complex, mut z) = (NewtonMatrix::<Complex64>::default(), r.map(|x| Complex64::new(x, -0.5 * x)));
        let right = z;
        assert!(complex.factor(&linear, shift), "regular");
        complex.solve(&linear, &right);
        complex.complete(&linear, &mut z);
        let parts = [z.map(|z| z.re), z.map(|z| z.im)].map(|part| {
            let mut product = [0.0; 4];
            linear.times(&part, &mut product);
            product
        });
        for i in 0..4 {
            let left = shift * z[i] - Complex64::new(parts[0][i], parts[1][i]) - right[i];
            assert!(left.norm() < 1e-14, "complex, component {i}: {left}");
        }
    }
}
