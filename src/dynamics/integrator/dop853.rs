//! Dormand–Prince 8(5,3): explicit Runge–Kutta of order 8 with a seventh-order continuous answer
//! (Hairer, Nørsett and Wanner, section II.5). Knows no physics; all buffers are kept from step to step.

use crate::dynamics::integrator::dop853_tableau::{A, C, D, E3, E5};
use crate::dynamics::integrator::low_rank_correction::Channel;

/// Coefficients of the interpolant per component.
pub const DENSE: usize = 8;

/// Slopes of a step with those that its continuous answer needs.
const STAGES: usize = 16;

/// Time constants of a decay that a step may span for its error to be seen: at 5.65 of them, inside the region of stability, the
/// estimate of fifth order crosses 0 while a quarter of what should have decayed is left.
pub(in crate::dynamics) const SEEN: f64 = 5.0;

/// Largest first and second derivatives of the interpolant's factors `x, xy, x²y, x²y², x³y², x³y³, x⁴y³`, y = 1 − x, on
/// \[0, 1\], rounded up.
const STEEPEST: [[f64; DENSE - 1]; 2] =
    [[1.0, 1.0, 1.0, 0.193, 0.136, 0.0537, 0.0336], [0.0, 2.0, 4.0, 2.0, 2.0, 0.375, 0.243]];

/// A first-order system with its own idea of how large an error is.
pub trait System {
    /// `ẏ` at `(t, y)`.
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]);
    /// Squared size of a difference of states, 1 being what the tolerance allows.
    fn size2(&self, difference: &[f64]) -> f64;
    /// How far component `i`, which is `y`, may move for its effect to be felt but still in proportion.
    fn extent(&self, _i: usize, y: f64) -> f64 {
        y.abs().max(1.0)
    }
    /// Whether component `i` never changes.
    fn is_held(&self, _i: usize) -> bool {
        false
    }
    /// Width of the blocks of the leading components and how many of each are places, if they are such: the rates of a
    /// block's places are linear in the rest of it, its speeds, by columns that are orthogonal, and nothing answers to
    /// changes of places that speeds cannot bring about.
    fn bodies(&self) -> Option<(usize, usize)> {
        None
    }
    /// A rate that nothing but what follows or slides exceeds by much \[1/s\].
    fn quickest(&self) -> f64 {
        f64::INFINITY
    }
    /// What an error of 1 is in parts of the motion.
    fn tolerance(&self) -> f64 {
        0.0
    }
    /// How many of the last components follow the others, each by one of the channels.
    fn followers(&self) -> usize {
        0
    }
    /// `∂ẏᵢ/∂yᵢ` of those components where the slope was last asked for.
    fn rates(&self) -> &[f64] {
        &[]
    }
    /// How many forces turn with velocities faster than one Jacobian can say.
    fn sliders(&self) -> usize {
        0
    }
    /// How they answered where the slope was last asked for: as many everywhere.
    fn channels(&self) -> &[Channel] {
        &[]
    }
    /// Whether from now on they keep the direction that they had there, and all that bends its side of the bend.
    fn hold(&mut self, _held: bool) {}
    /// Rates of the leading components per unit of a slider's force, and its velocity per unit of those components, at
    /// `y`: two columns and two rows, both 0 as given, and 0 for places.
    fn slider(&self, _slider: usize, _y: &[f64], _push: &mut [f64], _view: &mut [f64]) {}
}

/// The integrator's memory for systems of one size.
#[derive(Clone, Debug, Default)]
pub struct Dop853 {
    /// Row by row: of the stages, and the last four coefficients of the continuous answer per length of the step.
    slopes: Vec<f64>,
    stage: Vec<f64>,
    end: Vec<f64>,
    size: usize,
}

/// A continuous answer over one step: `[component][coefficient]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Dense {
    /// Where the step begins \[s\].
    pub from: f64,
    /// Its length \[s\].
    pub step: f64,
    coefficients: Vec<[f64; DENSE]>,
}

impl Dense {
    /// A continuous answer from its coefficients.
    pub(in crate::dynamics) fn new(from: f64, step: f64, coefficients: Vec<[f64; DENSE]>) -> Self {
        Self { from, step, coefficients }
    }

    /// Components `range` at `t`, written to `out`.
    #[inline]
    pub fn read(&self, range: std::ops::Range<usize>, t: f64, out: &mut [f64]) {
        let x = (t - self.from) / self.step;
        for (value, c) in out.iter_mut().zip(&self.coefficients[range]) {
            *value = Self::value(c, x);
        }
    }

    /// One component at `t`.
    #[inline]
    pub(in crate::dynamics) fn component(&self, i: usize, t: f64) -> f64 {
        Self::value(&self.coefficients[i], (t - self.from) / self.step)
    }

    /// A component in the part `x` of the step: Horner in x and 1 − x by turns, from the highest coefficient down.
    #[inline]
    pub(in crate::dynamics) fn value(c: &[f64; DENSE], x: f64) -> f64 {
        let y = 1.0 - x;
        c[0] + x * (c[1] + y * (c[2] + x * (c[3] + y * (c[4] + x * (c[5] + y * (c[6] + x * c[7]))))))
    }

    /// How far components `range` together are from their start at most, anywhere in the step.
    pub(in crate::dynamics) fn span(&self, range: std::ops::Range<usize>) -> f64 {
        // Every coefficient stands before a product of factors from 0 to 1.
        let far = |c: &[f64; DENSE]| c[1..].iter().map(|c| c.abs()).sum::<f64>();
        self.coefficients[range].iter().map(|c| far(c).powi(2)).sum::<f64>().sqrt()
    }

    /// Bounds on `|ẏ|` and `|ÿ|` of components `range` together, anywhere in the step.
    pub(in crate::dynamics) fn swing(&self, range: std::ops::Range<usize>) -> [f64; 2] {
        self.swing_of(self.coefficients[range].iter().copied())
    }

    /// The same of the difference to as many components from `other` on.
    pub(in crate::dynamics) fn swing_apart(&self, range: std::ops::Range<usize>, other: usize) -> [f64; 2] {
        let pairs = self.coefficients[range].iter().zip(&self.coefficients[other..]);
        self.swing_of(pairs.map(|(a, b)| std::array::from_fn(|k| a[k] - b[k])))
    }

    fn swing_of(&self, components: impl Iterator<Item = [f64; DENSE]>) -> [f64; 2] {
        let mut squares = [0.0; 2];
        for c in components {
            for (square, most) in squares.iter_mut().zip(&STEEPEST) {
                let largest: f64 = c[1..].iter().zip(most).map(|(c, most)| most * c.abs()).sum();
                *square += largest * largest;
            }
        }
        [squares[0].sqrt() / self.step, squares[1].sqrt() / (self.step * self.step)]
    }

    /// The same answer for some components only.
    #[must_use]
    pub fn part(&self, range: std::ops::Range<usize>) -> Self {
        Self { from: self.from, step: self.step, coefficients: self.coefficients[range].to_vec() }
    }

    /// Every coefficient, for hashing.
    pub fn coefficients(&self) -> &[[f64; DENSE]] {
        &self.coefficients
    }
}

impl Dop853 {
    /// Makes room for a system of `size` components.
    pub fn resize(&mut self, size: usize) {
        self.size = size;
        self.slopes.clear();
        self.slopes.resize((STAGES + D.len()) * size, 0.0);
        self.stage.resize(size, 0.0);
        self.end.resize(size, 0.0);
    }

    /// Sets the slope at the start of the next step.
    pub fn start(&mut self, system: &mut impl System, t: f64, y: &[f64]) {
        let n = self.size;
        system.slope(t, y, &mut self.slopes[..n]);
    }

    /// Slope at the start of the next step.
    pub fn slope(&self) -> &[f64] {
        &self.slopes[..self.size]
    }

    /// Tries a step of length `h` from `(t, y)`, whose slope stands in row 0; returns the error, 1 being the tolerance.
    pub fn attempt(&mut self, system: &mut impl System, t: f64, y: &[f64], h: f64) -> f64 {
        for stage in 1..12 {
            self.evaluate(system, stage, t, y, h);
        }
        let n = self.size;
        combine(&mut self.end, y, h, A[12], &self.slopes, n);
        self.error(system, h)
    }

    /// Error of the step just tried, as the code of the method's authors weighs the two estimates.
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

    /// Accepts the step just tried: its continuous answer. The slope at its end becomes the next start.
    pub fn accept(&mut self, system: &mut impl System, t: f64, y: &mut [f64], h: f64) -> Dense {
        let n = self.size;
        system.slope(t + h, &self.end, &mut self.slopes[12 * n..13 * n]);
        for stage in 13..16 {
            self.evaluate(system, stage, t, y, h);
        }
        let (slopes, upper) = self.slopes.split_at_mut(STAGES * n);
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
        Dense { from: t, step: h, coefficients }
    }

    /// How many time constants of the fastest motion the step just accepted spans, from its last two stages, which are
    /// for the same time (Hairer and Wanner, section IV.2).
    pub fn stiffness(&mut self, system: &impl System, accepted: &Dense) -> f64 {
        let n = self.size;
        for (i, c) in accepted.coefficients.iter().enumerate() {
            // The first slope has made room for the next step's; the answer still knows it.
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

#[inline]
fn combine(out: &mut [f64], y: &[f64], h: f64, row: &[(usize, f64)], slopes: &[f64], n: usize) {
    out.fill(0.0);
    for &(j, factor) in row {
        for (o, k) in out.iter_mut().zip(&slopes[j * n..(j + 1) * n]) {
            *o += factor * k;
        }
    }
    for (o, y) in out.iter_mut().zip(y) {
        *o = y + h * *o;
    }
}

#[inline]
fn difference(out: &mut [f64], row: &[(usize, f64)], slopes: &[f64], n: usize) {
    out.fill(0.0);
    for &(j, factor) in row {
        for (o, k) in out.iter_mut().zip(&slopes[j * n..(j + 1) * n]) {
            *o += factor * k;
        }
    }
}

/// Factor for the next step from the error of the last: order 8, kept between a fifth and six.
pub fn next_factor(error: f64) -> f64 {
    if error == 0.0 { 6.0 } else { (0.9 * error.powf(-0.125)).clamp(0.2, 6.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let worst = (1..=50).map(|i| seen(SEEN * f64::from(i) / 50.0)).fold(f64::INFINITY, f64::min);
        assert!(worst > 1.0, "of the error, at least: {worst}");
        assert!(seen(5.6543) < 1e-3, "of the error: {}", seen(5.6543));
    }

    /// Largest error over one turn: at the steps, and halfway between them.
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
    fn nothing_in_a_step_is_faster_or_bends_more_than_its_bounds() {
        let wild = |seed: f64| std::array::from_fn(|k| (seed + 1.7 * k as f64).sin() * 3.0);
        let dense = Dense::new(2.0, 0.3, vec![wild(0.4), wild(2.9), wild(5.1)]);
        let at = |i: usize, x: f64| Dense::value(&dense.coefficients[i], x) - Dense::value(&dense.coefficients[2], x);
        let [speed, bend] = dense.swing_apart(0..1, 2);
        let (h, mut worst) = (1e-4, [0.0f64; 2]);
        for k in 1..9999 {
            let x = f64::from(k) * h;
            let (before, here, after) = (at(0, x - h), at(0, x), at(0, x + h));
            worst[0] = worst[0].max(((after - before) / (2.0 * h * dense.step)).abs());
            worst[1] = worst[1].max(((after - 2.0 * here + before) / (h * dense.step).powi(2)).abs());
        }
        assert!(worst[0] <= speed && worst[1] <= bend, "{worst:?} against {speed}, {bend}");
        assert!(worst[0] > 0.1 * speed && worst[1] > 0.1 * bend, "not far above: {worst:?}, {speed}, {bend}");
    }

    #[test]
    fn the_order_is_eight_at_the_steps_and_seven_between() {
        let (coarse, fine) = (errors(8), errors(16));
        let order = |a: f64, b: f64| (a / b).log2();
        assert!((order(coarse.0, fine.0) - 8.0).abs() < 0.35, "steps: {}", order(coarse.0, fine.0));
        assert!(order(coarse.1, fine.1) > 6.8, "between: {}", order(coarse.1, fine.1));
    }
}
