//! The system's window, or the page's canvas: events, surface, painting.

mod differing;
mod event_log;
#[cfg(target_arch = "wasm32")]
#[path = "outside/page.rs"]
pub(in crate::app) mod outside;
#[cfg(not(target_arch = "wasm32"))]
#[path = "outside/desktop.rs"]
mod outside;
pub(in crate::app) mod painter;
pub(in crate::app) mod redraw;
pub(in crate::app) mod surface;
pub(in crate::app) mod textures;
pub(in crate::app) mod window;
