//! The first zero of a function of time: conservative advancement, subdivision and bracketing. No physics.

pub mod advancement;
pub(in crate::dynamics) mod constants;
pub(in crate::dynamics) mod cubic_bound;
pub(in crate::dynamics) mod first_rise;
pub(in crate::dynamics) mod positive_again;
pub mod root;
pub(in crate::dynamics) mod subdivision;
