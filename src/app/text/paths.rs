//! Words about paths: what they are asked for, and what is asked about them.

use crate::app::command::{Export, FilmFormat, Wish};

pub(in crate::app) const PATH: &str = "Path";
pub(in crate::app) const PATHS_HERE: &str = "Ask for paths in this window";
pub(in crate::app) const PATHS_HERE_HINT: &str = "Rather than in the dialogs of the system";
pub(in crate::app) const PATH_FOLDERS: &str = "Used lately:";
pub(in crate::app) const PATH_NEW: &str = "Nothing there begins so.";
pub(in crate::app) const PATH_EMPTY: &str = "Type a path.";
pub(in crate::app) const PATH_NOTHING: &str = "There is no such file";
pub(in crate::app) const PATH_NO_FOLDER: &str = "That is a file; a folder is asked for.";
pub(in crate::app) const PATH_REPLACE_ASK: &str = "This file is there already.";
pub(in crate::app) const PATH_REPLACE: &str = "Replace it";
pub(in crate::app) const PATH_AMONG_ASK: &str = "This folder is not empty; files of the same names are replaced.";
pub(in crate::app) const PATH_AMONG: &str = "Write into it";
pub(in crate::app) const PATH_MAKE_ASK: &str = "There is no such folder yet.";
pub(in crate::app) const PATH_MAKE: &str = "Make the folder";
pub(in crate::app) const SHOW_FOLDER: &str = "Show";
pub(in crate::app) const SHOW_FOLDER_HINT: &str = "Show the folder in the system's own window of files";
pub(in crate::app) const COPY_PATH: &str = "Copy path";
pub(in crate::app) const NO_FOLDER_WINDOW: &str = "This system has no program that shows folders. It is here";

/// What a path is asked for.
pub(in crate::app) fn wish(wish: Wish) -> &'static str {
    match wish {
        Wish::Open => "Open a scene",
        Wish::Record | Wish::Component(_) => "Choose a record",
        Wish::Save => "Save as",
        Wish::Export(Export::Picture) => "Export the picture",
        Wish::Export(Export::Tables) => "Export the tables into a folder",
        Wish::Export(Export::Report) => "Export the report",
        Wish::Plots(_) => "Export the plots",
        Wish::Film(FilmFormat::Gif) => "Film into a file",
        Wish::Film(FilmFormat::Png) => "Film into a folder",
    }
}

/// What the button says that takes the path.
pub(in crate::app) fn wish_done(wish: Wish) -> &'static str {
    match wish {
        Wish::Open => "Open it",
        Wish::Record | Wish::Component(_) => "Shake by it",
        Wish::Save => "Save it",
        Wish::Film(_) => "Film it",
        Wish::Export(_) | Wish::Plots(_) => "Write it",
    }
}
