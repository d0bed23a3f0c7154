//! Counts of the work of a run: searches, evaluations, steps.

/// Counts of the work of a run, by which tests hold that a scene costs no more than it needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Searches for the next closing of a pair, the next beginning of a link's force or the end of its phase in flight.
    pub searches: u64,
    /// Evaluations of the gaps of a pair in flight.
    pub looks: u64,
    /// Steps of integrators, retaken ones included.
    pub steps: u64,
}

impl std::ops::AddAssign for Effort {
    fn add_assign(&mut self, other: Self) {
        self.searches += other.searches;
        self.looks += other.looks;
        self.steps += other.steps;
    }
}
