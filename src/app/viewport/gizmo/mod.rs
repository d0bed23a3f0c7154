//! Handles in the 3D view: move, turn, length, width, skew, gaps, a wall's place and width.
//!
//! Handles are widgets: the mouse drags them, Tab reaches them, the arrow keys pull them, a screen reader names them.

mod handles;
mod held;
mod paint;
mod pull;
mod show;
mod snap;
mod typed;

pub(in crate::app) use held::{Held, Manner, handle_id, pull, snapped};
pub(in crate::app) use pull::Pulled;
pub(in crate::app) use show::{places, say, show};
pub(in crate::app) use typed::{Typing, begins_number, read as read_typed};
