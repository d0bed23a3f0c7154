//! Legendre polynomials on \[−1, 1\] and the integrals of them that (F4) and (F10) need.

/// `P_0 … P_degree` at ξ.
pub fn values(degree: usize, xi: f64) -> Vec<f64> {
    let mut values = Vec::with_capacity(degree + 2);
    values.extend([1.0, xi]);
    for k in 1..degree {
        let k_ = k as f64;
        values.push(((2.0 * k_ + 1.0) * xi * values[k] - k_ * values[k - 1]) / (k_ + 1.0));
    }
    values.truncate(degree + 1);
    values
}

/// `∫_ξ^1 P_k` for k from 0 to `degree`.
pub fn integrals_to_end(degree: usize, xi: f64) -> Vec<f64> {
    let p = values(degree + 1, xi);
    let above = |k: usize| (p[k - 1] - p[k + 1]) / (2 * k + 1) as f64;
    (0..=degree).map(|k| if k == 0 { 1.0 - xi } else { above(k) }).collect()
}

/// `∫_ξ^1 (x − ξ) P_k(x) dx` for k from 0 to `degree`.
pub fn moments_to_end(degree: usize, xi: f64) -> Vec<f64> {
    let once = integrals_to_end(degree + 1, xi);
    let above = |k: usize| (once[k - 1] - once[k + 1]) / (2 * k + 1) as f64;
    (0..=degree).map(|k| if k == 0 { 0.5 * (1.0 - xi) * (1.0 - xi) } else { above(k) }).collect()
}

/// `P_0' … P_degree'` at ξ.
pub fn slopes(degree: usize, xi: f64) -> Vec<f64> {
    let p = values(degree, xi);
    let mut slopes = vec![0.0; degree + 1];
    for k in 1..=degree {
        let before = if k > 1 { slopes[k - 2] } else { 0.0 };
        slopes[k] = before + (2 * k - 1) as f64 * p[k - 1];
    }
    slopes
}

/// `∫ P_k² = 2/(2k + 1)` over the whole.
pub fn square(k: usize) -> f64 {
    2.0 / (2 * k + 1) as f64
}

/// `∫ P_j' P_k'` over the whole.
pub fn derivative_product(j: usize, k: usize) -> f64 {
    let least = j.min(k);
    if (j + k).is_multiple_of(2) { (least * (least + 1)) as f64 } else { 0.0 }
}

/// `∫ P_j' P_k` over the whole.
pub fn half_product(j: usize, k: usize) -> f64 {
    if j > k && !(j + k).is_multiple_of(2) { 2.0 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integral over \[a, 1\] by Simpson's rule.
    fn integral(a: f64, f: impl Fn(f64) -> f64) -> f64 {
        let n = 2000;
        let h = (1.0 - a) / f64::from(n);
        let weight = |i: i32| if i == 0 || i == n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
        (0..=n).map(|i| weight(i) * f(a + h * f64::from(i))).sum::<f64>() * h / 3.0
    }

    #[test]
    fn polynomials_and_their_integrals_are_those_of_the_textbook() {
        let p = values(4, 0.3);
        assert!((p[2] - 0.5 * (3.0 * 0.09 - 1.0)).abs() < 1e-15, "P₂");
        assert!((p[4] - (35.0 * 0.0081 - 30.0 * 0.09 + 3.0) / 8.0).abs() < 1e-15, "P₄");
        assert_eq!((values(0, 0.3), values(1, 0.3)), (vec![1.0], vec![1.0, 0.3]));
        let rate = |k: usize, x: f64| (values(k, x + 1e-5)[k] - values(k, x - 1e-5)[k]) / 2e-5;
        for (j, k) in [(1, 1), (2, 4), (3, 2), (5, 3), (4, 1)] {
            let both = integral(-1.0, |x| rate(j, x) * rate(k, x));
            let half = integral(-1.0, |x| rate(j, x) * values(k, x)[k]);
            assert!((both - derivative_product(j, k)).abs() < 1e-6, "D {j} {k}: {both}");
            assert!((half - half_product(j, k)).abs() < 1e-6, "H {j} {k}: {half}");
        }
        let to_end = integrals_to_end(5, 0.2);
        for (k, value) in to_end.iter().enumerate() {
            let wanted = integral(0.2, |x| values(k, x)[k]);
            assert!((value - wanted).abs() < 1e-12, "∫P_{k}: {value} against {wanted}");
            assert!((integral(-1.0, |x| values(k, x)[k].powi(2)) - square(k)).abs() < 1e-9, "∫P_{k}²");
            let wanted = integral(0.2, |x| (x - 0.2) * values(k, x)[k]);
            let moment = moments_to_end(5, 0.2)[k];
            assert!((moment - wanted).abs() < 1e-12, "∫(x − ξ)P_{k}: {moment} against {wanted}");
            assert!((slopes(5, 0.2)[k] - rate(k, 0.2)).abs() < 1e-6, "P_{k}'");
        }
    }
}
