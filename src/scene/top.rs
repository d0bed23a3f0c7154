//! The whole scene, and the keys at the top of its file.

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Key, Range};
use super::motion::STANDARD_GRAVITY;
use super::{
    Abutment, Bumper, Codes, ContactSettings, Damper, Girder, ImpactSettings, Kind, Limits, ModelSettings, Motion,
    NamedGround, Pier, Restrainer, SolverSettings, Stopper, ViewSettings, Wave,
};

/// The version of the format that is read and written.
pub const VERSION: u32 = 1;

/// A scene file: everything that a run, a picture or a table depends on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Version of the file format; 1.
    #[serde(default = "format_version")]
    pub format: u32,
    /// Name of the scene.
    pub name: String,
    /// A line or two on what the scene shows.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub description: String,
    /// Planar or spatial.
    #[serde(default)]
    pub kind: Kind,
    /// Duration of the ground motion and of the answer \[s\].
    #[serde(rename = "duration_s")]
    pub duration: f64,
    /// Gravity, used by spatial scenes only \[m/s²\].
    #[serde(rename = "gravity_m_s2", default = "standard_gravity", skip_serializing_if = "is_standard_gravity")]
    pub gravity: f64,
    /// Values that were not given, as paths of `--set`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub assumed: Vec<String>,
    /// Models that compute it.
    #[serde(default, skip_serializing_if = "is_default")]
    pub model: ModelSettings,
    /// Girders, in the order of the file.
    #[serde(rename = "girder", default)]
    pub girders: Vec<Girder>,
    /// Abutments, in the order of the file.
    #[serde(rename = "abutment", default, skip_serializing_if = "Vec::is_empty")]
    pub abutments: Vec<Abutment>,
    /// Piers, in the order of the file.
    #[serde(rename = "pier", default, skip_serializing_if = "Vec::is_empty")]
    pub piers: Vec<Pier>,
    /// Restrainer cables, in the order of the file.
    #[serde(rename = "restrainer", default, skip_serializing_if = "Vec::is_empty")]
    pub restrainers: Vec<Restrainer>,
    /// Bumpers, in the order of the file.
    #[serde(rename = "bumper", default, skip_serializing_if = "Vec::is_empty")]
    pub bumpers: Vec<Bumper>,
    /// Viscous dampers, in the order of the file.
    #[serde(rename = "damper", default, skip_serializing_if = "Vec::is_empty")]
    pub dampers: Vec<Damper>,
    /// Stoppers, in the order of the file.
    #[serde(rename = "stopper", default, skip_serializing_if = "Vec::is_empty")]
    pub stoppers: Vec<Stopper>,
    /// Contact numbers and overrides for named pairs.
    #[serde(default)]
    pub contact: ContactSettings,
    /// Numbers of the impact model.
    #[serde(default, skip_serializing_if = "is_default")]
    pub impact: ImpactSettings,
    /// Motion of the ground.
    #[serde(default)]
    pub motion: Motion,
    /// Motions that supports have of their own, in the order of the file.
    #[serde(rename = "ground", default, skip_serializing_if = "Vec::is_empty")]
    pub grounds: Vec<NamedGround>,
    /// Propagation of that motion; without it the ground moves as one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wave: Option<Wave>,
    /// Settings of the solver.
    #[serde(default, skip_serializing_if = "is_default")]
    pub solver: SolverSettings,
    /// Limits that a run is checked against.
    #[serde(default, skip_serializing_if = "is_default")]
    pub limits: Limits,
    /// Inputs of design codes for seat lengths beside the scene.
    #[serde(default, skip_serializing_if = "is_default")]
    pub codes: Codes,
    /// First view.
    #[serde(default, skip_serializing_if = "is_default")]
    pub view: ViewSettings,
}

impl Scene {
    /// A scene with nothing in it, over still ground, of so many seconds.
    pub fn empty(name: impl Into<String>, duration: f64) -> Self {
        Self {
            format: VERSION,
            name: name.into(),
            description: String::new(),
            kind: Kind::default(),
            duration,
            gravity: STANDARD_GRAVITY,
            assumed: Vec::new(),
            model: ModelSettings::default(),
            girders: Vec::new(),
            abutments: Vec::new(),
            piers: Vec::new(),
            restrainers: Vec::new(),
            bumpers: Vec::new(),
            dampers: Vec::new(),
            stoppers: Vec::new(),
            contact: ContactSettings::default(),
            impact: ImpactSettings::default(),
            motion: Motion::default(),
            grounds: Vec::new(),
            wave: None,
            solver: SolverSettings::default(),
            limits: Limits::default(),
            codes: Codes::default(),
            view: ViewSettings::default(),
        }
    }
}

fn format_version() -> u32 {
    VERSION
}

fn standard_gravity() -> f64 {
    STANDARD_GRAVITY
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn is_standard_gravity(g: &f64) -> bool {
    *g == STANDARD_GRAVITY
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

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
    )
    .labelled("field-duration")
    .slid([0.1, 60.0]),
    Key::new(
        "gravity_m_s2",
        Range::NotNegative,
        Fallback::Number(STANDARD_GRAVITY),
        "gravity in a spatial scene; in a planar one it loads sliders and the base of a backwall, m/s²",
    )
    .labelled("field-gravity"),
    Key::new(
        "assumed",
        Range::Free,
        Fallback::Words("none"),
        "values that were not given: paths of --set, of a table all its numbers; check and the report list them, the window marks them",
    ),
    Key::new("girder", Range::Like("one or more"), Fallback::Needed("must be given"), "[[girder]], see below"),
    Key::new("abutment", Range::Free, Fallback::Words("none"), "[[abutment]], see below"),
    Key::new("pier", Range::Free, Fallback::Words("none"), "[[pier]], see below"),
    Key::new("restrainer", Range::Free, Fallback::Words("none"), "[[restrainer]], see below"),
    Key::new("bumper", Range::Free, Fallback::Words("none"), "[[bumper]], see below"),
    Key::new("damper", Range::Free, Fallback::Words("none"), "[[damper]], see below"),
    Key::new("stopper", Range::Free, Fallback::Words("none"), "[[stopper]], see below"),
    Key::new("model", Range::Free, Fallback::Words("as below"), "[model]"),
    Key::new("contact", Range::Free, Fallback::Words("as below"), "[contact] and [[contact.pair]]"),
    Key::new("impact", Range::Free, Fallback::Words("as below"), "[impact]"),
    Key::new("motion", Range::Free, Fallback::Words("still ground"), "[motion]"),
    Key::new("ground", Range::Free, Fallback::Words("all stand on that of [motion]"), "[[ground]], see below"),
    Key::new("wave", Range::Free, Fallback::Words("the ground moves as one"), "[wave]"),
    Key::new("solver", Range::Free, Fallback::Words("as below"), "[solver]"),
    Key::new("limits", Range::Free, Fallback::Words("none"), "[limits]"),
    Key::new("codes", Range::Free, Fallback::Words("as below"), "[codes]"),
    Key::new("view", Range::Free, Fallback::Words("as below"), "[view]"),
];
