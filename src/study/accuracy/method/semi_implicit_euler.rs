//! Semi-implicit (symplectic) Euler: velocities first, places with the new velocities. What robotics engines and games
//! step with.

use super::interface::{Job, Method, SettingKind, Work};
use super::march::{Scheme, march};
use super::world::World;

/// The semi-implicit Euler method.
#[derive(Debug)]
pub(super) struct SemiImplicitEuler;

struct Euler {
    slope: Vec<f64>,
    shift: Vec<f64>,
}

impl Scheme for Euler {
    fn new(world: &mut World) -> Self {
        Self { slope: vec![0.0; world.y.len()], shift: Vec::new() }
    }

    fn step(&mut self, world: &mut World, t: f64, h: f64) {
        let mut y = std::mem::take(&mut world.y);
        world.slope(t, &y, &mut self.slope);
        self.shift.clear();
        let rates = world.rates();
        for (state, slope) in y.chunks_mut(world.width).zip(self.slope.chunks(world.width)) {
            for i in rates.clone() {
                state[i] += h * slope[i];
                self.shift.push(h * state[i]);
            }
        }
        world.shift(&mut y, &self.shift);
        world.y = y;
    }
}

impl Method for SemiImplicitEuler {
    fn name(&self) -> &'static str {
        "semi-implicit-euler"
    }

    fn setting_kind(&self) -> SettingKind {
        SettingKind::StepsPerInterval
    }

    fn work(&self, job: &Job<'_>) -> Result<Work, String> {
        march::<Euler>(job)
    }
}
