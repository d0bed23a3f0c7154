//! The workbench: the state of the window and what commands do to it.

pub(in crate::app) mod apply;
pub(in crate::app) mod document;
pub(in crate::app) mod placing;
pub(in crate::app) mod queries;
pub(in crate::app) mod selection;
pub(in crate::app) mod workbench;

pub use workbench::Workbench;
