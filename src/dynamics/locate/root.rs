//! The root of a function of one variable in a bracket, to the last bit: secants in the variant of Anderson and Björck (1973), with
//! bisection where they converge slowly.

/// Where `f`, negative or 0 at `a` and positive at `b`, crosses 0, to the last bit.
pub fn root(mut f: impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    let (fa, fb) = (f(a), f(b));
    root_between(f, [a, b], [fa, fb])
}

/// The same where the values at both ends are known: secants, weighed as Anderson and Björck do where one end stays, and
/// four halvings where four of them have not done as much.
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
    let mut hair = f64::EPSILON * a.abs().max(b.abs());
    for count in 1..200 {
        let middle = f64::midpoint(a, b);
        if middle <= a || middle >= b {
            break;
        }
        let secant = b - fb * (b - a) / (fb - fa);
        // Never closer to an end than a hair: the root that is there is then passed, and held from both sides.
        let x = if slow || 2.0 * hair >= b - a || !(secant > a && secant < b) {
            middle
        } else {
            let x = secant.max(a + hair).min(b - hair);
            hair *= if x == secant { 1.0 } else { 4.0 };
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
        if count % 4 == 0 {
            (slow, width) = (!slow && b - a > width / 16.0, b - a);
        }
    }
    b
}

/// What the value at the end that stays counts, when the other one has gone from `before` to `now`.
fn weight(now: f64, before: f64) -> f64 {
    let left = 1.0 - now / before;
    if left > 0.0 { left } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_come_to_the_last_bits_in_a_dozen_looks() {
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
        assert!(count <= 14, "{count} looks");
        count = 0;
        let flat = root(
            |t| {
                count += 1;
                (t - 1e-3).powi(3)
            },
            0.0,
            1.0,
        );
        assert!((flat - 1e-3).abs() < 1e-12 && count <= 120, "a threefold root at {flat}, {count} looks");
    }
}
