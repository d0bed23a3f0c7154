//! A device between two points whose force sets in, changes its law and ends: phases, switching functions, gap.

use glam::DVec3;

use crate::dynamics::connection::{DeviceReadings, Excursion, Phase, Separation, SeparationBounds};

/// A connection with phases. While no force acts, its bodies are integrated without each other, and the search for the
/// beginning of the force uses [`gap`](Device::gap) and [`gap_curvature`](Device::gap_curvature); while the force acts, its
/// bodies are one island, and the end of the phase is a zero of a switching function on their dense output.
pub trait Device: DeviceReadings + std::fmt::Debug + Send + Sync {
    /// Phase at the start of a run.
    fn initial(&self, motion: &Separation) -> Phase;

    /// Whether a force acts in this phase, or may begin.
    fn activity(&self, phase: &Phase) -> Activity;

    /// Whether a force acts in this phase: its [activity](Self::activity).
    fn acts(&self, phase: &Phase) -> bool {
        self.activity(phase) == Activity::Acts
    }

    /// Stiffness and damping along its axes \[N/m, N·s/m\] where it always acts, in one phase, with a force that is linear in
    /// displacement and rate of its points.
    fn linear(&self) -> Option<[DVec3; 2]> {
        None
    }

    /// Whether it is [`linear`](Self::linear).
    fn is_linear(&self) -> bool {
        self.linear().is_some()
    }

    /// Linearity of the phase in displacement and rate of its points.
    fn linearity(&self, _phase: &Phase) -> Linearity {
        if self.is_linear() { Linearity::Whole } else { Linearity::None }
    }

    /// Distance to the beginning of the force, and its rate; while the force acts, less the deformation that it is
    /// measured by \[m, m/s\]. While it is positive it changes by no more than its points are displaced against one another.
    fn gap(&self, phase: &Phase, motion: &Separation) -> [f64; 2];

    /// Upper bound of the second derivative of the gap while the motion keeps to `bounds` \[m/s²\].
    fn gap_curvature(&self, phase: &Phase, bounds: &SeparationBounds) -> f64;

    /// Whether no force can begin while the motion keeps to `bounds`.
    fn stays_idle(&self, _phase: &Phase, _bounds: &SeparationBounds) -> bool {
        false
    }

    /// Number of switching functions of a phase in which a force acts; none for a device of one phase.
    fn switches(&self, _phase: &Phase) -> usize {
        0
    }

    /// Unit of a switching function.
    fn switch_unit(&self, _number: usize, _phase: &Phase) -> SwitchUnit {
        SwitchUnit::Length
    }

    /// Whether the law's first memory changes while the phase lasts, by [`Device::evolution`].
    fn evolves(&self, _phase: &Phase) -> bool {
        false
    }

    /// Rate of the law's first memory.
    fn evolution(&self, _phase: &Phase, _motion: &Separation) -> Evolution {
        Evolution::default()
    }

    /// Force on the first point and evolution together, for laws in which both come from one function of what is remembered.
    fn force_and_evolution(&self, phase: &Phase, motion: &Separation) -> (DVec3, Evolution) {
        (self.force(phase, motion), self.evolution(phase, motion))
    }

    /// Whether the support that it is has been lost in this phase.
    fn is_lost(&self, _phase: &Phase) -> bool {
        false
    }

    /// Distance of the relative velocity of its points from the nearest one, real or complex, at which the force is singular \[m/s\]: the
    /// force's series converges up to it. Infinite where there is none.
    fn smooth_within(&self, _phase: &Phase, _motion: &Separation) -> f64 {
        f64::INFINITY
    }

    /// Whether a run ends where this phase begins.
    fn ends_run(&self, _phase: &Phase) -> bool {
        false
    }

    /// A switching function of such a phase, in its [unit](Device::switch_unit): negative while the phase lasts.
    fn switch(&self, _number: usize, _phase: &Phase, _motion: &Separation) -> f64 {
        f64::NEG_INFINITY
    }

    /// Whether a switching function stays below 0 for certain while the motion departs from `motion` by no more than `within`.
    fn stays_below(&self, _number: usize, _phase: &Phase, _motion: &Separation, _within: Excursion) -> bool {
        false
    }

    /// Phase that begins where the gap closes (from a phase without force) or a switching function rises through 0; energy
    /// that the change releases \[J\].
    fn next(&self, _event: Switch, phase: &Phase, _motion: &Separation) -> (Phase, f64) {
        (*phase, 0.0)
    }
}

/// Whether a force acts in a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Activity {
    /// No force acts; one begins where the gap closes.
    Idle,
    /// A force acts.
    Acts,
    /// No force acts, and none can begin any more.
    Ended,
}

impl Activity {
    /// Of a device whose force can begin at any time where it does not act.
    pub fn of(acts: bool) -> Self {
        if acts { Self::Acts } else { Self::Idle }
    }
}

/// Quantities of a phase that are linear, with a constant, in displacement and rate of a device's points; ascending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Linearity {
    /// Not the force.
    None,
    /// The force alone; a switching function is not, as that of a yield circle.
    Force,
    /// Force, gap and switching functions, of which one that is a length changes by no more than the points are displaced.
    Whole,
}

/// Unit of a switching function: its rounding is that of the motion which it is a function of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwitchUnit {
    /// A length \[m\].
    Length,
    /// A speed \[m/s\].
    Speed,
}

impl SwitchUnit {
    /// Bound of the change of a function in this unit that is a component of the displacement or of the rate.
    pub fn largest_change(self, within: Excursion) -> f64 {
        match self {
            Self::Length => within.way,
            Self::Speed => within.rate,
        }
    }
}

/// Equation of motion of the first memory `m` of a law: `ṁ = rate`, with `m` in a unit of the device.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evolution {
    /// `ṁ` \[unit of m/s\].
    pub rate: f64,
    /// `∂ṁ/∂m` \[1/s\], not positive.
    pub decay: f64,
    /// Change of the force per `m` \[N/unit of m\], in the link's axes.
    pub force: DVec3,
    /// Change of `ṁ` per relative velocity \[unit of m/m\], in the link's axes.
    pub drive: DVec3,
}

/// Event that ends a phase of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// The gap closes: the force begins.
    Closing,
    /// The switching function of this number rises through 0.
    Function(usize),
}
