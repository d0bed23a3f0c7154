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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::normal::Linear;
    use crate::contact::{FrictionLaw, Normal};
    use crate::dynamics::integrator::dense_output::DENSE_TERMS;

    fn law(stiffness: f64) -> Law {
        let normal = Normal::Linear(Linear { k: stiffness, c: 0.0 });
        let friction = FrictionLaw::ReturnMapping;
        Law {
            normal,
            k_t: stiffness,
            c_t: 0.0,
            mu_s: 0.5,
            mu_k: 0.4,
            friction: friction.into(),
            clamp: false,
            v_stick: 1e-6,
        }
    }

    fn stick(x: f64) -> ClosedContact {
        ClosedContact::new(law(1e5), Mode::Stick { anchor: DVec2::new(x, 0.0) }, 0.0)
    }

    fn slip(stiffness: f64, regularisation: f64) -> ClosedContact {
        ClosedContact::new(law(stiffness), Mode::Slip { direction: DVec2::Y }, regularisation)
    }

    const ARMED: Contact = Contact::Open { armed: true };
    const WAY: DVec2 = DVec2::new(0.25, -0.5);

    #[test]
    fn a_state_holds_from_its_entry_on_and_of_several_at_one_time_the_last() {
        let mut log = ContactLog::default();
        assert_eq!((log.at(1.0), log.since(1.0), log.latest()), (ARMED, None, None), "before any entry it is open");
        log.push(1.0, Contact::Closed(slip(1e5, 0.0)), DVec2::ZERO);
        log.push(2.0, ARMED, DVec2::ZERO);
        log.push(2.0, Contact::Open { armed: false }, DVec2::ZERO);
        log.push(3.0, Contact::Closed(slip(1e5, 0.0)), DVec2::ZERO);
        let states = [0.9, 1.0, 1.9, 2.0, 2.9, 3.0].map(|t| log.at(t));
        let (disarmed, closed) = (Contact::Open { armed: false }, Contact::Closed(slip(1e5, 0.0)));
        assert_eq!(states, [ARMED, closed, closed, disarmed, disarmed, closed]);
        assert_eq!(log.beginnings(1.0, 2.0), [1.0, 2.0, 2.0], "both ends included");
        assert_eq!(log.beginnings(2.1, 2.9), [0.0; 0]);
        assert_eq!((log.latest(), log.closed(1), log.closed(3)), (Some(3), None, Some(slip(1e5, 0.0))));
    }

    #[test]
    fn an_anchor_is_relative_to_the_placed_poses_or_to_the_reference_poses_as_asked() {
        let mut log = ContactLog::default();
        log.push(0.0, Contact::Closed(stick(1e-3)), WAY);
        let Contact::Closed(ClosedContact { mode, .. }) = log.at(0.5) else { panic!("closed") };
        assert_eq!(mode, Mode::Stick { anchor: WAY + DVec2::X * 1e-3 }, "since placed");
        assert_eq!(log.since(0.5), Some(stick(1e-3)), "since the reference poses");
        assert_eq!(log.way(), WAY);
        let (from, whole) = log.states().next().expect("one state");
        assert_eq!((from, whole), (0.0, log.at(0.0)));
    }

    #[test]
    fn laws_touches_and_vectors_that_repeat_are_stored_once_and_read_back_as_entered() {
        let mut log = ContactLog::default();
        let entered = [stick(1e-3), slip(1e5, 0.0), slip(1e5, 0.0), slip(2e5, 0.0), slip(2e5, 1e-9)];
        for (i, closed) in (0u32..).zip(entered) {
            log.push(f64::from(i), Contact::Closed(closed), DVec2::ZERO);
        }
        for (i, closed) in (0u32..).zip(entered) {
            assert_eq!(log.closed(i), Some(closed), "state {i}");
        }
        assert_eq!((log.laws.len(), log.touches.len(), log.vectors.len()), (3, 3, 2));
        // An anchor of −0 is another one than that of 0, bit for bit.
        log.push(5.0, Contact::Closed(stick(0.0)), DVec2::ZERO);
        log.push(6.0, Contact::Closed(stick(-0.0)), DVec2::ZERO);
        assert_eq!(log.vectors.len(), 4);
    }

    #[test]
    fn flags_of_a_closed_state_are_kept() {
        let mut log = ContactLog::default();
        for (held_at_zero, passing_stop) in [(true, false), (false, true)] {
            let mut closed = slip(1e5, 0.0);
            (closed.held_at_zero, closed.solver.passing_stop) = (held_at_zero, passing_stop);
            log.push(0.0, Contact::Closed(closed), DVec2::ZERO);
            assert_eq!(log.at(0.0), Contact::Closed(closed));
        }
    }

    #[test]
    fn a_slip_that_turns_is_read_from_the_step_at_its_time() {
        let mut log = ContactLog::default();
        log.push(0.0, Contact::Closed(slip(1e5, 1e-9)), DVec2::ZERO);
        let turning = |from: f64, first: f64, change: f64| {
            let mut coefficients = [0.0; DENSE_TERMS];
            (coefficients[0], coefficients[1]) = (first, change);
            (from, DenseOutput::new(from, 1.0, vec![coefficients]))
        };
        log.angles = vec![turning(1.0, 0.2, 0.4), turning(2.0, 0.6, -0.8)];
        for (t, angle) in [(1.0, 0.2), (1.5, 0.4), (2.0, 0.6), (2.25, 0.4)] {
            let Contact::Closed(ClosedContact { mode: Mode::Slip { direction }, .. }) = log.at(t) else {
                panic!("a slip")
            };
            assert!((direction - DVec2::from_angle(angle)).length() < 1e-15, "{direction} at {t} s");
        }
        let before = log.since(0.5).expect("closed");
        assert_eq!(before.mode, Mode::Slip { direction: DVec2::Y }, "before the first step as it began");
        log.push(3.0, Contact::Closed(slip(1e5, 0.0)), DVec2::ZERO);
        assert_eq!(log.at(3.5), Contact::Closed(slip(1e5, 0.0)), "a slip without regularisation does not turn");
    }

    #[test]
    fn its_memory_grows_with_each_state_by_what_that_stores() {
        let mut log = ContactLog::default();
        assert_eq!(log.bytes(), 0);
        log.push(0.0, ARMED, DVec2::ZERO);
        let open = log.bytes();
        log.push(1.0, ARMED, DVec2::ZERO);
        assert_eq!(log.bytes(), 2 * open, "an open state stores nothing more");
        log.angles.push((0.0, DenseOutput::new(0.0, 1.0, vec![[0.0; DENSE_TERMS]])));
        let angle = size_of::<(f64, DenseOutput)>() + 8 * DENSE_TERMS;
        assert_eq!(log.bytes(), 2 * open + angle);
        log.shrink();
        assert_eq!((log.bytes(), log.at(1.0)), (2 * open + angle, ARMED));
    }
}
