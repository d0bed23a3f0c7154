//! What the user has chosen for every window, kept from one start to the next.
//!
//! Settings that are missing, unreadable or nonsense are none: they never keep the program from starting.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::read::{LARGEST_INPUT, read_regular};
use super::save::{folder_of, write_atomic};
use super::write_error::WriteError;
use crate::language::Language;

/// The settings.
#[derive(Debug, Default)]
pub struct Settings {
    file: PathBuf,
    language: Option<Language>,
}

/// The settings as they stand in their file.
#[derive(Default, Serialize, Deserialize)]
#[serde(default)]
struct Written {
    /// Code of the language.
    #[serde(skip_serializing_if = "Option::is_none")]
    language: Option<String>,
}

impl Settings {
    /// Reads the settings that are kept in a file.
    pub fn open(file: PathBuf) -> Self {
        let bytes = read_regular(&file, LARGEST_INPUT).unwrap_or_default();
        let written: Written = toml::from_slice(&bytes).unwrap_or_default();
        Self { file, language: written.language.and_then(|code| code.parse().ok()) }
    }

    /// The language that was chosen, if one was.
    pub fn language(&self) -> Option<Language> {
        self.language
    }

    /// Keeps a chosen language.
    ///
    /// # Errors
    /// When the file cannot be written; the language is chosen all the same.
    pub fn set_language(&mut self, language: Language) -> Result<(), WriteError> {
        self.language = Some(language);
        let written = Written { language: Some(language.code().to_owned()) };
        let folder = folder_of(&self.file);
        std::fs::create_dir_all(folder).map_err(|cause| WriteError::new(folder, cause))?;
        write_atomic(&self.file, toml::to_string(&written).unwrap_or_default().as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chosen_language_is_there_at_the_next_start() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("state/settings.toml");
        let mut settings = Settings::open(file.clone());
        assert_eq!(settings.language(), None, "nothing chosen yet");
        for language in [Language::Japanese, Language::English] {
            settings.set_language(language).expect("written, folder and all");
            assert_eq!(Settings::open(file.clone()).language(), Some(language), "kept");
        }
    }

    #[test]
    fn nonsense_is_no_choice() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("settings.toml");
        for nonsense in [&b"language = 3"[..], b"\xff\xfe", b"language = \"xx\"", b""] {
            std::fs::write(&file, nonsense).expect("written");
            let mut settings = Settings::open(file.clone());
            assert_eq!(settings.language(), None, "nothing in {nonsense:?}");
            settings.set_language(Language::Japanese).expect("written over");
            assert_eq!(Settings::open(file.clone()).language(), Some(Language::Japanese), "good again");
        }
    }
}
