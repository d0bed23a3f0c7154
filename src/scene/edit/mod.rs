//! Changes to a scene as values: each has a method that applies it and returns its inverse.
//!
//! An edit says what to do to a place, never how the mouse or a panel came to it, so handles, arrays and snapping are
//! only new makers of these same values. Whether the scene makes sense afterwards is
//! [`validate`](super::validate)'s business: a user passes through senseless states while editing. What an edit keeps
//! whole is names: removing a girder takes along what refers to it, renaming a body renames the references.

mod apply;
mod kinds;
mod names;
mod undo;

pub use kinds::{Edit, EditError, General};
pub use names::{free_among, free_name, free_name_after};
pub use undo::UndoStack;
