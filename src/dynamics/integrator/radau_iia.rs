//! The Radau IIA method of five stages, order 9 (Hairer and Wanner, section IV.8), for systems that hold an explicit
//! method to steps far shorter than the motion: a stiff contact that lasts, a slip direction that turns fast. Three and
//! seven stages were compared (`docs/cost.md`).
//!
//! The stages follow from Newton's method with the Jacobian at the start of the step, in the eigenvectors of the
//! method's matrix: a real system and two complex ones. Parts of the system that turn too
//! much within a step for one Jacobian (friction of sliding in two directions, slip angles) enter through a
//! [`LowRankCorrection`]. The dense output is the collocation polynomial.

use crate::dynamics::integrator::constants::{
    COARSE_FACTOR, COARSE_TOLERANCE, EXTRAPOLATED_STEPS, LONGEST_FACTOR_IMPLICIT, NEWTON_FIRST_SHARE, NEWTON_GOOD_RATE,
    NEWTON_ITERATIONS, NEWTON_RESIDUAL, NEWTON_STALLED, POWER_ROUNDS, QUIET_STEP, SAME_STEP, SHORTEST_FACTOR,
    STEP_SAFETY,
};
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::low_rank_correction::LowRankCorrection;
use crate::dynamics::integrator::newton_matrix::StageSystems;
use crate::dynamics::integrator::radau_tableau::{C, DENSE, ERROR, INVERSE, REAL, STAGES};
use crate::dynamics::integrator::system::ImplicitSystem;

/// Workspace of the method for systems of one size.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Radau {
    size: usize,
    /// Number of leading components, before the auxiliary ones.
    leading: usize,
    systems: StageSystems,
    low_rank: LowRankCorrection,
    /// Step length of the factored matrices; 0 without \[s\].
    factored: f64,
    /// Whether the Jacobian is that of the present state, and whether there is one.
    fresh: bool,
    known: bool,
    /// Whether the step is so short that only auxiliary components and ports change within it: no Jacobian is needed.
    quiet: bool,
    /// Convergence rate of the last Newton iteration.
    rate: f64,
    stages: Vec<f64>,
    slopes: Vec<f64>,
    /// Rates of the auxiliary components stage by stage, and the residuals of their equations.
    rates: Vec<f64>,
    auxiliary: Vec<f64>,
    scratch: Scratch,
    /// Length and polynomial, in increments, of the last accepted step.
    last: Option<(f64, Vec<[f64; STAGES]>)>,
}

#[derive(Debug, Default)]
struct Scratch {
    state: Vec<f64>,
    slope: Vec<f64>,
    correction: Vec<f64>,
    error: Vec<f64>,
}

impl Radau {
    /// Sizes the workspace for a system of `size` components and discards what is known of the last.
    pub(in crate::dynamics) fn resize(&mut self, size: usize) {
        self.size = size;
        self.low_rank.forget();
        (self.rate, self.quiet) = (0.0, false);
        self.rates.clear();
        (self.factored, self.fresh, self.known, self.last) = (0.0, false, false, None);
        for stages in [&mut self.stages, &mut self.slopes, &mut self.scratch.correction] {
            stages.resize(STAGES * size, 0.0);
        }
        for one in [&mut self.scratch.state, &mut self.scratch.slope, &mut self.scratch.error] {
            one.resize(size, 0.0);
        }
    }

    /// Attempts a step of length `h` from `(t, y)` with slope `slope`; returns the error in units of the tolerance,
    /// infinite where Newton's method fails.
    pub(in crate::dynamics) fn attempt(
        &mut self,
        system: &mut impl ImplicitSystem,
        t: f64,
        y: &[f64],
        slope: &[f64],
        h: f64,
    ) -> f64 {
        self.leading = self.size - system.auxiliary_count();
        self.quiet = h * system.rate_bound() < QUIET_STEP;
        if !self.known || !self.fresh && self.rate > NEWTON_GOOD_RATE {
            self.differentiate(system, t, y, slope);
        }
        if !self.factor(h) {
            return f64::INFINITY;
        }
        self.guess(h);
        if !self.solve(system, t, y, h) {
            if self.low_rank.couple(system) || !self.fresh {
                self.differentiate(system, t, y, slope);
                return self.attempt(system, t, y, slope, h);
            }
            return f64::INFINITY;
        }
        let error = self.error(system, t, y, slope, h);
        if self.rate > NEWTON_GOOD_RATE && self.low_rank.couple(system) {
            self.known = false;
        }
        error
    }

    /// Evaluates the Jacobian at the start of a step; it is 0 for a quiet step.
    fn differentiate(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &[f64], slope: &[f64]) {
        let n = self.leading;
        let Scratch { state, slope: moved, .. } = &mut self.scratch;
        self.systems.linear.number(system, n);
        if self.low_rank.coupled(system) {
            self.low_rank.gather(system, &self.systems.linear, y, n);
        }
        if !self.quiet {
            system.slope(t, y, moved);
            system.freeze(true);
            self.systems.linear.differentiate(system, t, [y, slope], [state, moved]);
            system.freeze(false);
        }
        (self.known, self.fresh, self.factored) = (!self.quiet, true, 0.0);
    }

    /// Factors the systems for a step of length `h`, unless they are; `false` for a singular one.
    fn factor(&mut self, h: f64) -> bool {
        if (self.factored - h).abs() <= SAME_STEP * h {
            return true;
        }
        let done = self.systems.factor(h);
        if done {
            self.low_rank.factor(&self.systems);
        }
        self.factored = if done { h } else { 0.0 };
        done
    }

    /// Initial increments of the stages: the polynomial of the last step, extrapolated.
    fn guess(&mut self, h: f64) {
        let Some((before, polynomial)) = self.last.as_ref().filter(|(before, _)| h < EXTRAPOLATED_STEPS * before)
        else {
            return self.stages.fill(0.0);
        };
        for (stage, c) in self.stages.chunks_exact_mut(self.size).zip(C) {
            let weights = increments(1.0 + c * h / before);
            for (z, p) in stage.iter_mut().zip(polynomial) {
                let there: f64 = weights.iter().zip(p).map(|(w, p)| w * p).sum();
                *z = there - p[0];
            }
        }
    }

    /// Newton's method for the stages; whether it converged.
    fn solve(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &[f64], h: f64) -> bool {
        let (n, mut before, mut rate) = (self.size, 0.0f64, 0.0f64);
        let auxiliaries = n - self.leading;
        self.rates.resize(STAGES * auxiliaries, 0.0);
        self.auxiliary.resize(STAGES * auxiliaries, 0.0);
        for round in 0..NEWTON_ITERATIONS {
            for (stage, c) in C.iter().enumerate() {
                let range = stage * n..(stage + 1) * n;
                let state = &mut self.scratch.state;
                state.iter_mut().zip(y).zip(&self.stages[range.clone()]).for_each(|((s, y), z)| *s = y + z);
                system.slope(t + c * h, state, &mut self.slopes[range]);
                self.rates[stage * auxiliaries..(stage + 1) * auxiliaries].copy_from_slice(system.auxiliary_rates());
                self.low_rank.record(stage, system.rank_one_terms());
            }
            if !self.correct(h) {
                return false;
            }
            // Components that never change are set to 0: elimination leaves round-off in them.
            self.scratch.correction.chunks_exact_mut(n).for_each(|stage| system.hold(stage));
            let size2 = self.scratch.correction.chunks_exact(n).map(|d| system.size2(d)).fold(0.0, |a, b| a + b);
            let size = (size2 / STAGES as f64).sqrt();
            if !size.is_finite() {
                return false;
            }
            self.stages.iter_mut().zip(&self.scratch.correction).for_each(|(z, d)| *z += d);
            if round > 0 && before > 0.0 {
                rate = size / before;
            }
            self.rate = rate;
            // Remaining error as the geometric series of further corrections; with auxiliary components the first
            // ratio of two corrections is optimistic, and its root is used.
            let ratio = if round == 1 && auxiliaries > 0 { rate.sqrt() } else { rate };
            if size == 0.0
                || (round > 0 && ratio < 1.0 && ratio / (1.0 - ratio) * size <= NEWTON_RESIDUAL)
                || size <= NEWTON_FIRST_SHARE * NEWTON_RESIDUAL
            {
                return true;
            }
            if round > 1 && rate >= 1.0 {
                return size <= NEWTON_STALLED;
            }
            before = size;
        }
        before <= NEWTON_STALLED
    }

    /// One Newton correction from stages and slopes, leading and auxiliary components; `false` for a singular
    /// correction.
    fn correct(&mut self, h: f64) -> bool {
        let (n, leading) = (self.size, self.leading);
        let auxiliaries = n - leading;
        self.systems.project(h, [&self.slopes, &self.stages], [n, leading]);
        for (k, row) in INVERSE.iter().enumerate() {
            for (i, left) in (leading..n).zip(&mut self.auxiliary[k * auxiliaries..]) {
                let moved: f64 = row.iter().enumerate().map(|(l, a)| a * self.stages[l * n + i]).sum();
                *left = self.slopes[k * n + i] - moved / h;
            }
        }
        let rates = &self.rates;
        let rate = |k: usize, number: usize| rates[k * auxiliaries + number];
        if !self.low_rank.complete(&mut self.systems, &mut self.auxiliary, h, rate) {
            return false;
        }
        let correction = &mut self.scratch.correction;
        self.systems.expand(correction, n);
        for (row, auxiliary) in correction.chunks_exact_mut(n).zip(self.auxiliary.chunks_exact(auxiliaries.max(1))) {
            row[leading..].copy_from_slice(&auxiliary[..auxiliaries]);
        }
        true
    }

    /// Error of the stages by the embedded formula, filtered by the real system so that fast decay does not count.
    fn error(&mut self, system: &mut impl ImplicitSystem, t: f64, y: &[f64], slope: &[f64], h: f64) -> f64 {
        let error = self.filtered(system, slope, h);
        if error < 1.0 || !error.is_finite() {
            return error;
        }
        let (mut state, mut again) = (std::mem::take(&mut self.scratch.state), std::mem::take(&mut self.scratch.slope));
        state.iter_mut().zip(y).zip(&self.scratch.error).for_each(|((s, y), e)| *s = y + e);
        system.slope(t, &state, &mut again);
        let error = self.filtered(system, &again, h);
        (self.scratch.state, self.scratch.slope) = (state, again);
        error
    }

    fn filtered(&mut self, system: &impl ImplicitSystem, slope: &[f64], h: f64) -> f64 {
        let (n, leading, shift) = (self.size, self.leading, REAL / h);
        let found = &mut self.scratch.error;
        found.fill(0.0);
        for (e, stage) in ERROR.iter().zip(self.stages.chunks_exact(n)) {
            found.iter_mut().zip(stage).for_each(|(x, z)| *x += e * z);
        }
        found.iter_mut().zip(slope).for_each(|(x, f)| *x = f + *x * shift);
        let (first, auxiliary) = found.split_at_mut(leading);
        self.systems.real.solve(&self.systems.linear, first);
        let rates = &self.rates;
        if !self.low_rank.filter(shift, &mut self.systems.real, auxiliary, |number| rates[number]) {
            return f64::INFINITY;
        }
        self.systems.real.complete(&self.systems.linear, first);
        let factor = if system.relative_tolerance() >= COARSE_TOLERANCE { COARSE_FACTOR } else { 1.0 };
        let error = factor * system.size2(found).sqrt();
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// Accepts the attempted step and returns its dense output; `y` becomes the state at its end.
    pub(in crate::dynamics) fn accept(&mut self, t: f64, y: &mut [f64], h: f64) -> DenseOutput {
        let n = self.size;
        let mut polynomial = vec![[0.0; STAGES]; n];
        for (k, stage) in self.stages.chunks_exact(n).enumerate() {
            for (p, z) in polynomial.iter_mut().zip(stage) {
                p.iter_mut().zip(DENSE).for_each(|(p, row)| *p += row[k] * z);
            }
        }
        let coefficients =
            polynomial.iter().zip(y.iter()).map(|(p, &y)| [y, p[0], p[1], p[2], p[3], p[4], 0.0, 0.0]).collect();
        let last = self.stages.len() - n;
        y.iter_mut().zip(&self.stages[last..]).for_each(|(y, z)| *y += z);
        (self.last, self.fresh) = (Some((h, polynomial)), false);
        DenseOutput::new(t, h, coefficients)
    }

    /// Spectral radius of the present Jacobian by the power method in the norm of the system, with the rates of
    /// auxiliary components and ports \[1/s\]; these alone without a Jacobian.
    pub(in crate::dynamics) fn fastest(&mut self, system: &impl ImplicitSystem) -> f64 {
        let n = self.leading;
        let mut rate = self.rates.iter().fold(self.low_rank.fastest(), |a, r| a.max(r.abs()));
        let Scratch { state, slope, .. } = &mut self.scratch;
        state.fill(0.0);
        slope.fill(0.0);
        state[..n].fill(1.0);
        for round in 0..POWER_ROUNDS {
            self.systems.linear.times(&state[..n], &mut slope[..n]);
            let (before, after) = (system.size2(state).sqrt(), system.size2(slope).sqrt());
            if !(before > 0.0 && after > 0.0 && after.is_finite()) {
                return rate;
            }
            // The norm of an oscillation grows alternately: the maximum over the last rounds.
            if round >= POWER_ROUNDS / 2 {
                rate = rate.max(after / before);
            }
            state.iter_mut().zip(slope.iter()).for_each(|(x, y)| *x = y / after);
        }
        rate
    }

    /// Discards what is known of the system, after a kink.
    pub(in crate::dynamics) fn forget(&mut self) {
        (self.last, self.fresh) = (None, false);
    }
}

/// Factor to the length of the next step from the error of the last: `0.9 e^(−1/6)`, between 1/5 and 8.
pub(in crate::dynamics) fn next_factor(error: f64) -> f64 {
    if error == 0.0 {
        LONGEST_FACTOR_IMPLICIT
    } else {
        (STEP_SAFETY * error.powf(-1.0 / (STAGES + 1) as f64)).clamp(SHORTEST_FACTOR, LONGEST_FACTOR_IMPLICIT)
    }
}

/// Factors of the collocation polynomial's coefficients in its increment at `x`, nested as in [`DenseOutput`].
fn increments(x: f64) -> [f64; STAGES] {
    let (mut factor, y) = (1.0, 1.0 - x);
    std::array::from_fn(|k| {
        factor *= if k % 2 == 0 { x } else { y };
        factor
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::integrator::system::System;

    /// Harmonic oscillator with a component attracted to it by fast decay: the problem of Prothero and Robinson.
    struct Stiff(f64);

    impl System for Stiff {
        fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
            (out[0], out[1]) = (y[1], -y[0]);
            out[2] = -self.0 * (y[2] - t.cos()) - t.sin();
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d.iter().map(|x| (x / 1e-13).powi(2)).sum()
        }
    }

    impl ImplicitSystem for Stiff {}

    /// Largest errors over three units of time of the oscillator and of the attracted component, at the ends of steps
    /// and between.
    fn errors(steps: u32, stiffness: f64) -> [f64; 3] {
        let (mut system, h) = (Stiff(stiffness), 3.0 / f64::from(steps));
        let (mut radau, mut y, mut slope, mut worst) =
            (Radau::default(), vec![0.0, 1.0, 1.0], vec![0.0; 3], [0.0f64; 3]);
        radau.resize(3);
        for i in 0..steps {
            let t = f64::from(i) * h;
            system.slope(t, &y, &mut slope);
            assert!(radau.attempt(&mut system, t, &y, &slope, h).is_finite(), "Newton's method ends");
            let dense = radau.accept(t, &mut y, h);
            let mut middle = [0.0; 3];
            dense.read(0..3, t + 0.5 * h, &mut middle);
            worst[0] = worst[0].max((y[0] - (t + h).sin()).abs());
            worst[1] = worst[1].max((y[2] - (t + h).cos()).abs());
            worst[2] = worst[2].max((middle[0] - (t + 0.5 * h).sin()).abs());
        }
        worst
    }

    #[test]
    fn the_order_is_nine_and_five_between_the_steps() {
        let order = |a: f64, b: f64| (a / b).log2();
        let (coarse, fine) = (errors(1, 1.0), errors(2, 1.0));
        // A linear step is the Padé approximation (4, 5) of the exponential: error 4! 5!/(9! 10!) h¹⁰, here of two
        // steps.
        let pade = 2.0 * 24.0 * 120.0 / (362_880.0 * 3_628_800.0) * 1.5f64.powi(10);
        assert!((0.3..1.5).contains(&(fine[0] / pade)), "steps: {} against {pade}", fine[0]);
        assert!(order(coarse[2], fine[2]) > 4.5, "between: {coarse:?} {fine:?}");
    }

    #[test]
    fn a_step_of_a_billion_time_constants_is_as_good_as_a_short_one() {
        let [swinging, decaying, between] = errors(20, 1e10);
        assert!(swinging.max(decaying) < 1e-12, "steps: {swinging} and {decaying}");
        // Between, the polynomial of degree 5 through the start and the nodes is as near as to a smooth function: the
        // sixth derivative, at most 1 here, times the product of the distances to these six over 6!.
        let distances = C.iter().fold(0.5, |product, c| product * (0.5 - c).abs());
        let interpolation = distances * 0.15f64.powi(6) / 720.0;
        assert!(between < 1.01 * interpolation, "between: {between} against {interpolation}");
        // What decays at the rate 1e9 lags by the error of that polynomial's slope over this rate; at the last node the
        // error is h⁵ times the product of the distances to the other five over 6!, here with h = 3.
        let distances = C[..STAGES - 1].iter().fold(1.0, |product, c| product * (1.0 - c));
        let lag = 3.0f64.powi(5) * distances / 720.0 / 1e9;
        assert!(errors(1, 1e9)[1] < lag, "what decays, in one step: {:?} against {lag}", errors(1, 1e9));
    }
}
