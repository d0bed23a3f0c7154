//! Numbers of about 32 digits: the unevaluated sum of two (Dekker; Hida, Li and Bailey's error-free sums and products).

use std::ops::{Add, Mul, Neg, Sub};

/// `hi + lo`, `|lo|` at most half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wide {
    /// The number to 16 digits.
    pub hi: f64,
    /// The number less `hi`.
    pub lo: f64,
}

/// `2π`.
pub const TAU: Wide = Wide { hi: std::f64::consts::TAU, lo: 2.449_293_598_294_706_4e-16 };

/// A number that a decimal fraction was rounded to: `numerator / denominator`, both exact.
pub fn ratio(numerator: f64, denominator: f64) -> Wide {
    let hi = numerator / denominator;
    // The remainder of a division is exact by a fused product.
    Wide { hi, lo: (-hi).mul_add(denominator, numerator) / denominator }
}

fn sum(a: f64, b: f64) -> Wide {
    let hi = a + b;
    let part = hi - a;
    Wide { hi, lo: (a - (hi - part)) + (b - part) }
}

fn ordered_sum(a: f64, b: f64) -> Wide {
    let hi = a + b;
    Wide { hi, lo: b - (hi - a) }
}

impl Wide {
    /// A whole number, or any number taken as it is.
    pub const fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }

    /// Divided by a number of 16 digits.
    #[must_use]
    pub fn over(self, by: f64) -> Self {
        let q = ratio(self.hi, by);
        ordered_sum(q.hi, q.lo + self.lo / by)
    }

    /// The nearest number of 16 digits.
    pub fn value(self) -> f64 {
        self.hi + self.lo
    }

    /// Square root of a positive number.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let x = self.hi.sqrt();
        let left = self - Self::from(x) * Self::from(x);
        ordered_sum(x, left.hi / (2.0 * x))
    }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (s, t) = (sum(self.hi, other.hi), sum(self.lo, other.lo));
        let s = ordered_sum(s.hi, s.lo + t.hi);
        ordered_sum(s.hi, s.lo + t.lo)
    }
}

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let lo = self.hi.mul_add(other.hi, -hi) + (self.hi * other.lo + self.lo * other.hi);
        ordered_sum(hi, lo)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_digits_are_kept() {
        let third = ratio(1.0, 3.0);
        let one = third + third + third - Wide::from(1.0);
        assert!(one.value().abs() < 1e-31, "three thirds miss one by {:e}", one.value());
        let two = Wide::from(2.0).sqrt();
        assert!((two * two - Wide::from(2.0)).value().abs() < 1e-31, "the root of two, squared");
        assert!(
            (ratio(0.7, 1.0).over(7.0) * Wide::from(7.0) - Wide::from(0.7)).value().abs() < 1e-32,
            "divided and back"
        );
    }
}
