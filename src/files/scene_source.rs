//! Source of a scene: the text that it is saved into.

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::read::{LARGEST_INPUT, read_regular};
use crate::scene::presets;

/// Source of a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum SceneSource {
    /// Nothing: it was made in the program.
    #[default]
    New,
    /// A text that comes with the program: of a preset, of a lesson.
    Shipped(&'static str),
    /// A file.
    File(PathBuf),
    /// A text of no file of its own: of unsaved work that was brought back.
    Text(Arc<str>),
}

impl SceneSource {
    /// Source that [`load_scene`](super::load_scene) reads under this name: a preset where one has it, else a file.
    pub fn of(name_or_path: impl AsRef<Path>) -> Self {
        let path = name_or_path.as_ref();
        let preset = path.to_str().and_then(presets::get);
        preset.map_or_else(|| Self::File(path.into()), |preset| Self::Shipped(preset.text))
    }

    /// The file, if it is one.
    pub fn file(&self) -> Option<&Path> {
        if let Self::File(file) = self { Some(file) } else { None }
    }

    /// The text as it is now; nothing for a new scene, or where the file can no longer be read.
    pub(super) fn text(&self) -> Option<Cow<'_, str>> {
        match self {
            Self::New => None,
            Self::Shipped(text) => Some(Cow::Borrowed(text)),
            Self::File(file) => text_of(file).map(Cow::Owned),
            Self::Text(text) => Some(Cow::Borrowed(text)),
        }
    }
}

/// The text of a file; nothing where it cannot be read.
pub(super) fn text_of(file: &Path) -> Option<String> {
    String::from_utf8(read_regular(file, LARGEST_INPUT).ok()?).ok()
}
