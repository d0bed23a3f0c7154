//! Times at which a function is sampled within an interval.

/// Time of sample `i` of `count` at equal distances from `from` to `until` \[s\], of which the last is `until` to the last bit.
#[inline]
pub(in crate::dynamics) fn sample_time([from, until]: [f64; 2], i: usize, count: usize) -> f64 {
    if i == count - 1 { until } else { from + (until - from) * i as f64 / (count - 1) as f64 }
}

/// The times of `N` samples \[s\].
#[inline]
pub(in crate::dynamics) fn sample_times<const N: usize>(interval: [f64; 2]) -> [f64; N] {
    std::array::from_fn(|i| sample_time(interval, i, N))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_equally_far_apart_and_the_last_is_the_end_exactly() {
        let (from, until) = (0.1, 0.7);
        let times = sample_times::<4>([from, until]);
        assert_eq!([times[0], times[3]], [from, until], "both ends to the last bit");
        assert!(times.windows(2).all(|pair| ((pair[1] - pair[0]) - 0.2).abs() < 1e-15), "{times:?}");
    }
}
