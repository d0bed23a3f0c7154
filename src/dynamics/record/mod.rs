//! Record of a run besides trajectories: events, contact states and device phases over time, steps that are
//! recomputed when read.

pub mod contact_log;
pub mod event;
pub mod link_log;
pub mod recomputed_steps;
