//! Ground motion as functions of time (`docs/physics.md#ground-motion`).
//!
//! A ground acceleration `a_g(t)` enters the bodies as `−m a_g`. It is either nothing, a sine, or a record that is
//! linear between samples; each is piecewise analytic, which is what lets free flight have a closed form.

pub mod format;
pub mod fourier;
pub mod integrate;
mod largest;
pub mod matching;
pub mod oscillator;
pub mod process;
pub mod responses;
pub mod spectrum;
pub mod support;
pub mod sweep;
pub mod synthetic;

use std::sync::Arc;

use glam::DVec3;

/// Ground acceleration in the world frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Ground {
    /// The ground stands still.
    Still,
    /// `A sin(ω t + φ0) + B cos(ω t + φ0)`.
    Sine {
        /// `A` \[m/s²\].
        amplitude: DVec3,
        /// `B`, of a vertical component out of phase \[m/s²\].
        quadrature: DVec3,
        /// `ω = 2π f` \[rad/s\].
        omega: f64,
        /// `φ0` \[rad\].
        phase: f64,
    },
    /// Samples at `t = 0, dt, 2 dt, …`, straight lines between them, nothing after the last.
    Record {
        /// Interval \[s\].
        dt: f64,
        /// Scaled samples.
        samples: Samples,
        /// Largest magnitude of them \[m/s²\].
        peak: f64,
    },
}

/// Samples of a record, shared by every body that moves under them.
#[derive(Clone, Debug, PartialEq)]
pub enum Samples {
    /// Along one direction.
    Along {
        /// Unit direction of shaking.
        direction: DVec3,
        /// Samples \[m/s²\].
        values: Arc<[f64]>,
    },
    /// Several components at once.
    Components {
        /// Samples in the world frame \[m/s²\].
        values: Arc<[DVec3]>,
        /// Largest magnitude along each world axis \[m/s²\].
        largest: DVec3,
        /// Components that end before others: number of the last sample, and what it is of the sum there \[m/s²\], which is gone after it.
        ends: Arc<[(usize, DVec3)]>,
    },
}

/// A stretch of ground motion without a kink, until `until`; the sine adds to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearPiece {
    /// Beginning of the piece \[s\].
    pub from: f64,
    /// End of the piece; infinite after the last sample \[s\].
    pub until: f64,
    /// Acceleration within it.
    pub line: Line,
}

/// An acceleration that is linear in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// `direction (start + slope (t − from))`.
    Along {
        /// Unit direction.
        direction: DVec3,
        /// Acceleration at the start \[m/s²\].
        start: f64,
        /// Its rate \[m/s³\].
        slope: f64,
    },
    /// `start + slope (t − from)`.
    Components {
        /// Acceleration at the start \[m/s²\].
        start: DVec3,
        /// Its rate \[m/s³\].
        slope: DVec3,
    },
}

impl LinearPiece {
    /// Acceleration at `t` \[m/s²\].
    pub fn acceleration(&self, t: f64) -> DVec3 {
        match self.line {
            Line::Along { direction, start, slope } => direction * (start + slope * (t - self.from)),
            Line::Components { start, slope } => start + slope * (t - self.from),
        }
    }

    /// Acceleration where the piece begins \[m/s²\].
    pub fn start(&self) -> DVec3 {
        match self.line {
            Line::Along { direction, start, .. } => direction * start,
            Line::Components { start, .. } => start,
        }
    }

    /// First and second integral of the acceleration \[m/s, m\], carried from `at` over τ.
    pub fn carried(&self, [v, d]: [DVec3; 2], at: f64, tau: f64) -> [DVec3; 2] {
        let (value, slope) = (self.acceleration(at), self.rate());
        [
            v + value * tau + slope * (0.5 * tau * tau),
            d + v * tau + value * (0.5 * tau * tau) + slope * (tau * tau * tau / 6.0),
        ]
    }

    /// Rate of the acceleration \[m/s³\].
    pub fn rate(&self) -> DVec3 {
        match self.line {
            Line::Along { direction, slope, .. } => direction * slope,
            Line::Components { slope, .. } => slope,
        }
    }

    /// No acceleration from `from` to `until`.
    fn still(from: f64, until: f64) -> Self {
        Self { from, until, line: Line::Along { direction: DVec3::ZERO, start: 0.0, slope: 0.0 } }
    }
}

impl Samples {
    fn len(&self) -> usize {
        match self {
            Self::Along { values, .. } => values.len(),
            Self::Components { values, .. } => values.len(),
        }
    }

    /// The line from a sample to the next; none from the last.
    fn line(&self, number: usize, dt: f64) -> Option<Line> {
        match self {
            Self::Along { direction, values } => {
                let (start, next) = (*values.get(number)?, values.get(number + 1)?);
                Some(Line::Along { direction: *direction, start, slope: (next - start) / dt })
            }
            Self::Components { values, ends, .. } => {
                let (mut start, next) = (*values.get(number)?, *values.get(number + 1)?);
                for (_, last) in ends.iter().filter(|(sample, _)| *sample == number) {
                    start -= *last;
                }
                Some(Line::Components { start, slope: (next - start) / dt })
            }
        }
    }
}

impl Ground {
    /// A record: unit direction, interval \[s\], scaled samples \[m/s²\].
    pub fn record(direction: DVec3, dt: f64, samples: impl IntoIterator<Item = f64>) -> Self {
        let values: Arc<[f64]> = samples.into_iter().collect();
        let peak = values.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
        Self::Record { dt, samples: Samples::Along { direction, values }, peak }
    }

    /// A record of several components: interval \[s\], samples of their sum in the world frame \[m/s²\]; of components that end before
    /// others the number and the value of the last sample, after which they are 0.
    pub fn components(
        dt: f64,
        samples: impl IntoIterator<Item = DVec3>,
        ends: impl IntoIterator<Item = (usize, DVec3)>,
    ) -> Self {
        let values: Arc<[DVec3]> = samples.into_iter().collect();
        let peak = values.iter().fold(0.0, |most: f64, a| most.max(a.length()));
        let largest = values.iter().fold(DVec3::ZERO, |most, a| most.max(a.abs()));
        Self::Record { dt, samples: Samples::Components { values, largest, ends: ends.into_iter().collect() }, peak }
    }

    /// Unit vector in plan at the excitation angle α; multiples of 90° are exact.
    pub fn direction(angle_deg: f64) -> DVec3 {
        match angle_deg.rem_euclid(360.0) {
            0.0 => DVec3::X,
            90.0 => DVec3::Y,
            180.0 => DVec3::NEG_X,
            270.0 => DVec3::NEG_Y,
            other => {
                let (s, c) = other.to_radians().sin_cos();
                DVec3::new(c, s, 0.0)
            }
        }
    }

    /// Sine and cosine of a sine's phase at `t`; both 0 where there is none.
    #[inline]
    pub fn phase(&self, t: f64) -> [f64; 2] {
        let Self::Sine { omega, phase, .. } = self else { return [0.0; 2] };
        let (s, c) = (omega * t + phase).sin_cos();
        [s, c]
    }

    /// Circular frequency of a sine; 0 where there is none \[rad/s\].
    pub fn drive(&self) -> f64 {
        if let Self::Sine { omega, .. } = self { *omega } else { 0.0 }
    }

    /// `a_g(t)` \[m/s²\].
    pub fn acceleration(&self, t: f64) -> DVec3 {
        match self {
            Self::Still => DVec3::ZERO,
            Self::Sine { amplitude, quadrature: DVec3::ZERO, omega, phase } => *amplitude * (omega * t + phase).sin(),
            Self::Sine { amplitude, quadrature, omega, phase } => {
                let (sin, cos) = (omega * t + phase).sin_cos();
                *amplitude * sin + *quadrature * cos
            }
            Self::Record { .. } => self.piece(self.piece_number(t)).acceleration(t),
        }
    }

    /// Number of the linear piece of a record that holds `t`; a sample belongs to the piece that it begins.
    pub fn piece_number(&self, t: f64) -> usize {
        let Self::Record { dt, samples, .. } = self else { return 0 };
        let last = samples.len() - 1;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the samples")]
        let mut j = ((t / dt).max(0.0) as usize).min(last);
        // The quotient may round across a sample; the product is what a piece begins with.
        if j < last && (j + 1) as f64 * dt <= t {
            j += 1;
        } else if j > 0 && j as f64 * dt > t {
            j -= 1;
        }
        j
    }

    /// Number of the linear piece of a record that holds the instants just before `t`.
    pub fn piece_number_before(&self, t: f64) -> usize {
        let number = self.piece_number(t);
        if number > 0 && self.piece_start(number) >= t { number - 1 } else { number }
    }

    /// Beginning of the linear piece of that number \[s\].
    pub fn piece_start(&self, number: usize) -> f64 {
        if let Self::Record { dt, .. } = self { number as f64 * dt } else { 0.0 }
    }

    /// The linear piece of that number; past the last sample the ground stands still.
    pub fn piece(&self, number: usize) -> LinearPiece {
        let Self::Record { dt, samples, .. } = self else {
            return LinearPiece::still(0.0, f64::INFINITY);
        };
        let from = self.piece_start(number);
        match samples.line(number, *dt) {
            Some(line) => LinearPiece { from, until: (number + 1) as f64 * dt, line },
            None => LinearPiece::still(from, f64::INFINITY),
        }
    }

    /// The next time after `t` at which the motion has a kink; infinite when there is none \[s\].
    pub fn next_kink(&self, t: f64) -> f64 {
        match self {
            Self::Still | Self::Sine { .. } => f64::INFINITY,
            Self::Record { .. } => self.piece(self.piece_number(t)).until,
        }
    }

    /// Bound of |`a_g`| at any time, reached without a component out of phase \[m/s²\].
    pub fn peak(&self) -> f64 {
        match self {
            Self::Still => 0.0,
            Self::Sine { amplitude, quadrature, .. } => amplitude.length().hypot(quadrature.length()),
            Self::Record { peak, .. } => *peak,
        }
    }

    /// Unit direction of shaking, of a component out of phase apart; nothing when the ground stands still. Of a record of
    /// several components the largest of each \[m/s²\]: 0 along an axis that the ground does not drive.
    pub fn axis(&self) -> DVec3 {
        match self {
            Self::Still => DVec3::ZERO,
            Self::Sine { amplitude, .. } => amplitude.normalize_or_zero(),
            Self::Record { samples: Samples::Along { direction, .. }, .. } => *direction,
            Self::Record { samples: Samples::Components { largest, .. }, .. } => *largest,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_linear_between_its_samples_and_still_after_the_last() {
        let ground = Ground::record(DVec3::X, 0.1, [0.0, 2.0, -1.0]);
        assert!((ground.acceleration(0.05).x - 1.0).abs() < 1e-15, "halfway between 0 and 2");
        assert!((ground.acceleration(0.1).x - 2.0).abs() < 1e-15, "at a sample");
        assert_eq!(ground.acceleration(0.25), DVec3::ZERO, "after the record");
        assert_eq!(ground.next_kink(0.1), 0.2, "a sample belongs to the piece it begins");
        assert_eq!(ground.next_kink(0.3), f64::INFINITY, "no kink after the record");
    }

    #[test]
    fn components_are_linear_between_their_samples_too() {
        let ground = Ground::components(0.1, [DVec3::ZERO, DVec3::new(3.0, 4.0, -1.0), DVec3::new(1.0, 0.0, 0.0)], []);
        assert!((ground.acceleration(0.05) - DVec3::new(1.5, 2.0, -0.5)).length() < 1e-15, "halfway");
        assert!((ground.peak() - 26f64.sqrt()).abs() < 1e-15 && ground.axis() == DVec3::new(3.0, 4.0, 1.0), "largest");
        assert_eq!(ground.acceleration(0.2), DVec3::ZERO, "after the record");
    }

    #[test]
    fn a_component_that_ends_before_others_is_nothing_after_its_last_sample() {
        let sum = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::new(3.0, 0.0, 0.0)];
        let ground = Ground::components(0.1, sum, [(1, DVec3::new(0.0, 2.0, 0.0))]);
        assert!((ground.acceleration(0.05) - DVec3::new(0.5, 1.0, 0.0)).length() < 1e-15, "before");
        assert!(
            (ground.acceleration(0.15) - DVec3::new(2.0, 0.0, 0.0)).length() < 1e-15,
            "no way down to the next sample"
        );
    }

    #[test]
    fn a_tenth_of_a_second_falls_into_its_own_piece_for_every_sample() {
        let ground = Ground::record(DVec3::X, 0.01, [0.0; 2000]);
        for j in 0..1999 {
            assert_eq!(ground.piece_number(j as f64 * 0.01), j, "sample {j}");
        }
    }

    #[test]
    fn just_before_a_sample_the_ground_is_in_the_piece_that_ends_there() {
        let ground = Ground::record(DVec3::X, 0.5, [1.0, 2.0, 3.0]);
        let before = |t: f64| ground.piece_number_before(t);
        assert_eq!([0.0, 0.2, 0.5, 0.7, 1.0, 2.0].map(before), [0, 0, 0, 1, 1, 2], "pieces begin at 0, 0.5 and 1");
    }
}
