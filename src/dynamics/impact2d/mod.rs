//! The 2D rigid-body impact model (paper section 3, `docs/physics.md#impact-model`).
//!
//! Girders and their faces are rigid: a hit is an impulse, a lasting contact a constraint. Planar scenes; a wall at any end,
//! and girder against girder by the same impulses with the levers of both bodies. Free flight, rest and a face that slides
//! along a wall are closed forms; hits are located to round-off.
//!
//! - [`impulse`]: impulses of a corner (26)–(43), of a face (44)–(48), and of several contacts at once.
//! - [`lasting`]: constrained motion of states c–f (7)–(25), contact modes (Tables 4–7), integration between changes.
//! - [`closing`]: the next impact of a pair.
//! - [`delassus`]: velocities at a contact point per unit impulse; [`instant`]: contacts and impulses of one instant;
//!   [`after_impact`]: contacts and trajectories from there on.
//! - [`state`]: the six states and the rows of Tables 4–10; [`record`]: what a run logs; [`engine`]: the event loop.
//!
//! Left out: the spread of a contact force along an elastic face, waves, and the duration of a hit.

mod after_impact;
mod closing;
pub mod delassus;
mod dense;
pub mod engine;
pub mod impulse;
mod instant;
pub mod lasting;
pub mod record;
pub mod state;
mod tracks;

/// A list of what an instant concerns: mostly one girder or two, and as many points.
pub type Few<T> = smallvec::SmallVec<[T; 2]>;

pub use record::{Hit, Record, Stay, Transition};
pub use state::{Row, State};
