//! The states that a contact went through, as a history keeps them: a touch's law once, not with every change of state.

use std::num::NonZeroU32;

use glam::{DVec2, DVec3};

use super::dop853::Dense;
use super::track::{Closed, Contact};
use crate::contact::{Law, Mode, law::Friction};

/// A state and when it began.
#[derive(Clone, Copy, Debug)]
struct Entry {
    from: f64,
    kept: Kept,
}

#[derive(Clone, Copy, Debug)]
enum Kept {
    Open { armed: bool },
    Closed { touch: u32, mode: Mode, passing: bool, slack: bool },
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
    entries: Vec<Entry>,
    /// The pair's numbers as shared in each touch, and the length below which a turning slip is eased \[m\].
    laws: Vec<(Law, f64)>,
    touches: Vec<Touch>,
    /// Places of the node, in the face's axes, that were carried on \[m\].
    carried: Vec<DVec3>,
    /// Angle of the slip direction in the face's axes, step by step, with the time each holds from.
    pub angles: Vec<(f64, Dense)>,
}

impl ContactLog {
    /// Enters the state from `from` on \[s\], whose anchor is counted from that way of the node along the face \[m\].
    pub fn push(&mut self, from: f64, state: Contact, way: DVec2) {
        let kept = match state {
            Contact::Open { armed } => Kept::Open { armed },
            Contact::Closed(Closed { law, mode, at, ease, passing, slack, .. }) => {
                if self.laws.last() != Some(&(law, ease)) {
                    self.laws.push((law, ease));
                }
                // More touches of one contact than a u32 counts would not fit into memory.
                let last = |n: usize| u32::try_from(n - 1).unwrap_or(u32::MAX);
                let at = at.and_then(|at| self.carry(at));
                let touch = Touch { law: last(self.laws.len()), way, at };
                if self.touches.last() != Some(&touch) {
                    self.touches.push(touch);
                }
                Kept::Closed { touch: last(self.touches.len()), mode, passing, slack }
            }
        };
        self.entries.push(Entry { from, kept });
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
        self.entries.iter().map(|entry| (entry.from, self.whole(entry.kept)))
    }

    /// From where anchors of the last touch are counted: a way along the face \[m\].
    pub fn way(&self) -> DVec2 {
        self.touches.last().map_or(DVec2::ZERO, |touch| touch.way)
    }

    /// Number of the latest state.
    pub fn latest(&self) -> Option<u32> {
        u32::try_from(self.entries.len().checked_sub(1)?).ok()
    }

    /// A closed state by its number as it was entered, a turning slip in the direction that it began with.
    pub fn closed(&self, number: u32) -> Option<Closed> {
        self.entered(self.entries.get(number as usize)?.kept).closed().copied()
    }

    /// What it takes \[bytes\].
    pub fn bytes(&self) -> usize {
        let angles: usize = self.angles.iter().map(|(_, dense)| size_of_val(dense.coefficients())).sum();
        self.entries.len() * size_of::<Entry>()
            + self.laws.len() * size_of::<(Law, f64)>()
            + self.touches.len() * size_of::<Touch>()
            + self.carried.len() * size_of::<DVec3>()
            + self.angles.len() * size_of::<(f64, Dense)>()
            + angles
    }

    /// A state whose anchor is counted from where the node was placed.
    fn whole(&self, kept: Kept) -> Contact {
        let mut contact = self.entered(kept);
        if let (Contact::Closed(closed), Kept::Closed { touch, .. }) = (&mut contact, kept) {
            closed.at = None;
            if let Mode::Stick { anchor } = &mut closed.mode {
                *anchor += self.touches[touch as usize].way;
            }
        }
        contact
    }

    fn entered(&self, kept: Kept) -> Contact {
        match kept {
            Kept::Open { armed } => Contact::Open { armed },
            Kept::Closed { touch, mode, passing, slack } => {
                let Touch { law, at, .. } = self.touches[touch as usize];
                let at = at.and_then(|number| self.carried.get(number.get() as usize - 1)).copied();
                let (law, ease) = self.laws[law as usize];
                Contact::Closed(Closed {
                    law,
                    mode,
                    at,
                    ease,
                    passing,
                    again: 0,
                    slack,
                    at_face: law.friction == Friction::Paper,
                })
            }
        }
    }

    /// The state at `t`; of several at one instant, the last.
    pub fn at(&self, t: f64) -> Contact {
        let n = self.entries.partition_point(|entry| entry.from <= t);
        match n.checked_sub(1).and_then(|i| self.entries.get(i)) {
            Some(entry) => self.turned(self.whole(entry.kept), t),
            None => Contact::Open { armed: true },
        }
    }

    /// The closed state at `t`, its anchor counted from where the bases of its bodies are.
    pub fn since(&self, t: f64) -> Option<Closed> {
        let n = self.entries.partition_point(|entry| entry.from <= t);
        let entry = self.entries.get(n.checked_sub(1)?)?;
        self.turned(self.entered(entry.kept), t).closed().copied()
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

    /// Gives back the memory that more states would have taken.
    pub fn shrink(&mut self) {
        self.entries.shrink_to_fit();
        self.laws.shrink_to_fit();
        self.touches.shrink_to_fit();
        self.carried.shrink_to_fit();
        self.angles.shrink_to_fit();
    }
}
