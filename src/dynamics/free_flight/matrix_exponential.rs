//! Three coupled degrees of freedom in closed form: `z(t + τ) = e^{Gτ} z(t)`.
//!
//! Eccentric bearings couple x, y and θ with dashpots that no modal transformation makes diagonal, and an undamped
//! resonance has no steady response. The force is therefore part of the state: `z = (q, v, sin, cos, u0, u1, 1)` with
//! the sine's phase, the record's value and slope and the constant push, so every case is one matrix exponential and
//! none is singular. `τ = n h + r`: the powers of `e^{Gh}` are kept, the rest is a Taylor series.

use glam::{DMat3, DVec3};
use twofloat::TwoFloat;

use crate::dynamics::free_flight::constants::{CELL_PHASE, LEAST_CELL_RATE, TAYLOR_TERMS};
use crate::dynamics::model::coordinates::planar::{POSITIONS, WIDTH};

/// Length of the augmented state.
pub const SIZE: usize = WIDTH + 5;
/// The augmented state.
pub type AugmentedState = [f64; SIZE];
type Matrix = [[f64; SIZE]; SIZE];
/// With twice the digits: a squaring doubles the relative error of a power and adds a rounding, `e' = 2e + ε`, so after k of
/// them a power of plain numbers is off by up to `2^k ε`. The domain's longest flight, 1e5 rad in cells of 0.5 rad, takes
/// k = 18: 6e-11 at the most and 6e-12 as measured, where tolerances go down to 1e-12.
type Doubled = [[TwoFloat; SIZE]; SIZE];

/// Index of `sin`; `cos`, `u0`, `u1` and `1` follow.
pub const SIN: usize = WIDTH;
/// Index of the record's value.
pub const VALUE: usize = WIDTH + 2;
/// Index of the constant 1.
pub const ONE: usize = WIDTH + 4;

/// A coupled linear system and the powers of its propagator.
#[derive(Clone, Debug)]
pub struct CoupledPropagator {
    generator: Matrix,
    cell: f64,
    powers: Vec<Matrix>,
}

impl CoupledPropagator {
    /// `q̈ = −k q − c v + push + forced (sine + record)`, per unit mass; `drive` is the sine's Ω \[rad/s\], `longest` the longest time span
    /// of an evaluation \[s\].
    pub fn new(k: DMat3, c: DMat3, push: DVec3, forced: DVec3, drive: f64, longest: f64) -> Self {
        let generator = generator(k, c, push, forced, drive);
        let rate = norm(k).sqrt().max(norm(c)).max(drive).max(LEAST_CELL_RATE);
        let cell = CELL_PHASE / rate;
        let mut power = exponential(&generator, cell);
        let mut powers = vec![rounded(&power)];
        let mut reach = cell;
        while reach < longest {
            power = product(&power, &power);
            powers.push(rounded(&power));
            reach *= 2.0;
        }
        Self { generator, cell, powers }
    }

    /// `e^{Gτ} z`.
    pub fn advance(&self, z: &AugmentedState, tau: f64) -> AugmentedState {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "τ is in [0, longest]")]
        let mut cells = (tau / self.cell) as u64;
        let mut z = taylor(&self.generator, z, tau - cells as f64 * self.cell);
        let mut level = 0;
        while cells > 0 {
            let power = &self.powers[level.min(self.powers.len() - 1)];
            if level >= self.powers.len() {
                // Asked for beyond `longest`: the largest power, as often as it takes.
                for _ in 0..(cells << (level - self.powers.len() + 1)) {
                    z = times(power, &z);
                }
                return z;
            }
            if cells & 1 == 1 {
                z = times(power, &z);
            }
            cells >>= 1;
            level += 1;
        }
        z
    }
}

/// Largest absolute row sum.
fn norm(m: DMat3) -> f64 {
    (0..3).map(|i| m.row(i).abs().element_sum()).fold(0.0, f64::max)
}

fn generator(k: DMat3, c: DMat3, push: DVec3, forced: DVec3, drive: f64) -> Matrix {
    let mut g = [[0.0; SIZE]; SIZE];
    for i in 0..POSITIONS {
        g[i][POSITIONS + i] = 1.0;
        for j in 0..POSITIONS {
            g[POSITIONS + i][j] = -k.col(j)[i];
            g[POSITIONS + i][POSITIONS + j] = -c.col(j)[i];
        }
        g[POSITIONS + i][SIN] = forced[i];
        g[POSITIONS + i][VALUE] = forced[i];
        g[POSITIONS + i][ONE] = push[i];
    }
    g[SIN][SIN + 1] = drive;
    g[SIN + 1][SIN] = -drive;
    g[VALUE][VALUE + 1] = 1.0;
    g
}

fn times(m: &Matrix, z: &AugmentedState) -> AugmentedState {
    std::array::from_fn(|i| m[i].iter().zip(z).map(|(a, b)| a * b).sum())
}

fn product(a: &Doubled, b: &Doubled) -> Doubled {
    let mut sum = [[TwoFloat::from(0.0); SIZE]; SIZE];
    for (row, sum) in a.iter().zip(&mut sum) {
        for (factor, b) in row.iter().zip(b).filter(|(factor, _)| factor.hi() != 0.0) {
            for (s, b) in sum.iter_mut().zip(b).filter(|(_, b)| b.hi() != 0.0) {
                *s += *factor * *b;
            }
        }
    }
    sum
}

fn rounded(m: &Doubled) -> Matrix {
    m.map(|row| row.map(|x| x.hi()))
}

fn taylor(g: &Matrix, z: &AugmentedState, tau: f64) -> AugmentedState {
    let (mut sum, mut term) = (*z, *z);
    for n in 1..=TAYLOR_TERMS {
        let factor = tau / f64::from(n);
        term = times(g, &term).map(|x| x * factor);
        for (s, t) in sum.iter_mut().zip(term) {
            *s += t;
        }
    }
    sum
}

fn exponential(g: &Matrix, tau: f64) -> Doubled {
    let g = g.map(|row| row.map(TwoFloat::from));
    let mut term: Doubled =
        std::array::from_fn(|i| std::array::from_fn(|j| TwoFloat::from(if i == j { 1.0 } else { 0.0 })));
    let mut sum = term;
    for n in 1..=TAYLOR_TERMS {
        let factor = TwoFloat::from(tau) / f64::from(n);
        term = product(&g, &term).map(|row| row.map(|x| x * factor));
        for (s, t) in sum.iter_mut().flatten().zip(term.iter().flatten()) {
            *s += *t;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::free_flight::oscillator::Oscillator;

    #[test]
    fn a_diagonal_system_answers_as_its_oscillators() {
        let (k, c) = (DVec3::new(266.9, 100.0, 0.0), DVec3::new(9.1, 0.0, 1.0));
        let push = DVec3::new(0.0, 2.0, 1.0);
        let system =
            CoupledPropagator::new(DMat3::from_diagonal(k), DMat3::from_diagonal(c), push, DVec3::X, 0.0, 20.0);
        let mut z = [0.0; SIZE];
        z[..WIDTH].copy_from_slice(&[0.01, 0.02, 0.03, 0.1, 0.2, 0.3]);
        (z[VALUE], z[VALUE + 1], z[ONE]) = (0.7, 0.3, 1.0);
        let after = system.advance(&z, 7.3);
        for i in 0..3 {
            let o = Oscillator { gamma: c[i] / 2.0, omega2: k[i] };
            let force = if i == 0 { [0.7, 0.3] } else { [push[i], 0.0] };
            let [q, v] = o.advance([z[i], z[POSITIONS + i]], force, 7.3);
            // Roundings at the size of the values.
            assert!((q - after[i]).abs() < 1e-12 * (1.0 + q.abs()), "q{i}: {q} against {}", after[i]);
            assert!(
                (v - after[POSITIONS + i]).abs() < 1e-12 * (1.0 + v.abs()),
                "v{i}: {v} against {}",
                after[POSITIONS + i]
            );
        }
    }

    #[test]
    fn a_power_of_the_longest_flight_is_off_by_no_more_than_a_few_roundings() {
        let phase = 1e5;
        let system = CoupledPropagator::new(DMat3::IDENTITY, DMat3::ZERO, DVec3::ZERO, DVec3::ZERO, 0.0, phase);
        let mut z = [0.0; SIZE];
        z[0] = 1.0;
        let after = system.advance(&z, phase);
        let error = (after[0] - phase.cos()).hypot(after[POSITIONS] + phase.sin());
        // 18 powers at most are applied; squared without twice the digits they would be off by 6e-12.
        assert!(error < 1e-13, "{error:e} after {phase} rad");
    }

    #[test]
    fn an_undamped_resonance_grows_as_the_textbook_says() {
        let w = 10.0;
        let system = CoupledPropagator::new(
            DMat3::from_diagonal(DVec3::splat(w * w)),
            DMat3::ZERO,
            DVec3::ZERO,
            DVec3::X,
            w,
            5.0,
        );
        let mut z = [0.0; SIZE];
        z[SIN + 1] = 1.0;
        let t: f64 = 4.7;
        let exact = ((w * t).sin() - w * t * (w * t).cos()) / (2.0 * w * w);
        let got = system.advance(&z, t)[0];
        assert!((got - exact).abs() < 1e-13, "{got} against {exact}");
    }
}
