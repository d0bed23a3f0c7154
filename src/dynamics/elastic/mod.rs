//! A girder as an elastic beam with free ends: sections, modes, flexibility of its ends; pure mathematics, no scene.
//!
//! `docs/physics.md#flexible-girders` has the equations; numbers in brackets there and here are (F1), (F2), ….

pub mod beam;
pub mod degree;
pub mod legendre;
pub mod modes;

pub use beam::Beam;
pub use degree::{Softness, automatic_degree};
pub use modes::Modes;
