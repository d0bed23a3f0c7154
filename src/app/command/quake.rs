//! Commands about the window of the ground motion.

/// Histories and response spectrum of the ground motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuakeCommand {
    /// Show them, or not.
    Show(bool),
    /// Show the component of this number.
    Component(usize),
}
