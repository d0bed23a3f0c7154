//! Commands about what is selected.

use crate::view::Target;

/// Commands on the selection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SelectCommand {
    /// Select this alone, or nothing.
    Only(Option<Target>),
    /// Select this beside what is selected, or let go of it.
    Also(Target),
    /// Select every girder and abutment.
    All,
}
