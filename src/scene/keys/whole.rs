//! Keys at the top of the file and of the ground motion.

use super::{Fallback, Key, Range};
use crate::scene::{Kind, STANDARD_GRAVITY};

/// The top of the file.
pub const TOP: &[Key] = &[
    Key::new("format", Range::Like("1"), Fallback::Number(1.0), "version of the format"),
    Key::new("name", Range::Like("not empty"), Fallback::Needed("must be given"), "what the scene is called"),
    Key::new("description", Range::Free, Fallback::Words("empty"), "a line or two on what it shows"),
    Key::new(
        "kind",
        Range::Words(Kind::WORDS),
        Kind::FALLBACK,
        "planar: x, y and the rotation θ; spatial: six degrees of freedom, gravity, bearings at their true places",
    ),
    Key::new(
        "duration_s",
        Range::Positive,
        Fallback::Needed("must be given"),
        "how long the ground shakes and the answer reaches, s",
    ),
    Key::new(
        "gravity_m_s2",
        Range::NotNegative,
        Fallback::Number(STANDARD_GRAVITY),
        "gravity in a spatial scene, m/s²",
    ),
    Key::new("girder", Range::Like("one or more"), Fallback::Needed("must be given"), "[[girder]], see below"),
    Key::new("abutment", Range::Free, Fallback::Words("none"), "[[abutment]], see below"),
    Key::new("model", Range::Free, Fallback::Words("as below"), "[model]"),
    Key::new("contact", Range::Free, Fallback::Words("as below"), "[contact] and [[contact.pair]]"),
    Key::new("impact", Range::Free, Fallback::Words("as below"), "[impact]"),
    Key::new("motion", Range::Free, Fallback::Words("still ground"), "[motion]"),
    Key::new("solver", Range::Free, Fallback::Words("as below"), "[solver]"),
    Key::new("limits", Range::Free, Fallback::Words("none"), "[limits]"),
    Key::new("view", Range::Free, Fallback::Words("as below"), "[view]"),
];

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
        "interval between samples, s",
    ),
    Key::new("file", Range::Free, Fallback::Needed("this or samples_m_s2"), "a two-column CSV beside the scene's file"),
    Key::new("scale", Range::Any, Fallback::Number(1.0), "multiplies every sample"),
    Key::new("angle_deg", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees"),
];
