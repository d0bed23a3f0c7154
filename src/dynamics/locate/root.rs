//! The root of a function of one variable in a bracket, to the last bit: secants in the variant of Anderson and Björck (1973), with
//! bisection where they converge slowly.

use crate::dynamics::locate::constants::{
    CUBIC_ROOT_FRACTION, CUBIC_STEPS, MARGIN_GROWTH, MAX_ROOT_EVALUATIONS, NEWTON_STEPS, ROUND, ROUND_REDUCTION,
};

/// Root of `f`, negative or 0 at `a` and positive at `b`, to the last bit: the upper end of a bracket that round-off of the
/// argument does not divide. `a` where `f` is positive there already.
pub fn root(mut f: impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    let (fa, fb) = (f(a), f(b));
    root_between(f, [a, b], [fa, fb])
}

/// Root in `[a, b]` where the values at both ends are known: [`root_within_noise`] of a function without round-off.
pub(in crate::dynamics) fn root_between(f: impl FnMut(f64) -> f64, ends: [f64; 2], values: [f64; 2]) -> f64 {
    root_within_noise(f, ends, values, 0.0)
}

/// Root in `[a, b]` where the values at both ends are known, of a function that rounds by `noise`: an argument at which it is 0 or more
/// and at most `noise`, or the upper end of the last bracket; by secants, weighted by Anderson and Björck where one end is kept,
/// and [`ROUND`] bisections where as many secants have reduced the bracket by less.
pub(in crate::dynamics) fn root_within_noise(
    mut f: impl FnMut(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    [mut fa, mut fb]: [f64; 2],
    noise: f64,
) -> f64 {
    if fa >= 0.0 {
        return a;
    }
    if fb <= 0.0 {
        return b;
    }
    let (mut last_side, mut width, mut slow) = (0, b - a, false);
    // Within the noise, by the slope of the bracket, a step across it is as good as any.
    let mut margin = (f64::EPSILON * a.abs().max(b.abs())).max(0.5 * noise * ((b - a) / (fb - fa)).abs());
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
        if (0.0..=noise).contains(&fx) {
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

/// Root in `[a, b]` of a function with its derivative, of which both are known at the ends, `(f, f')`: the interval is first narrowed
/// about the root of the cubic through them by Newton's steps, which leave it a few bits wide where `f` is smooth.
pub(in crate::dynamics) fn root_with_slope(
    mut f: impl FnMut(f64) -> [f64; 2],
    [mut a, mut b]: [f64; 2],
    [mut fa, mut fb]: [[f64; 2]; 2],
) -> f64 {
    if fa[0] >= 0.0 {
        return a;
    }
    if fb[0] <= 0.0 {
        return b;
    }
    let mut x = a + (b - a) * cubic_root([fa[0], fb[0]], [fa[1], fb[1]].map(|slope| slope * (b - a)));
    let bits = f64::EPSILON * a.abs().max(b.abs());
    for _ in 0..NEWTON_STEPS {
        if !(x > a && x < b) {
            break;
        }
        let [value, slope] = f(x);
        if value < 0.0 {
            (a, fa) = (x, [value, slope]);
        } else {
            (b, fb) = (x, [value, slope]);
        }
        let step = -value / slope;
        if step.abs() <= bits {
            // One bit beyond the root there is its other side.
            let other = x - bits.copysign(value);
            if other > a && other < b {
                let there = f(other);
                if there[0] < 0.0 { (a, fa) = (other, there) } else { (b, fb) = (other, there) }
            }
            break;
        }
        x += step;
    }
    root_between(|t| f(t)[0], [a, b], [fa[0], fb[0]])
}

/// A root in \[0, 1\] of the cubic with these values, of which the first is negative and the last positive, and slopes at 0 and 1, to a
/// millionth.
fn cubic_root([f0, f1]: [f64; 2], [s0, s1]: [f64; 2]) -> f64 {
    // f₀ + x (s₀ + x (c + x d)).
    let (c, d) = (3.0 * (f1 - f0) - 2.0 * s0 - s1, 2.0 * (f0 - f1) + s0 + s1);
    let at = |x: f64| f0 + x * (s0 + x * (c + x * d));
    let (mut low, mut high) = (0.0, 1.0);
    let mut x = f0 / (f0 - f1);
    for _ in 0..CUBIC_STEPS {
        let value = at(x);
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let next = x - value / (s0 + x * (2.0 * c + x * 3.0 * d));
        let next = if next > low && next < high { next } else { f64::midpoint(low, high) };
        if (next - x).abs() <= CUBIC_ROOT_FRACTION {
            return next;
        }
        x = next;
    }
    x
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
    fn a_slope_halves_the_evaluations_of_a_smooth_root() {
        let mut count = 0;
        let mut gap = |t: f64| {
            count += 1;
            [(t - 0.3).sin() + 0.2, (t - 0.3).cos()]
        };
        let ends = [gap(0.0), gap(0.5)];
        let exact = 0.3 - 0.2f64.asin();
        let at = root_with_slope(&mut gap, [0.0, 0.5], ends);
        assert!((at - exact).abs() <= f64::EPSILON, "{at}, not {exact}");
        assert!(count <= 2 + 6, "{count} evaluations");
        // No slope leads out of the interval, nor past the root of one that lies.
        let wrong = root_with_slope(|t| [t * t - 2.0, -1.0], [0.0, 2.0], [[-2.0, 1e9], [2.0, -1e9]]);
        assert!((wrong - std::f64::consts::SQRT_2).abs() <= 2.0 * f64::EPSILON, "{wrong}");
    }

    #[test]
    fn a_function_is_followed_no_further_than_it_is_known() {
        let evaluations = |noise: f64| {
            let mut count = 0;
            let exact = |t: f64| (t - 20.0).exp() - 1.3;
            let ends = [20.0, 20.5];
            let at = root_within_noise(
                |t| {
                    count += 1;
                    exact(t)
                },
                ends,
                ends.map(exact),
                noise,
            );
            assert!((-1e-15..=noise.max(1e-14)).contains(&exact(at)), "{:e} at {noise:e}", exact(at));
            count
        };
        let [fine, known] = [0.0, 1e-12].map(evaluations);
        assert!(known < fine, "{known} evaluations against {fine}");
    }

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
