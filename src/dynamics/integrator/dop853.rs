//! Dormand–Prince 8(5,3): explicit Runge–Kutta method of order 8 with dense output of order 7 (Hairer, Nørsett and
//! Wanner, section II.5). No physics; workspace is kept from step to step.

use crate::dynamics::integrator::constants::{LONGEST_FACTOR_EXPLICIT, SHORTEST_FACTOR, STEP_SAFETY};
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::dop853_tableau::{A, C, D, E3, E5};
use crate::dynamics::integrator::system::System;

/// Slopes of a step, those of the dense output included.
const DOP_STAGES: usize = 16;

/// Workspace of the method for systems of one size.
#[derive(Clone, Debug, Default)]
pub struct Dop853 {
    /// Slopes by stage; then, in the last four rows, the upper coefficients of the dense output divided by the step
    /// length.
    slopes: Vec<f64>,
    stage: Vec<f64>,
    end: Vec<f64>,
    size: usize,
}

impl Dop853 {
    /// Sizes the workspace for a system of `size` components.
    pub fn resize(&mut self, size: usize) {
        self.size = size;
        self.slopes.clear();
        self.slopes.resize((DOP_STAGES + D.len()) * size, 0.0);
        self.stage.resize(size, 0.0);
        self.end.resize(size, 0.0);
    }

    /// Evaluates the slope at the start of the next step.
    pub fn start(&mut self, system: &mut impl System, t: f64, y: &[f64]) {
        let n = self.size;
        system.slope(t, y, &mut self.slopes[..n]);
    }

    /// Slope at the start of the next step.
    pub fn slope(&self) -> &[f64] {
        &self.slopes[..self.size]
    }

    /// Attempts a step of length `h` from `(t, y)`, with the slope there in row 0; returns the error in units of the
    /// tolerance.
    pub fn attempt(&mut self, system: &mut impl System, t: f64, y: &[f64], h: f64) -> f64 {
        for stage in 1..12 {
            self.evaluate(system, stage, t, y, h);
        }
        let n = self.size;
        combine(&mut self.end, y, h, A[12], &self.slopes, n);
        self.error(system, h)
    }

    /// Error of the attempted step: the combination of fifth- and third-order estimates of the program DOP853.
    fn error(&mut self, system: &impl System, h: f64) -> f64 {
        let n = self.size;
        difference(&mut self.stage, E5, &self.slopes, n);
        let fifth = system.size2(&self.stage);
        difference(&mut self.stage, E3, &self.slopes, n);
        let third = system.size2(&self.stage);
        let mixed = fifth + 0.01 * third;
        if mixed > 0.0 && mixed.is_finite() {
            h.abs() * fifth / mixed.sqrt()
        } else if mixed == 0.0 {
            0.0
        } else {
            f64::INFINITY
        }
    }

    fn evaluate(&mut self, system: &mut impl System, stage: usize, t: f64, y: &[f64], h: f64) {
        let n = self.size;
        combine(&mut self.stage, y, h, A[stage], &self.slopes, n);
        let (_, after) = self.slopes.split_at_mut(stage * n);
        system.slope(t + C[stage] * h, &self.stage, &mut after[..n]);
    }

    /// Accepts the attempted step and returns its dense output; the slope at its end becomes that of the next start.
    pub fn accept(&mut self, system: &mut impl System, t: f64, y: &mut [f64], h: f64) -> DenseOutput {
        let n = self.size;
        system.slope(t + h, &self.end, &mut self.slopes[12 * n..13 * n]);
        for stage in 13..16 {
            self.evaluate(system, stage, t, y, h);
        }
        let (slopes, upper) = self.slopes.split_at_mut(DOP_STAGES * n);
        for (row, upper) in D.iter().zip(upper.chunks_exact_mut(n.max(1))) {
            difference(upper, row, slopes, n);
        }
        let coefficients = (0..n)
            .map(|i| {
                let delta = self.end[i] - y[i];
                let (first, last) = (h * slopes[i], h * slopes[12 * n + i]);
                let upper = |row: usize| h * upper[row * n + i];
                [y[i], delta, first - delta, 2.0 * delta - (last + first), upper(0), upper(1), upper(2), upper(3)]
            })
            .collect();
        y.copy_from_slice(&self.end);
        self.slopes.copy_within(12 * n..13 * n, 0);
        DenseOutput::new(t, h, coefficients)
    }

    /// Estimate of `h |λ|` for the fastest motion within the accepted step, from its last two stages, which are at
    /// one time (Hairer and Wanner, section IV.2).
    pub fn stiffness(&mut self, system: &impl System, accepted: &DenseOutput) -> f64 {
        let n = self.size;
        for (i, c) in accepted.coefficients().iter().enumerate() {
            // Row 0 holds the slope of the next start by now; that of this start is a coefficient of the dense
            // output.
            let slope = |j: usize| if j == 0 { (c[1] + c[2]) / accepted.step } else { self.slopes[j * n + i] };
            let moved: f64 = A[11].iter().map(|&(j, factor)| factor * slope(j)).sum();
            self.stage[i] = self.end[i] - (c[0] + accepted.step * moved);
        }
        let apart = system.size2(&self.stage);
        for i in 0..n {
            self.stage[i] = self.slopes[12 * n + i] - self.slopes[11 * n + i];
        }
        if apart > 0.0 { accepted.step * (system.size2(&self.stage) / apart).sqrt() } else { 0.0 }
    }
}

/// Terms of a sum that are added in one pass over the components.
const TERMS: usize = 4;

/// `out = y + h Σ factor · slope`.
#[inline]
fn combine(out: &mut [f64], y: &[f64], h: f64, row: &[(usize, f64)], slopes: &[f64], n: usize) {
    difference(out, row, slopes, n);
    for (o, y) in out.iter_mut().zip(y) {
        *o = y + h * *o;
    }
}

/// `out = Σ factor · slope`, terms added in their order.
#[inline]
fn difference(out: &mut [f64], row: &[(usize, f64)], slopes: &[f64], n: usize) {
    let (out, slope) = (&mut out[..n], |j: usize| &slopes[j * n..][..n]);
    out.fill(0.0);
    let (fours, rest) = row.as_chunks::<TERMS>();
    for four in fours {
        let ([a, b, c, d], f) = (four.map(|(j, _)| slope(j)), four.map(|(_, factor)| factor));
        for i in 0..n {
            out[i] = (((out[i] + f[0] * a[i]) + f[1] * b[i]) + f[2] * c[i]) + f[3] * d[i];
        }
    }
    for &(j, factor) in rest {
        for (o, k) in out.iter_mut().zip(slope(j)) {
            *o += factor * k;
        }
    }
}

/// Factor to the length of the next step from the error of the last: `0.9 e^(−1/8)`, between 1/5 and 6.
pub fn next_factor(error: f64) -> f64 {
    if error == 0.0 {
        LONGEST_FACTOR_EXPLICIT
    } else {
        (STEP_SAFETY * error.powf(-0.125)).clamp(SHORTEST_FACTOR, LONGEST_FACTOR_EXPLICIT)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::integrator::constants::{RESOLVED_DECAY, RESOLVED_RELAXATION};

    struct Circle;

    impl System for Circle {
        fn slope(&mut self, _t: f64, y: &[f64], out: &mut [f64]) {
            (out[0], out[1]) = (y[1], -y[0]);
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d.iter().map(|x| x * x).sum()
        }
    }

    struct Decay;

    impl System for Decay {
        fn slope(&mut self, _t: f64, y: &[f64], out: &mut [f64]) {
            out[0] = -y[0];
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d[0] * d[0]
        }
    }

    #[test]
    fn the_error_of_a_decay_is_seen_up_to_five_time_constants_and_not_at_all_a_little_beyond() {
        let seen = |h: f64| {
            let (mut rk, mut y) = (Dop853::default(), vec![1.0]);
            rk.resize(1);
            rk.start(&mut Decay, 0.0, &y);
            let estimate = rk.attempt(&mut Decay, 0.0, &y, h);
            rk.accept(&mut Decay, 0.0, &mut y, h);
            estimate / (y[0] - (-h).exp()).abs()
        };
        let worst = (1..=50).map(|i| seen(RESOLVED_DECAY * f64::from(i) / 50.0)).fold(f64::INFINITY, f64::min);
        assert!(worst > 1.0, "of the error, at least: {worst}");
        assert!(seen(5.05) > 1.0 && seen(5.06) < 1.0, "from {} to {}", seen(5.05), seen(5.06));
        assert!(seen(5.6543) < 1e-3, "of the error: {}", seen(5.6543));
    }

    /// Follows `cos t` at a rate λ: the problem of Prothero and Robinson.
    struct Follower(f64);

    impl System for Follower {
        fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
            out[0] = -self.0 * (y[0] - t.cos()) - t.sin();
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d[0] * d[0]
        }
    }

    #[test]
    fn between_the_ends_of_a_step_a_follower_errs_by_its_estimate_up_to_three_time_constants_and_by_far_more_at_five() {
        let unseen = |constants: f64, h: f64| {
            let (mut system, mut rk, mut y) = (Follower(constants / h), Dop853::default(), vec![1.0]);
            rk.resize(1);
            rk.start(&mut system, 0.0, &y);
            let estimate = rk.attempt(&mut system, 0.0, &y, h);
            let dense = rk.accept(&mut system, 0.0, &mut y, h);
            let error = |i: i32| {
                let (t, mut here) = (h * f64::from(i) / 40.0, [0.0]);
                dense.read(0..1, t, &mut here);
                (here[0] - t.cos()).abs()
            };
            (1..40).map(error).fold(0.0, f64::max) / estimate
        };
        for h in [0.25, 0.5] {
            for constants in [1.0, 2.0, RESOLVED_RELAXATION] {
                assert!(unseen(constants, h) < 2.6, "{constants} at {h}: {} of the estimate", unseen(constants, h));
            }
            assert!(unseen(5.0, h) > 50.0, "5 at {h}: {} of the estimate", unseen(5.0, h));
        }
    }

    #[test]
    fn a_step_of_an_oscillation_loses_a_part_of_the_tolerance_always_of_one_sign() {
        // Phases in which the estimate equals the safety factor's part of the tolerance.
        for (tolerance, phase, lost) in [(1e-4, 1.743, 0.067), (1e-7, 0.747, 0.0127), (1e-10, 0.316, 0.0022)] {
            let (mut rk, mut y) = (Dop853::default(), vec![0.0, 1.0]);
            rk.resize(2);
            rk.start(&mut Circle, 0.0, &y);
            let estimate = rk.attempt(&mut Circle, 0.0, &y, phase) / tolerance;
            rk.accept(&mut Circle, 0.0, &mut y, phase);
            assert!((estimate / STEP_SAFETY.powi(8) - 1.0).abs() < 0.02, "{estimate} of {tolerance:e}");
            let loss = (1.0 - y[0].hypot(y[1])) / tolerance;
            assert!((loss / lost - 1.0).abs() < 0.05, "amplitude lost: {loss} of {tolerance:e}");
        }
    }

    /// Largest error over one revolution, at the ends of steps and in their middle.
    fn errors(steps: u32) -> (f64, f64) {
        let h = std::f64::consts::TAU / f64::from(steps);
        let (mut rk, mut y, mut worst) = (Dop853::default(), vec![0.0, 1.0], (0.0f64, 0.0f64));
        rk.resize(2);
        rk.start(&mut Circle, 0.0, &y);
        for i in 0..steps {
            let t = f64::from(i) * h;
            rk.attempt(&mut Circle, t, &y, h);
            let dense = rk.accept(&mut Circle, t, &mut y, h);
            let mut middle = [0.0; 2];
            dense.read(0..2, t + 0.5 * h, &mut middle);
            worst.1 = worst.1.max((middle[0] - (t + 0.5 * h).sin()).abs());
            worst.0 = worst.0.max((y[0] - (t + h).sin()).abs());
        }
        worst
    }

    #[test]
    fn the_order_is_eight_at_the_steps_and_seven_between() {
        let (coarse, fine) = (errors(8), errors(16));
        let order = |a: f64, b: f64| (a / b).log2();
        assert!((order(coarse.0, fine.0) - 8.0).abs() < 0.35, "steps: {}", order(coarse.0, fine.0));
        assert!(order(coarse.1, fine.1) > 6.8, "between: {}", order(coarse.1, fine.1));
    }
}
