//! Devices between two bodies, or a body and the ground: a law of force with its phases, one file each
//! (`docs/physics.md#devices`).
//!
//! A device has the motion of its first point relative to its second ([`Separation`](crate::dynamics::connection::Separation)) as input and
//! the force on the first as output; a [`Link`](crate::dynamics::connection::Link) places it between two points of a model.

mod backfill;
mod bumper;
mod damper;
mod drop;
mod from_scene;
mod hysteretic_bearing;
mod line;
mod linear_bearing;
mod maxwell_damper;
mod restrainer;
mod slider;
mod stopper;
mod support;

pub use backfill::{Backfill, Envelope};
pub use bumper::Bumper;
pub use damper::ViscousDamper;
pub use drop::DropWatch;
pub use from_scene::{PlacedLaw, laws};
pub use hysteretic_bearing::{ElastoPlastic, Hysteresis};
pub use linear_bearing::LinearBearing;
pub use maxwell_damper::MaxwellDamper;
pub use restrainer::{Restrainer, Yielding};
pub use slider::Slider;
pub use stopper::{Failure, Stopper};
pub use support::Support;
