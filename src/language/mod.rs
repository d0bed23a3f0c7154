//! The languages that the program speaks: which one is in use, and texts by their keys.
//!
//! The words are tables outside of the code, `assets/texts/*.ftl` in Project Fluent's syntax, for each language with the same
//! keys; what the keys of the scene file mean stands in English with these. A new language is its tables, a line in
//! [`Language`] and, where egui's fonts lack its letters, a font.

mod catalog;
mod digits;
mod letters;
mod messages;
mod text;

use std::cell::Cell;

pub(crate) use digits::six;
pub use fluent_bundle::FluentArgs;
#[cfg(feature = "render")]
pub use letters::JAPANESE_FONT;
pub use letters::is_japanese;
pub use messages::Message;
pub(crate) use messages::message;
#[cfg(test)]
pub(crate) use text::keys_of;
pub(crate) use text::said;
pub use text::{Text, own};

/// Values of a text by their names: `values!["name" => "deck", "count" => 3]`.
macro_rules! values {
    ($($name:literal => $value:expr),+ $(,)?) => {{
        let mut values = $crate::language::FluentArgs::new();
        $(values.set($name, $value);)+
        values
    }};
}
pub(crate) use values;

/// A language of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English, the one that every text has.
    #[default]
    English,
    /// Japanese.
    Japanese,
}

thread_local! {
    /// Language of the texts of this thread.
    static CURRENT: Cell<Language> = const { Cell::new(Language::English) };
}

impl Language {
    /// All of them, in the order of the menu.
    pub const ALL: [Self; 2] = [Self::English, Self::Japanese];

    /// Its code in BCP 47, as `--lang` takes it.
    pub const fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Japanese => "ja",
        }
    }

    /// Its own name for itself.
    pub const fn name(self) -> &'static str {
        match self {
            Self::English => "English",
            Self::Japanese => "日本語",
        }
    }

    /// The language of a locale as systems write it (`ja`, `ja-JP`, `ja_JP.UTF-8`).
    pub fn of_locale(locale: &str) -> Option<Self> {
        let language = locale.split(['-', '_', '.', '@']).next()?.to_ascii_lowercase();
        Self::ALL.into_iter().find(|known| known.code() == language)
    }

    /// The language of the system (of `LC_ALL`, `LC_CTYPE`, `LANG` where there are such); English where it is none of ours.
    pub fn of_system() -> Self {
        sys_locale::get_locale().and_then(|locale| Self::of_locale(&locale)).unwrap_or_default()
    }

    /// The language that texts of this thread are in; English until [`Language::speak`].
    pub fn current() -> Self {
        CURRENT.get()
    }

    /// Has the texts of this thread be in this language from now on.
    pub fn speak(self) {
        CURRENT.set(self);
    }

    /// Has the texts of this thread be in this language while something is done.
    pub fn within<T>(self, done: impl FnOnce() -> T) -> T {
        let before = CURRENT.replace(self);
        let made = done();
        before.speak();
        made
    }
}

impl std::str::FromStr for Language {
    type Err = String;

    fn from_str(code: &str) -> Result<Self, String> {
        Self::of_locale(code).ok_or_else(|| {
            let known: Vec<String> = Self::ALL.iter().map(|l| format!("{} ({})", l.code(), l.name())).collect();
            said!("wrong-language", "known" => known.join(", "))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locales_are_known_as_systems_write_them() {
        for locale in ["ja", "ja-JP", "ja_JP.UTF-8", "JA"] {
            assert_eq!(Language::of_locale(locale), Some(Language::Japanese), "{locale}");
        }
        assert_eq!(Language::of_locale("en_GB.UTF-8"), Some(Language::English), "English of anywhere");
        assert_eq!(Language::of_locale("C"), None, "the portable locale is no language");
        assert!("fr".parse::<Language>().is_err_and(|said| said.contains("ja (日本語)")), "says which there are");
    }
}
