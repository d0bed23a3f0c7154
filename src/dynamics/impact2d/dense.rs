//! Small dense systems, as they come with a few contacts.

use crate::dynamics::integrator::dense_lu::Lu;

/// What is added to the diagonal of a system without a single answer, in parts of its largest entry: faces that are held
/// twice over share the load as if they gave by this little.
const GIVE: f64 = 1e-12;

/// Solves `A x = b`; nothing where the numbers are not finite.
pub(in crate::dynamics::impact2d) fn solve(
    size: usize,
    entry: impl Fn(usize, usize) -> f64,
    right: impl Fn(usize) -> f64,
) -> Option<Vec<f64>> {
    let b: Vec<f64> = (0..size).map(right).collect();
    let mut x = vec![0.0; size];
    let mut lu = Lu::default();
    let largest = (0..size * size).map(|i| entry(i / size, i % size).abs()).fold(0.0, f64::max);
    if !lu.factor(size, &entry) || lu.least_pivot() <= GIVE * largest {
        let give = GIVE * largest;
        if !lu.factor(size, |r, c| entry(r, c) + if r == c { give } else { 0.0 }) {
            return None;
        }
    }
    lu.solve(&b, &mut x);
    x.iter().all(|v| v.is_finite()).then_some(x)
}
