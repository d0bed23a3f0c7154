//! Low-rank correction of the Newton matrix of an implicit step: forces of sliding in two directions, which turn
//! within a step faster than one Jacobian can follow.
//!
//! A port of the system ([`ImplicitSystem::port`]) has two components of force and two of velocity. Rank-one terms
//! give, at every stage, the derivative of the force by the velocity: directly (friction along a velocity that
//! turns), or through an auxiliary component (a slip angle). The Newton equations of the stages are those of the
//! frozen Jacobian plus a correction whose rank is the number of terms times that of stages; the
//! Sherman–Morrison–Woodbury formula solves both coupled, so that neither needs to be slow against the other.

use glam::DVec2;
use num_complex::Complex64;

use crate::dynamics::integrator::dense_lu;
use crate::dynamics::integrator::dense_lu::Lu;
use crate::dynamics::integrator::newton_matrix::{Jacobian, NewtonMatrix, StageSystems};
use crate::dynamics::integrator::radau_tableau::{
    COMPLEX_LEFT, COMPLEX_RIGHT, INVERSE, PAIRS, REAL_LEFT, REAL_RIGHT, STAGES,
};
use crate::dynamics::integrator::system::{ImplicitSystem, RankOneTerm};

/// Ports of a system with the responses of the factored matrices to their forces, and the rank-one terms of all
/// stages. Forces act on velocities and outputs are taken from velocities, the unknowns of [`Jacobian`].
#[derive(Debug, Default)]
pub(in crate::dynamics) struct LowRankCorrection {
    ports: usize,
    size: usize,
    /// Whether auxiliary components are solved coupled with the leading ones; separately while they are slow against
    /// these.
    coupled: bool,
    /// Rates of the velocities per unit of force: columns of `B`, two per port.
    input_columns: Vec<f64>,
    /// Outputs per unit of the velocities: rows of `W`, two per port.
    output_rows: Vec<f64>,
    /// Responses of the factored stage systems to these columns.
    real: Vec<f64>,
    complex: [Vec<Complex64>; PAIRS],
    /// Outputs at one stage per unit of force at another, `W (s − J)⁻¹ B` in the basis of the stages:
    /// `[stage][stage][row][column]`.
    between: Vec<f64>,
    /// Outputs per unit of force in the real stage system, `W (s − J)⁻¹ B`, and `W B`: `[row][column]`.
    within: Vec<f64>,
    at_once: Vec<f64>,
    terms: [Vec<RankOneTerm>; STAGES],
    /// Indices of the terms that are not zero; and these stage by stage, as `(stage, index among them, term)`.
    nonzero: Vec<usize>,
    unknowns: Vec<(usize, usize, RankOneTerm)>,
    lu: Lu<f64>,
    right: Vec<f64>,
    found: Vec<f64>,
    /// Outputs in the basis of the stage systems.
    outputs: Vec<f64>,
    complex_outputs: [Vec<Complex64>; PAIRS],
}

impl LowRankCorrection {
    /// Takes the ports of a system with `n` leading components at state `y`.
    pub(in crate::dynamics) fn gather(&mut self, system: &impl ImplicitSystem, linear: &Jacobian, y: &[f64], n: usize) {
        (self.ports, self.size) = (system.port_count(), linear.size());
        self.input_columns.clear();
        self.output_rows.clear();
        let (mut input, mut output) = (vec![0.0; 2 * n], vec![0.0; 2 * n]);
        for port in 0..self.ports {
            input.fill(0.0);
            output.fill(0.0);
            system.port(port, y, &mut input, &mut output);
            for column in 0..2 {
                self.input_columns.extend(linear.gather(&input[column * n..]));
                self.output_rows.extend(linear.gather(&output[column * n..]));
            }
        }
        product(&self.output_rows, &self.input_columns, self.size, &mut self.at_once);
    }

    /// Whether the terms are solved coupled with the leading components: always where a term acts without an
    /// auxiliary component.
    pub(in crate::dynamics) fn coupled(&mut self, system: &impl ImplicitSystem) -> bool {
        self.coupled |= system.auxiliary_count() < system.port_count();
        self.coupled
    }

    /// Solves auxiliary and leading components coupled from now on; whether that is a change.
    pub(in crate::dynamics) fn couple(&mut self, system: &impl ImplicitSystem) -> bool {
        system.port_count() > 0 && !std::mem::replace(&mut self.coupled, true)
    }

    /// Resets for another system.
    pub(in crate::dynamics) fn forget(&mut self) {
        (self.ports, self.coupled) = (0, false);
        self.terms.iter_mut().for_each(Vec::clear);
    }

    /// Computes the responses of the factored stage systems to forces at the ports.
    pub(in crate::dynamics) fn factor(&mut self, systems: &StageSystems) {
        let (n, columns) = (self.size, 2 * self.ports);
        if columns == 0 || !self.coupled {
            return;
        }
        self.real.resize(columns * n, 0.0);
        for (input, found) in self.input_columns.chunks_exact(n).zip(self.real.chunks_exact_mut(n)) {
            systems.real.respond(input, found);
        }
        product(&self.output_rows, &self.real, n, &mut self.within);
        let mut right = vec![Complex64::ZERO; n];
        self.between.clear();
        self.between.resize(STAGES * STAGES * columns * columns, 0.0);
        for (responses, system) in self.complex.iter_mut().zip(&systems.complex) {
            responses.resize(columns * n, Complex64::ZERO);
            for (input, found) in self.input_columns.chunks_exact(n).zip(responses.chunks_exact_mut(n)) {
                right.iter_mut().zip(input).for_each(|(r, p)| *r = Complex64::new(*p, 0.0));
                system.respond(&right, found);
            }
        }
        for (kernel, responses) in self.complex_outputs.iter_mut().zip(&self.complex) {
            product(&self.output_rows, responses, n, kernel);
        }
        for (kl, out) in self.between.chunks_exact_mut(columns * columns).enumerate() {
            let (k, l) = (kl / STAGES, kl % STAGES);
            let weight = REAL_RIGHT[k] * REAL_LEFT[l];
            out.iter_mut().zip(&self.within).for_each(|(o, r)| *o += weight * r);
            for (m, kernel) in self.complex_outputs.iter().enumerate() {
                let (a, b) = (COMPLEX_RIGHT[m][k], COMPLEX_LEFT[m][l]);
                let (re, im) = (2.0 * (a.0 * b.0 - a.1 * b.1), -2.0 * (a.0 * b.1 + a.1 * b.0));
                out.iter_mut().zip(kernel).for_each(|(o, z)| *o += re * z.re + im * z.im);
            }
        }
    }

    /// Stores the rank-one terms of a stage.
    pub(in crate::dynamics) fn record(&mut self, stage: usize, terms: &[RankOneTerm]) {
        self.terms[stage].clear();
        self.terms[stage].extend_from_slice(terms);
    }

    /// Completes a Newton correction of the stages, from the solutions of the frozen Jacobian in `systems`. `auxiliary`
    /// holds the residuals of the auxiliary components stage by stage, replaced by their corrections; `rate(stage,
    /// number)` is the derivative `∂ẏᵢ/∂yᵢ` of an auxiliary component. `false` for a singular correction.
    pub(in crate::dynamics) fn complete(
        &mut self,
        systems: &mut StageSystems,
        auxiliary: &mut [f64],
        h: f64,
        rate: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let width = auxiliary.len() / STAGES;
        self.nonzero.clear();
        let terms = &self.terms;
        let lives = |c: &usize| terms.iter().any(|stage| stage[*c].input != DVec2::ZERO);
        self.nonzero.extend((0..terms[0].len()).filter(|c| terms[0][*c].auxiliary.is_some() || lives(c)));
        let (count, columns) = (self.nonzero.len(), 2 * self.ports);
        if !self.coupled {
            return (0..width).all(|number| Self::separately(auxiliary, number, h, &rate));
        }
        if count == 0 {
            return true;
        }
        self.unknowns.clear();
        for (k, stage) in terms.iter().enumerate() {
            self.unknowns.extend(self.nonzero.iter().enumerate().map(|(c, &number)| (k, c, stage[number])));
        }
        let (between, unknowns) = (&self.between, &self.unknowns);
        let done = self.lu.factor(STAGES * count, |i, j| {
            let ((k, which, ref to), (l, other, ref from)) = (unknowns[i], unknowns[j]);
            let own = if which != other {
                0.0
            } else if let Some(number) = to.auxiliary {
                INVERSE[k][l] / h - if k == l { rate(k, number) } else { 0.0 }
            } else {
                f64::from(u8::from(k == l))
            };
            own - through(&between[(k * STAGES + l) * columns * columns..], columns, to, from)
        });
        if !done {
            return false;
        }
        product(&self.output_rows, &systems.real.found, self.size, &mut self.outputs);
        for (outputs, system) in self.complex_outputs.iter_mut().zip(&systems.complex) {
            product(&self.output_rows, &system.found, self.size, outputs);
        }
        self.right.clear();
        for &(k, _, to) in &self.unknowns {
            let left = to.auxiliary.map_or(0.0, |number| auxiliary[k * width + number]);
            let velocity = |row: usize| {
                let turning = self.complex_outputs.iter().zip(&COMPLEX_RIGHT);
                turning.fold(REAL_RIGHT[k] * self.outputs[row], |sum, (outputs, right)| {
                    sum + 2.0 * (right[k].0 * outputs[row].re - right[k].1 * outputs[row].im)
                })
            };
            self.right.push(left + to.output.x * velocity(2 * to.port) + to.output.y * velocity(2 * to.port + 1));
        }
        self.found.resize(STAGES * count, 0.0);
        self.lu.solve(&self.right, &mut self.found);
        for ((k, _, term), found) in self.unknowns.iter().zip(&self.found) {
            if let Some(number) = term.auxiliary {
                auxiliary[k * width + number] = *found;
            }
        }
        self.respond(systems);
        true
    }

    /// Correction of one auxiliary component at all stages, separately from the leading components.
    fn separately(auxiliary: &mut [f64], number: usize, h: f64, rate: impl Fn(usize, usize) -> f64) -> bool {
        let width = auxiliary.len() / STAGES;
        let mut rows = [[0.0; STAGES + 1]; STAGES];
        for (k, row) in rows.iter_mut().enumerate() {
            row.iter_mut().zip(INVERSE[k]).for_each(|(entry, a)| *entry = a / h);
            row[k] -= rate(k, number);
            row[STAGES] = auxiliary[k * width + number];
        }
        let found = dense_lu::eliminate(&mut rows);
        (0..STAGES).for_each(|k| auxiliary[k * width + number] = rows[k][STAGES]);
        found
    }

    /// Adds the response to the forces of the terms just found, at all stages.
    fn respond(&self, StageSystems { real, complex, .. }: &mut StageSystems) {
        let (n, count) = (self.size, self.nonzero.len());
        for column in 0..2 * self.ports {
            let mut forces = [0.0; STAGES];
            for (k, force) in forces.iter_mut().enumerate() {
                for (c, &number) in self.nonzero.iter().enumerate() {
                    let term = &self.terms[k][number];
                    if term.port == column / 2 {
                        *force += term.input[column % 2] * self.found[k * count + c];
                    }
                }
            }
            let range = column * n..(column + 1) * n;
            let sum = REAL_LEFT.iter().zip(&forces).map(|(left, force)| left * force).sum::<f64>();
            real.found.iter_mut().zip(&self.real[range.clone()]).for_each(|(d, r)| *d += sum * r);
            for ((system, responses), left) in complex.iter_mut().zip(&self.complex).zip(&COMPLEX_LEFT) {
                let sum: Complex64 = left.iter().zip(&forces).map(|(&(a, b), f)| Complex64::new(a, b) * *f).sum();
                system.found.iter_mut().zip(&responses[range.clone()]).for_each(|(d, r)| *d += sum * r);
            }
        }
    }

    /// Completes the filtered error estimate with the terms of the first stage, from the solution of the frozen
    /// Jacobian in the real system. `auxiliary` holds the right-hand sides of the auxiliary components, replaced by
    /// their solutions. `false` for a singular correction.
    pub(in crate::dynamics) fn filter(
        &mut self,
        shift: f64,
        real: &mut NewtonMatrix<f64>,
        auxiliary: &mut [f64],
        rate: impl Fn(usize) -> f64,
    ) -> bool {
        let (n, columns, count) = (self.size, 2 * self.ports, self.terms[0].len());
        if !self.coupled {
            auxiliary.iter_mut().enumerate().for_each(|(number, f)| *f /= shift - rate(number));
            return true;
        }
        if count == 0 {
            return true;
        }
        let (terms, within) = (&self.terms[0], &self.within);
        let own = |c: &RankOneTerm| c.auxiliary.map_or(1.0, |number| shift - rate(number));
        let done = self.lu.factor(count, |i, j| {
            let (to, from) = (&terms[i], &terms[j]);
            (if i == j { own(to) } else { 0.0 }) - through(within, columns, to, from)
        });
        if !done {
            return false;
        }
        product(&self.output_rows, &real.found, n, &mut self.outputs);
        self.right.clear();
        for to in terms {
            let left = to.auxiliary.map_or(0.0, |number| auxiliary[number]);
            self.right.push(left + to.output.dot(DVec2::from_slice(&self.outputs[2 * to.port..])));
        }
        self.found.resize(count, 0.0);
        self.lu.solve(&self.right, &mut self.found[..count]);
        for (term, carried) in terms.iter().zip(&self.found) {
            for (axis, force) in (term.input * *carried).to_array().into_iter().enumerate() {
                let column = &self.real[(2 * term.port + axis) * n..][..n];
                real.found.iter_mut().zip(column).for_each(|(d, r)| *d += force * r);
            }
            if let Some(number) = term.auxiliary {
                auxiliary[number] = *carried;
            }
        }
        true
    }

    /// Largest rate of a term of the first stage without an auxiliary component \[1/s\].
    pub(in crate::dynamics) fn fastest(&self) -> f64 {
        let columns = 2 * self.ports;
        let at_once = self.terms[0].iter().filter(|c| c.auxiliary.is_none());
        at_once.map(|c| through(&self.at_once, columns, c, c).abs()).fold(0.0, f64::max)
    }
}

/// Change of the output of term `to` per unit of term `from`, by outputs per unit of force `velocities`.
fn through(velocities: &[f64], columns: usize, to: &RankOneTerm, from: &RankOneTerm) -> f64 {
    let entry = |row: usize, column: usize| velocities[(2 * to.port + row) * columns + 2 * from.port + column];
    let row = |row: usize| entry(row, 0) * from.input.x + entry(row, 1) * from.input.y;
    to.output.x * row(0) + to.output.y * row(1)
}

/// Products of rows and columns, each of length `n`.
fn product<T>(rows: &[f64], columns: &[T], n: usize, out: &mut Vec<T>)
where
    T: Copy + std::ops::Mul<f64, Output = T> + std::iter::Sum,
{
    out.clear();
    let columns = || columns.chunks_exact(n.max(1));
    for row in rows.chunks_exact(n.max(1)) {
        out.extend(columns().map(|column| column.iter().zip(row).map(|(c, r)| *c * *r).sum::<T>()));
    }
}

#[cfg(test)]
mod tests;
