//! View of a run that is asked about its energy.

use crate::sim::History;

/// The energy ledger of a run at any time, and whether it balances.
#[derive(Clone, Copy, Debug)]
pub struct Energy<'a> {
    pub(super) history: &'a History,
}

impl History {
    /// Energy: its ledger at any time, and the balance at the end.
    pub fn energy(&self) -> Energy<'_> {
        Energy { history: self }
    }
}
