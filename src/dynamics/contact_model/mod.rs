//! The contact model (`docs/physics.md#contact-events`) as an implementer of the event loop: free flight, closing,
//! stick, slip and opening.

pub(in crate::dynamics) mod closing_search;
mod constants;
pub(in crate::dynamics) mod contact_closing;
pub(in crate::dynamics) mod contact_law;
pub(in crate::dynamics) mod contact_states;
pub(in crate::dynamics) mod event_forecast;
pub(in crate::dynamics) mod event_poses;
pub(in crate::dynamics) mod event_source;
pub(in crate::dynamics) mod event_state;
#[cfg(test)]
mod example;
pub(in crate::dynamics) mod handlers;
pub(in crate::dynamics) mod islands;
pub(in crate::dynamics) mod least_overlap;
pub(in crate::dynamics) mod link_transitions;
pub mod run;
pub(in crate::dynamics) mod step_planning;
pub(in crate::dynamics) mod step_store;
pub(in crate::dynamics) mod transitions;
mod vertices;
