//! Search for the next closing of an open gap, and for the beginning or the phase end of a device's force: in flight, within planned
//! steps, and for a pair on one axis.

pub(in crate::dynamics) mod collinear_pair;
pub(in crate::dynamics) mod constants;
pub(in crate::dynamics) mod edge_in_step;
pub(in crate::dynamics) mod flight_view;
pub(in crate::dynamics) mod found;
pub(in crate::dynamics) mod gap_curvature;
pub(in crate::dynamics) mod in_flight;
pub(in crate::dynamics) mod in_steps;
pub(in crate::dynamics) mod link_closing;
mod link_motion;
pub mod next_closing;
mod phase_end;
mod phase_end_in_plan;
pub(in crate::dynamics) mod shared;
pub(in crate::dynamics) mod step_samples;
