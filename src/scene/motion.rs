//! Motion of the ground, as written in a scene.

use serde::de::value::{MapAccessDeserializer, StringDeserializer};
use serde::de::{DeserializeSeed, Error, IntoDeserializer, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::angle::sin_cos_deg;
use super::keys::{Fallback, Key, Range, table};
use super::record::{Heading, RecordMotion};
use super::sweep::SweepMotion;
use super::synthetic::SyntheticMotion;

pub use crate::motion::format::STANDARD_GRAVITY;

/// `[motion]`, whatever its kind.
pub const MOTION: &[Key] = &[Key::new(
    "kind",
    Range::Words(&["none", "sine", "record", "synthetic", "sweep"]),
    Fallback::Word("none"),
    "which of the following; \"none\" has no other keys",
)];

table! {
    /// `kind = "sine"`: `A sin(2π f t + φ0)` in plan, `A_z sin(2π f t + φz)` upwards.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    struct SineMotion, SINE {
        amplitude_g: Option<f64> = "amplitude_g" as "field-amplitude", Range::Any, Fallback::Needed("this or the next"),
            "A as a multiple of 9.80665 m/s²", slider [0.0, 1.0];
        amplitude: Option<f64> = "amplitude_m_s2" as "field-amplitude", Range::Any, Fallback::Needed("this or the last"), "A, m/s²", slider [0.0, STANDARD_GRAVITY];
        frequency_hz: f64 = "frequency_hz" as "field-frequency", Range::NotNegative, Fallback::Needed("must be given"), "f, Hz", slider [0.1, 10.0];
        #[serde(default)]
        phase_deg: f64 = "phase_deg" as "field-phase", Range::Any, Fallback::Number(0.0), "φ0, degrees", slider [-180.0, 180.0];
        #[serde(default)]
        angle_deg: f64 = "angle_deg" as "field-angle", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees", slider [-180.0, 180.0];
        vertical_amplitude_g: Option<f64> = "vertical_amplitude_g" as "field-vertical-amplitude", Range::Any,
            Fallback::Words("0.0, or the next"), "A_z as a multiple of 9.80665 m/s²", slider [0.0, 1.0], in in_space;
        vertical_amplitude: Option<f64> = "vertical_amplitude_m_s2" as "field-vertical-amplitude", Range::Any,
            Fallback::Words("0.0, or the last"), "A_z, m/s²", slider [0.0, STANDARD_GRAVITY], in in_space;
        vertical_phase_deg: Option<f64> = "vertical_phase_deg" as "field-vertical-phase", Range::Any,
            Fallback::Words("as phase_deg"), "φz, degrees", slider [-180.0, 180.0], in in_space;
    }
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
    /// A synthetic earthquake.
    Synthetic(SyntheticMotion),
    /// A sine sweep.
    Sweep(SweepMotion),
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

impl Motion {
    /// Excitation angle α; 0 when the ground stands still \[degrees\].
    pub fn angle_deg(&self) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Sine(sine) => sine.angle_deg,
            Self::Record(record) => record.angle_deg,
            Self::Synthetic(synthetic) => synthetic.angle_deg,
            Self::Sweep(sweep) => sweep.angle_deg,
        }
    }

    /// Whether the ground moves up and down.
    pub fn is_vertical(&self) -> bool {
        match self {
            Self::None | Self::Sweep(_) => false,
            Self::Sine(sine) => sine.vertical_si() != 0.0,
            Self::Record(record) => {
                let upwards = |n: usize| record.heading(n) == Some(Heading::Up);
                record.vertical_scale != 0.0 || (0..record.components.len()).any(upwards)
            }
            Self::Synthetic(synthetic) => synthetic.factors()[2] != 0.0,
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
    Synthetic,
    Sweep,
}

/// The known keys depend on `kind`, so it is read first; the reader of scene files hands it out first.
impl<'de> Deserialize<'de> for Motion {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(MotionVisitor { name: None })
    }
}

/// Reads a motion; beside its keys a name, where there is a place for one.
pub(super) struct MotionVisitor<'n> {
    /// Destination of the name.
    pub name: Option<&'n mut Option<String>>,
}

impl<'de> Visitor<'de> for MotionVisitor<'_> {
    type Value = Motion;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a table of keys, the kind of motion among them")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Motion, A::Error> {
        let mut map = OwnKeys { map, name: self.name };
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
            MotionKind::Synthetic => {
                SyntheticMotion::deserialize(MapAccessDeserializer::new(map)).map(Motion::Synthetic)
            }
            MotionKind::Sweep => SweepMotion::deserialize(MapAccessDeserializer::new(map)).map(Motion::Sweep),
        }
    }
}

/// The keys of a motion: all of a table, but for the name where that is put aside.
struct OwnKeys<'n, A> {
    map: A,
    name: Option<&'n mut Option<String>>,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for OwnKeys<'_, A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        while let Some(key) = self.map.next_key::<String>()? {
            match &mut self.name {
                Some(name) if key == "name" => **name = Some(self.map.next_value()?),
                _ => {
                    let key: StringDeserializer<A::Error> = key.into_deserializer();
                    return seed.deserialize(key).map(Some);
                }
            }
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.map.next_value_seed(seed)
    }
}
