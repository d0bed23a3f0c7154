//! The 2D rigid-body impact model (paper section 3, `docs/physics.md#impact-model`).
//!
//! Girders and their faces are rigid: a hit is an impulse, a lasting contact a constraint. Planar scenes; a wall at any end,
//! and girder against girder by the same impulses with the levers of both bodies. Free flight, rest and a face that slides
//! along a wall are closed forms; hits are located to round-off.
//!
//! - [`delassus`]: velocities at a contact point per unit impulse; [`kinematics`]: poses and free accelerations.
//! - [`impulse`]: impulses of a corner (26)–(43), of a face (44)–(48), and of several contacts at one instant.
//! - [`lasting`]: constrained motion of states c–f (7)–(25), contact modes (Tables 4–7), integration between changes.
//! - `closing`: the next impact of a pair.
//! - `instant`: bodies and contacts of one instant; `after_impact`: modes and trajectories from there on.
//! - [`state`], [`tables`]: the six states and the rows of Tables 4–10; [`record`]: the log of a run.
//! - [`run`]: the run of a group with its queue and log; `handlers`: what an event does; `event_source`: what is in the queue; `world`: present state;
//!   `tracks`: data of bodies and pairs.
//! - `constants`: every tolerance and count.
//!
//! Left out: the spread of a contact force along an elastic face, waves, and the duration of a hit.

mod after_impact;
mod closing;
mod constants;
pub mod delassus;
mod event_source;
#[cfg(test)]
mod example;
mod handlers;
pub mod impulse;
mod instant;
pub mod kinematics;
pub mod lasting;
mod projection;
pub mod record;
pub mod run;
pub mod state;
pub mod tables;
mod tracks;
mod world;

pub use record::{Hit, ImpactRecord, LastingInterval, Transition};
pub use state::GirderState;
pub use tables::Row;

/// A list that holds two entries without allocation: an instant mostly concerns one girder or two, and as many points.
pub type InlineVec<T> = smallvec::SmallVec<[T; 2]>;
