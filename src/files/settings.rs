//! The user's settings for every window, kept from one start to the next.
//!
//! Settings that are missing, unreadable or nonsense are none: they never keep the program from starting.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::read::{LARGEST_INPUT, read_regular};
use super::save::{folder_of, write_atomic};
use super::write_error::WriteError;
use crate::language::Language;

/// Settings chosen in this window or an earlier one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Chosen {
    /// The language of its words.
    pub language: Option<Language>,
    /// Whether it is dark, or light.
    pub dark: Option<bool>,
    /// Size of everything, as a share of the usual one.
    pub scale: Option<f32>,
    /// Which panels are folded.
    pub folded: FoldedPanels,
}

/// Panels that were folded or opened by hand; the others fold as there is room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct FoldedPanels {
    /// List of bodies and devices, and numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub placed: Option<bool>,
    /// Sliders.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub what_if: Option<bool>,
    /// The words of a lesson.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lesson: Option<bool>,
    /// The plots.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plots: Option<bool>,
}

/// The settings, and the file that they are kept in.
#[derive(Debug, Default)]
pub struct Settings {
    file: PathBuf,
    chosen: Chosen,
}

/// The settings as they stand in their file.
#[derive(Default, Serialize, Deserialize)]
#[serde(default)]
struct Written {
    /// Code of the language.
    #[serde(skip_serializing_if = "Option::is_none")]
    language: Option<String>,
    /// `light` or `dark`.
    #[serde(skip_serializing_if = "Option::is_none")]
    theme: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    scale: Option<f32>,
    folded: FoldedPanels,
}

/// Words of the themes in the file.
const LIGHT: &str = "light";
const DARK: &str = "dark";

impl Settings {
    /// Reads the settings that are kept in a file.
    pub fn open(file: PathBuf) -> Self {
        let bytes = read_regular(&file, LARGEST_INPUT).unwrap_or_default();
        let written: Written = toml::from_slice(&bytes).unwrap_or_default();
        let dark = |theme: String| match theme.as_str() {
            LIGHT => Some(false),
            DARK => Some(true),
            _ => None,
        };
        let chosen = Chosen {
            language: written.language.and_then(|code| code.parse().ok()),
            dark: written.theme.and_then(dark),
            scale: written.scale.filter(|scale| scale.is_finite()).map(Self::scale_within),
            folded: written.folded,
        };
        Self { file, chosen }
    }

    /// The chosen settings.
    pub fn chosen(&self) -> &Chosen {
        &self.chosen
    }

    /// A size within the range in which a window can be read and worked in.
    pub fn scale_within(scale: f32) -> f32 {
        scale.clamp(0.5, 4.0)
    }

    /// Takes a choice for this window alone.
    pub fn choose(&mut self, chosen: Chosen) {
        self.chosen = chosen;
    }

    /// Keeps what was chosen.
    ///
    /// # Errors
    /// When the file cannot be written; it is chosen all the same.
    pub fn keep(&mut self, chosen: Chosen) -> Result<(), WriteError> {
        self.choose(chosen);
        let written = Written {
            language: chosen.language.map(|language| language.code().to_owned()),
            theme: chosen.dark.map(|dark| (if dark { DARK } else { LIGHT }).to_owned()),
            scale: chosen.scale,
            folded: chosen.folded,
        };
        let folder = folder_of(&self.file);
        std::fs::create_dir_all(folder).map_err(|cause| WriteError::new(folder, cause))?;
        write_atomic(&self.file, toml::to_string(&written).unwrap_or_default().as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_chosen_is_there_at_the_next_start() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("state/settings.toml");
        let mut settings = Settings::open(file.clone());
        assert_eq!(*settings.chosen(), Chosen::default(), "nothing chosen yet");
        for language in [Language::Japanese, Language::English] {
            for (dark, scale) in [(None, Some(1.5)), (Some(true), None), (Some(false), Some(2.0))] {
                let folded = FoldedPanels { placed: dark, plots: Some(scale.is_some()), ..FoldedPanels::default() };
                let chosen = Chosen { language: Some(language), dark, scale, folded };
                settings.keep(chosen).expect("written, folder and all");
                assert_eq!(*Settings::open(file.clone()).chosen(), chosen, "kept");
            }
        }
    }

    #[test]
    fn nonsense_is_no_choice() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("settings.toml");
        let nonsense = ["language = 3", "language = \"xx\"", "theme = \"blue\"", "scale = nan", "folded = 1", ""];
        for nonsense in nonsense.map(str::as_bytes).into_iter().chain([&b"\xff\xfe"[..]]) {
            std::fs::write(&file, nonsense).expect("written");
            let mut settings = Settings::open(file.clone());
            assert_eq!(*settings.chosen(), Chosen::default(), "nothing in {nonsense:?}");
            let chosen = Chosen { language: Some(Language::Japanese), ..Chosen::default() };
            settings.keep(chosen).expect("written over");
            assert_eq!(*Settings::open(file.clone()).chosen(), chosen, "good again");
        }
        std::fs::write(&file, "scale = 1e9").expect("written");
        assert_eq!(Settings::open(file.clone()).chosen().scale, Some(4.0), "as large as can be worked in");
    }
}
