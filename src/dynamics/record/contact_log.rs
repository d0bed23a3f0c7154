//! The states that a contact went through, as a history keeps them: a touch's law once, not with every change of state.

use std::num::NonZeroU32;

use glam::{DVec2, DVec3};

use crate::contact::{FrictionLaw, Law, Mode};
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact, SolverState};

/// A state, in twelve bytes.
#[derive(Clone, Copy, Debug)]
enum Kept {
    Open { armed: bool },
    Closed { touch: u32, hold: Hold, passing_stop: bool, held_at_zero: bool },
}

/// A [`Mode`], its vector by its number.
#[derive(Clone, Copy, Debug)]
enum Hold {
    Stick(u32),
    Slip(u32),
}

/// What all states of a touch have in common, as long as they are counted from the same bases.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Touch {
    /// Number of its law.
    law: u32,
    /// From where anchors are counted: how far the node had come along the face since it was placed \[m\].
    way: DVec2,
    /// Number of where the node is there, where that was carried on.
    at: Option<NonZeroU32>,
}

/// A contact's states in order of time, and the turning of its slip where that is a state of the integrator.
#[derive(Clone, Debug, Default)]
pub struct ContactLog {
    /// When each state began \[s\].
    from: Vec<f64>,
    states: Vec<Kept>,
    /// Anchors \[m\] and directions, one after another.
    vectors: Vec<DVec2>,
    /// The pair's numbers as shared in each touch, and the length below which a turning slip is eased \[m\].
    laws: Vec<(Law, f64)>,
    touches: Vec<Touch>,
    /// Places of the node, in the face's axes, that were carried on \[m\].
    carried: Vec<DVec3>,
    /// Angle of the slip direction in the face's axes, step by step, with the time each holds from.
    pub angles: Vec<(f64, DenseOutput)>,
}

impl ContactLog {
    /// Enters the state from `from` on \[s\], whose anchor is counted from that way of the node along the face \[m\].
    pub fn push(&mut self, from: f64, state: Contact, way: DVec2) {
        let kept = match state {
            Contact::Open { armed } => Kept::Open { armed },
            Contact::Closed(ClosedContact { law, mode, held_at_zero, solver }) => {
                let SolverState { rebased_node, regularisation, passing_stop, .. } = solver;
                if self.laws.last() != Some(&(law, regularisation)) {
                    self.laws.push((law, regularisation));
                }
                // More touches of one contact than a u32 counts would not fit into memory.
                let last = |n: usize| u32::try_from(n - 1).unwrap_or(u32::MAX);
                let at = rebased_node.and_then(|at| self.carry(at));
                let touch = Touch { law: last(self.laws.len()), way, at };
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

    /// Keeps an anchor or a direction, once where it is the last one again: a straight row's are all the same; its number.
    fn vector(&mut self, vector: DVec2) -> u32 {
        let bits = |v: &DVec2| v.to_array().map(f64::to_bits);
        if self.vectors.last().map(bits) != Some(bits(&vector)) {
            self.vectors.push(vector);
        }
        u32::try_from(self.vectors.len() - 1).unwrap_or(u32::MAX)
    }

    /// Keeps a place of the node; its number, from 1 on.
    fn carry(&mut self, at: DVec3) -> Option<NonZeroU32> {
        if self.carried.last() != Some(&at) {
            self.carried.push(at);
        }
        u32::try_from(self.carried.len()).ok().and_then(NonZeroU32::new)
    }

    /// States with the times that they hold from, a turning slip in the direction that it began with.
    pub fn states(&self) -> impl ExactSizeIterator<Item = (f64, Contact)> + '_ {
        self.from.iter().zip(&self.states).map(|(from, kept)| (*from, self.whole(*kept)))
    }

    /// From where anchors of the last touch are counted: a way along the face \[m\].
    pub fn way(&self) -> DVec2 {
        self.touches.last().map_or(DVec2::ZERO, |touch| touch.way)
    }

    /// Number of the latest state.
    pub fn latest(&self) -> Option<u32> {
        u32::try_from(self.states.len().checked_sub(1)?).ok()
    }

    /// A closed state by its number as it was entered, a turning slip in the direction that it began with.
    pub fn closed(&self, number: u32) -> Option<ClosedContact> {
        self.entered(*self.states.get(number as usize)?).closed().copied()
    }

    /// What it takes \[bytes\].
    pub fn bytes(&self) -> usize {
        let angles: usize = self.angles.iter().map(|(_, dense)| size_of_val(dense.coefficients())).sum();
        self.states.len() * (size_of::<f64>() + size_of::<Kept>())
            + self.vectors.len() * size_of::<DVec2>()
            + self.laws.len() * size_of::<(Law, f64)>()
            + self.touches.len() * size_of::<Touch>()
            + self.carried.len() * size_of::<DVec3>()
            + self.angles.len() * size_of::<(f64, DenseOutput)>()
            + angles
    }

    /// A state whose anchor is counted from where the node was placed.
    fn whole(&self, kept: Kept) -> Contact {
        let mut contact = self.entered(kept);
        if let (Contact::Closed(closed), Kept::Closed { touch, .. }) = (&mut contact, kept) {
            closed.solver.rebased_node = None;
            if let Mode::Stick { anchor } = &mut closed.mode {
                *anchor += self.touches[touch as usize].way;
            }
        }
        contact
    }

    fn entered(&self, kept: Kept) -> Contact {
        match kept {
            Kept::Open { armed } => Contact::Open { armed },
            Kept::Closed { touch, hold, passing_stop, held_at_zero } => {
                let Touch { law, at, .. } = self.touches[touch as usize];
                let at = at.and_then(|number| self.carried.get(number.get() as usize - 1)).copied();
                let (law, regularisation) = self.laws[law as usize];
                let mode = match hold {
                    Hold::Stick(anchor) => Mode::Stick { anchor: self.vectors[anchor as usize] },
                    Hold::Slip(direction) => Mode::Slip { direction: self.vectors[direction as usize] },
                };
                let at_face = law.friction == FrictionLaw::Paper;
                let solver = SolverState { rebased_node: at, regularisation, passing_stop, retries: 0, at_face };
                Contact::Closed(ClosedContact { law, mode, held_at_zero, solver })
            }
        }
    }

    /// The state at `t`; of several at one instant, the last.
    pub fn at(&self, t: f64) -> Contact {
        match self.holding_at(t) {
            Some(kept) => self.turned(self.whole(kept), t),
            None => Contact::Open { armed: true },
        }
    }

    /// The closed state at `t`, its anchor counted from where the bases of its bodies are.
    pub fn since(&self, t: f64) -> Option<ClosedContact> {
        self.turned(self.entered(self.holding_at(t)?), t).closed().copied()
    }

    /// What was entered last at `t` or before.
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
            *direction = crate::dynamics::penalty3d::active_contact::direction(angle[0]);
        }
        Contact::Closed(closed)
    }

    /// Gives back the memory that more states would have taken.
    pub fn shrink(&mut self) {
        self.from.shrink_to_fit();
        self.states.shrink_to_fit();
        self.vectors.shrink_to_fit();
        self.laws.shrink_to_fit();
        self.touches.shrink_to_fit();
        self.carried.shrink_to_fit();
        self.angles.shrink_to_fit();
    }
}
