//! Commands about files.

use std::path::PathBuf;

/// Something to be written to a folder or file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Export {
    /// The picture in view, as PNG.
    Picture,
    /// Trajectory, contacts, events and summary.
    Tables,
    /// The run on one page, as HTML.
    Report,
}

/// Scene files, records, exports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileCommand {
    /// Open a preset.
    OpenPreset(String),
    /// Begin an empty scene.
    New,
    /// Ask which file to open.
    AskOpen,
    /// Open a file.
    Open(PathBuf),
    /// Ask which record shakes the ground.
    AskRecord,
    /// Shake the ground by the record in a file, given from the scene's own folder on.
    Record(PathBuf),
    /// Save where it came from, or ask.
    Save,
    /// Ask where to save.
    SaveAs,
    /// Save into a file.
    SaveTo(PathBuf),
    /// Ask where to, and export.
    AskExport(Export),
    /// Export to a file (picture, report) or folder (tables).
    Export(Export, PathBuf),
    /// Ask where to, and write the plots as `svg`, `png` or `csv`.
    AskPlots(&'static str),
    /// Write the plots into a file, in the format that its name ends in.
    Plots(PathBuf),
}

/// What is kept beside the scene: recent files, unsaved work, a file changed by another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Keep {
    /// Bring back the unsaved work that was found.
    Recover,
    /// Throw it away.
    Discard,
    /// Leave it where it is and ask again the next time.
    Later,
    /// Read the file again that another program has changed.
    Reload,
    /// Go on with the scene as it is here.
    KeepMine,
    /// Take a file from the list of recent ones.
    Forget(PathBuf),
    /// Forget all recent files.
    ForgetAll,
}
