//! The earthquake of the study: El Centro 1940, EW, where its file is given, else a synthetic one.
//!
//! The paper states neither scale nor version of its record. What is assumed here is written into the report.

use crate::motion::format::{Channel, STANDARD_GRAVITY};
use crate::scene::{Motion, RecordMotion, SyntheticMotion};

/// Peak of the synthetic earthquake: that of El Centro 1940, component 270, in PEER's first version, 0.2148 g \[g\].
pub(super) const SYNTHETIC_PEAK_G: f64 = 0.2148;
/// Length of the synthetic earthquake \[s\].
const SYNTHETIC_LENGTH: f64 = 30.0;
/// At most so much of a record is run; strong motion is over before \[s\].
const LONGEST: f64 = 60.0;

/// Acceleration of the shaking table, one component.
#[derive(Clone, Debug, PartialEq)]
pub struct Earthquake {
    /// Description, in a line.
    pub name: String,
    /// Whether it is the built-in synthetic one.
    pub synthetic: bool,
    /// Multiplies every sample.
    pub scale: f64,
    dt: f64,
    samples: Vec<f64>,
}

impl Earthquake {
    /// The built-in one, for want of a file.
    pub fn synthetic(scale: f64) -> Self {
        let motion =
            SyntheticMotion { peak_g: SYNTHETIC_PEAK_G, duration: SYNTHETIC_LENGTH, ..SyntheticMotion::default() };
        Self {
            name: format!("synthetic earthquake, seed {}, {SYNTHETIC_LENGTH} s", motion.seed),
            synthetic: true,
            scale,
            dt: motion.dt,
            samples: motion.samples(0),
        }
    }

    /// Of a channel of a record file.
    pub fn of(channel: &Channel, file: &str, scale: f64) -> Self {
        let name = if channel.name.is_empty() { file.to_owned() } else { format!("{file}, {}", channel.name) };
        Self { name, synthetic: false, scale, dt: channel.dt, samples: channel.samples.clone() }
    }

    /// As a scene has it, along this angle \[degrees\].
    pub(super) fn motion(&self, angle_deg: f64) -> Motion {
        Motion::Record(RecordMotion {
            samples: Some(self.samples.clone()),
            dt: Some(self.dt),
            scale: self.scale,
            angle_deg,
            ..RecordMotion::default()
        })
    }

    /// Duration of its runs \[s\].
    pub fn duration(&self) -> f64 {
        (self.dt * self.samples.len() as f64).min(LONGEST)
    }

    /// Largest magnitude as it shakes \[g\].
    pub fn peak_g(&self) -> f64 {
        let peak = self.samples.iter().fold(0.0_f64, |most, a| most.max(a.abs()));
        peak * self.scale.abs() / STANDARD_GRAVITY
    }
}
