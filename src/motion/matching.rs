//! A record brought to a target response spectrum: its Fourier amplitudes are multiplied by what each period lacks, its phases
//! stay, again and again (Gasparini & Vanmarcke 1976).
//!
//! At each of the control periods `T` the factor is `S_target(T) / S(T)` of 5 % pseudo-acceleration; between them it is linear in
//! logarithms. Below the shortest it is that of the shortest, beyond the longest `T_n` that of the longest by `(T_n / T)²`: the target
//! says nothing there, and a ground that went on shaking as strongly at ever longer periods would drift away by metres. After each
//! round the ends are tapered and the ground is brought to rest where it began. The best of the rounds is kept.

use super::fourier::transform;
use super::process::taper;
use super::spectrum::{DESIGN_DAMPING, periods, spectrum};

/// Control periods, evenly spaced by their logarithm.
const CONTROLS: u32 = 60;
/// Taper of both ends, in parts of the length: a record begins and ends without a jump.
const TAPER: f64 = 0.02;
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
        let found = spectrum(samples, dt, &controls, DESIGN_DAMPING);
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
        at_rest(&mut now, dt);
    }
    best.1
}

/// The record with the amplitudes of periods `T` beyond `longest` \[s\] multiplied by `(longest / T)²`, both ends tapered, brought to rest
/// where it began.
pub fn without_drift(samples: &[f64], dt: f64, longest: f64) -> Vec<f64> {
    let mut now = multiplied(samples, dt, &[[longest, 1.0]]);
    at_rest(&mut now, dt);
    now
}

/// Samples whose Fourier amplitudes are multiplied by the factor of their period.
fn multiplied(samples: &[f64], dt: f64, factors: &[[f64; 2]]) -> Vec<f64> {
    // As long again in zeros: what a factor spreads beyond the end does not come in at the beginning.
    let size = (2 * samples.len()).next_power_of_two().max(2);
    let longest = factors.last().map_or(f64::INFINITY, |pair| pair[0]);
    let mut lines: Vec<[f64; 2]> = samples.iter().map(|a| [*a, 0.0]).collect();
    lines.resize(size, [0.0; 2]);
    transform(&mut lines, -1.0);
    for (n, line) in lines.iter_mut().enumerate().skip(1) {
        let number = n.min(size - n);
        let period = size as f64 * dt / number as f64;
        let beyond = (longest / period).min(1.0);
        let factor = interpolated(factors, period) * beyond * beyond / size as f64;
        *line = line.map(|part| part * factor);
    }
    lines[0] = [0.0; 2];
    transform(&mut lines, 1.0);
    lines.iter().take(samples.len()).map(|line| line[0]).collect()
}

/// Tapers both ends, and takes off as much of `sin² πt/T` and of `(t/T − 1/2) sin² πt/T` as leaves neither velocity nor displacement
/// at the end T. Samples are joined by straight lines, so that `v(T) = Δt Σ a` and `u(T) = Δt Σ a (T − t)` where both ends are 0.
fn at_rest(samples: &mut [f64], dt: f64) {
    let Some(last) = samples.len().checked_sub(1).filter(|last| *last > 1) else { return };
    taper(samples, dt, TAPER * last as f64 * dt);
    let part = |i: usize| i as f64 / last as f64;
    let shapes = |i: usize| {
        // From the nearer end: exactly 0 at both.
        let bump = (std::f64::consts::PI * part(i.min(last - i))).sin().powi(2);
        [bump, bump * (part(i) - 0.5)]
    };
    // The matrix of both conditions and both shapes, and what is to go.
    let ([mut m, mut gone], weights) = ([[0.0; 4]; 2], |i: usize| [1.0, 1.0 - part(i)]);
    for (i, a) in samples.iter().enumerate() {
        for (row, weight) in weights(i).into_iter().enumerate() {
            gone[row] += weight * a;
            for (column, shape) in shapes(i).into_iter().enumerate() {
                m[2 * row + column] += weight * shape;
            }
        }
    }
    let determinant = m[0] * m[3] - m[1] * m[2];
    if determinant == 0.0 {
        return;
    }
    let much = [(gone[0] * m[3] - gone[1] * m[1]) / determinant, (gone[1] * m[0] - gone[0] * m[2]) / determinant];
    for (i, a) in samples.iter_mut().enumerate() {
        let [one, other] = shapes(i);
        *a -= much[0] * one + much[1] * other;
    }
}

/// Mean deviation of a record's spectrum from a target, in parts of it.
pub fn deviation_from(samples: &[f64], dt: f64, target: &[[f64; 2]]) -> f64 {
    let [Some(first), Some(last)] = [target.first(), target.last()] else { return 0.0 };
    let found = spectrum(samples, dt, &periods([first[0], last[0]], CONTROLS), DESIGN_DAMPING);
    let factors: Vec<[f64; 2]> =
        found.iter().map(|r| [r.period, interpolated(target, r.period) / r.pseudo_acceleration()]).collect();
    deviation(&factors).exp_m1()
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
        let same = multiplied(&samples, 0.01, &[[0.1, 1.0], [100.0, 1.0]]);
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
                let found = spectrum(samples, 0.01, &controls, DESIGN_DAMPING);
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
            assert_eq!([after[0], after[after.len() - 1]], [0.0; 2], "no jump at either end");
            let (mut v, mut u, mut farthest) = (0.0, 0.0, 0.0_f64);
            for pair in after.windows(2) {
                u += 0.01 * v + 1e-4 * (pair[0] / 3.0 + pair[1] / 6.0);
                v += 0.005 * (pair[0] + pair[1]);
                farthest = farthest.max(f64::abs(u));
            }
            assert!(f64::abs(v) < 1e-10 && f64::abs(u) < 1e-9, "at rest where it began: {v} m/s, {u} m");
            // Twice the displacement of the target at its longest period.
            let longest = 0.9375 * (4.0 / std::f64::consts::TAU).powi(2);
            assert!(farthest < 2.0 * longest, "seed {seed}: {farthest} m against {longest} m");
        }
    }

    #[test]
    fn without_drift_a_record_ends_where_it_began_and_shakes_short_periods_as_before() {
        // Its velocity at the end is 1.2 m/s, its displacement tens of metres.
        let raw = Earthquake { seed: 1, duration: 40.0, ..QUAKE }.samples();
        let still = without_drift(&raw, 0.01, 10.0);
        let (mut v, mut u, mut farthest) = (0.0, 0.0, 0.0_f64);
        for pair in still.windows(2) {
            u += 0.01 * v + 1e-4 * (pair[0] / 3.0 + pair[1] / 6.0);
            v += 0.005 * (pair[0] + pair[1]);
            farthest = farthest.max(f64::abs(u));
        }
        assert!(f64::abs(v) < 1e-10 && f64::abs(u) < 1e-9 && farthest < 2.0, "{v} m/s, {u} m, at most {farthest} m");
        let of = |samples: &[f64]| spectrum(samples, 0.01, &periods([0.1, 2.0], 20), DESIGN_DAMPING);
        for (before, after) in of(&raw).iter().zip(of(&still)) {
            let ratio = after.pseudo_acceleration() / before.pseudo_acceleration();
            assert!((ratio - 1.0).abs() < 0.03, "at {} s: {ratio}", before.period);
        }
    }

    #[test]
    fn a_target_without_two_periods_changes_nothing() {
        let samples = QUAKE.samples();
        assert_eq!(matched(&samples, 0.01, &[]), samples, "none");
        assert_eq!(matched(&[0.0; 8], 0.01, &[[0.1, 1.0], [1.0, 1.0]]), [0.0; 8], "nothing to multiply");
    }
}
