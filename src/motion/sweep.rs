//! A sine sweep: a sine of constant amplitude whose frequency rises or falls from one value to another.
//!
//! `a(t) = A sin φ(t)`, `φ' = 2π f(t)`, for `0 ≤ t ≤ T`, with the phase in closed form:
//!
//! - linear, `f = f₀ + (f₁ − f₀) t/T`: `φ = 2π (f₀ t + (f₁ − f₀) t²/(2T))`;
//! - logarithmic, `f = f₀ exp(r t/T)`, `r = ln(f₁/f₀)`: `φ = 2π f₀ (T/r) (exp(r t/T) − 1)`.
//!
//! The response of a damped oscillator to either has no elementary closed form (Fresnel integrals and incomplete gamma
//! functions of complex argument), so bodies are shaken by samples with straight lines between them, as by a record. Between
//! samples `dt` apart straight lines differ from `a` by at most `dt²/8 max|a''|`, and `|a''| ≤ A (φ'² + |φ''|)`: the interval
//! follows from a bound of that difference, [`LINE_ERROR`].

use std::f64::consts::TAU;

/// Largest difference between the sweep and the straight lines between its samples, as a share of its amplitude. The steady
/// amplitude of a sine of its highest frequency is lowered by two thirds of it (`sinc²(φ' dt/2) = 1 − (φ' dt)²/12 + …`).
pub const LINE_ERROR: f64 = 1e-4;

/// Frequency of a sweep as a function of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// By the same number of hertz each second.
    Linear,
    /// By the same factor each second.
    Logarithmic,
}

/// A sine sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sweep {
    /// `A` \[m/s²\].
    pub amplitude: f64,
    /// `f₀` \[Hz\].
    pub from: f64,
    /// `f₁` \[Hz\].
    pub to: f64,
    /// `T` \[s\].
    pub length: f64,
    /// Frequency as a function of time between the two.
    pub rate: Rate,
}

impl Sweep {
    /// Frequency `f(t)` \[Hz\].
    pub fn frequency(&self, t: f64) -> f64 {
        match self.rate {
            Rate::Linear => self.from + (self.to - self.from) * (t / self.length),
            Rate::Logarithmic => self.from * (self.octaves() * t / self.length).exp(),
        }
    }

    /// Phase `φ(t)` \[rad\].
    pub fn phase(&self, t: f64) -> f64 {
        match self.rate {
            Rate::Linear => TAU * t * (self.from + 0.5 * (self.to - self.from) * (t / self.length)),
            Rate::Logarithmic => {
                let grown = self.octaves() * t / self.length;
                let mean = if grown == 0.0 { 1.0 } else { grown.exp_m1() / grown };
                TAU * self.from * t * mean
            }
        }
    }

    /// `a(t)`; 0 before and after the sweep \[m/s²\].
    pub fn acceleration(&self, t: f64) -> f64 {
        if (0.0..=self.length).contains(&t) { self.amplitude * self.phase(t).sin() } else { 0.0 }
    }

    /// `r = ln(f₁/f₀)`.
    fn octaves(&self) -> f64 {
        (self.to / self.from).ln()
    }

    /// Number of intervals between samples, as a float: it may exceed every count.
    pub fn intervals(&self) -> f64 {
        let highest = TAU * self.from.max(self.to);
        // φ'' of the logarithmic rate is φ' r/T, largest where φ' is.
        let growth = match self.rate {
            Rate::Linear => TAU * (self.to - self.from).abs() / self.length,
            Rate::Logarithmic => highest * self.octaves().abs() / self.length,
        };
        let longest = (8.0 * LINE_ERROR / (highest * highest + growth)).sqrt();
        (self.length / longest).ceil().max(1.0)
    }

    /// Interval between samples \[s\].
    pub fn interval(&self) -> f64 {
        self.length / self.intervals()
    }

    /// Samples from t = 0 to t = T, both among them \[m/s²\]; of at most `most` intervals.
    pub fn samples(&self, most: u32) -> Vec<f64> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to a u32")]
        let count = self.intervals().min(f64::from(most)) as u32;
        (0..=count).map(|n| self.amplitude * self.phase(f64::from(n) * self.interval()).sin()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAPER: Sweep = Sweep { amplitude: 0.5, from: 1.0, to: 8.0, length: 20.0, rate: Rate::Linear };

    fn sweeps() -> impl Iterator<Item = Sweep> {
        let rates = [Rate::Linear, Rate::Logarithmic];
        let ends = [(1.0, 8.0), (8.0, 1.0), (3.0, 3.0), (0.1, 0.1 + 1e-13)];
        rates.into_iter().flat_map(move |rate| ends.map(|(from, to)| Sweep { from, to, rate, ..PAPER }))
    }

    #[test]
    fn the_frequency_is_the_rate_of_the_phase_and_runs_between_its_ends() {
        for sweep in sweeps() {
            for n in 1..40 {
                let (t, h) = (0.5 * f64::from(n), 1e-5);
                let rate = (sweep.phase(t + h) - sweep.phase(t - h)) / (2.0 * h) / TAU;
                assert!((rate - sweep.frequency(t)).abs() < 1e-7 * sweep.frequency(t), "{sweep:?} at {t} s: {rate} Hz");
            }
            assert_eq!(sweep.phase(0.0), 0.0, "{sweep:?} begins at rest");
            let [first, last] = [0.0, sweep.length].map(|t| sweep.frequency(t));
            assert!((first - sweep.from).abs() + (last - sweep.to).abs() < 1e-14 * sweep.to.max(1.0), "{sweep:?}");
        }
    }

    #[test]
    fn straight_lines_between_samples_stay_within_the_stated_error() {
        for sweep in sweeps() {
            let (dt, samples) = (sweep.interval(), sweep.samples(u32::MAX));
            let middle = |n: usize| (sweep.acceleration((n as f64 + 0.5) * dt), 0.5 * (samples[n] + samples[n + 1]));
            let off = |n: usize| middle(n).0 - middle(n).1;
            let largest = (0..samples.len() - 1).fold(0.0, |most: f64, n| most.max(off(n).abs()));
            let share = largest / sweep.amplitude / LINE_ERROR;
            assert!(share <= 1.0 + 1e-9 && share > 0.5, "{sweep:?}: {share} of the bound");
            assert!((samples.len() as f64 - 1.0) * dt - sweep.length < 1e-12, "the last sample ends the sweep");
        }
    }
}
