//! Integrals of exponentials without loss where the exponent is small.

use super::Complex;

/// |z| below which series are summed: differences of the exponential would lose more than a digit. The first term that is left out is
/// `SMALL¹³/15!` of φ2, and of the moments `SMALL¹⁷/17!`.
const SMALL: f64 = 0.5;
/// Terms of the moments' series after the first.
const TERMS: u32 = 16;

/// |z| below which the shorter of both sums is exact to rounding.
const TINY: f64 = 0.1;
/// `1/(n + 2)!`.
const FACTORIALS: [f64; 13] = [
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5040.0,
    1.0 / 40_320.0,
    1.0 / 362_880.0,
    1.0 / 3_628_800.0,
    1.0 / 39_916_800.0,
    1.0 / 479_001_600.0,
    1.0 / 6_227_020_800.0,
    1.0 / 87_178_291_200.0,
];
/// Terms of the shorter sum: the first that is left out is `TINY⁹/11!`.
const TINY_TERMS: usize = 9;

/// `e^z`, `φ1(z) = (e^z − 1)/z` and `φ2(z) = (e^z − 1 − z)/z²`; where z is small all from the series of φ2, `Σ zⁿ/(n + 2)!`.
pub(super) fn exponential_and_integrals(z: Complex) -> [Complex; 3] {
    let size2 = z.norm_sqr();
    if size2 > SMALL * SMALL {
        let exp = z.exp();
        let first = (exp - 1.0) / z;
        return [exp, first, (first - 1.0) / z];
    }
    let terms = if size2 > TINY * TINY { &FACTORIALS[..] } else { &FACTORIALS[..TINY_TERMS] };
    let second = terms.iter().rev().fold(Complex::from(0.0), |sum, term| sum * z + *term);
    let first = second * z + 1.0;
    [first * z + 1.0, first, second]
}

/// `∫₀^h τ^p e^{σ τ} dτ` for p = 0, 1, 2.
pub(super) fn moments(sigma: Complex, h: f64) -> [Complex; 3] {
    let z = sigma * h;
    if z.norm_sqr() > SMALL * SMALL {
        let exp = z.exp();
        let zeroth = (exp - 1.0) / sigma;
        let first = (exp * h - zeroth) / sigma;
        return [zeroth, first, (exp * (h * h) - first * 2.0) / sigma];
    }
    // Σ z^k/k! h^{p+1}/(k + p + 1).
    let (mut term, mut sums) = (Complex::from(1.0), [Complex::from(0.0); 3]);
    for k in 0..=TERMS {
        for (p, sum) in (1..).zip(&mut sums) {
            *sum += term / f64::from(k + p);
        }
        term *= z / f64::from(k + 1);
    }
    [sums[0] * h, sums[1] * (h * h), sums[2] * (h * h * h)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_and_large_exponents_agree_where_they_meet() {
        for angle in [0.0, 1.0, 2.5, 3.1] {
            let z = |r: f64| Complex::from_polar(r, angle);
            let [below, above] = [z(SMALL * (1.0 - 1e-12)), z(SMALL * (1.0 + 1e-12))];
            for (a, b) in exponential_and_integrals(below).into_iter().zip(exponential_and_integrals(above)) {
                assert!((a - b).norm() < 1e-11, "φ at {angle}: {a} against {b}");
            }
            let tiny = z(TINY * (1.0 - 1e-12));
            let [exp, first, second] = exponential_and_integrals(tiny);
            let rounding = 4.0 * f64::EPSILON;
            assert!((exp - tiny.exp()).norm() < rounding, "exponential at {angle}: {exp}");
            // Differences lose 1/|z| of their digits each time.
            let [long, longer] = [(tiny.exp() - 1.0) / tiny - first, (first - 1.0) / tiny - second].map(Complex::norm);
            let (once, twice) = (rounding / TINY, rounding / (TINY * TINY));
            assert!(long < once && longer < twice, "φ at {angle}: {long}, {longer} apart");
            for (a, b) in moments(below, 1.0).into_iter().zip(moments(above, 1.0)) {
                assert!((a - b).norm() < 1e-11, "moment at {angle}: {a} against {b}");
            }
        }
        assert_eq!(exponential_and_integrals(0.0.into()), [1.0.into(), 1.0.into(), 0.5.into()], "at 0");
        let [a, b, c] = moments(0.0.into(), 2.0).map(|m| m.re);
        assert_eq!((a, b), (2.0, 2.0), "powers of time");
        assert!((c - 8.0 / 3.0).abs() < 1e-15, "{c}");
    }
}
