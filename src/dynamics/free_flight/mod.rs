//! Free motion between contacts in closed form, and bounds on it.

pub mod body_flight;
pub mod body_motion;
pub(in crate::dynamics) mod constants;
pub mod flight;
mod flight_bounds;
pub mod ground_springs;
pub mod matrix_exponential;
pub mod oscillator;
pub(in crate::dynamics) mod relative_bounds;
pub mod sliding_face;
pub(in crate::dynamics) mod uncoupled_axis;

#[cfg(test)]
mod tests;
