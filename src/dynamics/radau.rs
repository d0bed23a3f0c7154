//! Radau IIA with seven stages: implicit, of order 13, for what an explicit method follows only in steps far shorter than
//! the motion (Hairer and Wanner, section IV.8): a stiff contact that lasts, the turning of a fast slip.
//!
//! The stages are found by Newton's method with the Jacobian at the start of the step, in the eigenvectors of the
//! method's matrix: one real and three complex systems of the size of one state. What turns too much within a step for one
//! Jacobian (friction of sliding in two directions, the angles of slips) enters by its own [`Slides`]. The continuous answer is the collocation polynomial itself, of degree seven.

use num_complex::Complex64;

use super::dop853::{Dense, System};
use super::lu::Lu;
use super::radau_coefficients::{
    C, COMPLEX, COMPLEX_LEFT, COMPLEX_RIGHT, DENSE, E, INVERSE, REAL, REAL_LEFT, REAL_RIGHT,
};
use super::slides::Slides;

/// Stages.
const STAGES: usize = 7;
/// Newton iterations before the step is shortened.
const PATIENCE: usize = 12;
/// What may be left of the stages' equations, in parts of the tolerance.
const LEFT: f64 = 1e-2;
/// Corrections that no longer shrink are rounding; it is let pass up to this part of the tolerance.
const STALLED: f64 = 0.2;
/// Newton's method that converges better than this keeps its Jacobian.
const GOOD: f64 = 0.1;
/// Steps that differ by less are one.
const SAME: f64 = 1e-6;
/// Rounds of the power method for the fastest rate.
const ROUNDS: usize = 12;

/// The integrator's memory for systems of one size.
#[derive(Debug, Default)]
pub(super) struct Radau {
    size: usize,
    /// Components before those that follow.
    leading: usize,
    jacobian: Vec<f64>,
    real: Lu<f64>,
    slides: Slides,
    complex: [Lu<Complex64>; 3],
    /// Step for which the matrices are factored; 0 when they are not.
    factored: f64,
    /// Whether the Jacobian is of the state at hand, and whether there is one.
    fresh: bool,
    known: bool,
    /// How well the last solution converged.
    rate: f64,
    stages: Vec<f64>,
    slopes: Vec<f64>,
    /// Rates of the components that follow, stage by stage.
    rates: Vec<f64>,
    scratch: Scratch,
    /// Length of the last accepted step, and its polynomial in increments.
    last: Option<(f64, Vec<[f64; STAGES]>)>,
}

#[derive(Debug, Default)]
struct Scratch {
    state: Vec<f64>,
    slope: Vec<f64>,
    correction: Vec<f64>,
    real: [Vec<f64>; 2],
    complex: [Vec<Complex64>; 2],
}

impl Radau {
    /// For systems of `size` components.
    pub(super) fn new(size: usize) -> Self {
        let mut radau = Self::default();
        radau.resize(size);
        radau
    }

    /// Makes room for a system of `size` components and forgets the last.
    pub(super) fn resize(&mut self, size: usize) {
        self.size = size;
        self.slides.forget();
        (self.factored, self.fresh, self.known, self.last) = (0.0, false, false, None);
        self.jacobian.resize(size * size, 0.0);
        for stages in [&mut self.stages, &mut self.slopes, &mut self.scratch.correction] {
            stages.resize(STAGES * size, 0.0);
        }
        for one in [&mut self.scratch.state, &mut self.scratch.slope] {
            one.resize(size, 0.0);
        }
        self.scratch.real.iter_mut().for_each(|v| v.resize(size, 0.0));
        self.scratch.complex.iter_mut().for_each(|v| v.resize(size, Complex64::ZERO));
    }

    /// Tries a step of length `h` from `(t, y)`, where the slope is `slope`; returns the error, 1 being the tolerance,
    /// infinite where Newton's method fails.
    pub(super) fn attempt(&mut self, system: &mut impl System, t: f64, y: &[f64], slope: &[f64], h: f64) -> f64 {
        self.leading = self.size - system.followers();
        if !self.known || !self.fresh && self.rate > GOOD {
            self.differentiate(system, t, y, slope);
        }
        if (self.factored - h).abs() > SAME * h && !self.factor(h) {
            return f64::INFINITY;
        }
        self.guess(h);
        if !self.solve(system, t, y, h) {
            if self.slides.unite(system) || !self.fresh {
                self.differentiate(system, t, y, slope);
                return self.attempt(system, t, y, slope, h);
            }
            return f64::INFINITY;
        }
        let error = self.error(system, t, y, slope, h);
        if self.rate > GOOD && self.slides.unite(system) {
            self.known = false;
        }
        error
    }

    /// The Jacobian by differences: each component moves by what changes the state by the root of a rounding.
    fn differentiate(&mut self, system: &mut impl System, t: f64, y: &[f64], slope: &[f64]) {
        let n = self.leading;
        let Scratch { state, slope: moved, .. } = &mut self.scratch;
        state.copy_from_slice(y);
        if self.slides.together(system) {
            system.slope(t, y, moved);
            self.slides.gather(system, y, n);
            system.hold(true);
        }
        for j in 0..n {
            let step = f64::EPSILON.sqrt() * system.extent(j, y[j]);
            state[j] = y[j] + step;
            let step = state[j] - y[j];
            system.slope(t, state, moved);
            for i in 0..n {
                self.jacobian[i * n + j] = (moved[i] - slope[i]) / step;
            }
            state[j] = y[j];
        }
        system.hold(false);
        (self.known, self.fresh, self.factored) = (true, true, 0.0);
    }

    fn factor(&mut self, h: f64) -> bool {
        let (n, jacobian) = (self.leading, &self.jacobian);
        let diagonal = |i: usize, j: usize, value: f64| if i == j { value / h } else { 0.0 };
        let mut done = self.real.factor(n, |i, j| diagonal(i, j, REAL) - jacobian[i * n + j]);
        for (lu, (re, im)) in self.complex.iter_mut().zip(COMPLEX) {
            done &= lu.factor(n, |i, j| Complex64::new(diagonal(i, j, re) - jacobian[i * n + j], diagonal(i, j, im)));
        }
        if done {
            self.slides.factor(&self.real, &self.complex);
        }
        self.factored = if done { h } else { 0.0 };
        done
    }

    /// Increments of the stages to begin with: the last step's polynomial, continued.
    fn guess(&mut self, h: f64) {
        let n = self.size;
        self.stages.fill(0.0);
        let Some((before, polynomial)) = &self.last else { return };
        for (stage, c) in C.iter().enumerate() {
            let x = 1.0 + c * h / before;
            for (z, p) in self.stages[stage * n..].iter_mut().zip(polynomial) {
                *z = increment(p, x) - increment(p, 1.0);
            }
        }
    }

    /// Newton's method for the stages.
    fn solve(&mut self, system: &mut impl System, t: f64, y: &[f64], h: f64) -> bool {
        let (n, mut before, mut rate) = (self.size, 0.0f64, 0.0f64);
        let followers = n - self.leading;
        self.rates.resize(STAGES * followers, 0.0);
        for round in 0..PATIENCE {
            for (stage, c) in C.iter().enumerate() {
                let range = stage * n..(stage + 1) * n;
                let state = &mut self.scratch.state;
                state.iter_mut().zip(y).zip(&self.stages[range.clone()]).for_each(|((s, y), z)| *s = y + z);
                system.slope(t + c * h, state, &mut self.slopes[range]);
                self.rates[stage * followers..(stage + 1) * followers].copy_from_slice(system.rates());
                self.slides.record(stage, n - followers, system.channels());
            }
            self.correct(h);
            (0..followers).for_each(|follower| self.residual(follower, h));
            let (rates, correction) = (&self.rates, &mut self.scratch.correction);
            if !self.slides.complete(correction, n, h, |k, follower| rates[k * followers + follower]) {
                return false;
            }
            // Elimination leaves rounding where nothing may move.
            for i in (0..self.leading).filter(|&i| system.is_held(i)) {
                (0..STAGES).for_each(|stage| self.scratch.correction[stage * n + i] = 0.0);
            }
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
            // What is left is what a geometric series of corrections would still add; two corrections tell its ratio only
            // where nothing turns.
            let sure = round > 1 || round == 1 && followers == 0;
            if size == 0.0 || (sure && rate < 1.0 && rate / (1.0 - rate) * size <= LEFT) || size <= 1e-2 * LEFT {
                return true;
            }
            if round > 1 && rate >= 1.0 {
                return size <= STALLED;
            }
            before = size;
        }
        before <= STALLED
    }

    /// One Newton correction of the leading components from the stages and their slopes, eigenvector by eigenvector.
    fn correct(&mut self, h: f64) {
        let (n, leading) = (self.size, self.leading);
        let (stages, slopes) = (&self.stages, &self.slopes);
        let Scratch { correction, real: [right, found], complex: [complex_right, complex_found], .. } =
            &mut self.scratch;
        // f − (λ/h) z of every stage, for the real eigenvalue.
        right[..leading].fill(0.0);
        for (k, left) in REAL_LEFT.iter().enumerate() {
            let rows = slopes[k * n..].iter().zip(&stages[k * n..]);
            right[..leading].iter_mut().zip(rows).for_each(|(r, (f, z))| *r += left * (f - REAL / h * z));
        }
        self.real.solve(&right[..leading], found);
        for (row, right) in correction.chunks_exact_mut(n).zip(&REAL_RIGHT) {
            row[..leading].iter_mut().zip(found.iter()).for_each(|(d, w)| *d = right * w);
        }
        for (m, &(re, im)) in COMPLEX.iter().enumerate() {
            let (re, im) = (re / h, im / h);
            complex_right[..leading].fill(Complex64::ZERO);
            for (k, &(a, b)) in COMPLEX_LEFT[m].iter().enumerate() {
                let rows = slopes[k * n..].iter().zip(&stages[k * n..]);
                for (r, (f, z)) in complex_right[..leading].iter_mut().zip(rows) {
                    let (x, y) = (f - re * z, im * z);
                    r.re += a * x + b * y;
                    r.im += b * x - a * y;
                }
            }
            self.complex[m].solve(&complex_right[..leading], complex_found);
            for (row, &(a, b)) in correction.chunks_exact_mut(n).zip(&COMPLEX_RIGHT[m]) {
                // The conjugate eigenvector adds the conjugate.
                let sums = row[..leading].iter_mut().zip(complex_found.iter());
                sums.for_each(|(d, w)| *d += 2.0 * (a * w.re - b * w.im));
            }
        }
    }

    /// What is left of the stages' equations of a component that follows.
    fn residual(&mut self, follower: usize, h: f64) {
        let (n, i) = (self.size, self.leading + follower);
        for (k, row) in INVERSE.iter().enumerate() {
            let moved = row.iter().enumerate().map(|(l, a)| a * self.stages[l * n + i]).sum::<f64>();
            self.scratch.correction[k * n + i] = self.slopes[k * n + i] - moved / h;
        }
    }

    /// Error of the stages just found: the embedded formula, filtered so that what decays at once does not count.
    fn error(&mut self, system: &mut impl System, t: f64, y: &[f64], slope: &[f64], h: f64) -> f64 {
        let error = self.filtered(system, slope, h);
        if error < 1.0 || !error.is_finite() {
            return error;
        }
        let (mut state, mut again) = (std::mem::take(&mut self.scratch.state), std::mem::take(&mut self.scratch.slope));
        state.iter_mut().zip(y).zip(&self.scratch.real[1]).for_each(|((s, y), e)| *s = y + e);
        system.slope(t, &state, &mut again);
        let error = self.filtered(system, &again, h);
        (self.scratch.state, self.scratch.slope) = (state, again);
        error
    }

    fn filtered(&mut self, system: &impl System, slope: &[f64], h: f64) -> f64 {
        let (n, leading) = (self.size, self.leading);
        let stages = &self.stages;
        let embedded = |i: usize| E.iter().enumerate().map(|(k, e)| e * stages[k * n + i]).sum::<f64>() * REAL / h;
        let [right, found] = &mut self.scratch.real;
        (0..n).for_each(|i| right[i] = slope[i] + embedded(i));
        self.real.solve(&right[..leading], &mut found[..leading]);
        found[leading..].copy_from_slice(&right[leading..]);
        let rates = &self.rates;
        self.slides.filter(found, h, |follower| rates[follower]);
        let error = system.size2(found).sqrt();
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// Accepts the step just tried: its continuous answer; `y` becomes the state at its end.
    pub(super) fn accept(&mut self, t: f64, y: &mut [f64], h: f64) -> Dense {
        let n = self.size;
        let polynomial: Vec<[f64; STAGES]> = (0..n)
            .map(|i| DENSE.map(|row| row.iter().enumerate().map(|(k, d)| d * self.stages[k * n + i]).sum::<f64>()))
            .collect();
        let coefficients =
            polynomial.iter().zip(y.iter()).map(|(p, &y)| [y, p[0], p[1], p[2], p[3], p[4], p[5], p[6]]).collect();
        for (i, y) in y.iter_mut().enumerate() {
            *y += self.stages[(STAGES - 1) * n + i];
        }
        (self.last, self.fresh) = (Some((h, polynomial)), false);
        Dense::new(t, h, coefficients)
    }

    /// The fastest rate in the Jacobian at hand, by the power method in the system's own measure; 0 without one \[1/s\].
    pub(super) fn fastest(&mut self, system: &impl System) -> f64 {
        let n = self.leading;
        let mut rate = self.rates.iter().fold(self.slides.fastest(), |a, r| a.max(r.abs()));
        let Scratch { state, slope, .. } = &mut self.scratch;
        state.fill(0.0);
        slope.fill(0.0);
        state[..n].fill(1.0);
        for round in 0..ROUNDS {
            for (i, out) in slope[..n].iter_mut().enumerate() {
                *out = self.jacobian[i * n..(i + 1) * n].iter().zip(state.iter()).map(|(a, x)| a * x).sum();
            }
            let (before, after) = (system.size2(state).sqrt(), system.size2(slope).sqrt());
            if !(before > 0.0 && after > 0.0 && after.is_finite()) {
                return rate;
            }
            // An oscillation grows by turns: the last rounds tell.
            if round >= ROUNDS / 2 {
                rate = rate.max(after / before);
            }
            state.iter_mut().zip(slope.iter()).for_each(|(x, y)| *x = y / after);
        }
        rate
    }

    /// Nothing is known of what comes: after a kink.
    pub(super) fn forget(&mut self) {
        (self.last, self.fresh) = (None, false);
    }
}

/// The collocation polynomial's increment at `x`, nested as in [`Dense`].
fn increment(p: &[f64; STAGES], x: f64) -> f64 {
    let y = 1.0 - x;
    x * (p[0] + y * (p[1] + x * (p[2] + y * (p[3] + x * (p[4] + y * (p[5] + x * p[6]))))))
}

/// Factor for the next step from the error of the last: the estimate is of order seven, kept between a fifth and eight.
pub(super) fn next_factor(error: f64) -> f64 {
    if error == 0.0 { 8.0 } else { (0.9 * error.powf(-0.125)).clamp(0.2, 8.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slow circle that a fast decay pulls towards itself: Prothero and Robinson's problem beside an oscillator.
    struct Stiff(f64);

    impl System for Stiff {
        fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
            (out[0], out[1]) = (y[1], -y[0]);
            out[2] = -self.0 * (y[2] - t.cos()) - t.sin();
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d.iter().map(|x| (x / 1e-13).powi(2)).sum()
        }

        fn extent(&self, _: usize, y: f64) -> f64 {
            y.abs().max(1.0)
        }
    }

    /// Largest errors over three units of time: of the circle and of what decays, at the ends of steps and between them.
    fn errors(steps: u32, stiffness: f64) -> [f64; 3] {
        let (mut system, h) = (Stiff(stiffness), 3.0 / f64::from(steps));
        let (mut radau, mut y, mut slope, mut worst) = (Radau::new(3), vec![0.0, 1.0, 1.0], vec![0.0; 3], [0.0f64; 3]);
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
    fn the_order_is_thirteen_and_seven_between_the_steps() {
        let order = |a: f64, b: f64| (a / b).log2();
        let (coarse, fine) = (errors(1, 1.0), errors(2, 1.0));
        // A linear step is the Padé approximation (6, 7) of the exponential: error 6! 7!/(13! 14!) h¹⁴, here of two steps.
        let pade = 2.0 * 720.0 * 5040.0 / (6_227_020_800.0 * 87_178_291_200.0) * 1.5f64.powi(14);
        assert!((0.3..1.5).contains(&(fine[0] / pade)), "steps: {} against {pade}", fine[0]);
        assert!(order(coarse[2], fine[2]) > 6.5, "between: {coarse:?} {fine:?}");
    }

    #[test]
    fn a_step_of_a_billion_time_constants_is_as_good_as_a_short_one() {
        assert!(errors(20, 1e10).iter().all(|&e| e < 1e-12), "all: {:?}", errors(20, 1e10));
        assert!(errors(1, 1e9)[1] < 1e-13, "what decays, in one step: {:?}", errors(1, 1e9));
    }
}
