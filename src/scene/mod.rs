//! What a user places: plain data, the units in the names of the file's keys.
//!
//! A [`Scene`] is what the file says and nothing more: defaults are filled in when it is read, every number is SI (or
//! carries its unit in its name), and nothing here moves. Sizes and places are as written; [`placed`] turns them into
//! corners and faces, [`facing`] finds who can touch whom.

mod abutment;
mod bearing;
mod contact;
mod girder;
mod limits;
mod model;
mod motion;
mod settings;

pub mod domain;
pub mod edit;
pub mod facing;
pub mod format;
pub mod keys;
pub mod overrides;
pub mod placed;
pub mod presets;
pub mod validate;

pub use abutment::Abutment;
pub use bearing::{Bearing, Bearings, PerDirection, ResolvedBearing, SharedBearings};
pub use contact::{ContactNumber, ContactSettings, FrictionLaw, PairSettings, Sharing, Tension};
pub use girder::{Direction, Girder, Initial, Push, Seat};
pub use limits::Limits;
pub use model::{Flush, ImpactSettings, ModelKind, ModelSettings};
pub use motion::{Motion, RecordMotion, SineMotion};
pub use settings::{Layer, Overlays, PlotSettings, SolverMethod, SolverSettings, ViewPreset, ViewSettings};
pub use validate::{SceneError, SceneErrors};

use serde::{Deserialize, Serialize};

/// Standard gravity, as the paper's "g" is read here \[m/s²\].
pub const STANDARD_GRAVITY: f64 = 9.806_65;

keys::words! {
    /// Which directions the bodies of a scene may move in.
    Kind, by default Planar {
        /// x, y and the rotation about the vertical; bearings linear at every rotation (the paper's experiments).
        Planar = "planar",
        /// Six degrees of freedom, gravity, bearings at their true attachment points.
        Spatial = "spatial",
    }
}

/// A scene file: everything that a run, a picture or a table depends on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Version of the file format; 1.
    #[serde(default = "settings::format_version")]
    pub format: u32,
    /// What the scene is called.
    pub name: String,
    /// A line or two on what the scene shows.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub description: String,
    /// Planar or spatial.
    #[serde(default)]
    pub kind: Kind,
    /// How long the ground shakes and the answer reaches \[s\].
    #[serde(rename = "duration_s")]
    pub duration: f64,
    /// Gravity, used by spatial scenes only \[m/s²\].
    #[serde(
        rename = "gravity_m_s2",
        default = "settings::standard_gravity",
        skip_serializing_if = "settings::is_standard_gravity"
    )]
    pub gravity: f64,
    /// What computes it.
    #[serde(default, skip_serializing_if = "settings::is_default")]
    pub model: ModelSettings,
    /// Girders, in the order of the file.
    #[serde(rename = "girder", default)]
    pub girders: Vec<Girder>,
    /// Abutments, in the order of the file.
    #[serde(rename = "abutment", default, skip_serializing_if = "Vec::is_empty")]
    pub abutments: Vec<Abutment>,
    /// Contact numbers and overrides for named pairs.
    #[serde(default)]
    pub contact: ContactSettings,
    /// Numbers of the impact model.
    #[serde(default, skip_serializing_if = "settings::is_default")]
    pub impact: ImpactSettings,
    /// How the ground moves.
    #[serde(default)]
    pub motion: Motion,
    /// How exactly it is to be computed.
    #[serde(default, skip_serializing_if = "settings::is_default")]
    pub solver: SolverSettings,
    /// What must not be passed.
    #[serde(default, skip_serializing_if = "settings::is_default")]
    pub limits: Limits,
    /// How it is first shown.
    #[serde(default, skip_serializing_if = "settings::is_default")]
    pub view: ViewSettings,
}
