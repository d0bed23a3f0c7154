//! Commands that change the scene.

use crate::scene::DeviceKind;
use crate::scene::edit::Edit;
use crate::view::Target;

/// A change of the scene, and the way back.
#[derive(Clone, Debug)]
pub enum EditCommand {
    /// Change the scene. Edits with the same gesture, one after the other, are undone together.
    Change {
        /// The change.
        edit: Edit,
        /// Number of the gesture, such as a drag of a slider; none for a click.
        gesture: Option<u64>,
    },
    /// Take the last change back.
    Undo,
    /// Make it again.
    Redo,
    /// Give something another name.
    Rename(Target, String),
}

/// Adding, copying, moving and removing bodies.
#[derive(Clone, Debug)]
pub enum PlaceCommand {
    /// Put something new where the mouse is.
    Put(Edit),
    /// Put a new girder after the last one.
    AddGirder,
    /// Put an abutment before a free end.
    AddAbutment,
    /// Put a pier under a joint.
    AddPier,
    /// Put a new device of this kind at the girder that is selected, or the first.
    AddDevice(DeviceKind),
    /// Put a copy of what is selected beside it.
    Duplicate,
    /// Make a row of the girder that is selected.
    Array(RowDraft),
    /// Move and turn what is selected by a little.
    Nudge(Nudge),
    /// Remove what is selected.
    Remove,
}

/// A small displacement and rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nudge {
    /// Along the world's x and y \[m\].
    pub way: [f64; 2],
    /// Anticlockwise seen from above \[degrees\].
    pub turn_deg: f64,
}

/// Numbers that a new bridge begins with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BridgeDraft {
    /// Length of each span \[m\].
    pub span: f64,
    /// Width of the deck, square to its axis \[m\].
    pub width: f64,
    /// Angle between axis and support line; 90 is straight \[degrees\].
    pub skew_deg: f64,
    /// Spans between two abutments.
    pub spans: usize,
}

impl Default for BridgeDraft {
    fn default() -> Self {
        Self { span: 30.0, width: 10.0, skew_deg: 60.0, spans: 2 }
    }
}

/// Numbers of a row of equal spans.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowDraft {
    /// Girders in the row, the selected one among them.
    pub spans: usize,
    /// Gap between neighbours \[m\].
    pub gap: f64,
}
