//! States of one contact over time as stored in a history: the law once per touch, vectors and origins once where
//! they repeat.

use glam::DVec2;

use crate::contact::{Law, Mode};
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::penalty3d::active_contact;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact, SolverState};

/// A state, stored in twelve bytes.
#[derive(Clone, Copy, Debug)]
enum Kept {
    Open { armed: bool },
    Closed { touch: u32, hold: Hold, passing_stop: bool, held_at_zero: bool },
}

/// A [`Mode`] with the number of its vector.
#[derive(Clone, Copy, Debug)]
enum Hold {
    Stick(u32),
    Slip(u32),
}

/// Properties common to all states of a touch with the same reference poses.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Touch {
    /// Number of the law.
    law: u32,
    /// Origin of anchors: displacement of the node along the face from the placed to the reference poses \[m\].
    way: DVec2,
    /// Node and normal of the contact.
    place: NodePlace,
}

/// States of a contact in order of time, and the angle of its slip direction where that is a state of the integrator.
#[derive(Clone, Debug, Default)]
pub struct ContactLog {
    /// Beginning of each state \[s\].
    from: Vec<f64>,
    states: Vec<Kept>,
    /// Anchors \[m\] and slip directions \[–\] in order of entry.
    vectors: Vec<DVec2>,
    /// Law of each touch with the pair's stiffness and dashpots as shared, and its regularisation length \[m\].
    laws: Vec<(Law, f64)>,
    touches: Vec<Touch>,
    /// Angle of the slip direction in the face's axes \[rad\] per step, with the beginning of the step \[s\].
    pub angles: Vec<(f64, DenseOutput)>,
}

impl ContactLog {
    /// Enters the state from `from` on \[s\]; `way` is the origin of its anchor, the displacement of the node along
    /// the face from the placed to the reference poses \[m\].
    pub fn push(&mut self, from: f64, state: Contact, way: DVec2) {
        let kept = match state {
            Contact::Open { armed } => Kept::Open { armed },
            Contact::Closed(ClosedContact { law, mode, held_at_zero, place, solver }) => {
                let SolverState { regularisation, passing_stop, .. } = solver;
                if self.laws.last() != Some(&(law, regularisation)) {
                    self.laws.push((law, regularisation));
                }
                // Memory ends before a u32 overflows: four billion touches of one contact.
                let last = |n: usize| u32::try_from(n - 1).unwrap_or(u32::MAX);
                let touch = Touch { law: last(self.laws.len()), way, place };
                if self.touches.last() != Some(&touch) {
                    self.touches.push(touch);
                }
                let hold = match mode {
                    Mode::Stick { anchor } => Hold::Stick(self.vector(anchor)),
                    Mode::Slip { direction } => Hold::Slip(self.vector(direction)),
                };
                Kept::Closed { touch: last(self.touches.len()), hold, passing_stop, held_at_zero }
            }
        };
        self.from.push(from);
        self.states.push(kept);
    }

    /// Stores an anchor or a slip direction unless it equals the last one bit for bit (those of a straight row do);
    /// its number.
    fn vector(&mut self, vector: DVec2) -> u32 {
        let bits = |v: &DVec2| v.to_array().map(f64::to_bits);
        if self.vectors.last().map(bits) != Some(bits(&vector)) {
            self.vectors.push(vector);
        }
        u32::try_from(self.vectors.len() - 1).unwrap_or(u32::MAX)
    }

    /// States with their beginnings \[s\], anchors relative to the placed poses; a slip direction that turns at its
    /// initial angle.
    pub fn states(&self) -> impl ExactSizeIterator<Item = (f64, Contact)> + '_ {
        self.from.iter().zip(&self.states).map(|(from, kept)| (*from, self.whole(*kept)))
    }

    /// Beginnings of the states that begin between two times, both included \[s\].
    pub fn beginnings(&self, from: f64, until: f64) -> Vec<f64> {
        let first = self.from.partition_point(|t| *t < from);
        self.from[first..].iter().copied().take_while(|t| *t <= until).collect()
    }

    /// Origin of the anchors of the last touch: a displacement along the face \[m\].
    pub fn way(&self) -> DVec2 {
        self.touches.last().map_or(DVec2::ZERO, |touch| touch.way)
    }

    /// Number of the latest state; `None` without states.
    pub fn latest(&self) -> Option<u32> {
        u32::try_from(self.states.len().checked_sub(1)?).ok()
    }

    /// The closed state of this number, its anchor relative to the reference poses, a slip direction that turns at
    /// its initial angle; `None` for an open state.
    pub fn closed(&self, number: u32) -> Option<ClosedContact> {
        self.entered(*self.states.get(number as usize)?).closed().copied()
    }

    /// Memory of the log \[bytes\].
    pub fn bytes(&self) -> usize {
        let angles: usize = self.angles.iter().map(|(_, dense)| size_of_val(dense.coefficients())).sum();
        self.states.len() * (size_of::<f64>() + size_of::<Kept>())
            + self.vectors.len() * size_of::<DVec2>()
            + self.laws.len() * size_of::<(Law, f64)>()
            + self.touches.len() * size_of::<Touch>()
            + self.angles.len() * size_of::<(f64, DenseOutput)>()
            + angles
    }

    /// A state with its anchor relative to the placed poses.
    fn whole(&self, kept: Kept) -> Contact {
        let mut contact = self.entered(kept);
        if let (Contact::Closed(closed), Kept::Closed { touch, .. }) = (&mut contact, kept)
            && let Mode::Stick { anchor } = &mut closed.mode
        {
            *anchor += self.touches[touch as usize].way;
        }
        contact
    }

    fn entered(&self, kept: Kept) -> Contact {
        match kept {
            Kept::Open { armed } => Contact::Open { armed },
            Kept::Closed { touch, hold, passing_stop, held_at_zero } => {
                let Touch { law, place, .. } = self.touches[touch as usize];
                let (law, regularisation) = self.laws[law as usize];
                let mode = match hold {
                    Hold::Stick(anchor) => Mode::Stick { anchor: self.vectors[anchor as usize] },
                    Hold::Slip(direction) => Mode::Slip { direction: self.vectors[direction as usize] },
                };
                let solver = SolverState { regularisation, passing_stop, ..SolverState::default() };
                Contact::Closed(ClosedContact { law, mode, held_at_zero, place, solver })
            }
        }
    }

    /// The state at `t`, its anchor relative to the placed poses; of several entered at `t`, the last.
    pub fn at(&self, t: f64) -> Contact {
        match self.holding_at(t) {
            Some(kept) => self.turned(self.whole(kept), t),
            None => Contact::Open { armed: true },
        }
    }

    /// The closed state at `t`, its anchor relative to the reference poses of its bodies; `None` for an open state.
    pub fn since(&self, t: f64) -> Option<ClosedContact> {
        self.turned(self.entered(self.holding_at(t)?), t).closed().copied()
    }

    /// The state entered last at `t` or before.
    fn holding_at(&self, t: f64) -> Option<Kept> {
        let begun = self.from.partition_point(|from| *from <= t);
        self.states.get(begun.checked_sub(1)?).copied()
    }

    fn turned(&self, contact: Contact, t: f64) -> Contact {
        let Contact::Closed(mut closed) = contact else { return contact };
        if closed.solver.regularisation > 0.0
            && let Mode::Slip { direction } = &mut closed.mode
            && let Some(i) = self.angles.partition_point(|(from, _)| *from <= t).checked_sub(1)
        {
            let mut angle = [0.0];
            self.angles[i].1.read(0..1, t, &mut angle);
            *direction = active_contact::direction(angle[0]);
        }
        Contact::Closed(closed)
    }

    /// Releases reserved memory.
    pub fn shrink(&mut self) {
        self.from.shrink_to_fit();
        self.states.shrink_to_fit();
        self.vectors.shrink_to_fit();
        self.laws.shrink_to_fit();
        self.touches.shrink_to_fit();
        self.angles.shrink_to_fit();
    }
}
