//! Shapes and where they stand: girder prisms, face polygons, who is near whom, and the only doors to parry.
//!
//! This room has lengths and vectors only, neither scenes nor bodies in motion, so every other room may use it.

pub mod broad;
pub mod face;
pub mod prism;
pub mod rectangle;
pub mod shape;

pub use face::{Face, FaceError};
pub use prism::{End, Prism};
