//! Numbers of a rectangle as the cross-section of a beam.

/// Torsion constant of a solid rectangle \[m⁴\], by Saint-Venant's series `a b³ [1/3 − (64/π⁵)(b/a) Σ tanh(k π a/2b)/k⁵]` over odd k,
/// a ≥ b its sides \[m\].
pub fn torsion_constant(one: f64, other: f64) -> f64 {
    // What is left out of the sum is below ∫ dk/2k⁵ from k = 199 on: 8e-11 of it.
    const TERMS: i32 = 100;
    let (a, b) = (one.max(other), one.min(other));
    let term = |i: i32| {
        let k = f64::from(2 * i + 1);
        (k * std::f64::consts::FRAC_PI_2 * a / b).tanh() / k.powi(5)
    };
    let sum: f64 = (0..TERMS).rev().map(term).sum();
    a * b.powi(3) * (1.0 / 3.0 - 64.0 / std::f64::consts::PI.powi(5) * (b / a) * sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_torsion_constant_is_that_of_the_textbook() {
        // Timoshenko and Goodier, table of k₁: J = k₁ a b³.
        for (ratio, wanted) in [(1.0, 0.1406), (1.5, 0.196), (2.0, 0.229), (4.0, 0.281), (10.0, 0.312)] {
            let j = torsion_constant(ratio * 0.7, 0.7) / (ratio * 0.7f64.powi(4));
            assert!((j - wanted).abs() < 6e-4, "a/b = {ratio}: {j} against {wanted}");
        }
        assert_eq!(torsion_constant(2.0, 3.0), torsion_constant(3.0, 2.0));
    }
}
