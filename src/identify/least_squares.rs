//! Nonlinear least squares by Levenberg and Marquardt, for a handful of parameters.
//!
//! Each step solves `(JᵀJ + λ diag JᵀJ) Δp = Jᵀ r`, `r = measured − model`, with the parameters scaled by the diagonal. λ falls
//! tenfold after a step that lowers `rᵀr` and rises tenfold after one that does not (Marquardt 1963).

/// Model to fit.
pub trait Model {
    /// Values at the measured places, none where the parameters have no sense.
    fn values(&self, parameters: &[f64]) -> Option<Vec<f64>>;

    /// Derivatives of the values by each parameter, a column each.
    fn slopes(&self, parameters: &[f64]) -> Option<Vec<Vec<f64>>>;
}

/// Result of the iteration.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Parameters.
    pub parameters: Vec<f64>,
    /// `measured − model` \[unit of the measured\].
    pub residuals: Vec<f64>,
    /// Derivatives of the model by each parameter.
    pub slopes: Vec<Vec<f64>>,
    /// Sum of squared residuals.
    pub cost: f64,
}

/// Most steps: from a start near the solution ten are enough; the rest is for long narrow valleys.
const MOST_STEPS: usize = 200;
/// A step whose every part is below this share of its parameter ends the search: below the rounding of the model's values.
const SMALL: f64 = 1e-12;

/// Product of two columns.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `AᵀB` of columns.
pub fn products(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    a.iter().map(|a| b.iter().map(|b| dot(a, b)).collect()).collect()
}

/// Pivot of the scaled matrix below which it counts as singular (chosen above rounding).
const SINGULAR: f64 = 1e-13;
/// λ at the start, its least value, and the value at which the search ends (chosen).
const LAMBDA: [f64; 3] = [1e-3, 1e-12, 1e12];

/// Solves `A x = b` of a positive definite matrix by Cholesky's method, scaled to a diagonal of ones; none where it is not
/// positive definite to rounding.
pub fn solve(matrix: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let n = right.len();
    let scale: Vec<f64> = (0..n).map(|i| matrix[i][i].sqrt()).collect();
    if scale.iter().any(|s| !(s.is_finite() && *s > 0.0)) {
        return None;
    }
    let mut lower = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let sum = matrix[i][j] / (scale[i] * scale[j]) - dot(&lower[i][..j], &lower[j][..j]);
            if i == j && sum <= SINGULAR {
                return None;
            }
            lower[i][j] = if i == j { sum.sqrt() } else { sum / lower[j][j] };
        }
    }
    let mut x: Vec<f64> = right.iter().zip(&scale).map(|(b, s)| b / s).collect();
    for i in 0..n {
        x[i] = (x[i] - dot(&lower[i][..i], &x[..i])) / lower[i][i];
    }
    for i in (0..n).rev() {
        let above: f64 = (i + 1..n).map(|k| lower[k][i] * x[k]).sum();
        x[i] = (x[i] - above) / lower[i][i];
    }
    Some(x.iter().zip(&scale).map(|(x, s)| x / s).collect())
}

/// The inverse of a positive definite matrix.
pub fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let unit = |i: usize| (0..matrix.len()).map(|j| f64::from(u8::from(i == j))).collect::<Vec<f64>>();
    (0..matrix.len()).map(|i| solve(matrix, &unit(i))).collect()
}

/// Coefficients of the columns whose sum is closest to `wanted`.
pub fn linear(columns: &[Vec<f64>], wanted: &[f64]) -> Option<Vec<f64>> {
    let right: Vec<f64> = columns.iter().map(|column| dot(column, wanted)).collect();
    solve(&products(columns, columns), &right)
}

fn residuals(model: &impl Model, measured: &[f64], parameters: &[f64]) -> Option<(Vec<f64>, f64)> {
    let r: Vec<f64> = measured.iter().zip(model.values(parameters)?).map(|(x, m)| x - m).collect();
    let cost = dot(&r, &r);
    cost.is_finite().then_some((r, cost))
}

/// The parameters of least squares near a start; none where the start has no sense or the parameters cannot be told apart.
pub fn fit(model: &impl Model, measured: &[f64], start: &[f64]) -> Option<Solution> {
    let mut p = start.to_vec();
    let (mut r, mut cost) = residuals(model, measured, &p)?;
    let [mut lambda, least, most] = LAMBDA;
    for _ in 0..MOST_STEPS {
        let slopes = model.slopes(&p)?;
        let normal = products(&slopes, &slopes);
        let right: Vec<f64> = slopes.iter().map(|column| dot(column, &r)).collect();
        let mut moved = false;
        while lambda < most {
            let mut damped = normal.clone();
            (0..p.len()).for_each(|i| damped[i][i] *= 1.0 + lambda);
            let step = solve(&damped, &right)?;
            let next: Vec<f64> = p.iter().zip(&step).map(|(p, s)| p + s).collect();
            // Ends where no parameter moves by more than SMALL of its own size.
            let small = step.iter().zip(&p).all(|(s, p)| s.abs() <= SMALL * p.abs());
            match residuals(model, measured, &next) {
                Some((new, lower)) if lower < cost && !small => {
                    (p, r, cost, moved) = (next, new, lower, true);
                    lambda = (lambda * 0.1).max(least);
                    break;
                }
                _ if small => break,
                _ => lambda *= 10.0,
            }
        }
        if !moved {
            break;
        }
    }
    let slopes = model.slopes(&p)?;
    Some(Solution { parameters: p, residuals: r, slopes, cost })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `a exp(−b t)` at whole t.
    struct Decay(usize);

    impl Model for Decay {
        fn values(&self, p: &[f64]) -> Option<Vec<f64>> {
            (p[1] > 0.0).then(|| (0..self.0).map(|t| p[0] * (-p[1] * t as f64).exp()).collect())
        }

        fn slopes(&self, p: &[f64]) -> Option<Vec<Vec<f64>>> {
            let e: Vec<f64> = (0..self.0).map(|t| (-p[1] * t as f64).exp()).collect();
            let by_rate = e.iter().enumerate().map(|(t, e)| -p[0] * t as f64 * e).collect();
            Some(vec![e, by_rate])
        }
    }

    #[test]
    fn exact_values_are_found_from_afar() {
        let model = Decay(30);
        let measured = model.values(&[3.0, 0.2]).expect("sound");
        for start in [[1.0, 1.0], [0.1, 0.01], [-5.0, 0.7]] {
            let found = fit(&model, &measured, &start).expect("a solution").parameters;
            assert!((found[0] - 3.0).abs() + (found[1] - 0.2).abs() < 1e-10, "{start:?}: {found:?}");
        }
        assert!(fit(&model, &measured, &[1.0, -1.0]).is_none(), "a start without sense");
    }

    #[test]
    fn matrices_are_solved_and_inverted_and_singular_ones_refused() {
        let matrix = vec![vec![4.0e6, 2.0], vec![2.0, 3.0e-6]];
        let inverse = inverse(&matrix).expect("regular");
        let unit = products(&matrix, &inverse);
        assert!((unit[0][0] - 1.0).abs() + unit[0][1].abs() + (unit[1][1] - 1.0).abs() < 1e-9, "{unit:?}");
        assert!(solve(&[vec![1.0, 1.0], vec![1.0, 1.0]], &[1.0, 1.0]).is_none(), "two alike");
        assert!(solve(&[vec![0.0]], &[1.0]).is_none(), "nothing");
    }
}
