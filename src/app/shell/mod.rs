//! The system's window, or the page's canvas: events, surface, painting.

pub(in crate::app) mod app_error;
mod between;
mod differing;
mod event_log;
#[cfg(target_arch = "wasm32")]
#[path = "outside/page.rs"]
pub(in crate::app) mod outside;
#[cfg(not(target_arch = "wasm32"))]
#[path = "outside/desktop.rs"]
mod outside;
pub(in crate::app) mod painter;
#[cfg(not(target_os = "linux"))]
#[path = "pixels/elsewhere.rs"]
mod pixels;
#[cfg(target_os = "linux")]
#[path = "pixels/x11.rs"]
mod pixels;
mod reading;
pub(in crate::app) mod redraw;
pub(in crate::app) mod surface;
pub(in crate::app) mod textures;
pub(in crate::app) mod window;
