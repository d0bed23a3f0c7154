//! The event loop of the contact model: queue, handlers, transitions of contact states, islands.

pub mod contact_engine;
pub(in crate::dynamics) mod event_queue;
pub(in crate::dynamics) mod handlers;
pub(in crate::dynamics) mod rebuild_islands;
pub(in crate::dynamics) mod storage_policy;
pub(in crate::dynamics) mod transitions;
pub(in crate::dynamics) mod world;
