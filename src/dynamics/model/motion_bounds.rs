//! Upper bounds of a body's motion over an interval of time, from which conservative advancement takes its step.

/// Bounds on a motion over `[t, t + window]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionBounds {
    /// How long they hold \[s\].
    pub window: f64,
    /// Displacement of G \[m\].
    pub reach: f64,
    /// |θ| \[rad\].
    pub turn: f64,
    /// Speed of G \[m/s\].
    pub speed: f64,
    /// |θ̇| \[rad/s\].
    pub spin: f64,
    /// Acceleration of G \[m/s²\].
    pub acceleration: f64,
    /// |θ̈| \[rad/s²\].
    pub spin_rate: f64,
}

impl MotionBounds {
    /// Of what does not move.
    pub fn still(window: f64) -> Self {
        Self { window, reach: 0.0, turn: 0.0, speed: 0.0, spin: 0.0, acceleration: 0.0, spin_rate: 0.0 }
    }
}
