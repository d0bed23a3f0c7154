//! State of a contact, and the forces of a closed one.

use glam::{DVec2, DVec3};

use crate::contact::{Forces, Law, Local, Mode, law::Friction};

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
    Closed(Closed),
}

/// A closed contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closed {
    /// The pair's numbers, shared.
    pub law: Law,
    /// Stick or slip; an anchor is counted from where the bases of its bodies are.
    pub mode: Mode,
    /// Where the node is there, in the face's axes, where that was carried on from earlier bases \[m\].
    pub at: Option<DVec3>,
    /// Length below which a turning direction of slip is eased (return mapping, two directions of sliding) \[m\].
    pub ease: f64,
    /// Sliding stopped but could not hold: it passes through until `V_t` has grown again.
    pub passing: bool,
    /// How many times at one instant it has gone on sliding when it had stopped.
    pub again: u32,
    /// Under `clamp`: the dashpot out-pulls the spring, the normal force is held at 0.
    pub slack: bool,
    /// It began its step within rounding of the face and does not go in: where it is before the face, nothing presses it and
    /// friction has nothing to act by. A node that comes out from within is not cut off so: its last step would meet a kink
    /// beyond its end.
    pub at_face: bool,
}

impl Closed {
    /// Forces on the node.
    #[inline]
    pub fn forces(&self, here: &Local) -> Forces {
        self.forces_in(&self.mode, here)
    }

    /// The same in another mode.
    #[inline]
    pub fn forces_in(&self, mode: &Mode, here: &Local) -> Forces {
        let mut forces = self.law.forces(mode, here);
        if let (Mode::Slip { direction }, true) = (*mode, self.ease > 0.0) {
            // The stretch turns as well as it grows; p lags by less.
            let length = (self.law.mu_k * here.penetration()).max(0.0);
            let across = direction.perp();
            forces.anchor_rate -= across * (across.dot(here.rate) * length / (length + self.ease));
            forces.tangential_damping = (forces.sliding - forces.anchor_rate) * -self.law.c_t;
        }
        if self.slack {
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

    /// Whether it slides without friction: a hair before the face, where its spring would pull it back.
    #[inline]
    pub fn is_loose(&self, here: &Local) -> bool {
        self.at_face && here.gap > 0.0 && matches!(self.mode, Mode::Slip { .. })
    }

    /// Angle of a slip whose direction turns on its own, which an integrator must carry \[rad\].
    pub fn turning(&self) -> Option<f64> {
        match self.mode {
            Mode::Slip { direction } if self.ease > 0.0 && self.law.friction == Friction::ReturnMapping => {
                Some(direction.to_angle())
            }
            _ => None,
        }
    }

    /// How much the dashpot out-pulls the spring \[N\].
    pub fn pull(&self, here: &Local) -> f64 {
        let forces = self.law.forces(&self.mode, here);
        -forces.normal_total()
    }
}

impl Contact {
    /// The closed contact, if it is.
    pub fn closed(&self) -> Option<&Closed> {
        match self {
            Self::Closed(closed) => Some(closed),
            Self::Open { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::law::Friction;

    #[test]
    fn a_slider_that_hangs_before_its_face_has_no_friction() {
        let law = Law {
            k: 1e9,
            c_n: 10.0,
            c_t: 3.0,
            mu_s: 0.5,
            mu_k: 0.4,
            friction: Friction::Paper,
            clamp: false,
            v_stick: 0.0,
        };
        let mode = Mode::Slip { direction: DVec2::X };
        let hanging = Closed { law, mode, at: None, ease: 0.0, passing: false, again: 0, slack: false, at_face: true };
        let coming_out = Closed { at_face: false, ..hanging };
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
