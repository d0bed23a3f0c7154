//! Starting values: the frequency at which a displacement resonates.
//!
//! Free motion: where its Fourier amplitude is largest, `f √(1 − 2h²)` of a lasting push and `f √(1 − h²)` of a decay. On shaking
//! ground: where the ratio to the ground's Fourier amplitude is, among frequencies at which the ground has a share of
//! `SHAKEN` of its largest.

use std::f64::consts::TAU;

use num_complex::Complex64;

use crate::motion::oscillator::Shaking;

/// Frequencies that are looked at first, evenly spaced by their logarithm.
const COUNT: u32 = 240;
/// Number of refinements of the neighbourhood of the largest, each by four.
const CLOSER: u32 = 4;
/// Share of the ground's largest Fourier amplitude below which a ratio is noise.
const SHAKEN: f64 = 0.1;

/// Magnitude of `Σ x exp(−2πi f t)`.
fn amplitude(at: impl Iterator<Item = (f64, f64)>, f: f64) -> f64 {
    at.map(|(t, x)| x * Complex64::from_polar(1.0, -TAU * f * t)).sum::<Complex64>().norm()
}

/// Frequencies that a history can show: from one period in its length to nine tenths of half its rate \[Hz\].
pub fn band(times: &[f64]) -> [f64; 2] {
    let length = times[times.len() - 1] - times[0];
    let lowest = 1.0 / length;
    [lowest, (0.45 * (times.len() - 1) as f64 / length).max(2.0 * lowest)]
}

/// So many frequencies between two, evenly spaced by their logarithm.
pub fn spaced([low, high]: [f64; 2], count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |n| low * (high / low).powf(f64::from(n) / f64::from(count - 1)))
}

/// Frequency of the resonance of a displacement \[m\] at these times \[s\] \[Hz\].
pub fn resonance(times: &[f64], x: &[f64], shaking: &Shaking) -> f64 {
    let mean = x.iter().sum::<f64>() / x.len() as f64;
    let moved = |f: f64| amplitude(times.iter().zip(x).map(|(t, x)| (*t, x - mean)), f);
    let ground = ground_in(times, shaking);
    let shaken = |f: f64| amplitude(ground.iter().copied(), f);
    let [low, high] = band(times);
    let grid: Vec<f64> = spaced([low, high], COUNT).collect();
    let of_ground: Vec<f64> = grid.iter().map(|f| shaken(*f)).collect();
    let floor = SHAKEN * of_ground.iter().copied().fold(0.0, f64::max);
    let ratio = |f: f64, shaken: f64| match shaken {
        _ if floor == 0.0 => moved(f),
        less if less < floor => 0.0,
        enough => moved(f) / enough,
    };
    let largest = |among: &mut dyn Iterator<Item = (f64, f64)>| {
        let all = among.map(|(f, shaken)| (ratio(f, shaken), f));
        all.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(low, |(_, f)| f)
    };
    let mut best = largest(&mut grid.into_iter().zip(of_ground));
    let mut width = (high / low).powf(1.0 / f64::from(COUNT - 1));
    for _ in 0..CLOSER {
        best = largest(&mut spaced([best / width, best * width], 9).map(|f| (f, shaken(f))));
        width = width.powf(0.25);
    }
    best
}

/// Samples of the ground while the displacement was measured; none of a sine, which shows one frequency alone.
fn ground_in(times: &[f64], shaking: &Shaking) -> Vec<(f64, f64)> {
    let Shaking::Samples { dt, values } = shaking else { return Vec::new() };
    let within = times[0]..=times[times.len() - 1];
    let all = values.iter().enumerate().map(|(n, a)| (n as f64 * dt, *a));
    all.filter(|(t, _)| within.contains(t)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::oscillator::{forced, free};

    #[test]
    fn a_decay_and_a_shaken_oscillator_resonate_near_their_frequency() {
        let times: Vec<f64> = (0..800).map(|n| 0.01 * f64::from(n)).collect();
        let oscillator = [TAU * 2.4, 0.05];
        let decay = &free(oscillator, &times)[0];
        let found = resonance(&times, decay, &Shaking::Still);
        assert!((found / 2.4 - 1.0).abs() < 0.01, "decay: {found} Hz");
        // A ramp of frequency through the resonance.
        let values = (0..8000).map(|n| f64::from(n) * 1e-3).map(|t| (TAU * (1.0 + 0.4 * t) * t).sin()).collect();
        let shaking = Shaking::Samples { dt: 1e-3, values };
        let found = resonance(&times, &forced(&shaking, oscillator, &times), &shaking);
        assert!((found / 2.4 - 1.0).abs() < 0.03, "sweep: {found} Hz");
    }
}
