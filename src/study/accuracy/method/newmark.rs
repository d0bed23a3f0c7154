//! Newmark's method with average acceleration (β = 1/4, γ = 1/2) and iterations to equilibrium, as finite-element codes
//! step: `v₁ = v₀ + h/2 (a₀ + a₁)`, `q₁ = q₀ + h v₀ + h²/4 (a₀ + a₁)`, `a₁` from the forces at the end of the step.
//!
//! The iteration is Newton's with a tangent by differences, kept while it still converges quickly (modified Newton).

use super::interface::{Job, Method, SettingKind, Work};
use super::march::{Scheme, march};
use super::solve::{inverse, subtract_product};
use super::world::World;

/// Iterations before a step is taken as it is, and counted.
const MOST: usize = 30;
/// Iterations with an old tangent before a new one is made.
const PATIENCE: usize = 4;
/// Residual of velocity over a step, in parts of the speeds in play \[-\], and where there are none \[m/s\].
const EQUILIBRIUM: f64 = 1e-15;

/// Newmark's method for rigid girders.
#[derive(Debug)]
pub(super) struct Newmark;

struct Average {
    /// Accelerations at the start of the step, then at its end.
    before: Vec<f64>,
    after: Vec<f64>,
    residual: Vec<f64>,
    slope: Vec<f64>,
    state: Vec<f64>,
    /// `(∂r/∂a)⁻¹` and the step that it was made for.
    tangent: Option<(Vec<f64>, f64)>,
    unsettled: usize,
}

impl Average {
    /// State at the end of the step from the accelerations there.
    fn advance(&mut self, world: &World, h: f64) {
        self.state.copy_from_slice(&world.y);
        let (rates, size) = (world.rates(), world.rates().len());
        let mut shift = Vec::with_capacity(self.after.len());
        for (i, body) in self.state.chunks_mut(world.width).enumerate() {
            for (k, at) in rates.clone().enumerate() {
                let sum = self.before[i * size + k] + self.after[i * size + k];
                shift.push(h * body[at] + 0.25 * h * h * sum);
                body[at] += 0.5 * h * sum;
            }
        }
        let mut state = std::mem::take(&mut self.state);
        world.shift(&mut state, &shift);
        self.state = state;
    }

    /// `r = a₁ − a(q₁, v₁)`.
    fn evaluate(&mut self, world: &mut World, t: f64, h: f64) {
        self.advance(world, h);
        world.slope(t + h, &self.state, &mut self.slope);
        let forces = world.accelerations(&self.slope);
        for ((r, a), f) in self.residual.iter_mut().zip(&self.after).zip(forces) {
            *r = a - f;
        }
    }

    /// The tangent at the state in hand, column by column.
    fn differentiate(&mut self, world: &mut World, t: f64, h: f64) -> Option<Vec<f64>> {
        let n = self.after.len();
        let here = self.residual.clone();
        let mut matrix = vec![0.0; n * n];
        for column in 0..n {
            let kept = self.after[column];
            // A change of acceleration that moves the body by a ten-millionth of a metre, or a thousandth of the whole.
            let change = (1e-3 * kept.abs()).max(1e-3);
            self.after[column] += change;
            self.evaluate(world, t, h);
            self.after[column] = kept;
            for row in 0..n {
                matrix[row * n + column] = (self.residual[row] - here[row]) / change;
            }
        }
        self.residual = here;
        inverse(matrix, n)
    }

    fn settled(&self, world: &World, h: f64) -> bool {
        let fastest =
            world.rates().fold(0.0_f64, |m, at| self.state.chunks(world.width).fold(m, |m, s| m.max(s[at].abs())));
        let left = self.residual.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
        h * left <= EQUILIBRIUM * (0.1 + fastest)
    }
}

impl Scheme for Average {
    fn new(world: &mut World) -> Self {
        let mut slope = vec![0.0; world.y.len()];
        let y = world.y.clone();
        world.slope(0.0, &y, &mut slope);
        let before = world.accelerations(&slope);
        let (after, residual) = (before.clone(), vec![0.0; before.len()]);
        Self { before, after, residual, slope, state: y, tangent: None, unsettled: 0 }
    }

    fn step(&mut self, world: &mut World, t: f64, h: f64) {
        let y = world.y.clone();
        world.slope(t, &y, &mut self.slope);
        self.before = world.accelerations(&self.slope);
        self.after.clone_from(&self.before);
        if self.tangent.as_ref().is_some_and(|(_, of)| *of != h) {
            self.tangent = None;
        }
        let mut settled = false;
        for iteration in 0..MOST {
            self.evaluate(world, t, h);
            settled = self.settled(world, h);
            if settled {
                break;
            }
            if self.tangent.is_none() || (iteration > 0 && iteration % PATIENCE == 0) {
                self.tangent = self.differentiate(world, t, h).map(|inverse| (inverse, h));
            }
            let Some((tangent, _)) = &self.tangent else { break };
            subtract_product(tangent, &self.residual, &mut self.after);
        }
        self.unsettled += usize::from(!settled);
        world.y.copy_from_slice(&self.state);
    }

    fn note(&self) -> String {
        match self.unsettled {
            0 => String::new(),
            n => format!("{n} steps not in equilibrium after {MOST} iterations"),
        }
    }
}

impl Method for Newmark {
    fn name(&self) -> &'static str {
        "newmark"
    }

    fn setting_kind(&self) -> SettingKind {
        SettingKind::StepsPerInterval
    }

    fn work(&self, job: &Job<'_>) -> Result<Work, String> {
        march::<Average>(job)
    }
}
