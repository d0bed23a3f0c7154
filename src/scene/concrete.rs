//! Concrete, where a scene does not say what something is made of.

/// Density ρ \[kg/m³\].
pub const CONCRETE_DENSITY: f64 = 2500.0;
/// Young's modulus E, uncracked \[Pa\].
pub const CONCRETE_MODULUS: f64 = 30e9;
