//! Random numbers by seed: a seed is the same scene everywhere and for ever.

/// A small, fast and well-mixed generator (splitmix64).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        // Neighbouring seeds start far apart.
        let mut random = Self(seed.wrapping_mul(0xD134_2543_DE82_EF95));
        random.bits();
        random
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [low, high).
    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Log-uniform in [low, high), three digits: a seed's scene file is read by people.
    pub fn log(&mut self, low: f64, high: f64) -> f64 {
        three_digits(self.range(low.ln(), high.ln()).exp()).clamp(low, high)
    }

    /// A whole number in [0, n).
    pub fn below(&mut self, n: usize) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in [0, n)")]
        let k = (self.unit() * n as f64) as usize;
        k.min(n.saturating_sub(1))
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// One of a few.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// +1 or −1.
    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }

    /// A small part of 1, 1e-3 … 1e-15, of either sign, or exactly 0.
    pub fn hair(&mut self) -> f64 {
        if self.chance(0.2) { 0.0 } else { self.sign() * self.log(1e-15, 1e-3) }
    }
}

/// Rounded to three significant digits.
pub fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_is_the_same_sequence_and_its_neighbour_another() {
        let draw = |seed| (0..4).map(|_| Random::new(seed).unit()).collect::<Vec<_>>();
        assert_eq!(draw(7), draw(7), "by seed");
        assert!((Random::new(7).unit() - Random::new(8).unit()).abs() > 1e-6, "neighbours differ");
    }

    #[test]
    fn logarithms_stay_in_their_range() {
        let mut random = Random::new(1);
        let all: Vec<f64> = (0..2000).map(|_| random.log(1e2, 1e12)).collect();
        assert!(all.iter().all(|x| (1e2..=1e12).contains(x)), "inside");
        let low = all.iter().filter(|x| **x < 1e7).count();
        assert!((800..1200).contains(&low), "half of them below the geometric middle: {low}");
    }
}
