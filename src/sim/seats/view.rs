//! View of a run that is asked about seats and what stands on them.

use crate::sim::History;

/// Seats of the girders of a run, their supports and how upright they stand, at any time and over the run.
#[derive(Clone, Copy, Debug)]
pub struct Seats<'a> {
    pub(super) history: &'a History,
}

impl History {
    /// Seats of girders: what remains of them, supports that are lost, bearings that lift.
    pub fn seats(&self) -> Seats<'_> {
        Seats { history: self }
    }
}
