//! Natural frequency and damping ratio of a girder on its bearings from a measured displacement (paper, section 2(3)b).
//!
//! The girder is an oscillator, `ẍ + 2hω ẋ + ω² x = −a(t)`, `ω = 2πf`, that is shaken by a known ground motion or by none, or
//! whose amplitude was measured at several frequencies of a steady sine. Starting values come from the resonance
//! ([`resonance`]), the values from least squares ([`least_squares`]), their intervals from the covariance of the residuals,
//! which need not be independent ([`noise`]).

pub mod columns;
pub mod fit;
pub mod least_squares;
pub mod noise;
pub mod resonance;

pub use columns::{Columns, Measured, Quantity};
pub use fit::{Estimate, Given, History, Identified, NotIdentified, SteadyResponse, from_history, from_response};
