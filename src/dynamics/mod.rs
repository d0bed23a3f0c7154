//! Bodies, bearings, flight, integrators and the event loop.
//!
//! [`Model`] is a scene compiled for computing; [`engine::Engine`] runs one group of its bodies and leaves exact paths
//! behind. A girder that touches nothing flies in closed form ([`flight`]); girders that touch are integrated together
//! (`island`) by [`dop853`], with every change of a contact's state found as a root (`watch`, `predict`).

mod abreast;
mod agenda;
mod allowance;
mod approach;
pub(crate) mod base;
pub mod bearing;
pub mod body_state;
pub mod bound;
pub mod contact_log;
pub mod coupled;
mod declare;
mod dof;
pub mod dop853;
mod dop853_coefficients;
pub mod engine;
pub mod event;
mod fastest;
mod field;
pub mod flight;
mod forming;
mod happening;
pub mod impact2d;
mod island;
mod keeping;
mod line;
mod lu;
mod model;
pub mod oscillator;
pub mod packed;
pub mod path;
pub mod penalty3d;
pub mod piece;
mod predict;
mod prowl;
mod radau;
mod radau_coefficients;
mod relative;
pub mod replay;
pub mod search;
mod shifted;
mod slides;
mod soon;
mod stepper;
mod swing;
pub mod track;
mod transition;
mod watch;
mod whereabouts;
mod within;

pub use model::{Body, ContactSite, Model, Pair};
