//! View of a run that is asked about its elastic girders.

use crate::sim::History;

/// Section forces, stress and deformation of the elastic girders of a run, at any time and their largest.
#[derive(Clone, Copy, Debug)]
pub struct Sections<'a> {
    pub(super) history: &'a History,
}

impl History {
    /// Sections of elastic girders: forces, stress and deformation.
    pub fn sections(&self) -> Sections<'_> {
        Sections { history: self }
    }
}
