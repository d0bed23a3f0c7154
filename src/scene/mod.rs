//! Scene as the user describes it: plain data, with units in the names of the file's keys.
//!
//! A [`Scene`] is what the file says and nothing more: defaults are filled in when it is read, every number is SI (or
//! carries its unit in its name), and nothing here moves. Sizes and places are as written; [`placed`] turns them into
//! corners and faces, [`facing`] finds who can touch whom.

mod abutment;
mod angle;
mod assumed;
mod backfill;
mod bearing;
mod bearing_law;
mod codes;
mod concrete;
mod contact;
mod deck_bearings;
mod elastic;
mod girder;
mod ground;
mod kind;
mod limits;
mod model;
mod motion;
mod motions;
mod moving_supports;
mod path;
mod pier;
mod processing;
mod record;
mod resolved;
mod resolved_elastic;
mod resolved_pier;
mod settings;
mod soil;
mod supports;
mod sweep;
mod synthetic;
mod top;
mod two_or_three;
mod unused;
mod wave;
mod whole;

pub mod device;
pub mod difference;
pub mod domain;
pub mod edit;
pub mod facing;
pub mod format;
pub mod keys;
pub mod overrides;
pub mod placed;
pub mod presets;
pub mod seating;
pub mod shown;
pub mod validate;

pub use crate::motion::format::Unit as RecordUnit;
pub use abutment::Abutment;
pub use assumed::is_assumed;
pub use backfill::{Backfill, BackfillLaw};
pub use bearing::{Bearing, Bearings, PerDirection, SharedBearings};
pub use bearing_law::{BearingSlide, BearingYield};
pub use codes::{Codes, EuropeanGround, JapaneseGround, Support};
pub use concrete::{CONCRETE_DENSITY, CONCRETE_MODULUS};
pub use contact::{
    Between, Calibration, ContactNumber, ContactSettings, FrictionLaw, NormalName, PairSettings, Sharing, Tension,
};
pub use deck_bearings::{BearingKind, DeckBearings, Loop};
pub use device::{Bumper, Damper, Device, DeviceId, DeviceKind, Restrainer, Sides, Stopper};
pub use elastic::{Degree, Elastic, Rayleigh, ShearFactor};
pub use girder::{AfterUnseating, Direction, Girder, Initial, Push, Seat};
pub use ground::{GroundId, NamedGround};
pub use kind::Kind;
pub use limits::Limits;
pub use model::{Flush, ImpactSettings, ModelKind, ModelSettings};
pub use motion::{Motion, STANDARD_GRAVITY, SineMotion};
pub use moving_supports::MovingSupports;
pub use pier::{ColumnTop, Pier};
pub use processing::{Baseline, Processing};
pub use record::{Combined, Component, Heading, RecordMotion};
pub use resolved::{ResolvedBearing, Setting};
pub use resolved_elastic::ResolvedElastic;
pub use resolved_pier::{BaseYield, ResolvedPier};
pub use settings::{
    FINEST_TOLERANCE, Layer, Overlays, PlotSettings, PlotShows, SolverMethod, SolverSettings, ViewPreset, ViewSettings,
};
pub use soil::{FAILING_PUSH, ResolvedBackfill};
pub use supports::StandsOn;
pub use sweep::{SweepMotion, SweepRate};
pub use synthetic::SyntheticMotion;
pub use top::Scene;
pub use validate::{SceneError, SceneErrors};
pub use wave::Wave;
