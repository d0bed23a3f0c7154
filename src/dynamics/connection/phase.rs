//! Phases of a device.

use crate::language::Text;

/// State of a device: the branch of its law in force, and the memory of that branch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phase {
    /// Number of the branch in force, by the device's own count.
    pub branch: u32,
    /// Memory of the branch, its internal variables: a plastic displacement, an elongation at rupture (units of the device).
    pub memory: [f64; 3],
}

/// The state of a device that has no force any more.
pub const IS_BROKEN: Text = Text::new("state-broken");
