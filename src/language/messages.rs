//! Messages: a key with values, formatted in the language in use where they are shown.

use std::fmt;

use fluent_bundle::FluentArgs;

use super::{Language, Text, six};

/// A text with values in their places, as a [`Message`]: `message!("wrong-order", "name" => name, "most" => most)`.
macro_rules! message {
    ($key:literal, $($name:literal => $value:expr),+ $(,)?) => {
        $crate::language::Message::Told(
            $crate::language::Text::new($key),
            vec![$(($name, $crate::language::Message::from($value))),+],
        )
    };
}
pub(crate) use message;

/// Words that are spelled where they are shown, in the language that is in use there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Message {
    /// The same in every language: a name, a number, a line of a file.
    Plain(String),
    /// A text with its values.
    Told(Text, Vec<(&'static str, Message)>),
}

impl Message {
    /// The words that are the same in every language; none of a text.
    pub fn plain(&self) -> &str {
        match self {
            Self::Plain(words) => words,
            Self::Told(..) => "",
        }
    }

    /// Whether it is this text, with whatever values.
    pub fn is(&self, text: Text) -> bool {
        matches!(self, Self::Told(own, _) if *own == text)
    }

    /// The words in English, for files, which are read by other programs.
    pub fn english(&self) -> String {
        Language::English.within(|| self.to_string())
    }
}

impl serde::Serialize for Message {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.english())
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Plain(words) => f.write_str(words),
            Self::Told(text, values) if values.is_empty() => f.write_str(text.as_str()),
            Self::Told(text, values) => {
                let spelled: FluentArgs<'_> = values.iter().map(|(name, value)| (*name, value.to_string())).collect();
                f.write_str(&text.with(&spelled))
            }
        }
    }
}

impl From<Text> for Message {
    fn from(text: Text) -> Self {
        Self::Told(text, Vec::new())
    }
}

impl From<String> for Message {
    fn from(words: String) -> Self {
        Self::Plain(words)
    }
}

/// Words and numbers that are written alike in every language.
macro_rules! plain {
    ($($kind:ty),+) => {
        $(impl From<$kind> for Message {
            fn from(value: $kind) -> Self {
                Self::Plain(value.to_string())
            }
        })+
    };
}
plain!(&str, u32, u64, usize);

/// In the digits that people read.
impl From<f64> for Message {
    fn from(value: f64) -> Self {
        Self::Plain(six(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_in_the_language_in_which_it_is_shown() {
        let both = message!("found-both", "one" => Text::new("found-nothing"), "other" => 3.5);
        assert_eq!(both.to_string(), "nothing and 3.5", "in English");
        assert_eq!(Language::Japanese.within(|| both.to_string()), "なし と 3.5", "the value in it too");
        assert_eq!(Language::Japanese.within(|| both.english()), "nothing and 3.5", "English in files");
        assert_eq!(Message::from(0.1 + 0.2).plain(), "0.3", "digits that mean something");
        assert_eq!(both.plain(), "", "nothing that is the same everywhere");
        assert_eq!(Message::from("deck").plain(), "deck", "a name is");
    }
}
