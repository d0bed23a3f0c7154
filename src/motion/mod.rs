//! Ground motion as functions of time (`docs/physics.md#ground-motion`).
//!
//! A ground acceleration `a_g(t)` enters the bodies as `−m a_g`. It is either nothing, a sine, or a record that is
//! linear between samples; each is piecewise analytic, which is what lets free flight have a closed form.

pub mod format;
pub mod integrate;
pub mod spectrum;

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
        /// Unit direction of shaking.
        direction: DVec3,
        /// Interval \[s\].
        dt: f64,
        /// Scaled samples, shared by all who fly under them \[m/s²\].
        samples: Arc<[f64]>,
        /// Largest of them, either sign \[m/s²\].
        peak: f64,
    },
}

/// A stretch of ground motion without a kink: `a(t) = start + slope (t − from)` plus the sine, until `until`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearPiece {
    /// Where the piece begins \[s\].
    pub from: f64,
    /// Where it ends; infinite after the last sample \[s\].
    pub until: f64,
    /// Acceleration at `from` \[m/s²\].
    pub start: f64,
    /// Its rate \[m/s³\].
    pub slope: f64,
}

impl Ground {
    /// A record: unit direction, interval \[s\], scaled samples \[m/s²\].
    pub fn record(direction: DVec3, dt: f64, samples: impl IntoIterator<Item = f64>) -> Self {
        let samples: Arc<[f64]> = samples.into_iter().collect();
        let peak = samples.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
        Self::Record { direction, dt, samples, peak }
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
            Self::Record { direction, .. } => {
                let piece = self.piece(self.piece_number(t));
                *direction * (piece.start + piece.slope * (t - piece.from))
            }
        }
    }

    /// Number of the linear piece of a record that holds `t`; a sample belongs to the piece that it begins.
    pub fn piece_number(&self, t: f64) -> usize {
        let Self::Record { dt, samples, .. } = self else { return 0 };
        let last = samples.len() - 1;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the samples")]
        let mut j = ((t / dt).floor().max(0.0) as usize).min(last);
        // The quotient may round across a sample; the product is what a piece begins with.
        if j < last && (j + 1) as f64 * dt <= t {
            j += 1;
        } else if j > 0 && j as f64 * dt > t {
            j -= 1;
        }
        j
    }

    /// The linear piece of that number; past the last sample the ground stands still.
    pub fn piece(&self, number: usize) -> LinearPiece {
        let Self::Record { dt, samples, .. } = self else {
            return LinearPiece { from: 0.0, until: f64::INFINITY, start: 0.0, slope: 0.0 };
        };
        let from = number as f64 * dt;
        match samples.get(number + 1) {
            Some(next) => {
                let until = (number + 1) as f64 * dt;
                LinearPiece { from, until, start: samples[number], slope: (next - samples[number]) / dt }
            }
            None => LinearPiece { from, until: f64::INFINITY, start: 0.0, slope: 0.0 },
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

    /// Unit direction of shaking, of a component out of phase apart; nothing when the ground stands still.
    pub fn axis(&self) -> DVec3 {
        match self {
            Self::Still => DVec3::ZERO,
            Self::Sine { amplitude, .. } => amplitude.normalize_or_zero(),
            Self::Record { direction, .. } => *direction,
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
    fn a_tenth_of_a_second_falls_into_its_own_piece_for_every_sample() {
        let ground = Ground::record(DVec3::X, 0.01, [0.0; 2000]);
        for j in 0..1999 {
            assert_eq!(ground.piece_number(j as f64 * 0.01), j, "sample {j}");
        }
    }
}
