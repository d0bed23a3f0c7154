//! Largest values of functions of time, and when they are reached first. Functions come as references, so that each search is there once.

/// Part of a value by which another one has to be larger to count as larger, so that a value that stays, as the force of what yields, is
/// dated to where it is first reached: the rounding of a sum of some thousand terms, far below every tolerance of a run.
pub(super) const PLATEAU: f64 = 1e-12;

/// Whether a value is larger than another one by more than [`PLATEAU`].
pub(super) fn exceeds(value: f64, seen: f64) -> bool {
    value > seen + PLATEAU * seen.abs()
}

/// Highest value of a function with one hump.
pub(super) fn golden(f: &dyn Fn(f64) -> f64, mut a: f64, mut b: f64) -> (f64, f64) {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let (mut x, mut y) = (b - RATIO * (b - a), a + RATIO * (b - a));
    let (mut fx, mut fy) = (f(x), f(y));
    // A peak is flat: its height is right to the last digits when its place is right to half of them.
    for _ in 0..36 {
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
    if fx > fy { (x, fx) } else { (y, fy) }
}

/// Largest value over `times`, in rising order, and over a golden-section search about every look that is not below its neighbours and
/// above 0.9 of the highest look.
pub(super) fn largest(times: &[f64], value: &dyn Fn(f64) -> f64) -> f64 {
    first_largest(times, value).1
}

/// The same, and when it is reached first.
pub(super) fn first_largest(times: &[f64], value: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let values: Vec<f64> = times.iter().map(|&t| value(t)).collect();
    largest_seen(times, &values, value)
}

/// The same where the values at the looks are known.
pub(super) fn largest_seen(times: &[f64], values: &[f64], value: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let higher = |best: (f64, f64), next: (f64, f64)| if exceeds(next.1, best.1) { next } else { best };
    let seen = times.iter().copied().zip(values.iter().copied()).fold((0.0, 0.0), higher);
    let peaks = values.windows(3).zip(times.windows(3));
    let peaks = peaks.filter(|(v, _)| v[1] >= v[0] && v[1] >= v[2] && v[1] > 0.9 * seen.1);
    // Within a plateau there is nothing to look for.
    let peaks = peaks.filter(|(v, _)| exceeds(v[1], v[0]) || exceeds(v[1], v[2]));
    let inside = peaks.map(|(_, t)| golden(value, t[0], t[2])).fold(seen, higher);
    let ends = beside_ends(times, values).into_iter().flatten().filter(|(v, _)| *v > 0.9 * seen.1);
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
