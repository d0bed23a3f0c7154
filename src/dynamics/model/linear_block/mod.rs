//! Bodies in plan that linear bearings join for ever, girders and the piers that they stand on, as one linear block: their free
//! motion in closed form (`docs/physics.md#free-motion-of-bodies-that-bearings-join`).

mod block;
mod bounds;
mod joint;
mod member;
pub mod part;
mod reach;
mod works;

pub use block::LinearBlock;
pub use joint::Joint;
pub use member::BlockMember;
