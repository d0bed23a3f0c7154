//! Sample times of a ground motion, the largest acceleration of a component, and the time at which it is first reached.

use glam::DVec3;

use super::{Ground, Samples};

impl Samples {
    /// A sample \[m/s²\]; 0 beyond the last.
    fn at(&self, number: usize) -> DVec3 {
        match self {
            Self::Along { direction, values } => values.get(number).map_or(DVec3::ZERO, |value| *direction * *value),
            Self::Components { values, .. } => values.get(number).copied().unwrap_or(DVec3::ZERO),
        }
    }
}

impl Ground {
    /// A record's interval \[s\] and its samples up to `end` \[m/s²\]; `None` where the ground is no record.
    pub fn samples_until(&self, end: f64) -> Option<(f64, Vec<DVec3>)> {
        let Self::Record { dt, samples, .. } = self else { return None };
        let within = (0..samples.len()).take_while(|&number| number as f64 * dt <= end);
        Some((*dt, within.map(|number| samples.at(number)).collect()))
    }

    /// The largest |acceleration| along a world axis up to `end` \[m/s²\], and when it is reached first \[s\]: of a record at a sample, of
    /// a sine at its first crest.
    pub fn largest(&self, axis: usize, end: f64) -> [f64; 2] {
        let higher = |best: [f64; 2], next: [f64; 2]| if next[0] > best[0] { next } else { best };
        let at = |t: f64| [self.acceleration(t)[axis].abs(), t];
        match self {
            Self::Still => [0.0; 2],
            Self::Sine { amplitude, quadrature, omega, phase } => {
                // A sin + B cos is R sin(φ + ψ), with |R| at φ + ψ = π/2 and every half turn from it.
                let ahead = quadrature[axis].atan2(amplitude[axis]);
                let crest = (std::f64::consts::FRAC_PI_2 - phase - ahead).rem_euclid(std::f64::consts::PI) / omega;
                let within = (crest <= end).then(|| [amplitude[axis].hypot(quadrature[axis]), crest]);
                within.unwrap_or_else(|| higher(at(0.0), at(end)))
            }
            Self::Record { dt, samples, .. } => {
                let values = (0..samples.len()).map(|number| [samples.at(number)[axis].abs(), number as f64 * dt]);
                let between = at(end);
                values.take_while(|[_, t]| *t <= end).chain([between]).fold([0.0; 2], higher)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn a_record_is_largest_at_a_sample_or_where_the_run_ends() {
        let ground = Ground::record(DVec3::X, 0.1, [0.0, 2.0, -3.0, 3.0]);
        assert_eq!(ground.largest(0, 1.0), [3.0, 0.2], "the first of equals");
        let [value, t] = ground.largest(0, 0.19);
        assert!((value - 2.5).abs() < 1e-12 && t == 0.19, "on the way to a sample beyond the end: {value} at {t} s");
        assert_eq!(ground.largest(1, 1.0)[0], 0.0, "across");
        assert_eq!(ground.samples_until(0.2).map(|(_, samples)| samples.len()), Some(3));
    }

    #[test]
    fn a_sine_is_largest_at_its_first_crest() {
        let omega = TAU * 2.4;
        let sine = |phase: f64, quadrature: f64| Ground::Sine {
            amplitude: DVec3::new(3.0, 0.0, 1.0),
            quadrature: DVec3::new(0.0, 0.0, quadrature),
            omega,
            phase,
        };
        let [value, t] = sine(0.0, 0.0).largest(0, 10.0);
        assert!((value - 3.0).abs() < 1e-15 && (t - 1.0 / (4.0 * 2.4)).abs() < 1e-15, "{value} at {t} s");
        let [_, t] = sine(0.75 * PI, 0.0).largest(0, 10.0);
        assert!((omega * t - 0.75 * PI).abs() < 1e-12, "a trough counts: {t} s");
        let [value, t] = sine(0.3, 2.0).largest(2, 10.0);
        assert!((value - 5.0_f64.sqrt()).abs() < 1e-15, "{value}");
        assert!((sine(0.3, 2.0).acceleration(t).z.abs() - value).abs() < 1e-14, "there: {t} s");
        let [value, t] = sine(0.0, 0.0).largest(0, 0.05);
        assert!(t == 0.05 && (value - 3.0 * (omega * 0.05).sin()).abs() < 1e-15, "before its crest: {value} at {t} s");
    }
}
