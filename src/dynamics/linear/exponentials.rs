//! Integrals of exponentials without loss where the exponent is small.

use super::Complex;

/// |z| below which the series is summed: twelve terms are then exact to rounding.
const SMALL: f64 = 0.5;
const TERMS: u32 = 16;

/// `φ1(z) = (e^z − 1)/z` and `φ2(z) = (e^z − 1 − z)/z²`, from `e^z`.
pub(super) fn phi(z: Complex, exp: Complex) -> [Complex; 2] {
    if z.norm() > SMALL {
        let first = (exp - 1.0) / z;
        return [first, (first - 1.0) / z];
    }
    let second = series(z, 2);
    [second * z + 1.0, second]
}

/// `Σ z^k k₀!/(k + k₀)!/k₀!`: φ of order `from`, with `φ_n(z) = Σ z^k/(k + n)!`.
fn series(z: Complex, from: u32) -> Complex {
    let factorial: f64 = (1..=from).map(f64::from).product();
    let (mut term, mut sum) = (Complex::from(1.0 / factorial), Complex::from(0.0));
    for k in 1..=TERMS {
        sum += term;
        term *= z / f64::from(k + from);
    }
    sum
}

/// `∫₀^h τ^p e^{σ τ} dτ` for p = 0, 1, 2.
pub(super) fn moments(sigma: Complex, h: f64) -> [Complex; 3] {
    let z = sigma * h;
    if z.norm() > SMALL {
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
            for (a, b) in phi(below, below.exp()).into_iter().zip(phi(above, above.exp())) {
                assert!((a - b).norm() < 1e-11, "φ at {angle}: {a} against {b}");
            }
            for (a, b) in moments(below, 1.0).into_iter().zip(moments(above, 1.0)) {
                assert!((a - b).norm() < 1e-11, "moment at {angle}: {a} against {b}");
            }
        }
        assert_eq!(phi(0.0.into(), 1.0.into()), [1.0.into(), 0.5.into()], "at 0");
        let [a, b, c] = moments(0.0.into(), 2.0).map(|m| m.re);
        assert_eq!((a, b), (2.0, 2.0), "powers of time");
        assert!((c - 8.0 / 3.0).abs() < 1e-15, "{c}");
    }
}
