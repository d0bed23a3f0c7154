//! `girderbench presets`: what comes with the program, a line each.

use super::console::Console;
use crate::scene::presets;

/// Lists the presets.
pub(super) fn run(console: &mut Console) {
    let width = presets::all().iter().map(|preset| preset.name.len()).max().unwrap_or(0);
    let lines = presets::all().iter().map(|preset| format!("{:<width$}  {}\n", preset.name, preset.summary));
    console.print(&lines.collect::<String>());
}
