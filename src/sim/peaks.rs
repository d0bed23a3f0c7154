//! Largest values of functions of time, and when they are reached first. Functions come as references, so that each search is there once.

use super::report::Extreme;

/// Part of a value by which another one has to be larger to count as larger, so that a value that stays, as the force of what yields, is
/// dated to where it is first reached: the rounding of a sum of some thousand terms, far below every tolerance of a run.
pub(super) const PLATEAU: f64 = 1e-12;

/// Whether a value is larger than another one by more than [`PLATEAU`].
pub(super) fn exceeds(value: f64, seen: f64) -> bool {
    value > seen + PLATEAU * seen.abs()
}

/// Part of the highest look from which a peak beside another look may be higher and is looked for \[–\]. Chosen: between looks, ten or more a
/// period of the fastest motion, a value rises by less.
pub(super) const NEAR: f64 = 0.9;
/// Steps of a golden-section search: they leave `0.618³⁶ = 3e-8` of the interval. A peak is flat: its height is right to the last digits when
/// its place is right to half of them.
const GOLDEN_STEPS: usize = 36;

/// Highest value of a function with one hump.
pub(super) fn golden(f: &dyn Fn(f64) -> f64, mut a: f64, mut b: f64) -> Extreme {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let (mut x, mut y) = (b - RATIO * (b - a), a + RATIO * (b - a));
    let (mut fx, mut fy) = (f(x), f(y));
    for _ in 0..GOLDEN_STEPS {
        if fx > fy {
            (b, y, fy) = (y, x, fx);
            x = b - RATIO * (b - a);
            fx = f(x);
        } else {
            (a, x, fx) = (x, y, fy);
            y = a + RATIO * (b - a);
            fy = f(y);
        }
    }
    if fx > fy { Extreme { value: fx, t: x } } else { Extreme { value: fy, t: y } }
}

/// Largest value over `times`, in rising order, and when it is reached first: over a golden-section search about every look that is not
/// below its neighbours and above [`NEAR`] of the highest look. Not a number where there is no value at any look.
pub(super) fn largest(times: &[f64], value: &dyn Fn(f64) -> f64) -> Extreme {
    let values: Vec<f64> = times.iter().map(|&t| value(t)).collect();
    largest_seen(times, &values, value)
}

/// Largest of each of several values that are computed together.
pub(super) fn largest_of_each<const N: usize>(times: &[f64], values: &dyn Fn(f64) -> [f64; N]) -> [Extreme; N] {
    let seen: Vec<[f64; N]> = times.iter().map(|&t| values(t)).collect();
    std::array::from_fn(|own| {
        let seen: Vec<f64> = seen.iter().map(|all| all[own]).collect();
        largest_seen(times, &seen, &|t| values(t)[own])
    })
}

/// Largest value, where the values at the sample times are known.
pub(super) fn largest_seen(times: &[f64], values: &[f64], value: &dyn Fn(f64) -> f64) -> Extreme {
    let higher = |best: Extreme, next: Extreme| if exceeds(next.value, best.value) { next } else { best };
    let looks = times.iter().zip(values).map(|(&t, &value)| Extreme { value, t });
    let Some(seen) = looks.filter(|look| !look.value.is_nan()).reduce(higher) else {
        return Extreme { value: f64::NAN, t: 0.0 };
    };
    let near = seen.value - (1.0 - NEAR) * seen.value.abs();
    let peaks = values.windows(3).zip(times.windows(3));
    let peaks = peaks.filter(|(v, _)| v[1] >= v[0] && v[1] >= v[2] && v[1] > near);
    // Within a plateau there is nothing to look for.
    let peaks = peaks.filter(|(v, _)| exceeds(v[1], v[0]) || exceeds(v[1], v[2]));
    let inside = peaks.map(|(_, t)| golden(value, t[0], t[2])).fold(seen, higher);
    let ends = beside_ends(times, values).into_iter().flatten().filter(|(v, _)| *v > near);
    let before_end = |(v, [end, next]): &(f64, [f64; 2])| exceeds(value(end + INSIDE * (next - end)), *v);
    ends.filter(before_end).map(|(_, [a, b])| golden(value, a.min(b), a.max(b))).fold(inside, higher)
}

/// Part of the interval beside the first or last look at which a value is looked at that may be higher inside of it. Chosen: what a peak
/// that is nearer to the end is higher by is a millionth of what the value changes by over the interval.
const INSIDE: f64 = 1e-3;

/// First and last look with the next one inside, where it is not below that: its value, and both times.
fn beside_ends(times: &[f64], values: &[f64]) -> [Option<(f64, [f64; 2])>; 2] {
    let last = times.len().saturating_sub(1);
    [(0, 1.min(last)), (last, last.saturating_sub(1))].map(|(end, next)| {
        let is_end = end != next && values[end] >= values[next];
        is_end.then(|| (values[end], [times[end], times[next]]))
    })
}
