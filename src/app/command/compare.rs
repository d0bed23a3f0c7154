//! Commands about runs that are kept to compare with.

/// Runs kept to compare with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompareCommand {
    /// Keep the run that is shown.
    Pin,
    /// Let a kept run go, by its number from 0.
    Unpin(usize),
    /// Let every kept run go.
    UnpinAll,
    /// Plot the differences from kept runs, or the runs themselves.
    Differences(bool),
}
