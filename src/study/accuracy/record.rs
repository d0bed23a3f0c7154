//! A synthetic earthquake record: seeded white noise through the ground of Kanai and Tajimi, under an envelope.
//!
//! It needs no file and is the same everywhere: the generator is integer arithmetic, a sample is the sum of twelve
//! uniform numbers. A record of the field would do the same work.

/// Interval between samples \[s\].
pub(super) const INTERVAL: f64 = 0.01;
/// Samples: 40 s.
pub(super) const SAMPLES: usize = 4000;
/// Largest acceleration \[m/s²\].
const PEAK: f64 = 3.924;
/// Circular frequency of the ground, that of stiff soil \[rad/s\].
const GROUND: f64 = 15.6;
/// Damping of the ground.
const DAMPING: f64 = 0.6;

/// The samples \[m/s²\].
pub(super) fn samples(seed: u64) -> Vec<f64> {
    let mut noise = Noise(seed);
    let (mut x, mut v) = (0.0, 0.0);
    let mut samples: Vec<f64> =
        (0..SAMPLES).map(|i| envelope(i as f64 * INTERVAL) * ground(&mut x, &mut v, noise.next())).collect();
    let largest = samples.iter().fold(0.0_f64, |m, a| m.max(a.abs()));
    for a in &mut samples {
        *a *= PEAK / largest;
    }
    samples
}

/// One sample of the filtered noise; the filter's own step is semi-implicit.
fn ground(x: &mut f64, v: &mut f64, noise: f64) -> f64 {
    *v += INTERVAL * (noise - GROUND * GROUND * *x - 2.0 * DAMPING * GROUND * *v);
    *x += INTERVAL * *v;
    GROUND * GROUND * *x + 2.0 * DAMPING * GROUND * *v
}

/// Rises for 4 s, is strong until 14 s, dies away.
fn envelope(t: f64) -> f64 {
    if t < 4.0 {
        (t / 4.0).powi(2)
    } else if t < 14.0 {
        1.0
    } else {
        (-0.15 * (t - 14.0)).exp()
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

    #[test]
    fn the_record_is_strong_in_the_middle_and_the_same_each_time() {
        let record = samples(1);
        let largest = |part: &[f64]| part.iter().fold(0.0_f64, |m, a| m.max(a.abs()));
        assert!((largest(&record) - PEAK).abs() < 1e-12, "scaled to its peak");
        assert!(largest(&record[3500..]) < 0.2 * PEAK, "it dies away");
        assert_eq!(record, samples(1), "seeded");
        assert!(record != samples(2), "by its seed");
    }
}
