//! Lasting contact: its reactions, the choice of contact modes, and the motion between two changes.

pub mod constrained_motion;
pub(in crate::dynamics::impact2d) mod lasting_contact;
pub mod mode_selection;
mod painleve;
