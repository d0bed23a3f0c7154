//! Commands about the run's numbers over the angle of the shaking.

/// The run's numbers over the angle of the shaking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngleCommand {
    /// Show them, or not.
    Show(bool),
    /// Compute them.
    Compute,
    /// Stop computing; what has come out stays.
    Cancel,
    /// Give the scene the angle of this number.
    Go(usize),
}
