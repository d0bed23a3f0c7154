//! The event loop: one for both models.
//!
//! A model of contact ([`mechanics::Mechanics`]) enters in the queue when each of its islands and pairs is due; the loop takes
//! the earliest, lets the model handle it, and ends the run where the work exceeds its bound.

pub mod effort;
pub mod event_queue;
pub mod mechanics;
pub mod schedule;
