//! State of a contact (`docs/physics.md#contact-events`), and the forces of a closed one.

use crate::contact::{Forces, Law, Local, Mode, SlipDirection};
use crate::dynamics::model::edge_node::node_place::NodePlace;

/// State of a contact with all quantities that its forces depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "copied with every contact of a step; in a box each copy would be an allocation"
)]
pub enum Contact {
    /// No contact. A disarmed contact (its node is behind the face and did not enter through it) does not close until
    /// its gap is positive again.
    Open {
        /// Whether the next crossing of the gap through zero is a closing.
        armed: bool,
    },
    /// In contact, in stick or slip.
    Closed(ClosedContact),
}

/// State of a closed contact: law, mode, and state of the numerical method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedContact {
    /// Law with the pair's stiffness and dashpots as shared.
    pub law: Law,
    /// Stick or slip; an anchor is relative to the reference poses of the bodies.
    pub mode: Mode,
    /// Law with `clamp` while the damping force exceeds the elastic one: the normal force is held at 0.
    pub held_at_zero: bool,
    /// Node and normal of the contact.
    pub place: NodePlace,
    /// State of the numerical method.
    pub solver: SolverState,
}

/// State of a closed contact that belongs to the numerical method, not to the law.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolverState {
    /// Regularisation length `ℓ` of a slip direction that turns (`docs/physics.md#law-return-mapping`), added to the
    /// stretch in the denominator of the angle's rate; 0 for none \[m\].
    pub regularisation: f64,
    /// Sliding has stopped and stick cannot hold: the next stop is located only after `V_t` has exceeded `v_stick`
    /// again.
    pub passing_stop: bool,
    /// In slip, the number of changes of the contact at the instant at which the slip began; 0 in stick.
    pub retries: u32,
    /// Distance beyond the edges of its face up to which the contact is kept, where it alone carries an overlap of two bodies
    /// that have met \[m\].
    pub kept_beyond_edge: f64,
    /// Distance beyond its face's edge at which a corner of bodies that have met hands its vertex on to the next face \[m\]; `None` after the
    /// handover, and of a corner that closed beyond the edge: the planes of the faces around bound its contact.
    pub handover_distance: Option<f64>,
    /// Greatest distance of a corner beside its face at which it took over a vertex from another node \[m\].
    pub beside: f64,
}

impl ClosedContact {
    /// State of a contact at its closing.
    pub fn new(law: Law, mode: Mode, regularisation: f64) -> Self {
        let solver = SolverState { regularisation, ..SolverState::default() };
        Self { law, mode, held_at_zero: false, place: NodePlace::default(), solver }
    }

    /// Forces on the node in the face's axes \[N\].
    #[inline]
    pub fn forces(&self, here: &Local) -> Forces {
        self.forces_in(&self.mode, here)
    }

    /// Forces on the node in the face's axes \[N\], in the mode `mode`.
    #[inline]
    pub fn forces_in(&self, mode: &Mode, here: &Local) -> Forces {
        let mut forces = self.law.forces_turning(mode, here, self.solver.regularisation);
        if self.held_at_zero {
            forces.normal_damping = -forces.normal;
        }
        forces
    }

    /// Slip angle of a contact whose slip direction is a state of the integrator \[rad\]; `None` for others.
    pub fn slip_angle(&self) -> Option<f64> {
        match self.mode {
            Mode::Slip { direction }
                if self.solver.regularisation > 0.0 && self.law.slip_direction() == SlipDirection::State =>
            {
                Some(direction.to_angle())
            }
            Mode::Stick { .. } | Mode::Slip { .. } => None,
        }
    }

    /// Switching function of the next kink of the normal force, negative before it: end of the phase of the normal law, in the unit of
    /// that function, or beginning or end of a force held at 0 \[N\].
    pub fn kink(&self, here: &Local) -> f64 {
        let forces = self.law.forces(&self.mode, here);
        if self.law.normal.has_phases() {
            return self.law.normal.phase_end(here.penetration(), forces.normal_velocity);
        }
        // Excess of the damping force over the elastic one, a pull.
        let pull = -forces.normal_total();
        if self.held_at_zero { -pull } else { pull }
    }

    /// State after the kink.
    #[must_use]
    pub fn after_kink(mut self, here: &Local) -> Self {
        if self.law.normal.has_phases() {
            self.law.normal = self.law.normal.next_phase(here.penetration());
        } else {
            self.held_at_zero = !self.held_at_zero;
        }
        self
    }
}

impl Contact {
    /// State of a closed contact; `None` for an open one.
    pub fn closed(&self) -> Option<&ClosedContact> {
        match self {
            Self::Closed(closed) => Some(closed),
            Self::Open { .. } => None,
        }
    }
}
