//! Shapes and where they stand: girder prisms, face polygons, and the one door to parry.
//!
//! This room knows lengths and vectors only, neither scenes nor bodies in motion, so every other room may ask it.

pub mod face;
pub mod prism;
pub mod shape;

pub use face::{Face, FaceError};
pub use prism::{End, Prism};
