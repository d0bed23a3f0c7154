//! Lasting contact: candidates, contact modes, reactions, and the motion between two changes.

pub(in crate::dynamics::impact2d) mod candidates;
pub mod constrained_motion;
pub(in crate::dynamics::impact2d) mod impact_without_collision;
pub mod indeterminate;
pub(in crate::dynamics::impact2d) mod lasting_contact;
pub mod mode_selection;
pub(in crate::dynamics::impact2d) mod painleve;
mod slide_on_wall;
pub(in crate::dynamics::impact2d) mod switch;
