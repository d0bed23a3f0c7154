//! Bounds that end a run: of its work, of its memory, and of a pace at which neither would be enough.

use crate::dynamics::event_loop::constants::{
    MEMORY_SHARE_OF_GROUP, PACE_SHARE, STEADY, WORK_BETWEEN_LOOKS, WORK_BOUND_PER_BODY, WORK_OVERRUN,
};
use crate::language::{Message, message};

/// Cost of a run.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Spent {
    /// Handled events, and what a search that ended at its bound of advances counts for \[–\].
    pub work: usize,
    /// Memory of stored steps and events \[bytes\].
    pub bytes: usize,
    /// The most that the whole run may take of it \[bytes\].
    pub memory: usize,
    /// Events of contacts so far.
    pub events: usize,
    /// Whether a contact is closed now.
    pub touches: bool,
    /// Time \[s\].
    pub t: f64,
    /// Length of the run \[s\].
    pub duration: f64,
    /// Bodies of the group, and of the model.
    pub bodies: [usize; 2],
}

/// A bound that a run has exceeded, with what it has spent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) enum ExceededBound {
    /// That of its work.
    Work { done: usize },
    /// That of its memory \[bytes\].
    Memory { taken: usize, most: usize },
    /// That of the work that is to be expected until the end, after what was done since `from` \[s\].
    Pace { from: f64, done: usize, expected: f64 },
}

/// A state of a run from which its pace is measured.
#[derive(Clone, Copy, Debug, Default)]
struct PaceMark {
    work: usize,
    /// \[s\].
    t: f64,
    events: usize,
}

/// The bounds of the run of one group of bodies.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct WorkBounds {
    /// Work at which the bounds are looked at next.
    due: usize,
    /// From where the pace is measured.
    pace: PaceMark,
}

impl WorkBounds {
    /// Whether the bounds are to be looked at after so much work.
    pub(in crate::dynamics) fn is_due(&self, work: usize) -> bool {
        work >= self.due
    }

    /// The one that is exceeded.
    pub(in crate::dynamics) fn exceeded(&mut self, spent: &Spent) -> Option<ExceededBound> {
        let most = WORK_BOUND_PER_BODY.saturating_mul(spent.bodies[0]);
        self.due = (spent.work + WORK_BETWEEN_LOOKS).min(most + 1);
        let [own, all] = spent.bodies;
        let memory = (spent.memory / all.max(1)).saturating_mul(own).max(spent.memory / MEMORY_SHARE_OF_GROUP);
        if spent.work > most {
            Some(ExceededBound::Work { done: spent.work })
        } else if spent.bytes > memory {
            Some(ExceededBound::Memory { taken: spent.bytes, most: memory })
        } else {
            self.by_pace(spent, most)
        }
    }

    /// The work that is expected until the end, where a run that keeps its pace exceeds its bound by far, or, without contact, comes
    /// near it.
    fn by_pace(&mut self, spent: &Spent, most: usize) -> Option<ExceededBound> {
        let from = self.pace;
        let done = spent.work - from.work;
        if done < most / PACE_SHARE {
            return None;
        }
        self.pace = PaceMark { work: spent.work, t: spent.t, events: spent.events };
        let bound = if spent.touches || spent.events > from.events { WORK_OVERRUN } else { STEADY };
        let expected = done as f64 / (spent.t - from.t) * (spent.duration - spent.t);
        (expected > bound * most as f64).then_some(ExceededBound::Pace { from: from.t, done, expected })
    }
}

impl ExceededBound {
    /// It in words.
    pub(in crate::dynamics) fn spent(self) -> Message {
        match self {
            Self::Memory { taken, most } => {
                let [bytes, most] = [taken, most].map(|bytes| format!("{:.0}", bytes as f64 / f64::from(1 << 20)));
                message!("stop-memory", "bytes" => bytes, "most" => most)
            }
            Self::Pace { from, done, expected } if expected.is_infinite() => {
                message!("stop-stands", "done" => done, "at" => format!("{from:e}"))
            }
            Self::Pace { from, done, expected } => {
                let [from, expected] = [format!("{from:e}"), format!("{expected:.0e}")];
                message!("stop-pace", "done" => done, "from" => from, "expected" => expected)
            }
            Self::Work { done } => message!("stop-work", "work" => done),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEMORY: usize = 1 << 30;
    const BODY: Spent =
        Spent { work: 0, bytes: 0, memory: MEMORY, events: 0, touches: true, t: 0.0, duration: 10.0, bodies: [1, 1] };

    #[test]
    fn work_is_bounded_to_the_step() {
        let mut bounds = WorkBounds::default();
        let at = |work| Spent { work, t: 9.0, ..BODY };
        assert_eq!(bounds.exceeded(&at(WORK_BOUND_PER_BODY)), None, "as much as is allowed");
        assert!(bounds.is_due(WORK_BOUND_PER_BODY + 1), "the next one is looked at");
        let words = bounds.exceeded(&at(WORK_BOUND_PER_BODY + 1)).expect("one more").spent().to_string();
        assert!(words.contains("exceed the bound on the work"), "{words}");
        let two = Spent { bodies: [2, 2], ..at(WORK_BOUND_PER_BODY + 1) };
        assert_eq!(WorkBounds::default().exceeded(&two), None, "two bodies");
    }

    #[test]
    fn memory_is_bounded_by_the_share_of_the_group() {
        let over = |bytes, bodies| WorkBounds::default().exceeded(&Spent { bytes, bodies, ..BODY }).is_some();
        assert!(!over(MEMORY, [1, 1]) && over(MEMORY + 1, [1, 1]), "the whole of it alone");
        assert!(!over(MEMORY / 2, [1, 2]) && over(MEMORY / 2 + 1, [1, 2]), "a half of two");
        assert!(!over(MEMORY / MEMORY_SHARE_OF_GROUP, [1, 1000]), "a little for each");
    }

    #[test]
    fn a_pace_that_leads_nowhere_is_told_from_a_dense_stretch() {
        let window = WORK_BOUND_PER_BODY / PACE_SHARE;
        let pace = |t| WorkBounds::default().exceeded(&Spent { work: window, t, ..BODY }).is_some();
        let dense = window as f64 * BODY.duration / (WORK_OVERRUN * WORK_BOUND_PER_BODY as f64);
        assert!(!pace(1.01 * dense) && pace(0.99 * dense), "a thousand bounds until the end");
        let mut bounds = WorkBounds::default();
        assert_eq!(bounds.exceeded(&Spent { work: window - 1, t: 1e-12, ..BODY }), None, "too short to tell");
        let words = bounds.exceeded(&Spent { work: window, t: 1e-12, ..BODY }).expect("now").spent().to_string();
        assert!(words.contains("at this pace"), "{words}");
        let stands = WorkBounds::default().exceeded(&Spent { work: window, ..BODY }).expect("it stands");
        assert!(stands.spent().to_string().contains("without getting on"), "{}", stands.spent());
        assert!(!pace(BODY.duration), "at the end nothing is left");
    }

    #[test]
    fn without_contact_a_pace_is_not_taken_for_a_dense_stretch() {
        let window = WORK_BOUND_PER_BODY / PACE_SHARE;
        // Until here the whole takes as much as the bound.
        let t = BODY.duration / PACE_SHARE as f64;
        let exceeds = |spent| WorkBounds::default().exceeded(&Spent { work: window, t, ..spent }).is_some();
        assert!(exceeds(Spent { touches: false, ..BODY }), "nothing touches");
        assert!(!exceeds(Spent { touches: false, events: 1, ..BODY }) && !exceeds(BODY), "something has, or does");
        assert!(
            WorkBounds::default().exceeded(&Spent { work: window, t: 5.0 * t, touches: false, ..BODY }).is_none(),
            "a fifth"
        );
    }
}
