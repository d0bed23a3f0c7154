//! The 2D rigid-body impact model (paper section 3, physics section 5).
//!
//! Girders are rigid and so are their faces: a hit is an impulse, lasting contact a constraint. Planar scenes; a wall at
//! any end, and girder against girder by the same impulses with both bodies' levers. Flights, rest and
//! a face that slides along a wall are closed forms, hits are found to rounding.
//!
//! - [`hit`]: the two impulses of a corner (26)–(43); [`flush`]: of a whole face (44)–(48), or at both of its ends.
//! - [`reaction`]: the constrained motion of states c–f (7)–(25); [`decide`]: who stays in contact (Tables 4–7).
//! - [`state`]: the six states and the rows of Tables 4–10; [`record`]: what a run logs.
//!
//! Left out: the spread of a push along an elastic face, waves, and everything that takes time in a hit.

mod agree;
pub mod blow;
pub mod decide;
mod dense;
pub mod engine;
pub mod flush;
mod grip;
pub mod hit;
mod leap;
mod meet;
pub mod point;
pub mod reaction;
pub mod record;
mod search;
mod settle;
mod side;
pub mod state;
mod track;
mod wedge;

/// A list of what an instant concerns: mostly one girder or two, and as many points.
pub type Few<T> = smallvec::SmallVec<[T; 2]>;

pub use record::{Hit, Record, Stay, Transition};
pub use state::{Row, State};
