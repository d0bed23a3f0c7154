//! The first zero of a function of time. No physics.
//!
//! - [`advancement`]: with a bound on the second derivative from an instant on, with that on the third by `cubic_bound`.
//! - `subdivision`: with a bound on the second derivative between two samples.
//! - `first_rise`: by samples alone.
//! - [`root`]: in a bracket.
//! - `horizon`: how far ahead one search looks.
//! - `sample_times`: the times at which a function is sampled.

pub mod advancement;
pub(in crate::dynamics) mod constants;
pub(in crate::dynamics) mod cubic_bound;
pub(in crate::dynamics) mod first_rise;
pub(in crate::dynamics) mod horizon;
pub(in crate::dynamics) mod positive_again;
pub mod root;
pub(in crate::dynamics) mod sample_times;
pub(in crate::dynamics) mod subdivision;
