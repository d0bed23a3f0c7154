//! Upper bounds of a body's motion over an interval of time, from which conservative advancement takes its step.

/// Bounds on a motion over `[t, t + window]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionBounds {
    /// Time for which they hold \[s\].
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

    /// Acceleration of a point against G by the body's rotation, tangential and towards the axis, over its distance from G \[1/s²\].
    #[inline]
    pub fn acceleration_per_arm(&self) -> f64 {
        self.spin_rate + self.spin * self.spin
    }
}

/// Bound on `|g̈|` of a node before a face \[m/s²\], from bounds on the motion of both bodies and on the speed and acceleration of G
/// against G: with r from the face's G to the node and n fixed to the face, `g = n·r` and `g̈ = n·r̈ + 2 ṅ·ṙ + n̈·r`. `arm` and `apart` are
/// the distances of the node from its own G and from the face's \[m\].
#[inline]
pub(in crate::dynamics) fn gap_acceleration(
    [node, face]: [&MotionBounds; 2],
    [speed, acceleration]: [f64; 2],
    [arm, apart]: [f64; 2],
) -> f64 {
    acceleration
        + node.acceleration_per_arm() * arm
        + face.acceleration_per_arm() * apart
        + 2.0 * face.spin * (speed + node.spin * arm)
}
