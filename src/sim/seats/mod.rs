//! Seats and what stands on them: what remains at each corner, what comes off, which supports are lost, what lifts.

pub mod lost_supports;
mod seat;
pub mod seat_on;
pub(super) mod uplift;
pub mod verdict;

pub use seat::{Departure, Ledge, OrbitPoint, Seat, SeatCorner, corners_at, of_girder, orbit, seated_share};
pub(in crate::sim) use seat::{length, remaining};
