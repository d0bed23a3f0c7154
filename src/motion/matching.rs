//! A record brought to a target response spectrum: its Fourier amplitudes are multiplied by what each period lacks, its phases
//! stay, again and again (Gasparini & Vanmarcke 1976).
//!
//! At each of the control periods `T` the factor is `S_target(T) / S(T)` of 5 % pseudo-acceleration; between them it is linear in
//! logarithms, beyond them that of the last. The best of the rounds is kept.

use super::fourier::transform;
use super::spectrum::{periods, spectrum};

/// Damping of the spectra, of critical.
const DAMPING: f64 = 0.05;
/// Control periods, evenly spaced by their logarithm.
const CONTROLS: u32 = 60;
/// Rounds; the mean deviation falls no further after five to eight (measured on ten seeds).
const ROUNDS: usize = 8;

/// Value of a spectrum at a period \[s\], linear in logarithms between pairs of period and value, both above 0.
fn interpolated(target: &[[f64; 2]], period: f64) -> f64 {
    let after = target.partition_point(|pair| pair[0] < period);
    match (after.checked_sub(1).and_then(|n| target.get(n)), target.get(after)) {
        (Some(low), Some(high)) => {
            let part = (period / low[0]).ln() / (high[0] / low[0]).ln();
            low[1] * (high[1] / low[1]).powf(part)
        }
        (Some(end), None) | (None, Some(end)) => end[1],
        (None, None) => 0.0,
    }
}

/// Mean magnitude of `ln(S / S_target)` over the control periods.
fn deviation(factors: &[[f64; 2]]) -> f64 {
    factors.iter().map(|pair| pair[1].ln().abs()).sum::<f64>() / factors.len().max(1) as f64
}

/// The record matched to `target`, pairs of period \[s\] and 5 % pseudo-acceleration \[m/s²\] in growing periods, two at least.
pub fn matched(samples: &[f64], dt: f64, target: &[[f64; 2]]) -> Vec<f64> {
    let [Some(first), Some(last)] = [target.first(), target.last()] else { return samples.to_vec() };
    let controls = periods([first[0], last[0]], CONTROLS);
    let lacking = |samples: &[f64]| -> Vec<[f64; 2]> {
        let found = spectrum(samples, dt, &controls, DAMPING);
        found.iter().map(|r| [r.period, interpolated(target, r.period) / r.pseudo_acceleration()]).collect()
    };
    let (mut now, mut best) = (samples.to_vec(), (f64::INFINITY, samples.to_vec()));
    for _ in 0..ROUNDS {
        let factors = lacking(&now);
        let off = deviation(&factors);
        if !off.is_finite() {
            break;
        }
        if off < best.0 {
            best = (off, now.clone());
        }
        now = multiplied(&now, dt, &factors);
    }
    best.1
}

/// Samples whose Fourier amplitudes are multiplied by the factor of their period.
fn multiplied(samples: &[f64], dt: f64, factors: &[[f64; 2]]) -> Vec<f64> {
    let size = samples.len().next_power_of_two().max(2);
    let mut lines: Vec<[f64; 2]> = samples.iter().map(|a| [*a, 0.0]).collect();
    lines.resize(size, [0.0; 2]);
    transform(&mut lines, -1.0);
    for (n, line) in lines.iter_mut().enumerate().skip(1) {
        let number = n.min(size - n);
        let factor = interpolated(factors, size as f64 * dt / number as f64) / size as f64;
        *line = line.map(|part| part * factor);
    }
    lines[0] = [0.0; 2];
    transform(&mut lines, 1.0);
    lines.iter().take(samples.len()).map(|line| line[0]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::synthetic::Earthquake;

    const QUAKE: Earthquake = Earthquake {
        seed: 3,
        duration: 20.0,
        dt: 0.01,
        peak: 3.0,
        ground: 15.6,
        damping: 0.6,
        rise: 2.0,
        until: 10.0,
        decay: 0.3,
    };

    #[test]
    fn factors_of_one_change_nothing_but_the_mean() {
        let samples = QUAKE.samples();
        let same = multiplied(&samples, 0.01, &[[0.1, 1.0], [1.0, 1.0]]);
        let mean = same.iter().zip(&samples).map(|(a, b)| a - b).sum::<f64>() / samples.len() as f64;
        let apart = same.iter().zip(&samples).fold(0.0_f64, |most, (a, b)| most.max((a - b - mean).abs()));
        assert!(apart < 1e-12, "{apart}");
    }

    #[test]
    fn a_matched_record_has_the_target_spectrum() {
        // A plateau between 0.15 and 0.5 s, falling as 1/T beyond.
        let target = [[0.05, 3.0], [0.15, 7.5], [0.5, 7.5], [2.0, 1.875], [4.0, 0.9375]];
        for seed in 1..=3 {
            let raw = Earthquake { seed, ..QUAKE }.samples();
            let controls = periods([0.05, 4.0], 60);
            let off = |samples: &[f64]| {
                let found = spectrum(samples, 0.01, &controls, DAMPING);
                let ratio =
                    |r: &crate::motion::spectrum::Response| r.pseudo_acceleration() / interpolated(&target, r.period);
                found.iter().map(|r| ratio(r).ln().abs()).sum::<f64>() / 60.0
            };
            let after = matched(&raw, 0.01, &target);
            assert!(
                off(&after) < 0.06 && off(&after) < 0.3 * off(&raw),
                "seed {seed}: {} from {}",
                off(&after),
                off(&raw)
            );
            assert_eq!(after.len(), raw.len(), "as many samples");
        }
    }

    #[test]
    fn a_target_without_two_periods_changes_nothing() {
        let samples = QUAKE.samples();
        assert_eq!(matched(&samples, 0.01, &[]), samples, "none");
        assert_eq!(matched(&[0.0; 8], 0.01, &[[0.1, 1.0], [1.0, 1.0]]), [0.0; 8], "nothing to multiply");
    }
}
