//! Why there is no window, or none any more.

use crate::language::{Text, said};

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
pub enum AppError {
    /// There is no display to open a window on: work without one.
    #[error("{}", Text::new("window-no-display"))]
    NoDisplay,
    /// There is a display, but nothing that could draw on it.
    #[error("{}", said!("window-not-opened", "why" => .0.as_str()))]
    NoWindow(String),
    /// The window was open, and cannot go on.
    #[error("{}", ended(.why, *.kept))]
    Ended {
        /// Cause.
        why: String,
        /// Whether there was unsaved work; it is on the disk.
        kept: bool,
    },
}

fn ended(why: &str, kept: bool) -> String {
    if kept { said!("window-ended-kept", "why" => why) } else { said!("window-ended", "why" => why) }
}
