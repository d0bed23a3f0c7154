//! Commands about the window itself.

use crate::app::command::edit::{BridgeDraft, RowDraft};
use crate::language::Language;

/// A panel that can be folded to a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pane {
    /// List of bodies and devices, and numbers.
    Placed,
    /// Sliders and what the run is held against.
    WhatIf,
    /// The words of a lesson.
    Lesson,
    /// The plots under the timeline.
    Plots,
}

impl Pane {
    /// All of them.
    pub(in crate::app) const ALL: [Self; 4] = [Self::Placed, Self::WhatIf, Self::Lesson, Self::Plots];
}

/// The run that is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RunCommand {
    /// Stop computing.
    Cancel,
    /// Compute what was stopped.
    Again,
}

/// Appearance of the window; kept from one start to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AppearanceCommand {
    /// The language of its words.
    Language(Language),
    /// Light or dark.
    Theme(egui::Theme),
    /// Size of everything, as a share of the usual one.
    Scale(f32),
}

/// Leaving the scene that is worked on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeaveCommand {
    /// Close the window; asks first when something is not saved.
    Close,
    /// Close the window and lose what is not saved.
    CloseAnyway,
    /// Open what was about to be opened, and lose what is not saved.
    GiveUp,
    /// Stay with the scene: do not close, open nothing.
    Stay,
}

/// The window itself: its dialogs, its panels, its notice.
#[derive(Clone, Debug, PartialEq)]
pub enum WindowCommand {
    /// Show the help, or not.
    Help(bool),
    /// Ask for the numbers of a row, or stop asking.
    AskRow(Option<RowDraft>),
    /// Other numbers for a new bridge.
    Bridge(BridgeDraft),
    /// Fold a panel, or open it.
    Fold(Pane, bool),
    /// Fold every panel, or open all.
    FoldAll(bool),
    /// Tell the user something.
    Say(String),
    /// The notice at the bottom has been read.
    Dismiss,
}
