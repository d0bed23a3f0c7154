//! What a run keeps: the path of every body and the states of every contact, exact at any time.

use super::dop853::Dense;
use super::flight::Flight;
use crate::contact::{Forces, Law, Local, Mode};

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
    Flight(Flight),
    /// Continuous answer of an integrator's step.
    Dense(Dense),
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

/// A contact's states in order of time, and the turning of its slip where that is a state of the integrator.
#[derive(Clone, Debug, Default)]
pub struct ContactLog {
    /// `(from, state)`.
    pub states: Vec<(f64, Contact)>,
    /// Angle of the slip direction in the face's axes, step by step, with the time each holds from.
    pub angles: Vec<(f64, Dense)>,
}

impl ContactLog {
    /// The state at `t`; of several at one instant, the last.
    pub fn at(&self, t: f64) -> Contact {
        let n = self.states.partition_point(|(from, _)| *from <= t);
        match n.checked_sub(1).and_then(|i| self.states.get(i)) {
            Some((_, contact)) => self.turned(*contact, t),
            None => Contact::Open { armed: true },
        }
    }

    fn turned(&self, contact: Contact, t: f64) -> Contact {
        let Contact::Closed(mut closed) = contact else { return contact };
        if closed.ease > 0.0
            && let Mode::Slip { direction } = &mut closed.mode
            && let Some(i) = self.angles.partition_point(|(from, _)| *from <= t).checked_sub(1)
        {
            let mut angle = [0.0];
            self.angles[i].1.read(0..1, t, &mut angle);
            *direction = super::field::direction(angle[0]);
        }
        Contact::Closed(closed)
    }
}
