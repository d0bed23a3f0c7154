//! A sine sweep, as written in a scene.

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table, words};
use super::motion::STANDARD_GRAVITY;
use crate::language::Text;
use crate::motion::sweep::{Rate, Sweep};

/// Most intervals between samples of a sweep.
const MOST_INTERVALS: u32 = 1_000_000;

words! {
    /// Frequency of a sweep as a function of time.
    SweepRate, by default Linear {
        /// By the same number of hertz each second.
        Linear = "linear",
        /// By the same factor each second.
        Logarithmic = "logarithmic",
    }
}

table! {
    /// `kind = "sweep"`: a sine of constant amplitude and changing frequency.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct SweepMotion, SWEEP {
        amplitude_g: f64 = "amplitude_g" as "field-amplitude", Range::Any, Fallback::Number(0.05), "A as a multiple of 9.80665 m/s²", slider [0.0, 1.0];
        from_hz: f64 = "from_hz" as "field-from-frequency", Range::Positive, Fallback::Number(1.0), "frequency f₀ at its start, Hz", slider [0.1, 10.0];
        to_hz: f64 = "to_hz" as "field-to-frequency", Range::Positive, Fallback::Number(8.0), "frequency f₁ at its end, Hz", slider [0.1, 10.0];
        rate: SweepRate = "rate" as "field-rate", Range::Words(SweepRate::WORDS), SweepRate::FALLBACK, "how the frequency changes: by the same number of hertz, or by the same factor each second";
        length: f64 = "length_s" as "field-length", Range::Positive, Fallback::Number(60.0), "length T; the ground then stands still, s", slider [5.0, 100.0];
        angle_deg: f64 = "angle_deg" as "field-angle", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees", slider [-180.0, 180.0];
    }
}

impl SweepMotion {
    /// The motion.
    pub fn sweep(&self) -> Sweep {
        let rate = match self.rate {
            SweepRate::Linear => Rate::Linear,
            SweepRate::Logarithmic => Rate::Logarithmic,
        };
        let amplitude = self.amplitude_g * STANDARD_GRAVITY;
        Sweep { amplitude, from: self.from_hz, to: self.to_hz, length: self.length, rate }
    }

    /// Samples that bodies are shaken by: interval \[s\], values \[m/s²\].
    pub fn samples(&self) -> (f64, Vec<f64>) {
        let sweep = self.sweep();
        (sweep.interval(), sweep.samples(MOST_INTERVALS))
    }

    /// Fault of keys that contradict each other: key, value and remedy.
    pub(in crate::scene) fn fault(&self) -> Option<(&'static str, f64, Text)> {
        let too_long = self.sweep().intervals() > f64::from(MOST_INTERVALS);
        too_long.then_some(("length_s", self.length, Text::new("wrong-sweep-length")))
    }
}
