//! View of a run that is asked about hits.

use crate::sim::History;

/// Touches of the contacts of a run, hits of its bodies, and their largest forces and impulses.
#[derive(Clone, Copy, Debug)]
pub struct Hits<'a> {
    pub(super) history: &'a History,
}

impl History {
    /// Hits: touches of contacts, forces between bodies, and the largest of them.
    pub fn hits(&self) -> Hits<'_> {
        Hits { history: self }
    }
}
