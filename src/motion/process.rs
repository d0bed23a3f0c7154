//! Processing of the samples of a record: baselines, tapers, padding.

use glam::{DMat3, DVec3};

/// Takes off the mean.
pub fn remove_mean(samples: &mut [f64]) {
    let mean = samples.iter().sum::<f64>() / samples.len().max(1) as f64;
    for a in samples {
        *a -= mean;
    }
}

/// Takes off the straight line of least squares.
pub fn remove_line(samples: &mut [f64]) {
    let count = samples.len() as f64;
    // Centred times are orthogonal to a constant.
    let time = |n: usize| n as f64 - 0.5 * (count - 1.0);
    let (mut moment, mut square) = (0.0, 0.0);
    for (n, a) in samples.iter().enumerate() {
        moment += time(n) * a;
        square += time(n) * time(n);
    }
    remove_mean(samples);
    if square > 0.0 {
        for (n, a) in samples.iter_mut().enumerate() {
            *a -= moment / square * time(n);
        }
    }
}

/// Takes off the parabola `c₀ + c₁ x + c₂ x²` that leaves the least `Σ v²` of the velocity at the samples, from rest, with `a`
/// linear between them (Berg & Housner 1961). `x` runs from 0 to 1 over the record.
pub fn remove_velocity_parabola(samples: &mut [f64]) {
    let steps = samples.len().saturating_sub(1);
    if steps < 3 {
        return;
    }
    let x = |n: usize| n as f64 / steps as f64;
    let powers = |n: usize| [1.0, x(n), x(n) * x(n)];
    // Velocities of the record and of the three powers, per interval; their normal equations.
    let (mut v, mut shapes) = (0.0, [0.0; 3]);
    let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    for n in 1..=steps {
        v += 0.5 * (samples[n - 1] + samples[n]);
        for (shape, (before, now)) in shapes.iter_mut().zip(powers(n - 1).into_iter().zip(powers(n))) {
            *shape += 0.5 * (before + now);
        }
        for i in 0..3 {
            right[i] += shapes[i] * v;
            (0..3).for_each(|j| matrix[i][j] += shapes[i] * shapes[j]);
        }
    }
    let coefficients = (DMat3::from_cols_array_2d(&matrix).inverse() * DVec3::from(right)).to_array();
    for (n, a) in samples.iter_mut().enumerate() {
        *a -= powers(n).iter().zip(coefficients).map(|(power, c)| power * c).sum::<f64>();
    }
}

/// Multiplies by `½ (1 − cos(π t / length))` within `length` \[s\] of the start, and likewise before the end.
pub fn taper(samples: &mut [f64], dt: f64, length: f64) {
    let last = samples.len().saturating_sub(1);
    for (n, a) in samples.iter_mut().enumerate() {
        let t = n.min(last - n) as f64 * dt;
        if t < length {
            *a *= 0.5 * (1.0 - (std::f64::consts::PI * t / length).cos());
        }
    }
}

/// Multiplies all samples so that their largest magnitude is `peak`; samples of nothing but zeros stay.
pub fn scale_to(samples: &mut [f64], peak: f64) {
    let largest = samples.iter().fold(0.0_f64, |m, a| m.max(a.abs()));
    if largest > 0.0 {
        for a in samples {
            *a *= peak / largest;
        }
    }
}

/// So many zeros before the first sample and after the last.
pub fn pad(samples: &[f64], zeros: usize) -> Vec<f64> {
    let still = || std::iter::repeat_n(0.0, zeros);
    still().chain(samples.iter().copied()).chain(still()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(count: u32, [a, b, c]: [f64; 3]) -> Vec<f64> {
        (0..count).map(|n| a + f64::from(n) * (b + f64::from(n) * c)).collect()
    }

    fn largest(samples: &[f64]) -> f64 {
        samples.iter().fold(0.0, |most, a| most.max(a.abs()))
    }

    #[test]
    fn each_baseline_takes_off_its_own_polynomial_and_nothing_twice() {
        let mut constant = polynomial(100, [3.0, 0.0, 0.0]);
        remove_mean(&mut constant);
        assert!(largest(&constant) < 1e-14, "a constant has a mean alone");
        let mut line = polynomial(100, [3.0, -0.2, 0.0]);
        remove_line(&mut line);
        assert!(largest(&line) < 1e-12, "a line: {}", largest(&line));
        let mut parabola = polynomial(100, [3.0, -0.2, 0.001]);
        remove_velocity_parabola(&mut parabola);
        assert!(largest(&parabola) < 1e-9, "a parabola: {}", largest(&parabola));
        for remove in [remove_mean, remove_line, remove_velocity_parabola] {
            let mut once: Vec<f64> = (0..200).map(|n| (0.1 * f64::from(n)).sin() + 0.3).collect();
            remove(&mut once);
            let mut twice = once.clone();
            remove(&mut twice);
            let apart = once.iter().zip(&twice).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(apart < 1e-12, "done twice as done once: {apart}");
        }
    }

    #[test]
    fn a_parabola_leaves_less_velocity_than_any_other_near_it() {
        let record: Vec<f64> = (0..300).map(|n| (0.07 * f64::from(n)).sin() + 0.01 * f64::from(n % 17)).collect();
        let velocity2 = |samples: &[f64]| {
            let v = |v: &mut f64, pair: &[f64]| {
                *v += 0.5 * (pair[0] + pair[1]);
                Some(*v * *v)
            };
            samples.windows(2).scan(0.0, v).sum::<f64>()
        };
        let mut best = record.clone();
        remove_velocity_parabola(&mut best);
        for other in [[1e-3, 0.0, 0.0], [0.0, 1e-5, 0.0], [0.0, 0.0, 1e-7], [-1e-3, 1e-5, 0.0]] {
            let near: Vec<f64> = best.iter().zip(polynomial(300, other)).map(|(a, b)| a + b).collect();
            assert!(velocity2(&near) > velocity2(&best), "{other:?}");
        }
        assert!(velocity2(&best) < velocity2(&record), "and less than none");
    }

    #[test]
    fn a_taper_is_half_a_cosine_at_both_ends() {
        let mut samples = vec![2.0; 101];
        taper(&mut samples, 0.1, 2.0);
        for (n, expected) in [(0, 0.0), (5, 1.0 - 0.5_f64.sqrt()), (10, 1.0), (15, 1.0 + 0.5_f64.sqrt()), (20, 2.0)] {
            assert!((samples[n] - expected).abs() < 1e-14, "sample {n}: {}", samples[n]);
            assert_eq!(samples[100 - n], samples[n], "the same at the end");
        }
        assert_eq!(samples[50], 2.0, "untouched between");
    }

    #[test]
    fn padding_is_still_before_and_after() {
        assert_eq!(pad(&[1.0, 2.0], 2), [0.0, 0.0, 1.0, 2.0, 0.0, 0.0], "two of each");
        for operation in [remove_mean, remove_line, remove_velocity_parabola] {
            operation(&mut []);
            operation(&mut [1.0]);
        }
        taper(&mut [], 0.1, 1.0);
    }
}
