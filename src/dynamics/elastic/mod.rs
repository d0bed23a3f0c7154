//! A girder as an elastic beam with free ends: sections, modes, flexibility of its ends; pure mathematics, no scene.
//!
//! `docs/physics.md#flexible-girders` has the equations; numbers in brackets there and here are (F1), (F2), ….

pub mod beam;
pub mod degree;
pub mod fields;
pub mod legendre;
pub mod modes;
pub mod space_beam;
pub mod space_modes;

pub use beam::Beam;
pub use degree::{Softness, automatic_degree};
pub use fields::Fields;
pub use modes::Modes;
pub use space_beam::SpaceBeam;
pub use space_modes::SpaceModes;
