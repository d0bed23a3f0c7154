//! Length of one search of a first zero: bounds on free motion hold over part of a period or of a record alone.

use crate::motion::Ground;

/// Length of one search; under ground at rest it goes to the end of the run.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Horizon {
    /// Periods of a sine \[–\].
    pub periods: f64,
    /// Samples of a record \[–\].
    pub samples: f64,
}

impl Horizon {
    /// End of a search that begins at `t`, in a run of this duration \[s\].
    pub(in crate::dynamics) fn end(self, ground: &Ground, t: f64, duration: f64) -> f64 {
        let stretch = match ground {
            Ground::Still => duration,
            Ground::Sine { omega, .. } => self.periods * std::f64::consts::TAU / omega,
            Ground::Record { dt, .. } => self.samples * dt,
        };
        (t + stretch).min(duration)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_search_covers_periods_or_samples_or_the_run() {
        let horizon = Horizon { periods: 2.0, samples: 64.0 };
        let omega = 4.0 * std::f64::consts::PI;
        let sine = Ground::Sine { amplitude: DVec3::X, quadrature: DVec3::ZERO, omega, phase: 0.3 };
        assert_eq!(horizon.end(&sine, 1.0, 60.0), 2.0, "two periods of 0.5 s");
        let record = Ground::record(DVec3::X, 0.01, [0.0, 1.0, 0.0]);
        assert_eq!(horizon.end(&record, 1.0, 60.0), 1.0 + 0.01 * 64.0);
        assert_eq!(horizon.end(&record, 59.9, 60.0), 60.0, "no further than the run");
        assert_eq!(horizon.end(&Ground::Still, 1.0, 60.0), 60.0);
    }
}
