//! When an open gap closes next: in flight, inside a planned step, and for a pair that moves along one axis.

pub(in crate::dynamics) mod collinear_pair;
pub(in crate::dynamics) mod constants;
pub(in crate::dynamics) mod flight_view;
pub(in crate::dynamics) mod found;
pub(in crate::dynamics) mod gap_curvature;
pub(in crate::dynamics) mod in_flight;
pub(in crate::dynamics) mod in_steps;
pub(in crate::dynamics) mod link_closing;
pub mod next_closing;
