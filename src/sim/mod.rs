//! A run of a scene: advance it, then ask the answer anything.
//!
//! [`Session`] computes, [`History`] answers: motion, contacts, events and energy at any time, from the paths and states
//! that the run left, never from samples.

mod acting;
mod backfill;
mod balance;
mod bearing_readings;
mod books;
mod contact_account;
mod degree_check;
mod device_readings;
mod digest;
mod energy_quantity;
pub mod error_estimate;
mod flexible;
mod history;
mod impact;
mod law_sense;
mod ledger;
mod ledger_steps;
pub mod links;
pub mod loops;
pub mod moving_ground;
pub mod on_bearings;
mod overlap;
mod peaks;
mod piers;
mod quadrature;
pub mod quantity;
pub mod readings;
mod recent_steps;
mod report;
mod resultants;
pub mod seat_on;
pub mod seats;
pub mod section_field;
mod section_peaks;
mod section_quantity;
mod session;
pub mod spectra;
mod summary;
mod supports;
mod touches;
mod trajectories;
mod unit;
mod uplift;
pub mod verdict;

pub use backfill::{BackfillReading, SoilNow, WallNow};
pub use balance::Balance;
pub use bearing_readings::BearingsReading;
pub use degree_check::DegreeCheck;
pub use device_readings::DeviceReading;
pub use error_estimate::ErrorEstimate;
pub use flexible::{ElasticHit, FlexibleReading, NEGLIGIBLE, Neglected};
pub use history::History;
pub use law_sense::{Dropped, TooDeep};
pub use links::LinkNow;
pub use loops::Loop;
pub use overlap::{Unjoined, unjoined};
pub use piers::{BaseReading, PierNow, PierReading};
pub use quantity::Quantity;
pub use report::{
    Cause, ContactNow, ContactState, Event, EventKind, Ledger, Motion, Overlap, Pounding, PoundingHit, RunDifference,
    SolidId, Stop, Touch, Uplift, Upright,
};
pub use section_field::SectionField;
pub use section_quantity::OfSection;
pub use session::{Reached, Session};
pub use summary::Summary;
pub use supports::{Carrying, LostSupport};
pub use unit::Unit;

pub use crate::dynamics::impact2d::{Hit, LastingInterval, Record, Row, State, Transition};
