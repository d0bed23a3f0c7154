//! The event loop of both models.
//!
//! A model of contact ([`event_driven::EventDriven`]) enters in the queue the times of its next events; the loop takes the
//! earliest, has the model handle it, and ends the run where the work exceeds its bound.

mod constants;
pub mod effort;
pub mod event_driven;
pub mod event_queue;
pub mod schedule;
pub mod work_bounds;
