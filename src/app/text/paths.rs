//! Words about paths: what they are asked for, and what is asked about them.

use crate::app::command::{Export, FilmFormat, Wish};
use crate::language::{Text, values};

/// That a file is being written.
pub(in crate::app) fn is_writing(name: &str) -> String {
    Text::new("is-writing").with(&values!["name" => name])
}

pub(in crate::app) const PATH: Text = Text::new("path");
pub(in crate::app) const PATHS_HERE: Text = Text::new("paths-here");
pub(in crate::app) const PATHS_HERE_HINT: Text = Text::new("paths-here-hint");
pub(in crate::app) const PATH_FOLDERS: Text = Text::new("path-folders");
pub(in crate::app) const PATH_NEW: Text = Text::new("path-new");
pub(in crate::app) const PATH_EMPTY: Text = Text::new("path-empty");
pub(in crate::app) const PATH_NOTHING: Text = Text::new("path-nothing");
pub(in crate::app) const PATH_NO_FOLDER: Text = Text::new("path-no-folder");
pub(in crate::app) const PATH_REPLACE_ASK: Text = Text::new("path-replace-ask");
pub(in crate::app) const PATH_REPLACE: Text = Text::new("path-replace");
pub(in crate::app) const PATH_AMONG_ASK: Text = Text::new("path-among-ask");
pub(in crate::app) const PATH_AMONG: Text = Text::new("path-among");
pub(in crate::app) const PATH_MAKE_ASK: Text = Text::new("path-make-ask");
pub(in crate::app) const PATH_MAKE: Text = Text::new("path-make");
pub(in crate::app) const SHOW_FOLDER: Text = Text::new("show-folder");
pub(in crate::app) const SHOW_FOLDER_HINT: Text = Text::new("show-folder-hint");
pub(in crate::app) const COPY_PATH: Text = Text::new("copy-path");
pub(in crate::app) const NO_FOLDER_WINDOW: Text = Text::new("no-folder-window");

/// Text on the purpose of a path.
pub(in crate::app) fn wish(wish: Wish) -> &'static str {
    let words = match wish {
        Wish::Open => Text::new("wish-open"),
        Wish::Record(_) | Wish::Component(..) => Text::new("wish-record"),
        Wish::Save => Text::new("wish-save"),
        Wish::Export(Export::Print) => Text::new("wish-print"),
        Wish::Export(Export::Picture) => Text::new("wish-picture"),
        Wish::Export(Export::Tables) => Text::new("wish-tables"),
        Wish::Export(Export::Report) => Text::new("wish-report"),
        Wish::Plots(_) => Text::new("wish-plots"),
        Wish::Film(FilmFormat::Gif) => Text::new("wish-film-file"),
        Wish::Film(FilmFormat::Png) => Text::new("wish-film-folder"),
    };
    words.as_str()
}

/// Label of the button that takes the path.
pub(in crate::app) fn wish_done(wish: Wish) -> &'static str {
    let words = match wish {
        Wish::Open => Text::new("done-open"),
        Wish::Record(_) | Wish::Component(..) => Text::new("done-record"),
        Wish::Save => Text::new("done-save"),
        Wish::Film(_) => Text::new("done-film"),
        Wish::Export(_) | Wish::Plots(_) => Text::new("done-write"),
    };
    words.as_str()
}
