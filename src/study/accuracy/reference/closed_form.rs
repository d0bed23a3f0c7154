//! Free decay and the response to a sine of the straight girder: three oscillators in closed form, the textbook's.

use crate::study::accuracy::{Answer, Instants};

/// `ω` of the straight girder 1, h, and the lever of its legs \[m\].
const FREQUENCY: f64 = 2.4;
const DAMPING: f64 = 0.29;
const LEGS: (f64, f64) = (0.070, 0.025);
const PLAN: (f64, f64) = (0.190, 0.070);

/// `q̈ + 2hω q̇ + ω² q = 0`.
#[derive(Clone, Copy)]
struct Oscillator {
    omega: f64,
    h: f64,
}

impl Oscillator {
    /// In translation.
    fn along() -> Self {
        Self { omega: std::f64::consts::TAU * FREQUENCY, h: DAMPING }
    }

    /// In rotation: `k_θ/(m i²) = ω² l²/i²` with `l² = l_x² + l_y²`, dashpots likewise.
    fn about() -> Self {
        let part = (LEGS.0.powi(2) + LEGS.1.powi(2)) / ((PLAN.0.powi(2) + PLAN.1.powi(2)) / 12.0);
        let Self { omega, h } = Self::along();
        Self { omega: omega * part.sqrt(), h: h * part.sqrt() }
    }

    /// Free motion from `(q, v)`.
    fn free(self, q: f64, v: f64, t: f64) -> f64 {
        let decay = self.h * self.omega;
        let w = self.omega * (1.0 - self.h * self.h).sqrt();
        let (sin, cos) = (w * t).sin_cos();
        (-decay * t).exp() * (q * cos + (v + decay * q) / w * sin)
    }

    /// From rest under `−A sin Ωt`.
    fn driven(self, amplitude: f64, drive: f64, t: f64) -> f64 {
        let (re, im) = (self.omega.powi(2) - drive * drive, 2.0 * self.h * self.omega * drive);
        let size2 = re * re + im * im;
        let (sine, cosine) = (-amplitude * re / size2, amplitude * im / size2);
        let (s, c) = (drive * t).sin_cos();
        sine * s + cosine * c + self.free(-cosine, -sine * drive, t)
    }
}

/// Let go from 10 mm, 4 mm and 2°, at 0.1 m/s across.
pub(super) fn free_decay(instants: Instants) -> Answer {
    let (along, about) = (Oscillator::along(), Oscillator::about());
    let place = |t: f64| {
        let turn = about.free(2.0_f64.to_radians(), 0.0, t);
        [along.free(0.010, 0.0, t), along.free(0.004, 0.1, t), 0.0, turn]
    };
    Answer { places: instants.all().map(place).collect(), bodies: 1, ..Answer::default() }
}

/// From rest under 3.924 m/s² at 2 Hz, 30° to the axis.
pub(super) fn harmonic_response(instants: Instants) -> Answer {
    let (along, drive) = (Oscillator::along(), std::f64::consts::TAU * 2.0);
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let place = |t: f64| {
        let q = along.driven(3.924, drive, t);
        [cos * q, sin * q, 0.0, 0.0]
    };
    Answer { places: instants.all().map(place).collect(), bodies: 1, ..Answer::default() }
}
