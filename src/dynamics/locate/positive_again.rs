//! The test for a function that was negative and counts as positive again, beyond rounding of its value and of the time.

use crate::dynamics::locate::constants::{REARM_RESOLUTIONS, TIME_ROUNDING};

/// Whether a gap that was ignored while negative is positive beyond round-off: [`REARM_RESOLUTIONS`] resolutions of its value
/// and, at its rate, the round-off of the time `t`.
pub(in crate::dynamics) fn is_positive_again(gap: f64, rate: f64, t: f64, resolution: f64) -> bool {
    gap > REARM_RESOLUTIONS * resolution + TIME_ROUNDING * t * rate.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gap_is_positive_beyond_rounding_of_place_and_time() {
        let resolution = 1e-15;
        assert!(!is_positive_again(63.0 * resolution, 0.0, 10.0, resolution), "rounding of place");
        assert!(is_positive_again(65.0 * resolution, 0.0, 10.0, resolution), "beyond it");
        let of_time = 16.0 * f64::EPSILON * 10.0 * 2.0;
        assert!(
            !is_positive_again(64.0 * resolution + 0.9 * of_time, -2.0, 10.0, resolution),
            "rounding of time at 2 m/s"
        );
        assert!(is_positive_again(64.0 * resolution + 1.1 * of_time, -2.0, 10.0, resolution), "beyond both");
    }
}
