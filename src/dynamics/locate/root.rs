//! The root of a function of one variable in a bracket, to the last bit: secants in the variant of Anderson and Björck (1973), with
//! bisection where they converge slowly.

use crate::dynamics::locate::constants::{MARGIN_GROWTH, MAX_ROOT_EVALUATIONS, ROUND, ROUND_REDUCTION};

/// Root of `f`, negative or 0 at `a` and positive at `b`, to the last bit: the upper end of a bracket that round-off of the
/// argument does not divide. `a` where `f` is positive there already.
pub fn root(mut f: impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    let (fa, fb) = (f(a), f(b));
    root_between(f, [a, b], [fa, fb])
}

/// Root in `[a, b]` where the values at both ends are known: secants, weighted by Anderson and Björck where one end is kept,
/// and [`ROUND`] bisections where as many secants have reduced the bracket by less.
pub(in crate::dynamics) fn root_between(
    mut f: impl FnMut(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    [fa, fb]: [f64; 2],
) -> f64 {
    let (mut fa, mut fb) = (fa, fb);
    if fa >= 0.0 {
        return a;
    }
    if fb <= 0.0 {
        return b;
    }
    let (mut last_side, mut width, mut slow) = (0, b - a, false);
    let mut margin = f64::EPSILON * a.abs().max(b.abs());
    for count in 1..MAX_ROOT_EVALUATIONS {
        let middle = f64::midpoint(a, b);
        if middle <= a || middle >= b {
            break;
        }
        let secant = b - fb * (b - a) / (fb - fa);
        // At least `margin` from both ends, so that a root close to an end is passed and bracketed from both sides.
        let x = if slow || 2.0 * margin >= b - a || !(secant > a && secant < b) {
            middle
        } else {
            let x = secant.max(a + margin).min(b - margin);
            margin *= if x == secant { 1.0 } else { MARGIN_GROWTH };
            x
        };
        let fx = f(x);
        if fx == 0.0 {
            return x;
        }
        if fx < 0.0 {
            fb *= if last_side < 0 { weight(fx, fa) } else { 1.0 };
            (a, fa, last_side) = (x, fx, -1);
        } else {
            fa *= if last_side > 0 { weight(fx, fb) } else { 1.0 };
            (b, fb, last_side) = (x, fx, 1);
        }
        if b - a <= f64::EPSILON * a.abs().max(b.abs()) {
            break;
        }
        if count % ROUND == 0 {
            (slow, width) = (!slow && b - a > width / ROUND_REDUCTION, b - a);
        }
    }
    b
}

/// Weight of the value at the end that is kept, where the value at the other end changes from `before` to `now`.
fn weight(now: f64, before: f64) -> f64 {
    let left = 1.0 - now / before;
    if left > 0.0 { left } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_come_to_the_last_bits_in_a_dozen_evaluations() {
        let mut count = 0;
        let t = root(
            |t| {
                count += 1;
                t * t - 2.0
            },
            0.0,
            2.0,
        );
        assert!((t - std::f64::consts::SQRT_2).abs() <= 2.0 * f64::EPSILON, "{t}");
        assert!(count <= 14, "{count} evaluations");
        count = 0;
        let flat = root(
            |t| {
                count += 1;
                (t - 1e-3).powi(3)
            },
            0.0,
            1.0,
        );
        assert!((flat - 1e-3).abs() < 1e-12 && count <= 120, "a threefold root at {flat}, {count} evaluations");
    }
}
