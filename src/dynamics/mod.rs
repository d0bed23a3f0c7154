//! Motion of bodies: free flight in closed form, contact by integration or by impulses, one event loop.
//!
//! `docs/solver.md` draws how a run is computed. Rooms, each using only rooms listed before it (held by `tests/architecture.rs`):
//!
//! | room | what is in it |
//! |---|---|
//! | [`integrator`] | explicit and implicit methods, dense output, step control; no physics |
//! | [`locate`] | the first zero of a function of time: conservative advancement, subdivision, bracketed root |
//! | [`connection`] | forces between two points: what contacts, bearings and devices have in common; links |
//! | [`devices`] | cables, bumpers, dampers, stoppers, bearings (linear, with hysteresis, sliding, lost), backfill |
//! | [`elastic`] | a girder as a beam: modes, flexibility of its ends; no scene |
//! | [`linear`] | free motion of a linear block of coordinates as a sum of exponentials; no scene |
//! | [`model`] | a scene compiled to constant data: bodies with their degrees of freedom, bearings, facing pairs, contact sites, rate bounds |
//! | [`free_flight`] | closed-form free motion and bounds on it |
//! | [`trajectory`] | trajectories as stored |
//! | [`penalty3d`] | closed contacts, equations of motion of bodies that touch, error scale, event location |
//! | [`record`] | events, contact states over time, steps to be computed again |
//! | [`event_loop`] | queue, progress of a run, the loop over a model of contact |
//! | `world` | bodies, pairs, contacts and islands of a group at the present time |
//! | [`closing`] | when an open gap closes next |
//! | [`contact_model`] | what an event does under the contact model |
//! | [`impact2d`] | the impact model |
//! | [`run`] | a run of a group under either model |

pub mod closing;
pub mod connection;
pub mod contact_model;
pub mod devices;
pub mod elastic;
pub mod event_loop;
pub mod free_flight;
pub mod impact2d;
pub mod integrator;
pub mod linear;
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
