//! Small dense linear equations, as a Newton iteration needs them.

/// The inverse of an `n × n` matrix by Gauss–Jordan elimination with row pivots; nothing when it is singular.
pub(super) fn inverse(mut a: Vec<f64>, n: usize) -> Option<Vec<f64>> {
    let mut b = vec![0.0; n * n];
    (0..n).for_each(|i| b[i * n + i] = 1.0);
    for column in 0..n {
        let pivot = (column..n).max_by(|&i, &j| a[i * n + column].abs().total_cmp(&a[j * n + column].abs()))?;
        let size = a[pivot * n + column];
        if size == 0.0 || !size.is_finite() {
            return None;
        }
        for k in 0..n {
            a.swap(column * n + k, pivot * n + k);
            b.swap(column * n + k, pivot * n + k);
        }
        for k in 0..n {
            a[column * n + k] /= size;
            b[column * n + k] /= size;
        }
        for row in (0..n).filter(|&row| row != column) {
            let factor = a[row * n + column];
            for k in 0..n {
                a[row * n + k] -= factor * a[column * n + k];
                b[row * n + k] -= factor * b[column * n + k];
            }
        }
    }
    Some(b)
}

/// `out −= A x`.
pub(super) fn subtract_product(a: &[f64], x: &[f64], out: &mut [f64]) {
    let n = x.len();
    for (row, out) in out.iter_mut().enumerate() {
        *out -= a[row * n..(row + 1) * n].iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_times_its_inverse_is_one() {
        let a = vec![0.0, 2.0, 1.0, 1.0, 1.0, 0.0, 4.0, 0.5, 3.0];
        let inverse = inverse(a.clone(), 3).expect("regular");
        for i in 0..3 {
            for j in 0..3 {
                let entry: f64 = (0..3).map(|k| a[i * 3 + k] * inverse[k * 3 + j]).sum();
                assert!((entry - f64::from(u8::from(i == j))).abs() < 1e-15 * 8.0, "entry {i}, {j}: {entry}");
            }
        }
        assert!(super::inverse(vec![1.0, 2.0, 2.0, 4.0], 2).is_none(), "a singular one has none");
    }
}
