//! (61)–(63) of the paper without their large rotations: two-node bar elements with consistent mass, Newmark's steps with average
//! acceleration, and in each step an iteration until gaps and forces agree. For straight elastic girders in one line.
//!
//! Elements are as long as a wave runs in a step: shorter ones, or shorter steps alone, would only cost.

use super::interface::{Job, Method, SettingKind, Work};
use crate::scene::Scene;
use crate::study::accuracy::Answer;
use crate::study::accuracy::answer::INTERVALS;
use crate::study::accuracy::line::{Bar, Line};

/// Iterations before a step is taken as it is, and counted.
const MOST: usize = 30;
/// Fewest elements of a bar.
const FEWEST: usize = 10;

/// Newmark's method on bar elements.
#[derive(Debug)]
pub(super) struct NewmarkElements;

impl Method for NewmarkElements {
    fn name(&self) -> &'static str {
        "newmark-elements"
    }

    fn setting_kind(&self) -> SettingKind {
        SettingKind::StepsPerInterval
    }

    fn knows(&self, scene: &Scene) -> bool {
        Line::of(scene).is_some()
    }

    fn work(&self, job: &Job<'_>) -> Result<Work, String> {
        let line = Line::of(job.scene).ok_or("no bars in one line")?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count, at least 1")]
        let per_interval = job.setting.max(1.0) as usize;
        let h = job.instants.until / (INTERVALS * per_interval) as f64;
        let mut steps = Newmark::of(line, h);
        let mut places = steps.places();
        for number in 0..INTERVALS * per_interval {
            steps.step((number + 1) as f64 * h);
            if (number + 1).is_multiple_of(per_interval) {
                places.extend(steps.places());
            }
        }
        let restless = steps.unsettled;
        let note = if restless > 0 { format!("{restless} steps not in equilibrium") } else { String::new() };
        let (bodies, peak_force) = (steps.line.bars.len(), steps.peak);
        Ok(Work::Sampled(Answer { places, bodies, peak_force, steps: INTERVALS * per_interval, note }))
    }
}

/// A symmetric tridiagonal matrix: its diagonal, and what is beside it.
#[derive(Clone, Debug)]
struct Band {
    own: Vec<f64>,
    beside: Vec<f64>,
}

impl Band {
    fn of(size: usize) -> Self {
        Self { own: vec![0.0; size], beside: vec![0.0; size - 1] }
    }

    /// Adds `factor w wᵀ` over node `i` and the next, w = (a, b).
    fn add(&mut self, i: usize, [a, b]: [f64; 2], factor: f64) {
        self.own[i] += factor * a * a;
        if b != 0.0 {
            self.own[i + 1] += factor * b * b;
            self.beside[i] += factor * a * b;
        }
    }

    fn sum(terms: &[(f64, &Self)]) -> Self {
        let mut out = Self::of(terms[0].1.own.len());
        for (factor, band) in terms {
            out.own.iter_mut().zip(&band.own).for_each(|(out, x)| *out += factor * x);
            out.beside.iter_mut().zip(&band.beside).for_each(|(out, x)| *out += factor * x);
        }
        out
    }

    /// Subtracts its product with `x`.
    fn subtract_product(&self, x: &[f64], out: &mut [f64]) {
        for (i, own) in self.own.iter().enumerate() {
            let mut sum = own * x[i];
            if i > 0 {
                sum += self.beside[i - 1] * x[i - 1];
            }
            if let Some(beside) = self.beside.get(i) {
                sum += beside * x[i + 1];
            }
            out[i] -= sum;
        }
    }

    /// `L D Lᵀ`: the pivots, and L beside its diagonal.
    fn factored(mut self) -> Self {
        for i in 0..self.beside.len() {
            let part = self.beside[i] / self.own[i];
            self.own[i + 1] -= part * self.beside[i];
            self.beside[i] = part;
        }
        self
    }

    /// Solves in place with a factored matrix.
    fn solve(&self, x: &mut [f64]) {
        for i in 0..self.beside.len() {
            x[i + 1] -= self.beside[i] * x[i];
        }
        x.iter_mut().zip(&self.own).for_each(|(x, pivot)| *x /= pivot);
        for i in (0..self.beside.len()).rev() {
            x[i] -= self.beside[i] * x[i + 1];
        }
    }
}

struct Newmark {
    line: Line,
    h: f64,
    damping: Band,
    /// Without and with contact.
    stiffness: [Band; 2],
    /// `M + h/2 C + h²/4 K`, factored, of both.
    effective: [Band; 2],
    /// Mass at each node, row sums.
    lumped: Vec<f64>,
    /// First node of each bar, and one behind the last.
    bounds: Vec<usize>,
    /// Node before the gap.
    before: usize,
    closed: bool,
    u: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    residual: Vec<f64>,
    peak: f64,
    unsettled: usize,
}

impl Newmark {
    fn of(line: Line, h: f64) -> Self {
        let counts: Vec<usize> = line.bars.iter().map(|bar| elements(bar, h)).collect();
        let mut bounds = vec![0];
        for count in &counts {
            bounds.push(bounds[bounds.len() - 1] + count + 1);
        }
        let size = bounds[bounds.len() - 1];
        let [mut mass, mut damping, mut open] = [Band::of(size), Band::of(size), Band::of(size)];
        let mut v = vec![0.0; size];
        for ((bar, &count), &first) in line.bars.iter().zip(&counts).zip(&bounds) {
            assemble(bar, (first, count), [&mut mass, &mut damping, &mut open]);
            v[first..=first + count].fill(bar.speed);
        }
        let before = bounds[1] - 1;
        let mut shut = open.clone();
        shut.add(before, [1.0, if line.bars.len() > 1 { -1.0 } else { 0.0 }], line.stiffness);
        let mut lumped = vec![0.0; size];
        mass.subtract_product(&vec![-1.0; size], &mut lumped);
        let stiffness = [open, shut];
        let effective =
            [0, 1].map(|i| Band::sum(&[(1.0, &mass), (0.5 * h, &damping), (0.25 * h * h, &stiffness[i])]).factored());
        let [u, a, residual] = [vec![0.0; size], vec![0.0; size], vec![0.0; size]];
        Self {
            line,
            h,
            damping,
            stiffness,
            effective,
            lumped,
            bounds,
            before,
            closed: false,
            u,
            v,
            a,
            residual,
            peak: 0.0,
            unsettled: 0,
        }
    }

    fn depth(&self, u: &[f64]) -> f64 {
        let beyond = if self.line.bars.len() > 1 { u[self.before + 1] } else { 0.0 };
        u[self.before] - beyond - self.line.gap
    }

    /// Takes a step to `t`.
    fn step(&mut self, t: f64) {
        let (h, ground) = (self.h, self.line.ground(t));
        let place: Vec<f64> = (0..self.u.len()).map(|i| self.u[i] + h * self.v[i] + 0.25 * h * h * self.a[i]).collect();
        let speed: Vec<f64> = self.v.iter().zip(&self.a).map(|(v, a)| v + 0.5 * h * a).collect();
        let mut next = vec![0.0; place.len()];
        let mut settled = false;
        for _ in 0..MOST {
            self.accelerate(ground, &place, &speed);
            (0..place.len()).for_each(|i| next[i] = place[i] + 0.25 * h * h * self.residual[i]);
            let closed = self.depth(&next) > 0.0;
            settled = closed == self.closed;
            if settled {
                break;
            }
            self.closed = closed;
        }
        self.unsettled += usize::from(!settled);
        std::mem::swap(&mut self.a, &mut self.residual);
        self.u = next;
        self.v.iter_mut().zip(speed.iter().zip(&self.a)).for_each(|(v, (speed, a))| *v = speed + 0.5 * h * a);
        let force = self.line.stiffness * self.depth(&self.u).max(0.0);
        self.peak = self.peak.max(force / self.line.nodes);
    }

    /// Accelerations at the end of a step, into `residual`.
    fn accelerate(&mut self, ground: f64, place: &[f64], speed: &[f64]) {
        let state = usize::from(self.closed);
        self.residual.iter_mut().zip(&self.lumped).for_each(|(r, mass)| *r = -mass * ground);
        self.damping.subtract_product(speed, &mut self.residual);
        self.stiffness[state].subtract_product(place, &mut self.residual);
        if self.closed {
            let push = self.line.stiffness * self.line.gap;
            self.residual[self.before] += push;
            if self.line.bars.len() > 1 {
                self.residual[self.before + 1] -= push;
            }
        }
        self.effective[state].solve(&mut self.residual);
    }

    /// Places of the mass centres.
    fn places(&self) -> Vec<[f64; 4]> {
        let of = |(bar, bounds): (&Bar, &[usize])| {
            let nodes = bounds[0]..bounds[1];
            let sum: f64 = nodes.map(|i| self.lumped[i] * self.u[i]).sum();
            [sum / bar.mass, 0.0, 0.0, 0.0]
        };
        self.line.bars.iter().zip(self.bounds.windows(2)).map(of).collect()
    }
}

/// Elements of a bar for steps of `h`.
fn elements(bar: &Bar, h: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
    let count = (bar.length / (bar.wave_speed() * h)).ceil() as usize;
    count.max(FEWEST)
}

/// Adds a bar of so many elements from a node on.
fn assemble(bar: &Bar, (first, count): (usize, usize), [mass, damping, stiffness]: [&mut Band; 3]) {
    let (length, mu) = (bar.length / count as f64, bar.mass / count as f64);
    for i in first..first + count {
        // m/6 (2, 1; 1, 2) = m/4 (1, 1)(1, 1)ᵀ + m/12 (1, −1)(1, −1)ᵀ.
        mass.add(i, [1.0, 1.0], mu / 4.0);
        mass.add(i, [1.0, -1.0], mu / 12.0);
        stiffness.add(i, [1.0, -1.0], bar.axial / length);
        damping.add(i, [1.0, -1.0], bar.retardation * bar.axial / length);
    }
    for [at, k, c] in &bar.legs {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the bar")]
        let element = ((at / length) as usize).min(count - 1);
        let part = at / length - element as f64;
        stiffness.add(first + element, [1.0 - part, part], *k);
        damping.add(first + element, [1.0 - part, part], *c);
    }
}
