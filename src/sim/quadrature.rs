//! Gauss–Legendre quadrature with eight nodes: exact for polynomials of degree 15, which the power on a step's continuous
//! answer (degree 7, squared) does not exceed by more than its trigonometry.

/// Positive nodes on \[−1, 1\] and their weights (Abramowitz and Stegun, table 25.4).
const NODES: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// `∫ f` over \[a, b\] for several integrands at once.
pub(super) fn integrate<const N: usize>(a: f64, b: f64, mut f: impl FnMut(f64) -> [f64; N]) -> [f64; N] {
    let (middle, half) = (f64::midpoint(a, b), (b - a) / 2.0);
    let mut sum = [0.0; N];
    for (x, w) in NODES {
        for t in [middle - half * x, middle + half * x] {
            for (s, v) in sum.iter_mut().zip(f(t)) {
                *s += w * half * v;
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degree_fifteen_is_exact() {
        let [got] = integrate(0.0, 2.0, |t| [t.powi(15)]);
        let exact = 2f64.powi(16) / 16.0;
        assert!((got / exact - 1.0).abs() < 1e-14, "{got} against {exact}");
    }
}
