//! Words about panels that fold.

use crate::app::command::Pane;
use crate::language::{Text, values};

/// Name of a panel.
pub(in crate::app) fn pane(pane: Pane) -> &'static str {
    let words = match pane {
        Pane::Placed => Text::new("placed"),
        Pane::WhatIf => Text::new("what-if"),
        Pane::Lesson => Text::new("lesson"),
        Pane::Plots => super::PLOTS,
    };
    words.as_str()
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

/// A part of a link that has no sense.
pub(in crate::app) fn link_refused(part: &str) -> String {
    Text::new("link-refused").with(&values!["part" => part])
}

/// A button that folds a panel.
pub(in crate::app) fn fold(which: Pane) -> String {
    Text::new("fold").with(&values!["pane" => pane(which)])
}

/// A button that opens a folded panel.
pub(in crate::app) fn unfold(which: Pane) -> String {
    Text::new("unfold").with(&values!["pane" => pane(which)])
}
