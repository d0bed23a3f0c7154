//! A run of a scene: advance it, then ask the answer anything.
//!
//! [`Session`] computes, [`History`] answers: motion, contacts, events and energy at any time, from the paths and states
//! that the run left, never from samples. History's own questions are about time and the motion of bodies; all others are asked of its views:
//! [`Contacts`] (forces at any time), [`Hits`] (touches and forces between bodies over the run), [`Energy`], [`Connections`] (bearings,
//! devices, soil, piers), [`Seats`] and [`Sections`] (of elastic girders). A [`Comparison`] tells how far two runs are apart.

mod comparison;
pub mod connections;
pub mod contacts;
mod digest;
pub mod energy;
pub mod error_estimate;
mod history;
pub mod hits;
mod impact;
mod looks;
pub mod moving_ground;
mod overlap;
mod peaks;
pub mod quantity;
pub mod readings;
mod recent_steps;
mod report;
pub mod seats;
pub mod sections;
mod session;
pub mod spectra;
mod summary;
mod trajectories;
mod unit;

pub use comparison::Comparison;
pub use connections::backfill::{BackfillReading, SoilNow, WallNow};
pub use connections::bearing_readings::BearingsReading;
pub use connections::device_readings::DeviceReading;
pub use connections::hysteresis::Loop;
pub use connections::link::LinkNow;
pub use connections::piers::{BaseReading, PierNow, PierReading};
pub use connections::view::Connections;
pub use contacts::validity::{Dropped, TooDeep};
pub use contacts::view::Contacts;
pub use energy::balance::Balance;
pub use energy::entries::Ledger;
pub use energy::view::Energy;
pub use error_estimate::ErrorEstimate;
pub use history::History;
pub use hits::ContactTimes;
pub use hits::view::Hits;
pub use overlap::{Unjoined, unjoined};
pub use quantity::Quantity;
pub use report::{
    Cause, ContactNow, ContactState, Event, EventKind, GirderExtreme, LargestMotion, Motion, Overlap, Pounding,
    PoundingHit, RunDifference, SolidId, Stop, Touch, Uplift, Upright,
};
pub use seats::lost_supports::{Carrying, LostSupport};
pub use seats::view::Seats;
pub use sections::degree_check::DegreeCheck;
pub use sections::field::SectionField;
pub use sections::quantity::OfSection;
pub use sections::readings::{ElasticHit, FlexibleReading, NEGLIGIBLE, Neglected};
pub use sections::view::Sections;
pub use session::{Reached, Session};
pub use summary::Summary;
pub use unit::Unit;

pub use crate::dynamics::impact2d::{GirderState, Hit, ImpactRecord, LastingInterval, Row, Transition};
