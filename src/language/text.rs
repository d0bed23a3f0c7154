//! A text by its key.

use std::fmt;
use std::ops::Deref;

use fluent_bundle::{FluentArgs, FluentValue};

use super::Language;
use super::catalog::Catalog;
#[cfg(test)]
use super::catalog::{keys, tables};

/// A text with values in their places: `said!("gap-to", "name" => name, "gap" => gap)`.
macro_rules! said {
    ($key:literal, $($values:tt)+) => {
        $crate::language::Text::new($key).with(&$crate::language::values![$($values)+])
    };
}
pub(crate) use said;

/// A text in the language of the thread that asks for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Text(&'static str);

impl Text {
    /// The text of a key of the tables.
    pub const fn new(key: &'static str) -> Self {
        Self(key)
    }

    /// Its key, the same in every language.
    pub const fn key(self) -> &'static str {
        self.0
    }

    /// Its words. A text that takes values is had by [`Text::with`].
    pub fn as_str(self) -> &'static str {
        look(|catalog| catalog.words(self.0)).unwrap_or(self.0)
    }

    /// Its words with values in their places.
    pub fn with(self, values: &FluentArgs<'_>) -> String {
        look(|catalog| catalog.format(self.0, values)).unwrap_or_else(|| self.0.to_owned())
    }
}

/// In the current language; in English what that one lacks.
fn look<T>(find: impl Fn(&'static Catalog) -> Option<T>) -> Option<T> {
    find(Catalog::of(Language::current())).or_else(|| find(Catalog::of(Language::English)))
}

impl Deref for Text {
    type Target = str;

    fn deref(&self) -> &str {
        self.as_str()
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// In files texts are English.
impl serde::Serialize for Text {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(Language::English.within(|| self.as_str()))
    }
}

impl From<Text> for String {
    fn from(text: Text) -> Self {
        text.as_str().to_owned()
    }
}

impl From<Text> for FluentValue<'_> {
    fn from(text: Text) -> Self {
        text.as_str().into()
    }
}

/// The words that the language in use has under a key of its own; none in English, which has them where they are used.
pub fn own(key: &str) -> Option<&'static str> {
    Catalog::of(Language::current()).words(key)
}

/// Keys of one table of a language: `""`, `".keys"`.
#[cfg(test)]
pub(crate) fn keys_of(language: Language, table: &str) -> Vec<String> {
    let name = format!("{}{table}.ftl", language.code());
    let tables = tables(language).iter().filter(|(file, _)| *file == name);
    tables.flat_map(|(_, table)| keys(table)).map(str::to_owned).collect()
}
