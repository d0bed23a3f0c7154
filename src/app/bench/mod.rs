//! The workbench: the parts of the window's state put together, and what commands do to them.

mod apply;
mod files;
mod queries;
mod window_state;
mod workbench;

pub(in crate::app) use window_state::Closing;
pub use workbench::Workbench;
