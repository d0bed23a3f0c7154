//! Events of closed contacts and devices within a planned step.

/// Event that ends the state of a closed contact (`docs/physics.md#contact-events`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::dynamics) enum Reason {
    /// Opening: δ returns to 0.
    Opening,
    /// Breakaway in stick, stop in slip.
    Switching,
    /// The projection leaves the polygon, or the node comes out behind the body.
    Edge,
    /// Beginning or end of a zero normal force under `clamp`, or the end of a phase of the normal law.
    Kink,
    /// The two bodies, which have met, overlap by more than any contact between them carries.
    Overlap,
}

/// Event of a closed contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct Due {
    /// Index of the contact in the island.
    pub index: usize,
    /// Kind of event.
    pub reason: Reason,
}

/// End of the phase of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dynamics) struct LinkDue {
    /// Index of the link in the island.
    pub index: usize,
    /// Number of the switching function.
    pub switch: usize,
}
