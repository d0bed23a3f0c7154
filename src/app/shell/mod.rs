//! The system's window: events, surface, painting.

mod event_log;
pub(in crate::app) mod painter;
pub(in crate::app) mod surface;
pub(in crate::app) mod textures;
pub(in crate::app) mod window;
