//! Frequency and damping of least squares, with intervals.

use std::f64::consts::TAU;

use super::least_squares::{self, Model, Solution, dot};
use super::noise::{Noise, student_95};
use super::resonance::{band, resonance, spaced};
use crate::language::{Text, said};
use crate::motion::oscillator::{Shaking, forced, free};

/// A measured displacement, relative to the ground.
#[derive(Clone, Copy, Debug)]
pub struct History<'a> {
    /// Times, growing \[s\].
    pub times: &'a [f64],
    /// Displacements \[m\].
    pub x: &'a [f64],
    /// Motion of the ground along it.
    pub shaking: &'a Shaking,
    /// Whether the ground motion is known only up to a factor, which is fitted too.
    pub scaled: bool,
}

/// Measured amplitudes of a steady motion under sines of constant acceleration.
#[derive(Clone, Copy, Debug)]
pub struct SteadyResponse<'a> {
    /// Frequencies, growing \[Hz\].
    pub frequencies: &'a [f64],
    /// Amplitudes of the displacement relative to the ground \[m\].
    pub amplitudes: &'a [f64],
    /// Amplitude of the ground's acceleration, where it is known \[m/s²\].
    pub ground: Option<f64>,
}

/// Parameters that are given, not fitted.
#[derive(Clone, Copy, Debug, Default)]
pub struct Given {
    /// The natural frequency, where damping alone is looked for \[Hz\].
    pub frequency: Option<f64>,
}

/// A value with half the width of its interval of 95 %.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Name of the parameter.
    pub name: Text,
    /// Its unit; empty of a ratio.
    pub unit: &'static str,
    /// Of least squares, in SI.
    pub value: f64,
    /// The truth lies within it 95 times in 100; 0 of what was given.
    pub half_width: f64,
}

/// Parameters by least squares, and their quality.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Natural frequency f \[Hz\].
    pub frequency: Estimate,
    /// Damping ratio h.
    pub damping: Estimate,
    /// Further fitted parameters.
    pub others: Vec<Estimate>,
    /// Frequency of the resonance that the search began at \[Hz\].
    pub resonance: f64,
    /// Values of the model at the measured places \[m\].
    pub fitted: Vec<f64>,
    /// Measured less fitted \[m\].
    pub residuals: Vec<f64>,
    /// Statistics of the residuals.
    pub noise: Noise,
    /// Root mean square of the residuals as a share of that of the measured, less its mean.
    pub unexplained: f64,
}

impl Identified {
    /// Whether the damping ratio lies at the highest that is looked for: the motion does not swing, and neither value nor interval says
    /// how much it is damped.
    pub fn is_at_the_bound(&self) -> bool {
        self.damping.value > AT_THE_BOUND * MOST_DAMPING
    }
}

/// Reasons of a failed identification, with remedies.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotIdentified {
    /// Too few rows.
    #[error("{}", said!("identify-too-few", "have" => *have, "need" => *need))]
    TooFew {
        /// Rows.
        have: usize,
        /// Rows needed.
        need: usize,
    },
    /// It does not move.
    #[error("{}", Text::new("identify-no-motion"))]
    Still,
    /// Frequency and damping change nothing that was measured, or alike.
    #[error("{}", Text::new("identify-undetermined"))]
    Undetermined,
}

/// Highest damping ratio that is looked for: an overdamped girder has no resonance.
const MOST_DAMPING: f64 = 0.99;
/// Part of it from which a value counts as held by it: a search ends within a thousandth (measured on decays of h = 1 and 1.5).
const AT_THE_BOUND: f64 = 0.995;
/// Damping ratios to start from.
const DAMPINGS: [f64; 7] = [0.003, 0.01, 0.03, 0.1, 0.2, 0.35, 0.6];
/// Frequencies to start from, of that of the resonance: the resonance of h = 0.6 lies at 0.53 f.
const NEAR: [f64; 11] = [0.8, 0.9, 0.95, 0.98, 1.0, 1.02, 1.05, 1.1, 1.25, 1.5, 2.0];
/// Frequencies to start from over the whole band where the ground shakes: a sine shows no resonance, noise can hide one (chosen).
const OVER_BAND: u32 = 24;
/// Damping ratios to start from with these: the neighbours of a frequency are a fifth or more away.
const DAMPINGS_OVER_BAND: [f64; 2] = [0.05, 0.25];
/// Starts that least squares follows: those of the least sum of squares (chosen).
const FOLLOWED: usize = 4;
/// Relative step of the central differences by f and h: truncation is of order 1e-12 (1e-6 over 1e3 periods), rounding 1e-10.
const MOVED: f64 = 1e-6;
/// Rows beyond the number of parameters at least.
const ROWS_LEFT: usize = 5;

/// Name and unit of a parameter.
type Named = (Text, &'static str);

const FREQUENCY: Named = (Text::new("identify-frequency"), "Hz");
const DAMPING: Named = (Text::new("identify-damping"), "");

/// The model's values as a sum of columns with known and unknown factors.
struct Parts {
    known: Vec<f64>,
    unknown: Vec<Vec<f64>>,
}

/// A model that is linear in all but frequency and damping.
trait Linear {
    /// The columns at a frequency \[Hz\] and a damping ratio.
    fn parts(&self, f: f64, h: f64) -> Parts;

    /// Names of the linear factors.
    fn names(&self) -> Vec<Named>;
}

impl Linear for History<'_> {
    fn parts(&self, f: f64, h: f64) -> Parts {
        let shaken = forced(self.shaking, [TAU * f, h], self.times);
        let [placed, pushed] = free([TAU * f, h], self.times);
        let mut unknown = vec![placed, pushed, vec![1.0; self.times.len()]];
        let mut known = shaken;
        if self.scaled {
            let none = vec![0.0; known.len()];
            unknown.push(std::mem::replace(&mut known, none));
        }
        Parts { known, unknown }
    }

    fn names(&self) -> Vec<Named> {
        let mut names = vec![
            (Text::new("identify-displacement"), "m"),
            (Text::new("identify-velocity"), "m/s"),
            (Text::new("identify-zero"), "m"),
        ];
        names.extend(self.scaled.then_some((Text::new("identify-factor"), "")));
        names
    }
}

impl Linear for SteadyResponse<'_> {
    fn parts(&self, f: f64, h: f64) -> Parts {
        let omega = TAU * f;
        let gain = |drive: f64| 1.0 / (omega * omega - drive * drive).hypot(2.0 * h * omega * drive);
        let column: Vec<f64> = self.frequencies.iter().map(|f| gain(TAU * f)).collect();
        match self.ground {
            Some(a) => Parts { known: column.iter().map(|gain| gain * a).collect(), unknown: Vec::new() },
            None => Parts { known: vec![0.0; column.len()], unknown: vec![column] },
        }
    }

    fn names(&self) -> Vec<Named> {
        self.ground.is_none().then_some((Text::new("identify-amplitude"), "m/s²")).into_iter().collect()
    }
}

/// All parameters: frequency unless it is given, damping, factors of the columns.
struct All<'a, L> {
    linear: &'a L,
    given: Option<f64>,
}

impl<L: Linear> All<'_, L> {
    fn split<'p>(&self, p: &'p [f64]) -> Option<([f64; 2], &'p [f64])> {
        let (f, rest) = match self.given {
            Some(f) => (f, p),
            None => (p[0], &p[1..]),
        };
        let sound = f.is_finite() && f > 0.0 && rest[0] > 0.0 && rest[0] < MOST_DAMPING;
        sound.then_some(([f, rest[0]], &rest[1..]))
    }

    fn at(&self, [f, h]: [f64; 2], factors: &[f64]) -> Vec<f64> {
        let Parts { mut known, unknown } = self.linear.parts(f, h);
        for (factor, column) in factors.iter().zip(&unknown) {
            known.iter_mut().zip(column).for_each(|(sum, value)| *sum += factor * value);
        }
        known
    }

    /// Factors of the columns that fit best at a frequency and a damping ratio, and the sum of squares that they leave.
    fn projected(&self, [f, h]: [f64; 2], measured: &[f64]) -> Option<(Vec<f64>, f64)> {
        let Parts { known, unknown } = self.linear.parts(f, h);
        let mut left: Vec<f64> = measured.iter().zip(&known).map(|(x, known)| x - known).collect();
        let factors = if unknown.is_empty() { Vec::new() } else { least_squares::linear(&unknown, &left)? };
        for (factor, column) in factors.iter().zip(&unknown) {
            left.iter_mut().zip(column).for_each(|(x, value)| *x -= factor * value);
        }
        let cost = dot(&left, &left);
        cost.is_finite().then_some((factors, cost))
    }

    /// The solution from the best of many starts.
    fn solve(&self, measured: &[f64], oscillators: Vec<[f64; 2]>) -> Option<Solution> {
        let mut starts = Vec::new();
        let oscillators = self.given.map_or(oscillators, |f| DAMPINGS.map(|h| [f, h]).to_vec());
        for [f, h] in oscillators {
            if let Some((factors, cost)) = self.projected([f, h], measured) {
                let own = self.given.is_none().then_some(f);
                let start: Vec<f64> = own.into_iter().chain([h]).chain(factors).collect();
                starts.push((cost, start));
            }
        }
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let ends = starts.iter().take(FOLLOWED).filter_map(|(_, start)| least_squares::fit(self, measured, start));
        ends.min_by(|a, b| a.cost.total_cmp(&b.cost))
    }
}

impl<L: Linear> Model for All<'_, L> {
    fn values(&self, parameters: &[f64]) -> Option<Vec<f64>> {
        let (oscillator, factors) = self.split(parameters)?;
        Some(self.at(oscillator, factors))
    }

    fn slopes(&self, parameters: &[f64]) -> Option<Vec<Vec<f64>>> {
        let ([f, h], factors) = self.split(parameters)?;
        let by = |step: [f64; 2], width: f64| {
            let [above, below] = [1.0, -1.0].map(|s| self.at([f + s * step[0], h + s * step[1]], factors));
            above.iter().zip(&below).map(|(a, b)| (a - b) / (2.0 * width)).collect::<Vec<f64>>()
        };
        let of_frequency = self.given.is_none().then(|| by([MOVED * f, 0.0], MOVED * f));
        let of_damping = by([0.0, MOVED * h], MOVED * h);
        let unknown = self.linear.parts(f, h).unknown;
        Some(of_frequency.into_iter().chain([of_damping]).chain(unknown).collect())
    }
}

/// Identifies f and h from a history.
///
/// # Errors
/// A history that does not move, is too short, or does not depend on f and h.
pub fn from_history(history: &History<'_>, given: Given) -> Result<Identified, NotIdentified> {
    let History { times, x, shaking, .. } = history;
    checked(history, x, given)?;
    let resonance = resonance(times, x, shaking);
    let band = band(times);
    let mut starts = near(resonance);
    starts.retain(|[f, _]| (0.5 * band[0]..=2.0 * band[1]).contains(f));
    if !matches!(shaking, Shaking::Still) {
        starts.extend(spaced(band, OVER_BAND).flat_map(|f| DAMPINGS_OVER_BAND.map(|h| [f, h])));
    }
    identified((history, x), given, (resonance, starts), is_even(times))
}

/// Identifies f and h from steady amplitudes over frequency.
///
/// # Errors
/// As of [`from_history`].
pub fn from_response(response: &SteadyResponse<'_>, given: Given) -> Result<Identified, NotIdentified> {
    let SteadyResponse { frequencies, amplitudes, .. } = response;
    checked(response, amplitudes, given)?;
    let all = frequencies.iter().zip(*amplitudes);
    let resonance = all.max_by(|a, b| a.1.total_cmp(b.1)).map_or(0.0, |(f, _)| *f);
    identified((response, amplitudes), given, (resonance, near(resonance)), is_even(frequencies))
}

/// Oscillators to start from around a resonance.
fn near(resonance: f64) -> Vec<[f64; 2]> {
    NEAR.iter().flat_map(|share| DAMPINGS.map(|h| [share * resonance, h])).collect()
}

/// Whether values lie evenly, to a hundredth of their interval.
fn is_even(values: &[f64]) -> bool {
    let interval = (values[values.len() - 1] - values[0]) / (values.len() - 1) as f64;
    let off = |(n, value): (usize, &f64)| (value - values[0] - n as f64 * interval).abs();
    values.iter().enumerate().all(|value| off(value) <= 0.01 * interval)
}

/// Refuses what cannot be fitted.
fn checked(linear: &impl Linear, measured: &[f64], given: Given) -> Result<(), NotIdentified> {
    let parameters = linear.names().len() + 1 + usize::from(given.frequency.is_none());
    let (have, need) = (measured.len(), parameters + ROWS_LEFT);
    if have < need {
        return Err(NotIdentified::TooFew { have, need });
    }
    if measured.iter().all(|x| *x == measured[0]) {
        return Err(NotIdentified::Still);
    }
    Ok(())
}

fn identified(
    (linear, measured): (&impl Linear, &[f64]),
    given: Given,
    (resonance, starts): (f64, Vec<[f64; 2]>),
    evenly: bool,
) -> Result<Identified, NotIdentified> {
    let all = All { linear, given: given.frequency };
    let solution = all.solve(measured, starts).ok_or(NotIdentified::Undetermined)?;
    let noise = Noise::of(&solution.residuals, solution.parameters.len(), evenly);
    let covariance = noise.covariance(&solution).ok_or(NotIdentified::Undetermined)?;
    let factor = student_95(measured.len() - solution.parameters.len());
    let fitted_ones =
        (0..).zip(given.frequency.is_none().then_some(FREQUENCY).into_iter().chain([DAMPING]).chain(linear.names()));
    let mut estimates: Vec<Estimate> = fitted_ones
        .map(|(i, (name, unit)): (usize, Named)| Estimate {
            name,
            unit,
            value: solution.parameters[i],
            half_width: factor * covariance[i][i].max(0.0).sqrt(),
        })
        .collect();
    let held = |value| Estimate { name: FREQUENCY.0, unit: FREQUENCY.1, value, half_width: 0.0 };
    let frequency = given.frequency.map_or_else(|| estimates.remove(0), held);
    let damping = estimates.remove(0);
    let mean = measured.iter().sum::<f64>() / measured.len() as f64;
    let moved: f64 = measured.iter().map(|x| (x - mean) * (x - mean)).sum();
    let fitted = measured.iter().zip(&solution.residuals).map(|(x, r)| x - r).collect();
    let unexplained = (solution.cost / moved).sqrt();
    Ok(Identified {
        frequency,
        damping,
        others: estimates,
        resonance,
        fitted,
        residuals: solution.residuals,
        noise,
        unexplained,
    })
}
