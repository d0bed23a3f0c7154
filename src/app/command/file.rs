//! Commands about files.

use std::path::PathBuf;

use super::edit::BridgeDraft;
use super::film::FilmFormat;
use crate::scene::{GroundId, RecordMotion};

/// Something to be written to a folder or file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Export {
    /// The picture in view, as PNG.
    Picture,
    /// The view for paper, as PNG: larger, on white, without what is selected, kept runs and handles.
    Print,
    /// Trajectory, contacts, events and summary.
    Tables,
    /// The run on one page, as HTML.
    Report,
}

/// Purpose of a path that is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// A scene to open.
    Open,
    /// A record that shakes the ground.
    Record(GroundId),
    /// A record of the component of this number.
    Component(GroundId, usize),
    /// A file to save the scene in.
    Save,
    /// Where an export goes.
    Export(Export),
    /// Where the plots go, as `svg`, `png` or `csv`.
    Plots(&'static str),
    /// Where a film goes.
    Film(FilmFormat),
}

impl Wish {
    /// Extension of a new file; `None` of a folder, or of an existing file.
    pub(in crate::app) fn extension(self) -> Option<&'static str> {
        match self {
            Self::Open
            | Self::Record(_)
            | Self::Component(..)
            | Self::Export(Export::Tables)
            | Self::Film(FilmFormat::Png) => None,
            Self::Save => Some("toml"),
            Self::Export(Export::Picture | Export::Print) => Some("png"),
            Self::Export(Export::Report) => Some("html"),
            Self::Plots(format) => Some(format),
            Self::Film(FilmFormat::Gif) => Some("gif"),
        }
    }

    /// Suggested name of a new file of a scene of this name; `None` as [`extension`](Self::extension).
    pub(in crate::app) fn file_name(self, scene: &str) -> Option<String> {
        let what = match self {
            Self::Plots(_) => "-plots",
            Self::Export(Export::Print) => "-print",
            _ => "",
        };
        Some(format!("{scene}{what}.{}", self.extension()?))
    }

    /// Whether it is for something that is there already.
    pub(in crate::app) fn is_for_reading(self) -> bool {
        matches!(self, Self::Open | Self::Record(_) | Self::Component(..))
    }

    /// Whether it is for a folder.
    pub(in crate::app) fn is_for_folder(self) -> bool {
        self.extension().is_none() && !self.is_for_reading()
    }

    /// The path as it is meant: a new file has an extension.
    pub(in crate::app) fn complete(self, path: PathBuf) -> PathBuf {
        match self.extension() {
            Some(extension) if path.extension().is_none() => path.with_extension(extension),
            _ => path,
        }
    }
}

/// The path that is asked for in the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PathCommand {
    /// Ask for one here: the system has no dialog for it.
    Ask(Wish),
    /// Another text.
    Type(String),
    /// It is good; asks first when something would be replaced.
    Take,
    /// Do it all the same.
    Confirm,
    /// Do not.
    Leave,
    /// Whether paths are asked for here from now on, rather than by the system.
    Here(bool),
}

/// Scene files, records, exports.
#[derive(Clone, Debug, PartialEq)]
pub enum FileCommand {
    /// Open a preset.
    OpenPreset(String),
    /// Begin an empty scene.
    New,
    /// Begin a bridge.
    Build(BridgeDraft),
    /// Ask for a path, and do with it what it is asked for.
    Ask(Wish),
    /// The path that is asked for in the window.
    Path(PathCommand),
    /// Open a file.
    Open(PathBuf),
    /// Shake the ground by the record in a file, given from the scene's own folder on.
    Record(GroundId, PathBuf),
    /// Shake along the component of this number by the record in a file.
    Component(GroundId, usize, PathBuf),
    /// Shake by these records, whose files are read anew where something else is stated of them.
    Shake(GroundId, Box<RecordMotion>),
    /// Save where it came from, or ask.
    Save,
    /// Save into a file.
    SaveTo(PathBuf),
    /// Export to a file (picture, report) or folder (tables).
    Export(Export, PathBuf),
    /// Write the plots into a file, in the format that its name ends in.
    Plots(PathBuf),
    /// Show a folder in the system's own window of files.
    ShowFolder(PathBuf),
    /// Copy a link to the scene and the moment that are shown.
    CopyLink,
}

/// Commands on files beside the scene: recent files, unsaved work, a file changed by another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum KeepCommand {
    /// Bring back unsaved work that was found, by its number; the rest is asked about the next time.
    Recover(usize),
    /// Throw it away.
    Discard(usize),
    /// Leave all of it where it is and ask again the next time.
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
