//! Hits over a run: touches of single contacts, the forces between two bodies, and the largest of both.

mod largest;
mod resultants;
pub(super) mod touches;
pub mod view;

pub use largest::ContactTimes;
