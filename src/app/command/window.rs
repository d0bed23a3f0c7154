//! Commands about the window itself.

use crate::app::command::edit::{BridgeDraft, RowDraft};

/// The window itself: its size, its dialogs, its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindowCommand {
    /// Size of everything, as a share of the usual one.
    Scale(f32),
    /// Light or dark.
    Theme(egui::Theme),
    /// Show the help, or not.
    Help(bool),
    /// Ask for the numbers of a row, or stop asking.
    AskRow(Option<RowDraft>),
    /// Other numbers for a new bridge.
    Bridge(BridgeDraft),
    /// Stop computing.
    CancelRun,
    /// The notice at the bottom has been read.
    Dismiss,
    /// Close the window; asks first when something is not saved.
    Close,
    /// Close the window and lose what is not saved.
    CloseAnyway,
    /// Open what was about to be opened, and lose what is not saved.
    GiveUp,
    /// Stay with the scene: do not close, open nothing.
    KeepOpen,
}
