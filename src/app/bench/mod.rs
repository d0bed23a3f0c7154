//! The workbench: the parts of the window's state put together, and commands that concern several of them.

mod apply;
mod folds;
mod linked;
mod opening;
mod window_state;
mod workbench;

pub(in crate::app) use apply::dress_as_chosen;
pub(in crate::app) use folds::Folded;
pub(in crate::app) use window_state::{Next, WindowState};
pub use workbench::Workbench;
