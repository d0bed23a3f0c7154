//! Stored trajectories of bodies: flights, polynomials of steps, packed states.

pub mod heading;
pub mod packed_states;
pub mod segment;
pub(in crate::dynamics) mod segment_code;
pub mod step_polynomial;
pub mod stored_path;
