//! Free motion of a linear block of coordinates in closed form: `ξ̈ + C ξ̇ + K ξ = g + b·a_g(t)`, unit masses; pure mathematics, no scene.
//!
//! The block is decomposed once. A flight is then a sum of exponentials and of a motion that the ground and a constant load drive,
//! whatever its length: nothing is stepped.

mod driven;
mod exponentials;
mod flight;
mod spectrum;
mod works;

#[cfg(test)]
mod tests;

pub use driven::Driven;
pub use flight::{FlightParameters, LinearMotion, ModalCoordinates};
pub use spectrum::Spectrum;
pub use works::{LineOrSine, PowerForm};

/// A complex number.
pub type Complex = num_complex::Complex<f64>;
