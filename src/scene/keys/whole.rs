//! Keys at the top of the file, of the ground motion, the solver, the limits and the view.

use super::{Fallback, Key, Range};
use crate::scene::STANDARD_GRAVITY;

/// The top of the file.
pub const TOP: &[Key] = &[
    Key::new("format", Range::Like("1"), Fallback::Number(1.0), "version of the format"),
    Key::new("name", Range::Like("not empty"), Fallback::Needed("must be given"), "what the scene is called"),
    Key::new("description", Range::Free, Fallback::Words("empty"), "a line or two on what it shows"),
    Key::new(
        "kind",
        Range::Words(&["planar", "spatial"]),
        Fallback::Word("planar"),
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

/// `[motion]` of `kind = "sine"`.
pub const SINE: &[Key] = &[
    Key::new("amplitude_g", Range::Any, Fallback::Needed("this or the next"), "A as a multiple of 9.80665 m/s²"),
    Key::new("amplitude_m_s2", Range::Any, Fallback::Needed("this or the last"), "A, m/s²"),
    Key::new("frequency_hz", Range::NotNegative, Fallback::Needed("must be given"), "f, Hz"),
    Key::new("phase_deg", Range::Any, Fallback::Number(0.0), "φ0, degrees"),
    Key::new("angle_deg", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees"),
];

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

/// `[solver]`.
pub const SOLVER: &[Key] = &[
    Key::new(
        "tolerance",
        Range::Within([1e-13, 0.01]),
        Fallback::Number(1e-10),
        "local error a step, relative to the motion in hand",
    ),
    Key::new(
        "method",
        Range::Words(&["event-driven"]),
        Fallback::Word("event-driven"),
        "closed-form flight where it exists, an embedded pair of order 8 elsewhere, every event root-found",
    ),
];

/// `[limits]`.
pub const LIMITS: &[Key] = &[
    Key::new(
        "rotation_deg",
        Range::NotNegative,
        Fallback::Words("not watched"),
        "largest rotation of any girder, either way, degrees",
    ),
    Key::new(
        "drift_m",
        Range::NotNegative,
        Fallback::Words("not watched"),
        "largest distance of any corner in plan from where it was placed, m",
    ),
    Key::new(
        "remaining_seat_m",
        Range::NotNegative,
        Fallback::Words("not watched"),
        "least seat that remains under every end that has one (seat_m), m",
    ),
    Key::new("force_n", Range::NotNegative, Fallback::Words("not watched"), "largest force of any contact, N"),
];

/// `[view]`.
pub const VIEW: &[Key] = &[
    Key::new(
        "camera",
        Range::Words(&["iso", "top", "side", "contact"]),
        Fallback::Word("iso"),
        "where the camera stands first",
    ),
    Key::new("overlays", Range::Free, Fallback::Words("as below"), "[view.overlays]"),
    Key::new(
        "force_scale_n_per_m",
        Range::Positive,
        Fallback::Words("from the run's peak"),
        "scale of the force arrows, N per metre",
    ),
    Key::new("plot", Range::Free, Fallback::Words("none"), "[[view.plot]]"),
];

/// `[[view.plot]]`.
pub const PLOT: &[Key] = &[
    Key::new(
        "y",
        Range::Like("names of quantities of one unit"),
        Fallback::Needed("must be given"),
        "what is drawn; only energies against time: one upon the other",
    ),
    Key::new("x", Range::Like("the name of a quantity"), Fallback::Words("time"), "what it is drawn against"),
];

/// `[view.overlays]`.
pub const OVERLAYS: &[Key] = &[
    Key::new("grid", Range::Switch, Fallback::Switch(true), "ground grid"),
    Key::new("bearings", Range::Switch, Fallback::Switch(true), "bearings"),
    Key::new("gap", Range::Switch, Fallback::Switch(true), "gap of each facing pair"),
    Key::new("contacts", Range::Switch, Fallback::Switch(true), "contact points with their state"),
    Key::new("normal", Range::Switch, Fallback::Switch(false), "arrows of the normal force"),
    Key::new("tangential", Range::Switch, Fallback::Switch(false), "arrows of the tangential force"),
    Key::new("resultant", Range::Switch, Fallback::Switch(true), "arrows of the resultant, dashpots left out"),
    Key::new("damping", Range::Switch, Fallback::Switch(false), "arrows of the dashpots"),
    Key::new("cones", Range::Switch, Fallback::Switch(true), "friction cones"),
    Key::new("axes", Range::Switch, Fallback::Switch(true), "world axes"),
    Key::new("legend", Range::Switch, Fallback::Switch(true), "force scale, states, cone"),
    Key::new("title", Range::Switch, Fallback::Switch(true), "title and time"),
    Key::new("names", Range::Switch, Fallback::Switch(true), "names at the bodies"),
];
