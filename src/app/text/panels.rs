//! Words about panels that fold.

use crate::app::command::Pane;

/// What a panel is called.
pub(in crate::app) fn pane(pane: Pane) -> &'static str {
    match pane {
        Pane::Placed => "Placed",
        Pane::WhatIf => "What if",
        Pane::Lesson => "Lesson",
        Pane::Plots => "Plots",
    }
}

/// The key that folds a panel and opens it.
pub(in crate::app) fn pane_key(pane: Pane) -> &'static str {
    match pane {
        Pane::Placed => "F2",
        Pane::WhatIf => "F3",
        Pane::Plots => "F4",
        Pane::Lesson => "F5",
    }
}

/// A button that folds a panel.
pub(in crate::app) fn fold(which: Pane) -> String {
    format!("Fold: {}", pane(which))
}

/// A button that opens a folded panel.
pub(in crate::app) fn unfold(which: Pane) -> String {
    format!("Show: {}", pane(which))
}
