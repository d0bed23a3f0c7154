//! Normal laws of several phases (`docs/physics.md#other-normal-laws`): a dashpot that acts in the approach alone, a spring that yields. In
//! each phase the force is a smooth function of δ and `V_n`; the memory of a touch is part of the phase.

/// Phases of a normal law within a touch; by default a single one.
pub trait Phases: Copy {
    /// Whether there are several.
    fn has_phases(&self) -> bool {
        false
    }

    /// The law of a touch that begins at this penetration \[m\], 0 but for a node that is inside already, and normal velocity,
    /// positive apart \[m/s\].
    #[must_use]
    fn begun(self, _penetration: f64, _velocity: f64) -> Self {
        self
    }

    /// The law of a node that takes over from one of the same pair in the phase of `before`, at this penetration \[m\].
    #[must_use]
    fn resumed(self, _before: Self, penetration: f64) -> Self {
        self.begun(penetration, 0.0)
    }

    /// Switching function of the end of the present phase, negative while it lasts, in a unit of the phase's own.
    fn phase_end(&self, _penetration: f64, _velocity: f64) -> f64 {
        f64::NEG_INFINITY
    }

    /// Scale of that function at penetrations \[m\] and speeds \[m/s\] of these sizes.
    fn phase_end_scale(&self, _depth: f64, _speed: f64) -> f64 {
        0.0
    }

    /// Scale of its change by a change of δ of this size \[m\] at this circular frequency \[rad/s\].
    fn phase_end_change(&self, _change: f64, _frequency: f64) -> f64 {
        0.0
    }

    /// The law in the phase after the present one, which ends at this penetration \[m\].
    #[must_use]
    fn next_phase(self, _penetration: f64) -> Self {
        self
    }
}

/// Whether a dashpot that acts in the approach alone acts at present.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// δ grows.
    Approach,
    /// δ falls.
    Return,
}

impl Stage {
    /// The other stage.
    #[must_use]
    pub fn next(self) -> Self {
        match self {
            Self::Approach => Self::Return,
            Self::Return => Self::Approach,
        }
    }

    /// Switching function of its end: the normal velocity crosses 0 \[m/s\].
    pub fn end(self, velocity: f64) -> f64 {
        match self {
            Self::Approach => velocity,
            Self::Return => -velocity,
        }
    }
}
