//! What a run has done, counted.

/// What a run has done, counted: for seeing that what a scene does not need is left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Searches for the next touch of a pair.
    pub searches: u64,
    /// Looks at a pair in flight.
    pub looks: u64,
    /// Steps of integrators.
    pub steps: u64,
}

impl std::ops::AddAssign for Effort {
    fn add_assign(&mut self, other: Self) {
        self.searches += other.searches;
        self.looks += other.looks;
        self.steps += other.steps;
    }
}
