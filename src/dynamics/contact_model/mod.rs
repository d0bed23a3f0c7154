//! The contact model: bodies fly, touch, stick, slip and part; one implementer of the event loop.

pub(in crate::dynamics) mod at_instant;
pub(in crate::dynamics) mod contact_law;
pub(in crate::dynamics) mod event_forecast;
pub(in crate::dynamics) mod handlers;
pub(in crate::dynamics) mod islands;
pub(in crate::dynamics) mod link_handlers;
pub mod run;
pub(in crate::dynamics) mod step_store;
pub(in crate::dynamics) mod transitions;
