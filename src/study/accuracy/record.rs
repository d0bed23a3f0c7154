//! The record of the study: 40 s of a synthetic earthquake that needs no file. A record of the field would do the same work.

use crate::motion::synthetic::Earthquake;

/// Interval between samples \[s\].
pub(super) const INTERVAL: f64 = 0.01;
/// Samples: 40 s.
pub(super) const SAMPLES: usize = 4000;

/// The samples \[m/s²\].
pub(super) fn samples(seed: u64) -> Vec<f64> {
    let quake = Earthquake {
        seed,
        duration: SAMPLES as f64 * INTERVAL,
        dt: INTERVAL,
        peak: 3.924,
        ground: 15.6,
        damping: 0.6,
        rise: 4.0,
        until: 14.0,
        decay: 0.15,
    };
    quake.samples()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_as_many_samples_as_the_run_needs() {
        assert_eq!(samples(1).len(), SAMPLES, "40 s");
    }
}
