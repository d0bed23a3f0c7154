//! Fourier amplitudes of evenly spaced samples.

use std::f64::consts::TAU;

/// Amplitudes `|Σ q_j exp(−i 2π f j dt)| dt` of samples at an interval \[s\], the trapezoidal sum of `|∫ q exp(−i 2π f t) dt|`: pairs of
/// frequency \[Hz\] and amplitude in the unit of the samples times seconds, from `1/(n dt)` to half the sampling rate. Samples are
/// filled up with zeros to a power of two `n`.
pub fn amplitudes(samples: &[f64], dt: f64) -> Vec<[f64; 2]> {
    let size = samples.len().next_power_of_two().max(2);
    let mut lines: Vec<[f64; 2]> = samples.iter().map(|q| [*q, 0.0]).collect();
    // The ends of the stretch count half.
    let last = lines.len().saturating_sub(1);
    for end in [0, last].into_iter().take(lines.len()) {
        lines[end][0] *= 0.5;
    }
    lines.resize(size, [0.0; 2]);
    transform(&mut lines, -1.0);
    let line = |n: usize| [n as f64 / (size as f64 * dt), lines[n][0].hypot(lines[n][1]) * dt];
    (1..=size / 2).map(line).collect()
}

/// Fast Fourier transform in place of a power of two of complex numbers, `Σ z exp(±i 2π j k / n)` (Cooley & Tukey 1965).
pub(super) fn transform(z: &mut [[f64; 2]], sign: f64) {
    let n = z.len();
    let mut j = 0;
    for i in 1..n {
        let mut bit = n >> 1;
        while j & bit != 0 {
            j ^= bit;
            bit >>= 1;
        }
        j |= bit;
        if i < j {
            z.swap(i, j);
        }
    }
    let mut length = 2;
    while length <= n {
        for k in 0..length / 2 {
            let (s, c) = (sign * TAU * k as f64 / length as f64).sin_cos();
            for start in (k..n).step_by(length) {
                let (even, odd) = (z[start], z[start + length / 2]);
                let turned = [odd[0] * c - odd[1] * s, odd[0] * s + odd[1] * c];
                z[start] = [even[0] + turned[0], even[1] + turned[1]];
                z[start + length / 2] = [even[0] - turned[0], even[1] - turned[1]];
            }
        }
        length *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_is_the_sum_it_stands_for() {
        let samples: Vec<[f64; 2]> =
            (0..16).map(|n| [(f64::from(n) * 0.7).sin(), (f64::from(n) * 1.3).cos()]).collect();
        let mut fast = samples.clone();
        transform(&mut fast, -1.0);
        for (k, fast) in fast.iter().enumerate() {
            let mut slow = [0.0; 2];
            for (j, z) in samples.iter().enumerate() {
                let (s, c) = (-TAU * (j * k) as f64 / 16.0).sin_cos();
                slow = [slow[0] + z[0] * c - z[1] * s, slow[1] + z[0] * s + z[1] * c];
            }
            assert!((fast[0] - slow[0]).abs() < 1e-13 && (fast[1] - slow[1]).abs() < 1e-13, "line {k}");
        }
        let mut back = fast;
        transform(&mut back, 1.0);
        let apart = back.iter().zip(&samples).fold(0.0_f64, |most, (a, b)| most.max((a[0] / 16.0 - b[0]).abs()));
        assert!(apart < 1e-15, "there and back: {apart}");
    }

    #[test]
    fn a_pulse_has_the_amplitudes_of_its_integral() {
        // q = exp(−t/τ): |∫ q exp(−iωt) dt| = τ / √(1 + ω²τ²).
        let (tau, dt, count) = (0.2, 1e-3, 8192_u32);
        let samples: Vec<f64> = (0..count).map(|n| (-f64::from(n) * dt / tau).exp()).collect();
        for [f, amplitude] in amplitudes(&samples, dt).into_iter().take_while(|line| line[0] < 20.0) {
            let exact = tau / (1.0 + (TAU * f * tau).powi(2)).sqrt();
            // The trapezoidal rule is off by dt²/12 (q'(end) − q'(0)), which the rule's aliases hold to (ω dt)²/12 of it.
            assert!((amplitude / exact - 1.0).abs() < 3e-3, "{f} Hz: {amplitude}, not {exact}");
        }
    }

    #[test]
    fn few_samples_have_few_lines() {
        assert_eq!(amplitudes(&[], 0.1).len(), 1, "none");
        assert_eq!(amplitudes(&[1.0], 0.1).len(), 1, "one");
    }
}
