//! Two or three numbers; a missing third is 0, and a third of 0 is not written.

use serde::de::{SeqAccess, Visitor};
use serde::{Deserializer, Serialize, Serializer};

/// Writes two numbers where the third is 0.
///
/// # Errors
///
/// Those of the serializer.
pub(super) fn serialize<S: Serializer>(v: &[f64; 3], serializer: S) -> Result<S::Ok, S::Error> {
    if v[2].to_bits() == 0 { v[..2].serialize(serializer) } else { v.serialize(serializer) }
}

/// Reads two or three numbers.
///
/// # Errors
/// Anything else.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; 3], D::Error> {
    deserializer.deserialize_any(TwoOrThree)
}

struct TwoOrThree;

impl<'de> Visitor<'de> for TwoOrThree {
    type Value = [f64; 3];

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a list of two or three numbers")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<[f64; 3], A::Error> {
        let two = (seq.next_element()?, seq.next_element()?);
        match two {
            (Some(x), Some(y)) => Ok([x, y, seq.next_element()?.unwrap_or(0.0)]),
            _ => Err(serde::de::Error::invalid_length(0, &self)),
        }
    }
}

/// A list that may be left out.
pub(super) mod optional {
    use serde::{Deserializer, Serializer};

    /// Writes what is given; what is not is left out before.
    ///
    /// # Errors
    ///
    /// Those of the serializer.
    #[expect(clippy::ref_option, reason = "serde passes fields by reference")]
    pub(in crate::scene) fn serialize<S: Serializer>(v: &Option<[f64; 3]>, serializer: S) -> Result<S::Ok, S::Error> {
        match v {
            Some(v) => super::serialize(v, serializer),
            None => serializer.serialize_none(),
        }
    }

    /// Reads two or three numbers.
    ///
    /// # Errors
    /// Anything else.
    pub(in crate::scene) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<[f64; 3]>, D::Error> {
        super::deserialize(deserializer).map(Some)
    }
}
