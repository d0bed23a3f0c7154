//! Impulses of a hit: at a corner, along a face, and at several contacts one after another or together.

pub mod collision;
pub mod corner;
pub mod face;
pub(in crate::dynamics::impact2d) mod sequential;
pub(in crate::dynamics::impact2d) mod simultaneous;
