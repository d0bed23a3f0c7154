//! The first zero of a function of time: conservative advancement and bracketing. No physics.

pub mod advancement;
pub(in crate::dynamics) mod first_rise;
