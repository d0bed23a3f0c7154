//! What is said later: kept by its key and values, and spelled where it is shown.

use std::fmt;

use fluent_bundle::FluentArgs;

use super::Text;

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
plain!(&str, f64, u32, u64, usize);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Language;

    #[test]
    fn a_message_is_in_the_language_in_which_it_is_shown() {
        let both = message!("found-both", "one" => Text::new("found-nothing"), "other" => 3.5);
        assert_eq!(both.to_string(), "nothing and 3.5", "in English");
        assert_eq!(Language::Japanese.within(|| both.to_string()), "なし と 3.5", "the value in it too");
        assert_eq!(both.plain(), "", "nothing that is the same everywhere");
        assert_eq!(Message::from("deck").plain(), "deck", "a name is");
    }
}
