//! Trajectories of bodies as stored: polynomials of steps, flights, packed states.

pub mod packed_states;
pub mod segment;
pub mod step_polynomial;
pub mod stored_path;
