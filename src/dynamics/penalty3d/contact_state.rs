//! State of a contact, and the forces of a closed one.

use glam::{DVec2, DVec3};

use crate::contact::{Forces, FrictionLaw, Law, Local, Mode};

/// State of a contact with everything its forces depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Not touching. A node behind the face that did not come in through it is not armed: it is ignored until the gap is
    /// positive again.
    Open {
        /// Whether the next crossing counts.
        armed: bool,
    },
    /// Touching.
    Closed(ClosedContact),
}

/// A closed contact: its law, its mode, and what the solver keeps about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedContact {
    /// The pair's law, shared.
    pub law: Law,
    /// Stick or slip; an anchor is counted from where the reference poses of its bodies have the node.
    pub mode: Mode,
    /// The phase of a clamped contact in which damping out-pulls elastic force: the normal force is held at 0.
    pub held_at_zero: bool,
    /// What the solver keeps about it.
    pub solver: SolverState,
}

/// State of a closed contact that comes from the numerical method, not from its law.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolverState {
    /// The node in the face's axes at the reference poses, where these have changed during the touch \[m\].
    pub rebased_node: Option<DVec3>,
    /// Regularisation length of a slip direction that turns (return mapping, two directions of sliding): added to the
    /// stretch that the direction follows its velocity within; 0 for none \[m\].
    pub regularisation: f64,
    /// Sliding stopped but a stop cannot hold: no stop is located until `V_t` has grown again.
    pub passing_stop: bool,
    /// Number of times that sliding began again at this instant after a stop.
    pub retries: u32,
    /// The step began within round-off of the face, with no velocity into it: before the face the slip has no friction, since
    /// nothing presses the node. A node that comes out from inside keeps its friction, so that its last step has no kink
    /// beyond its end.
    pub at_face: bool,
}

impl ClosedContact {
    /// A contact that has just closed.
    pub fn new(law: Law, mode: Mode, regularisation: f64) -> Self {
        Self { law, mode, held_at_zero: false, solver: SolverState { regularisation, ..SolverState::default() } }
    }

    /// Forces on the node.
    #[inline]
    pub fn forces(&self, here: &Local) -> Forces {
        self.forces_in(&self.mode, here)
    }

    /// The same in another mode.
    #[inline]
    pub fn forces_in(&self, mode: &Mode, here: &Local) -> Forces {
        let mut forces = self.law.forces(mode, here);
        if let (Mode::Slip { direction }, true) = (*mode, self.solver.regularisation > 0.0) {
            // The stretch turns as well as it grows; p lags by less.
            let length = self.law.slip_stretch(here);
            let across = direction.perp();
            forces.anchor_rate -= across * (across.dot(here.rate) * length / (length + self.solver.regularisation));
            forces.tangential_damping = (forces.sliding - forces.anchor_rate) * -self.law.c_t;
        }
        if self.held_at_zero {
            forces.normal_damping = -forces.normal;
        }
        if self.is_loose(here) {
            forces.tangential = DVec2::ZERO;
            forces.tangential_damping = DVec2::ZERO;
            forces.stretch = DVec2::ZERO;
            forces.anchor_rate = forces.sliding;
        }
        forces
    }

    /// Whether it slides without friction: within round-off before the face, where its spring would pull it back.
    #[inline]
    pub fn is_loose(&self, here: &Local) -> bool {
        self.solver.at_face && here.gap > 0.0 && matches!(self.mode, Mode::Slip { .. })
    }

    /// Angle of a slip whose direction turns on its own, which an integrator must carry \[rad\].
    pub fn turning(&self) -> Option<f64> {
        match self.mode {
            Mode::Slip { direction }
                if self.solver.regularisation > 0.0 && self.law.friction == FrictionLaw::ReturnMapping =>
            {
                Some(direction.to_angle())
            }
            _ => None,
        }
    }

    /// Excess of the damping force over the elastic one, a pull \[N\]; the switching function of the clamp.
    pub fn pull(&self, here: &Local) -> f64 {
        let forces = self.law.forces(&self.mode, here);
        -forces.normal_total()
    }
}

impl Contact {
    /// The closed contact, if it is.
    pub fn closed(&self) -> Option<&ClosedContact> {
        match self {
            Self::Closed(closed) => Some(closed),
            Self::Open { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Normal;
    use crate::contact::normal::Linear;

    #[test]
    fn a_slider_that_hangs_before_its_face_has_no_friction() {
        let law = Law {
            normal: Normal::Linear(Linear { k: 1e9, c: 10.0 }),
            k_t: 1e9,
            c_t: 3.0,
            mu_s: 0.5,
            mu_k: 0.4,
            friction: FrictionLaw::Paper,
            clamp: false,
            v_stick: 0.0,
        };
        let mode = Mode::Slip { direction: DVec2::X };
        let coming_out = ClosedContact::new(law, mode, 0.0);
        let mut hanging = coming_out;
        hanging.solver.at_face = true;
        let here = |gap: f64| Local {
            gap,
            gap_rate: 0.0,
            at: DVec2::ZERO,
            way: DVec2::ZERO,
            rate: DVec2::X,
            spin: DVec3::ZERO,
        };
        let (before, behind) = (here(1e-12), here(-1e-12));
        assert_eq!(hanging.forces(&before).tangential_total(), DVec2::ZERO, "nothing presses it");
        assert_eq!(
            hanging.forces(&before).normal_total(),
            coming_out.forces(&before).normal_total(),
            "the spring pulls"
        );
        // No kink beyond the end of a step that ends a touch.
        assert!(coming_out.forces(&before).tangential.x > 0.0, "as it goes on from behind");
        assert_eq!(hanging.forces(&behind), coming_out.forces(&behind), "behind the face friction is friction");
        assert!(hanging.forces(&behind).tangential.x < 0.0, "against the sliding");
    }
}
