//! Bodies, bearings, free flight, integrators and the event loop.

pub mod closing;
pub mod contact_model;
pub mod event_loop;
pub mod free_flight;
pub mod impact2d;
pub mod integrator;
pub mod locate;
pub mod model;
pub mod penalty3d;
pub mod record;
pub mod run;
pub mod trajectory;
mod world;

pub use model::body::Body;
pub use model::compiled_model::Model;
pub use model::pair::{ContactSite, Pair};
