//! How the ground moves, as written in a scene.

use std::sync::Arc;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::angle::sin_cos_deg;
use super::keys::{Fallback, Key, Range, table};
use crate::motion::format::{Record, Unit};

pub use crate::motion::format::STANDARD_GRAVITY;

/// `[motion]`, whatever its kind.
pub const MOTION: &[Key] = &[Key::new(
    "kind",
    Range::Words(&["none", "sine", "record"]),
    Fallback::Word("none"),
    "which of the following; \"none\" has no other keys",
)];

/// `[motion]` of `kind = "record"`.
pub const RECORD: &[Key] = &[
    Key::new(
        "samples_m_s2",
        Range::Like("two or more numbers"),
        Fallback::Needed("this or file"),
        "acceleration from t = 0 on, m/s²",
    ),
    Key::new(
        "dt_s",
        Range::Positive,
        Fallback::Needed("must be given with samples_m_s2"),
        "interval between samples, s; beside a file only where that states none",
    )
    .labelled("Interval")
    .slid([0.001, 0.1]),
    Key::new(
        "file",
        Range::Free,
        Fallback::Needed("this or samples_m_s2"),
        "a file that holds it, beside the scene's file",
    ),
    Key::new(
        "channel",
        Range::Like("a whole number from 1 on"),
        Fallback::Words("the one channel of the file"),
        "which channel of a file that has several",
    ),
    Key::new(
        "unit",
        Range::Words(Unit::WORDS),
        Fallback::Words("as the file states"),
        "unit of the numbers in a file that states none",
    ),
    Key::new("scale", Range::Any, Fallback::Number(1.0), "multiplies every sample")
        .labelled("Record scale")
        .slid([0.0, 3.0]),
    Key::new("angle_deg", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees")
        .labelled("Angle α")
        .slid([-180.0, 180.0]),
    Key::new("vertical_scale", Range::Any, Fallback::Number(0.0), "multiplies every sample for a vertical component")
        .labelled("Vertical scale")
        .slid([0.0, 3.0])
        .in_space(),
];

table! {
    /// `kind = "sine"`: `A sin(2π f t + φ0)` in plan, `A_z sin(2π f t + φz)` upwards.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    struct SineMotion, SINE {
        amplitude_g: Option<f64> = "amplitude_g" as "Amplitude", Range::Any, Fallback::Needed("this or the next"),
            "A as a multiple of 9.80665 m/s²", slider [0.0, 1.0];
        amplitude: Option<f64> = "amplitude_m_s2" as "Amplitude", Range::Any, Fallback::Needed("this or the last"), "A, m/s²", slider [0.0, STANDARD_GRAVITY];
        frequency_hz: f64 = "frequency_hz" as "Frequency", Range::NotNegative, Fallback::Needed("must be given"), "f, Hz", slider [0.1, 10.0];
        #[serde(default)]
        phase_deg: f64 = "phase_deg" as "Phase φ0", Range::Any, Fallback::Number(0.0), "φ0, degrees", slider [-180.0, 180.0];
        #[serde(default)]
        angle_deg: f64 = "angle_deg" as "Angle α", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees", slider [-180.0, 180.0];
        vertical_amplitude_g: Option<f64> = "vertical_amplitude_g" as "Vertical amplitude", Range::Any,
            Fallback::Words("0.0, or the next"), "A_z as a multiple of 9.80665 m/s²", slider [0.0, 1.0], in in_space;
        vertical_amplitude: Option<f64> = "vertical_amplitude_m_s2" as "Vertical amplitude", Range::Any,
            Fallback::Words("0.0, or the last"), "A_z, m/s²", slider [0.0, STANDARD_GRAVITY], in in_space;
        vertical_phase_deg: Option<f64> = "vertical_phase_deg" as "Vertical phase φz", Range::Any,
            Fallback::Words("as phase_deg"), "φz, degrees", slider [-180.0, 180.0], in in_space;
    }
}

/// `kind = "record"`: samples at a constant interval, straight lines between them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordMotion {
    /// Acceleration samples \[m/s²\]; these with `dt_s`, or `file`.
    #[serde(rename = "samples_m_s2", default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<Vec<f64>>,
    /// Interval between samples \[s\].
    #[serde(rename = "dt_s", default, skip_serializing_if = "Option::is_none")]
    pub dt: Option<f64>,
    /// File of the record, relative to the scene's file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Which channel of the file, from 1; needed where the file has several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub channel: Option<usize>,
    /// Unit of the numbers in a file that states none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<Unit>,
    /// Multiplies every sample.
    #[serde(default = "one")]
    pub scale: f64,
    /// Excitation angle α, anticlockwise from world x \[degrees\].
    #[serde(default)]
    pub angle_deg: f64,
    /// Multiplies every sample for a vertical component.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub vertical_scale: f64,
    /// What `file` held, once it has been read. Never written.
    #[serde(skip)]
    pub loaded: Option<Arc<Record>>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

fn one() -> f64 {
    1.0
}

/// `[motion]`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Motion {
    /// The ground stands still.
    #[default]
    None,
    /// Harmonic.
    Sine(SineMotion),
    /// A record.
    Record(RecordMotion),
}

impl SineMotion {
    /// `A`, from whichever of the two keys is given; 0 when neither is (validation says so in words) \[m/s²\].
    pub fn amplitude_si(&self) -> f64 {
        self.amplitude.or(self.amplitude_g.map(|g| g * STANDARD_GRAVITY)).unwrap_or(0.0)
    }
}

impl SineMotion {
    /// `A_z`, 0 when it is not given \[m/s²\].
    pub fn vertical_si(&self) -> f64 {
        self.vertical_amplitude.or(self.vertical_amplitude_g.map(|g| g * STANDARD_GRAVITY)).unwrap_or(0.0)
    }

    /// `φ_z − φ0` \[rad\].
    pub fn vertical_lead(&self) -> f64 {
        self.vertical_phase_deg.map_or(0.0, |phase| (phase - self.phase_deg).to_radians())
    }
}

impl Default for RecordMotion {
    /// No samples yet, scale 1 along x.
    fn default() -> Self {
        Self {
            samples: None,
            dt: None,
            file: None,
            channel: None,
            unit: None,
            scale: 1.0,
            angle_deg: 0.0,
            vertical_scale: 0.0,
            loaded: None,
        }
    }
}

impl RecordMotion {
    /// `(dt, samples)` in s and m/s², unscaled, from the scene or from the file that was read; `None` until it is, and where
    /// the file has no such channel.
    pub fn series(&self) -> Option<(f64, &[f64])> {
        match (&self.samples, self.dt, &self.loaded) {
            (Some(samples), Some(dt), _) => Some((dt, samples)),
            (None, _, Some(loaded)) => {
                loaded.channel(self.channel).ok().map(|channel| (channel.dt, channel.samples.as_slice()))
            }
            _ => None,
        }
    }

    /// Samples of the scene's own in place of those of the file; whether there were any.
    pub fn keep_samples(&mut self) -> bool {
        let Some((dt, samples)) = self.series().map(|(dt, samples)| (dt, samples.to_vec())) else { return false };
        (self.dt, self.samples) = (Some(dt), Some(samples));
        (self.file, self.channel, self.unit, self.loaded) = (None, None, None, None);
        true
    }

    /// Whether a file read for one of the two holds for the other as well.
    pub(in crate::scene) fn reads_as(&self, other: &Self) -> bool {
        (&self.file, self.dt, self.unit) == (&other.file, other.dt, other.unit)
    }
}

impl Motion {
    /// Excitation angle α; 0 when the ground stands still \[degrees\].
    pub fn angle_deg(&self) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Sine(sine) => sine.angle_deg,
            Self::Record(record) => record.angle_deg,
        }
    }

    /// `(cos α, sin α)`, exact at multiples of 90°.
    pub fn direction(&self) -> [f64; 2] {
        let (sin, cos) = sin_cos_deg(self.angle_deg());
        [cos, sin]
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum MotionKind {
    None,
    Sine,
    Record,
}

/// Which keys are known depends on `kind`, so it is read first; the reader of scene files hands it out first.
impl<'de> Deserialize<'de> for Motion {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(MotionVisitor)
    }
}

struct MotionVisitor;

impl<'de> Visitor<'de> for MotionVisitor {
    type Value = Motion;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a table of keys, the kind of motion among them")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Motion, A::Error> {
        if map.next_key::<String>()?.as_deref() != Some("kind") {
            return Err(A::Error::missing_field("kind"));
        }
        match map.next_value()? {
            MotionKind::None => match map.next_key::<String>()? {
                None => Ok(Motion::None),
                Some(key) => Err(A::Error::unknown_field(&key, &["kind"])),
            },
            MotionKind::Sine => SineMotion::deserialize(MapAccessDeserializer::new(map)).map(Motion::Sine),
            MotionKind::Record => RecordMotion::deserialize(MapAccessDeserializer::new(map)).map(Motion::Record),
        }
    }
}
