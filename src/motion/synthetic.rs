//! A synthetic earthquake: seeded noise through the ground of Kanai (1957) and Tajimi (1960), under an envelope.
//!
//! `ẍ + 2 ζ_g ω_g ẋ + ω_g² x = w`, `a = e(t) (ω_g² x + 2 ζ_g ω_g ẋ)`: the acceleration of stiff soil above a base that shakes
//! by white noise `w`, so that its power spectrum is `(ω_g⁴ + 4 ζ_g² ω_g² ω²) / ((ω_g² − ω²)² + 4 ζ_g² ω_g² ω²)`. The filter's
//! own step is semi-implicit, one a sample. The envelope rises by a parabola, is 1 for a while, and dies away as `exp(−t/τ)`
//! (Jennings, Housner & Tsai 1968); all is scaled to its peak. A sample of the noise is the sum of twelve uniform numbers of
//! a linear congruence, so that a seed is the same record for ever.

use super::process::scale_to;

/// Most samples of a record.
const MOST: f64 = 1e7;

/// Parameters of a synthetic earthquake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Earthquake {
    /// Seed of the noise.
    pub seed: u64,
    /// Length \[s\].
    pub duration: f64,
    /// Interval between samples \[s\].
    pub dt: f64,
    /// Largest magnitude \[m/s²\].
    pub peak: f64,
    /// Circular frequency of the ground `ω_g` \[rad/s\].
    pub ground: f64,
    /// Damping of the ground `ζ_g`, of critical.
    pub damping: f64,
    /// Time within which the envelope rises \[s\].
    pub rise: f64,
    /// Beginning of the decay \[s\].
    pub until: f64,
    /// Rate at which it does `1/τ` \[1/s\].
    pub decay: f64,
}

impl Earthquake {
    /// Its samples from t = 0 on \[m/s²\]; at most 1e7.
    pub fn samples(&self) -> Vec<f64> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 1e7")]
        let count = (self.duration / self.dt).round().clamp(0.0, MOST) as usize;
        let mut noise = Noise(self.seed);
        let (mut x, mut v) = (0.0, 0.0);
        let sample = |i: usize| self.envelope(i as f64 * self.dt) * self.shaken(&mut x, &mut v, noise.next());
        let mut samples: Vec<f64> = (0..count).map(sample).collect();
        scale_to(&mut samples, self.peak);
        samples
    }

    /// One sample of the filtered noise.
    fn shaken(&self, x: &mut f64, v: &mut f64, noise: f64) -> f64 {
        let Self { ground, damping, dt, .. } = self;
        *v += dt * (noise - ground * ground * *x - 2.0 * damping * ground * *v);
        *x += dt * *v;
        ground * ground * *x + 2.0 * damping * ground * *v
    }

    fn envelope(&self, t: f64) -> f64 {
        if t < self.rise {
            (t / self.rise).powi(2)
        } else if t < self.until {
            1.0
        } else {
            (-self.decay * (t - self.until)).exp()
        }
    }
}

/// Nearly normal numbers from a 64-bit linear congruence (Knuth's MMIX constants).
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn next(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const QUAKE: Earthquake = Earthquake {
        seed: 1,
        duration: 40.0,
        dt: 0.01,
        peak: 3.0,
        ground: 15.6,
        damping: 0.6,
        rise: 4.0,
        until: 14.0,
        decay: 0.15,
    };

    #[test]
    fn it_is_strong_in_the_middle_and_the_same_each_time() {
        let record = QUAKE.samples();
        let largest = |part: &[f64]| part.iter().fold(0.0_f64, |m, a| m.max(a.abs()));
        assert!((largest(&record) - 3.0).abs() < 1e-12, "scaled to its peak");
        assert!(largest(&record[3500..]) < 0.6, "it dies away");
        assert_eq!(record, QUAKE.samples(), "seeded");
        assert!(record != Earthquake { seed: 2, ..QUAKE }.samples(), "by its seed");
    }

    #[test]
    fn its_power_has_the_filters_shape() {
        // Long and stationary, averaged over seeds: power at ω by the sum Σ a e^(−iωt), against that of the filter.
        let power = |omega: f64| {
            (1..=60)
                .map(|seed| {
                    let quake = Earthquake { seed, rise: 0.0, until: 40.0, peak: 1.0, ..QUAKE };
                    let samples = quake.samples();
                    let energy: f64 = samples.iter().map(|a| a * a).sum();
                    let [mut c, mut s] = [0.0; 2];
                    for (n, a) in samples.iter().enumerate() {
                        let (sin, cos) = (omega * n as f64 * quake.dt).sin_cos();
                        (c, s) = (c + a * cos, s + a * sin);
                    }
                    (c * c + s * s) / energy
                })
                .sum::<f64>()
        };
        let filter = |w: f64| {
            let (w2, g2, d) = (w * w, QUAKE.ground * QUAKE.ground, 2.0 * QUAKE.damping * QUAKE.ground * w);
            (g2 * g2 + d * d) / ((g2 - w2) * (g2 - w2) + d * d)
        };
        // Around each frequency several lines: the spread of their mean is a few percent.
        let near = |f: &dyn Fn(f64) -> f64, w: f64| (0..8).map(|k| f(w * (0.93 + 0.02 * f64::from(k)))).sum::<f64>();
        let [low, high] =
            [5.0, 40.0].map(|w| near(&power, w) / near(&power, 15.0) / (near(&filter, w) / near(&filter, 15.0)));
        assert!((low - 1.0).abs() < 0.2 && (high - 1.0).abs() < 0.35, "against the filter: {low}, {high}");
    }
}
