//! A folder shown in the system's own window of files.

use std::path::Path;
use std::process::{Command, Stdio};

use crate::app::host::Told;
use crate::app::text;

/// The program that shows folders.
const PROGRAM: &str = if cfg!(target_os = "macos") {
    "open"
} else if cfg!(target_os = "windows") {
    "explorer"
} else {
    "xdg-open"
};

/// Shows a folder, or the one that a file is in; has nothing to tell when that was done.
///
/// # Errors
/// In words: the system has no program for it, or it has failed.
pub(super) fn show(place: &Path) -> Result<Told, String> {
    let folder = if place.is_dir() { place } else { place.parent().unwrap_or(place) };
    let quiet = || Stdio::null();
    let ended = Command::new(PROGRAM).arg(folder).stdin(quiet()).stdout(quiet()).stderr(quiet()).status();
    // The explorer's status says nothing.
    let shown = ended.is_ok_and(|status| status.success() || cfg!(target_os = "windows"));
    if shown { Ok(Told::default()) } else { Err(format!("{}: {}", text::NO_FOLDER_WINDOW, folder.display())) }
}
