//! Gauss–Legendre quadrature with eight nodes: exact for polynomials of degree 15, which the power on a step's continuous
//! answer (degree 7, squared) does not exceed by more than its trigonometry.

use std::sync::LazyLock;

/// Nodes.
pub(in crate::sim) const COUNT: usize = 8;

/// Nodes on \[−1, 1\] and their weights (Abramowitz and Stegun, table 25.4).
const NODES: [(f64, f64); COUNT] = [
    (-0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
    (-0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (-0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (-0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Slope at node i of the polynomial that is 1 at node j and 0 at the others.
static SLOPES: LazyLock<[[f64; COUNT]; COUNT]> = LazyLock::new(|| {
    let x = |i: usize| NODES[i].0;
    let apart = |i: usize| (0..COUNT).filter(|&k| k != i).map(|k| x(i) - x(k)).product::<f64>();
    let slope = |i: usize, j: usize| {
        if i == j { x(i) / (1.0 - x(i) * x(i)) } else { apart(i) / (apart(j) * (x(i) - x(j))) }
    };
    std::array::from_fn(|i| std::array::from_fn(|j| slope(i, j)))
});

/// `∫ f` over \[a, b\] for several integrands at once.
///
/// A node is where its time was rounded to: of a step of 1e-7 s that begins after 10 s, a hundred-millionth away from where it
/// should be. What a steep power changes by over that is taken back by its interpolant's slope.
pub(in crate::sim) fn integrate<const N: usize>(a: f64, b: f64, mut f: impl FnMut(f64) -> [f64; N]) -> [f64; N] {
    if a == b { [0.0; N] } else { Nodes::within(a, b).sum(|_, t| f(t)) }
}

/// Nodes within a cell with their weights: of integrands that share what has been computed at them.
pub(in crate::sim) struct Nodes {
    /// Times of the nodes \[s\].
    pub(in crate::sim) times: [f64; COUNT],
    /// Their weights \[s\].
    weights: [f64; COUNT],
}

impl Nodes {
    /// Those of \[a, b\], which is not empty.
    pub(in crate::sim) fn within(a: f64, b: f64) -> Self {
        let (middle, half) = (f64::midpoint(a, b), (b - a) / 2.0);
        let times = NODES.map(|(x, _)| middle + half * x);
        let mut weights = NODES.map(|(_, w)| w);
        for (i, (x, w)) in NODES.into_iter().enumerate() {
            // Differences of times so near are exact.
            let away = ((times[i] - a) - (b - times[i])) / (2.0 * half) - x;
            for (weight, slope) in weights.iter_mut().zip(SLOPES[i]) {
                *weight -= w * away * slope;
            }
        }
        Self { times, weights: weights.map(|weight| weight * half) }
    }

    /// Integrals of integrands by the number of a node and its time.
    pub(in crate::sim) fn sum<const N: usize>(&self, mut f: impl FnMut(usize, f64) -> [f64; N]) -> [f64; N] {
        let mut sum = [0.0; N];
        for (node, (&t, weight)) in self.times.iter().zip(self.weights).enumerate() {
            for (s, v) in sum.iter_mut().zip(f(node, t)) {
                *s += weight * v;
            }
        }
        sum
    }
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

    #[test]
    fn nothing_flows_in_no_time() {
        assert_eq!(integrate(8.1, 8.1, |_| [f64::MAX, 1.0]), [0.0; 2]);
    }

    #[test]
    fn a_cell_far_from_zero_is_as_exact_as_one_beside_it() {
        let (from, length) = (8.1, 5.0 * f64::EPSILON * 2f64.powi(28));
        let [got] = integrate(from, from + length, |t| [(-2.0 * (t - from) / length).exp()]);
        let exact = length * (1.0 - (-2.0f64).exp()) / 2.0;
        assert!(((from + length) - from - length).abs() < 1e-30, "its end is a time");
        assert!((got / exact - 1.0).abs() < 1e-13, "{got} against {exact}");
    }
}
