//! The classical Runge–Kutta method of fourth order at a fixed step.

use super::interface::{Job, Method, SettingKind, Work};
use super::march::{Scheme, march};
use super::world::World;

/// The classical Runge–Kutta method.
#[derive(Debug)]
pub(super) struct RungeKutta4;

struct Rk4 {
    slopes: [Vec<f64>; 4],
    stage: Vec<f64>,
}

impl Scheme for Rk4 {
    fn new(world: &mut World) -> Self {
        let zeros = vec![0.0; world.y.len()];
        Self { slopes: std::array::from_fn(|_| zeros.clone()), stage: zeros }
    }

    fn step(&mut self, world: &mut World, t: f64, h: f64) {
        let mut y = std::mem::take(&mut world.y);
        world.slope(t, &y, &mut self.slopes[0]);
        for (i, part) in [(1, 0.5), (2, 0.5), (3, 1.0)] {
            for ((s, y), k) in self.stage.iter_mut().zip(&y).zip(&self.slopes[i - 1]) {
                *s = y + part * h * k;
            }
            world.slope(t + part * h, &self.stage, &mut self.slopes[i]);
        }
        let [a, b, c, d] = &self.slopes;
        for (i, y) in y.iter_mut().enumerate() {
            *y += h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]);
        }
        world.y = y;
    }
}

impl Method for RungeKutta4 {
    fn name(&self) -> &'static str {
        "rk4"
    }

    fn setting_kind(&self) -> SettingKind {
        SettingKind::StepsPerInterval
    }

    fn work(&self, job: &Job<'_>) -> Result<Work, String> {
        march::<Rk4>(job)
    }
}
