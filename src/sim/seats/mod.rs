//! Seats and what stands on them: what remains at each corner, what comes off, which supports are lost, what lifts.

pub mod lost_supports;
mod seat;
pub mod seat_on;
pub(super) mod uplift;
pub mod verdict;
pub mod view;

pub use seat::{Departure, Ledge, OrbitPoint, Seat, SeatCorner, seated_share};
