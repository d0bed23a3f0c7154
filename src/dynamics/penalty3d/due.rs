//! Events of closed contacts and devices that are due within a planned step.

/// What ends a contact's state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::dynamics) enum Reason {
    /// δ returns to 0.
    Opening,
    /// Breakaway, or sliding stops.
    Switching,
    /// The projection leaves the polygon, or the node comes out behind the body.
    Edge,
    /// The normal force reaches 0, or leaves it, under `clamp`.
    Kink,
}

/// An event that is due.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct Due {
    /// Number of the contact in the island.
    pub number: usize,
    /// Which.
    pub reason: Reason,
}

/// End of a device's phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dynamics) struct LinkDue {
    /// Number of the link in the island.
    pub index: usize,
    /// Number of the switching function.
    pub switch: usize,
}
