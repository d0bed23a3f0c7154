//! View of a run that is asked about its contacts.

use crate::sim::History;

/// Forces of the contacts of a run at any time, and those that left the validity of their law.
#[derive(Clone, Copy, Debug)]
pub struct Contacts<'a> {
    pub(super) history: &'a History,
}

impl History {
    /// Contacts: their forces at any time, and those beyond the validity of their law.
    pub fn contacts(&self) -> Contacts<'_> {
        Contacts { history: self }
    }
}
