//! Errors of least squares: the covariance of the estimates under residuals that need not be independent.
//!
//! The estimate `p` of least squares moves with the noise `e` by `(JᵀJ)⁻¹ Jᵀ e`, so its covariance is
//! `(JᵀJ)⁻¹ JᵀΣJ (JᵀJ)⁻¹`, `Σ` that of the noise. For independent noise `Σ = s² I`. Noise that is correlated from sample to
//! sample, as of a filter or a drifting zero, is taken as an autoregression: its order by Schwarz's criterion (1978) up to
//! [`MOST_ORDER`], its coefficients by the recursion of Levinson and Durbin from the residuals' autocovariances,
//! `Σᵢⱼ = s² ρ(|i − j|)`.

use super::least_squares::{Solution, dot, inverse, products};

/// Highest order of the autoregression.
pub const MOST_ORDER: usize = 10;
/// Correlation below which the noise counts as uncorrelated \[–\] (chosen).
const NO_CORRELATION: f64 = 1e-3;
/// Most lags of the correlation \[samples\]; beyond them it counts as 0 (chosen: bounds the cost of the covariance).
const MOST_LAGS: usize = 2000;

/// Noise as the residuals show it.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// Its standard deviation `s`, `s² = Σ r²/(n − p)` \[unit of the measured\].
    pub deviation: f64,
    /// Order of the autoregression; 0 for independent noise.
    pub order: usize,
    /// Correlations over 0, 1, 2, … samples; of independent noise the first alone.
    pub correlations: Vec<f64>,
}

/// Autocovariances over 0 to `most` samples, divided by the count: never an indefinite sequence.
fn autocovariances(r: &[f64], most: usize) -> Vec<f64> {
    (0..=most).map(|k| dot(&r[..r.len() - k], &r[k..]) / r.len() as f64).collect()
}

/// Coefficients and variance of the innovations of autoregressions of order 0 to that of the autocovariances less one
/// (Levinson and Durbin).
fn autoregressions(c: &[f64]) -> Vec<(Vec<f64>, f64)> {
    let mut all = vec![(Vec::new(), c[0])];
    for order in 1..c.len() {
        let (before, variance) = &all[order - 1];
        let predicted: f64 = before.iter().enumerate().map(|(i, a)| a * c[order - 1 - i]).sum();
        let reflection = (c[order] - predicted) / variance;
        let mut a: Vec<f64> =
            before.iter().zip(before.iter().rev()).map(|(own, back)| own - reflection * back).collect();
        a.push(reflection);
        let variance = variance * (1.0 - reflection * reflection);
        if variance.is_nan() || variance <= 0.0 {
            break;
        }
        all.push((a, variance));
    }
    all
}

impl Noise {
    /// Of the residuals of so many parameters; `evenly`, whether samples are evenly spaced: else they are taken as independent.
    pub fn of(residuals: &[f64], parameters: usize, evenly: bool) -> Self {
        let n = residuals.len();
        let deviation = (dot(residuals, residuals) / (n.saturating_sub(parameters)).max(1) as f64).sqrt();
        let most = MOST_ORDER.min(n / 20);
        if !evenly || most == 0 || deviation == 0.0 {
            return Self { deviation, order: 0, correlations: vec![1.0] };
        }
        let c = autocovariances(residuals, most);
        let all = autoregressions(&c);
        let criterion = |(order, (_, variance)): (usize, &(Vec<f64>, f64))| {
            (n as f64 * variance.ln() + order as f64 * (n as f64).ln(), order)
        };
        let scores = all.iter().enumerate().map(criterion);
        let order = scores.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(0, |(_, order)| order);
        let mut rho: Vec<f64> = c[..=order].iter().map(|own| own / c[0]).collect();
        let a = &all[order].0;
        while order > 0 && rho.len() < MOST_LAGS.min(n) {
            let next: f64 = a.iter().zip(rho.iter().rev()).map(|(a, rho)| a * rho).sum();
            rho.push(next);
            if rho.iter().rev().take(order).all(|rho| rho.abs() < NO_CORRELATION) {
                break;
            }
        }
        Self { deviation, order, correlations: rho }
    }

    /// Covariance of the estimates; none where they cannot be told apart.
    pub fn covariance(&self, solution: &Solution) -> Option<Vec<Vec<f64>>> {
        let slopes = &solution.slopes;
        let sensitivity = inverse(&products(slopes, slopes))?;
        let spread: Vec<Vec<f64>> = slopes.iter().map(|column| self.correlated(column)).collect();
        let middle = products(slopes, &spread);
        let half: Vec<Vec<f64>> = sensitivity.iter().map(|row| combine(row, &middle)).collect();
        // E rᵀr = s² (n − tr (JᵀJ)⁻¹ JᵀΣJ/s²): a parameter takes more than one residual away where these are correlated.
        let n = slopes.first().map_or(0, Vec::len) as f64;
        let taken: f64 = half.iter().enumerate().map(|(i, row)| row[i]).sum();
        let s2 = solution.cost / (n - taken.min(0.5 * n));
        Some(half.iter().map(|row| combine(row, &sensitivity).iter().map(|v| v * s2).collect()).collect())
    }

    /// `Σ/s²` times a column.
    fn correlated(&self, column: &[f64]) -> Vec<f64> {
        let mut all = column.to_vec();
        for (k, rho) in self.correlations.iter().enumerate().skip(1).take_while(|(k, _)| *k < column.len()) {
            for i in k..column.len() {
                all[i] += rho * column[i - k];
                all[i - k] += rho * column[i];
            }
        }
        all
    }
}

/// `Σ weightᵢ rowᵢ`.
fn combine(weights: &[f64], rows: &[Vec<f64>]) -> Vec<f64> {
    (0..weights.len()).map(|j| weights.iter().zip(rows).map(|(w, row)| w * row[j]).sum()).collect()
}

/// The factor of a standard deviation within which Student's t of so many degrees of freedom lies 95 times in 100 (expansion of
/// Cornish and Fisher, within 3e-3 of the tables from 5 on).
pub fn student_95(degrees: usize) -> f64 {
    const Z: f64 = 1.959_963_984_540_054;
    let (v, z3, z5) = (degrees.max(1) as f64, Z.powi(3), Z.powi(5));
    let first = (z3 + Z) / 4.0;
    let second = (5.0 * z5 + 16.0 * z3 + 3.0 * Z) / 96.0;
    let third = (3.0 * Z.powi(7) + 19.0 * z5 + 17.0 * z3 - 15.0 * Z) / 384.0;
    Z + first / v + second / (v * v) + third / v.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn students_factor_is_that_of_the_tables() {
        for (degrees, wanted) in [(5, 2.5706), (10, 2.2281), (30, 2.0423), (1_000_000, 1.95997)] {
            assert!((student_95(degrees) - wanted).abs() < 3e-3, "{degrees}: {}", student_95(degrees));
        }
    }

    #[test]
    fn an_autoregression_is_found_again() {
        // e(n) = 1.2 e(n−1) − 0.5 e(n−2) + w: ρ₁ = 1.2/1.5 = 0.8, ρ₂ = 1.2·0.8 − 0.5 = 0.46.
        let (mut seed, mut e) = (1_u64, vec![0.0, 0.0]);
        let mut uniform = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for n in 2..40_000 {
            e.push(1.2 * e[n - 1] - 0.5 * e[n - 2] + uniform());
        }
        let noise = Noise::of(&e, 0, true);
        assert_eq!(noise.order, 2, "by Schwarz's criterion");
        let [one, two] = [noise.correlations[1], noise.correlations[2]];
        assert!((one - 0.8).abs() < 0.01 && (two - 0.46).abs() < 0.02, "{one}, {two}");
        let white: Vec<f64> = (0..5000).map(|_| uniform()).collect();
        assert_eq!(Noise::of(&white, 0, true).correlations, [1.0], "independent");
        assert_eq!(Noise::of(&e, 0, false).order, 0, "unevenly spaced");
        assert_eq!(Noise::of(&[0.0; 100], 3, true).deviation, 0.0, "no noise at all");
    }

    #[test]
    fn a_mean_of_correlated_noise_is_less_certain() {
        // Variance of the mean of n samples: s²/n (1 + 2 Σ (1 − k/n) ρₖ).
        let noise = Noise { deviation: 2.0, order: 1, correlations: vec![1.0, 0.5, 0.25] };
        let more = 1.0 + 2.0 * (0.99 * 0.5 + 0.98 * 0.25);
        let (slopes, cost) = (vec![vec![1.0; 100]], 4.0 * (100.0 - more));
        let solution = Solution { parameters: vec![0.0], residuals: Vec::new(), slopes, cost };
        let variance = noise.covariance(&solution).expect("regular")[0][0];
        let exact = 4.0 / 100.0 * more;
        assert!((variance - exact).abs() < 1e-14, "{variance}, not {exact}");
    }
}
