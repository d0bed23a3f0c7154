//! Dormand and Prince's 5(4) pair with its own step control and continuous answer, no event located: what a general
//! solver of ordinary differential equations does with a gap test in its right-hand side. The friction state is brought
//! up to date after every accepted step.
//!
//! Coefficients and continuous extension after Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I,
//! II.5 and II.6.

use super::interface::{Job, Method, SettingKind, Work};
use super::world::World;
use crate::study::accuracy::Answer;
use crate::study::accuracy::answer::INTERVALS;

const C: [f64; 7] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
const A: [[f64; 6]; 7] = [
    [0.0; 6],
    [0.2, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// Fifth order less fourth.
const E: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
/// Of the continuous extension.
const D: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// Accepted and refused steps before it is given up.
const MOST: usize = 20_000_000;
/// Absolute over relative tolerance, in the unit of the component: errors are divided by `tolerance · (ABSOLUTE + |y|)`. Chosen.
const ABSOLUTE: f64 = 1e-2;

/// The method of Dormand and Prince, order 5(4).
#[derive(Debug)]
pub(super) struct DormandPrince;

struct Pair {
    k: [Vec<f64>; 7],
    stage: Vec<f64>,
}

impl Pair {
    /// Tries a step; the state at its end is left in `stage`. Returns the error against the tolerance.
    fn attempt(&mut self, world: &mut World, t: f64, y: &[f64], h: f64, tolerance: f64) -> f64 {
        for i in 1..7 {
            for (n, y) in y.iter().enumerate() {
                let sum: f64 = (0..i).map(|j| A[i][j] * self.k[j][n]).sum();
                self.stage[n] = y + h * sum;
            }
            let (_, rest) = self.k.split_at_mut(i);
            world.slope(t + C[i] * h, &self.stage, &mut rest[0]);
        }
        let error = |n: usize| {
            let error: f64 = h * (0..7).map(|i| E[i] * self.k[i][n]).sum::<f64>();
            error / (tolerance * (ABSOLUTE + y[n].abs().max(self.stage[n].abs())))
        };
        ((0..y.len()).map(|n| error(n).powi(2)).sum::<f64>() / y.len() as f64).sqrt()
    }

    /// The state at the part `s` of the step from `y` to `stage`.
    fn between(&self, y: &[f64], h: f64, s: f64) -> Vec<f64> {
        let r = 1.0 - s;
        let state = |(n, y): (usize, &f64)| {
            let difference = self.stage[n] - y;
            let bend = h * self.k[0][n] - difference;
            let fourth = difference - h * self.k[6][n] - bend;
            let fifth = h * (0..7).map(|i| D[i] * self.k[i][n]).sum::<f64>();
            y + s * (difference + r * (bend + s * (fourth + r * fifth)))
        };
        y.iter().enumerate().map(state).collect()
    }
}

/// Everything up to the last instant.
fn follow(world: &mut World, job: &Job<'_>) -> Result<Answer, String> {
    let zeros = vec![0.0; world.y.len()];
    let mut pair = Pair { k: std::array::from_fn(|_| zeros.clone()), stage: zeros };
    let until = job.instants.until;
    let mut places = world.places(&world.y);
    let (mut t, mut next, mut steps, mut refused) = (0.0, 1, 0, 0);
    // At rest nothing shows how fast things will be: no step is longer than a fifth of an interval of comparison at first.
    let mut h: f64 = until / (5 * INTERVALS) as f64;
    let y = world.y.clone();
    world.slope(t, &y, &mut pair.k[0]);
    while next <= INTERVALS {
        let y = world.y.clone();
        let taken = h.min(until / 200.0).min(until - t);
        let error = pair.attempt(world, t, &y, taken, job.setting);
        h = taken * (0.9 * error.powf(-0.2)).clamp(0.2, 5.0);
        if error.is_nan() || error > 1.0 {
            refused += 1;
            h = if error.is_nan() { 0.1 * taken } else { h.min(taken) };
            if h < 1e-15 * until || steps + refused > MOST {
                return Err(format!("gave up at {t:.6} s: a step of {h:.1e} s after {} steps", steps + refused));
            }
            continue;
        }
        let last = t + taken >= until * (1.0 - 1e-14);
        while next <= INTERVALS && (last || job.instants.at(next) <= t + taken) {
            let part = ((job.instants.at(next) - t) / taken).min(1.0);
            places.extend(world.places(&pair.between(&y, taken, part)));
            next += 1;
        }
        t += taken;
        steps += 1;
        if steps + refused > MOST {
            return Err(format!("gave up at {t:.6} s after {MOST} steps"));
        }
        world.y.copy_from_slice(&pair.stage);
        if world.settle() || world.width > 6 {
            let y = world.y.clone();
            world.slope(t, &y, &mut pair.k[0]);
        } else {
            pair.k.swap(0, 6);
        }
    }
    let note = if refused > 0 { format!("{refused} steps refused") } else { String::new() };
    Ok(Answer { places, bodies: world.model.bodies.len(), peak_force: world.peak_force(), steps, note })
}

impl Method for DormandPrince {
    fn name(&self) -> &'static str {
        "dormand-prince"
    }

    fn setting_kind(&self) -> SettingKind {
        SettingKind::Tolerance
    }

    fn work(&self, job: &Job<'_>) -> Result<Work, String> {
        let mut world = World::new(job.scene)?;
        follow(&mut world, job).map(Work::Sampled)
    }
}
