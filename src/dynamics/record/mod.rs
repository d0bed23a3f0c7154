//! What a run leaves besides trajectories: events, contact states over time, steps to be computed again.

pub mod contact_log;
pub mod event;
pub mod link_log;
pub mod recomputed_steps;
