//! View of a run that is asked about bearings, devices, soil and piers.

use crate::sim::History;

/// State and force of the bearings, devices, soil and piers of a run, at any time and their largest.
#[derive(Clone, Copy, Debug)]
pub struct Connections<'a> {
    pub(super) history: &'a History,
}

impl History {
    /// Connections of bodies: bearings, devices, soil behind backwalls, and piers.
    pub fn connections(&self) -> Connections<'_> {
        Connections { history: self }
    }
}
