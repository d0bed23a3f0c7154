//! The contact-friction model: states and forces of closed contacts, equations of motion of islands, location of
//! events.

pub(in crate::dynamics) mod active_contact;
pub(in crate::dynamics) mod active_link;
pub(in crate::dynamics) mod carried_overlap;
pub(in crate::dynamics) mod collinear_island;
pub(crate) mod constants;
pub mod contact_force;
pub(in crate::dynamics) mod contact_rates;
pub mod contact_state;
pub(in crate::dynamics) mod coupled_system;
pub(in crate::dynamics) mod due;
pub(in crate::dynamics) mod equations_of_motion;
pub(in crate::dynamics) mod event_location;
pub(in crate::dynamics) mod general_island;
mod implicit_cost;
pub(in crate::dynamics) mod island;
pub(in crate::dynamics) mod island_kind;
pub(in crate::dynamics) mod island_poses;
pub(in crate::dynamics) mod island_retake;
pub(in crate::dynamics) mod link_events;
pub(in crate::dynamics) mod planned_step;
pub(in crate::dynamics) mod sliding;
pub(in crate::dynamics) mod step_budget;
pub(in crate::dynamics) mod stepper;

#[cfg(test)]
pub(in crate::dynamics) mod example;
pub(in crate::dynamics) mod workspace;
