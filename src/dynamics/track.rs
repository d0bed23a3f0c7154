//! What a run keeps: the path of every body and the states of every contact, exact at any time.

use super::flight::Flight;
use super::impact2d::slide::Slide;
use super::piece::Piece;
use crate::contact::{Forces, Law, Local, Mode, law::Friction};

/// One stretch of a body's path.
#[derive(Clone, Debug)]
pub struct Segment {
    /// From \[s\].
    pub from: f64,
    /// Until; a step may have been meant to go further \[s\].
    pub until: f64,
    /// The motion in between.
    pub path: Path,
}

/// How a stretch was computed.
#[derive(Clone, Debug)]
pub enum Path {
    /// Closed form.
    Flight(Box<Flight>),
    /// Closed form of a face that slides along a wall (impact model).
    Slide(Box<Slide>),
    /// Continuous answer of an integrator's step.
    Step(Piece),
    /// The same, to be taken again by its number among the group's.
    Again(u32),
}

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
    /// Stick or slip.
    pub mode: Mode,
    /// Length below which a turning direction of slip is eased (return mapping, two directions of sliding) \[m\].
    pub ease: f64,
    /// Sliding stopped but could not hold: it passes through until `V_t` has grown again.
    pub passing: bool,
    /// How many times at one instant it has gone on sliding when it had stopped.
    pub again: u32,
    /// Under `clamp`: the dashpot out-pulls the spring, the normal force is held at 0.
    pub slack: bool,
}

impl Closed {
    /// Forces on the node.
    #[inline]
    pub fn forces(&self, here: &Local) -> Forces {
        let mut forces = self.law.forces(&self.mode, here);
        if let (Mode::Slip { direction }, true) = (self.mode, self.ease > 0.0) {
            // The stretch turns as well as it grows; p lags by less.
            let length = (self.law.mu_k * here.penetration()).max(0.0);
            let across = direction.perp();
            forces.anchor_rate -= across * (across.dot(here.rate) * length / (length + self.ease));
            forces.tangential_damping = (forces.sliding - forces.anchor_rate) * -self.law.c_t;
        }
        if self.slack {
            forces.normal_damping = -forces.normal;
        }
        forces
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
