//! Velocity, displacement and intensity of an acceleration that is linear between samples: exact integrals, from rest.

use super::format::STANDARD_GRAVITY;

/// Largest magnitude of a series, with its sign and time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// With its sign, in the unit of the series.
    pub value: f64,
    /// Time \[s\].
    pub at: f64,
}

impl Peak {
    /// Of samples at this interval \[s\]; the first of several.
    pub fn of(samples: &[f64], dt: f64) -> Self {
        let larger = |most: Self, (n, value): (usize, &f64)| {
            if value.abs() > most.value.abs() { Self { value: *value, at: n as f64 * dt } } else { most }
        };
        samples.iter().enumerate().fold(Self::default(), larger)
    }
}

/// Ground velocity \[m/s\] and displacement \[m\] at the samples of an acceleration \[m/s²\], from rest at the first.
pub fn integrate(samples: &[f64], dt: f64) -> [Vec<f64>; 2] {
    let (mut v, mut d) = (0.0, 0.0);
    let (mut velocity, mut displacement) = (Vec::with_capacity(samples.len()), Vec::with_capacity(samples.len()));
    for (n, a) in samples.iter().enumerate() {
        velocity.push(v);
        displacement.push(d);
        if let Some(next) = samples.get(n + 1) {
            d += v * dt + dt * dt * (2.0 * a + next) / 6.0;
            v += 0.5 * dt * (a + next);
        }
    }
    [velocity, displacement]
}

/// Largest ground velocity \[m/s\] and displacement \[m\] of an acceleration that is straight between samples, with these integrals at them:
/// at a sample, or between two where the acceleration or the velocity passes 0.
pub fn peaks(samples: &[f64], [velocity, displacement]: [&[f64]; 2], dt: f64) -> [Peak; 2] {
    let mut most = [Peak::of(velocity, dt), Peak::of(displacement, dt)];
    for (n, pair) in samples.windows(2).enumerate() {
        // a(τ) = a₀ + j τ, v(τ) = v₀ + a₀ τ + j τ²/2, d(τ) = d₀ + v₀ τ + a₀ τ²/2 + j τ³/6.
        let (a, jerk) = (pair[0], (pair[1] - pair[0]) / dt);
        let (v, d) = (velocity[n], displacement[n]);
        let turn = -a / jerk;
        // Roots of the velocity, without the difference of nearly equal numbers.
        let root = (a * a - 2.0 * jerk * v).sqrt();
        let sum = -(a + root.copysign(a));
        let at_rest =
            [sum / jerk, 2.0 * v / sum].map(|tau| (1, tau, d + tau * (v + tau * (0.5 * a + tau * jerk / 6.0))));
        for (which, tau, value) in at_rest.into_iter().chain([(0, turn, v + 0.5 * a * turn)]) {
            // NaN where there is no root.
            if tau > 0.0 && tau < dt && value.abs() > most[which].value.abs() {
                most[which] = Peak { value, at: n as f64 * dt + tau };
            }
        }
    }
    most
}

/// Strong motion: Arias intensity and when it passes 5 % and 95 % of its final value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StrongMotion {
    /// `π / (2 g) ∫ a² dt` \[m/s\].
    pub arias: f64,
    /// Time at which 5 % are reached \[s\].
    pub from: f64,
    /// Time at which 95 % are reached \[s\].
    pub until: f64,
}

impl StrongMotion {
    /// Of an acceleration \[m/s²\]. Straight between samples, so that its square has the integral
    /// `(a³ - a₀³)/(3 a')` from a sample `a₀` on.
    pub fn of(samples: &[f64], dt: f64) -> Self {
        let mut sum = 0.0;
        let mut sums = vec![0.0];
        for pair in samples.windows(2) {
            sum += dt * (pair[0] * pair[0] + pair[0] * pair[1] + pair[1] * pair[1]) / 3.0;
            sums.push(sum);
        }
        let reached = |share: f64| {
            let goal = share * sum;
            let n = sums.partition_point(|sum| *sum < goal);
            let Some(before) = n.checked_sub(1) else { return 0.0 };
            let [from, to] = [before, n].map(|n| samples.get(n).copied().unwrap_or(0.0));
            // The acceleration when it is reached; the share of the interval without a difference of nearly equal numbers.
            let missing = (goal - sums[before]) / dt;
            let there = (from.powi(3) + 3.0 * (to - from) * missing).cbrt();
            (before as f64 + 3.0 * missing / (there * there + there * from + from * from)) * dt
        };
        let arias = std::f64::consts::PI / (2.0 * STANDARD_GRAVITY) * sum;
        if sum > 0.0 { Self { arias, from: reached(0.05), until: reached(0.95) } } else { Self::default() }
    }

    /// Significant duration, 5 to 95 % \[s\].
    pub fn duration(&self) -> f64 {
        self.until - self.from
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_integrates_to_its_cube() {
        let dt = 0.1;
        let ramp: Vec<f64> = (0..11).map(|n| 3.0 * f64::from(n) * dt).collect();
        let [v, d] = integrate(&ramp, dt);
        for n in 0..11_u32 {
            let t = f64::from(n) * dt;
            let at = n as usize;
            assert!((v[at] - 1.5 * t * t).abs() < 1e-14, "v at {t}: {}", v[at]);
            assert!((d[at] - 0.5 * t * t * t).abs() < 1e-14, "d at {t}: {}", d[at]);
        }
    }

    #[test]
    fn a_constant_has_nine_tenths_of_its_length_as_strong_motion() {
        let strong = StrongMotion::of(&[2.0; 101], 0.1);
        assert!((strong.duration() - 9.0).abs() < 1e-12 && (strong.from - 0.5).abs() < 1e-12, "{strong:?}");
        let arias = std::f64::consts::PI / (2.0 * STANDARD_GRAVITY) * 40.0;
        assert!((strong.arias - arias).abs() < 1e-12, "4 · 10 s");
        // ∫ a² = t³/12 up to 10 s, 250 in all: 5 % at the cube root of 150.
        let few = StrongMotion::of(&[0.0, 5.0, -5.0, 0.0], 10.0);
        assert!(
            (few.from - 150f64.cbrt()).abs() < 1e-12 && (few.until - 30.0 + 150f64.cbrt()).abs() < 1e-12,
            "{few:?}"
        );
        assert_eq!(StrongMotion::of(&[0.0; 5], 0.1), StrongMotion::default(), "still ground");
    }

    #[test]
    fn velocity_and_displacement_are_largest_where_acceleration_and_velocity_pass_nought() {
        // Up by 1, down to -1, back to 0, a second each: v(τ) = 1/2 + τ - τ² in the second, largest half-way.
        let samples = [0.0, 1.0, -1.0, 0.0];
        let [v, d] = integrate(&samples, 1.0);
        let [velocity, _] = peaks(&samples, [&v, &d], 1.0);
        assert!((velocity.value - 0.75).abs() < 1e-15 && (velocity.at - 1.5).abs() < 1e-15, "{velocity:?}");
        // a = 2 - 4 t: v = 2 t - 2 t² is 0 at 1 s, d = t² - 2 t³/3 largest there, between samples at 0, 0.75, 1.5 s.
        let samples = [2.0, -1.0, -4.0];
        let [v, d] = integrate(&samples, 0.75);
        let [velocity, displacement] = peaks(&samples, [&v, &d], 0.75);
        assert!((velocity.value + 1.5).abs() < 1e-15 && velocity.at == 1.5, "at the last sample: {velocity:?}");
        assert!(
            (displacement.value - 1.0 / 3.0).abs() < 1e-15 && (displacement.at - 1.0).abs() < 1e-15,
            "{displacement:?}"
        );
        assert_eq!(peaks(&[0.0; 4], [&[0.0; 4]; 2], 0.1), [Peak::default(); 2], "still ground");
    }

    #[test]
    fn the_peak_keeps_its_sign_and_is_the_first_of_several() {
        assert_eq!(Peak::of(&[1.0, -2.0, 2.0], 0.5), Peak { value: -2.0, at: 0.5 }, "downwards, first");
    }
}
