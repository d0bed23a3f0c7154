//! The texts of the tables of keys in the language in use: English as it stands with the keys, another by keys of its own in
//! `assets/texts/*.keys.ftl`.
//!
//! A text that stands with several keys has one key of its own, under the first of them: `meaning-girder-length_m`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::index::TABLES;
use super::key::{Fallback, Key};
use super::range::Range;
use crate::language::{self, Language, Text, said};

/// Text of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Of {
    Meaning,
    Default,
    Range,
}

impl Of {
    fn label(self) -> &'static str {
        match self {
            Self::Meaning => "meaning",
            Self::Default => "default",
            Self::Range => "range",
        }
    }
}

impl Key {
    /// Meaning, in the language in use.
    pub fn meaning_told(&self) -> &'static str {
        told(Of::Meaning, self.meaning)
    }

    /// One of the words that may stand under it, in the language in use.
    pub fn word_told(&self, word: &'static str) -> &'static str {
        match self.range {
            Range::Words(words) => word_told(words, word),
            _ => word,
        }
    }
}

impl Fallback {
    /// Default as a text, in the language in use; `None` of a number.
    pub fn told(self) -> Option<&'static str> {
        match self {
            Self::Needed(words) | Self::Words(words) => Some(told(Of::Default, words)),
            _ => None,
        }
    }
}

impl Range {
    /// The rule in a few words of the language in use; `number` writes the limits.
    pub fn words(self, number: impl Fn(f64) -> String) -> String {
        match self {
            Self::Any => Text::new("range-any").into(),
            Self::Positive => said!("range-positive", "number" => number(0.0)),
            Self::NotNegative => said!("range-not-negative", "number" => number(0.0)),
            Self::NotBelow(key) => said!("range-not-below", "number" => number(0.0), "key" => key),
            Self::Within([low, high]) => said!("range-within", "low" => number(low), "high" => number(high)),
            Self::Between([low, high]) => said!("range-between", "low" => number(low), "high" => number(high)),
            Self::Words(words) => words.iter().map(|word| word_told(words, word)).collect::<Vec<_>>().join(", "),
            Self::Switch => Text::new("range-switch").into(),
            Self::Like(words) => told(Of::Range, words).into(),
            Self::Free => Text::new("range-free").into(),
        }
    }
}

/// One of the words of a list, in the language in use.
pub fn word_told(words: &'static [&'static str], word: &'static str) -> &'static str {
    if Language::current() == Language::English {
        return word;
    }
    WORDS.get(words).and_then(|first| language::own(&key("word", &[first.0, first.1, word]))).unwrap_or(word)
}

fn told(of: Of, english: &'static str) -> &'static str {
    if Language::current() == Language::English {
        return english;
    }
    TEXTS.get(&(of, english)).and_then(|key| language::own(key)).unwrap_or(english)
}

/// Every text of the tables with the key that another language has it under.
static TEXTS: LazyLock<BTreeMap<(Of, &'static str), String>> = LazyLock::new(|| {
    let mut texts = BTreeMap::new();
    for table in TABLES {
        for one in table.keys {
            let mut note = |of: Of, text| {
                texts.entry((of, text)).or_insert_with(|| key(of.label(), &[table.path, one.name]));
            };
            note(Of::Meaning, one.meaning);
            if let Range::Like(text) = one.range {
                note(Of::Range, text);
            }
            if let Fallback::Words(text) | Fallback::Needed(text) = one.fallback {
                note(Of::Default, text);
            }
        }
    }
    texts
});

/// Every list of words with the table and the key where it stands first.
static WORDS: LazyLock<BTreeMap<&'static [&'static str], (&'static str, &'static str)>> = LazyLock::new(|| {
    let mut lists = BTreeMap::new();
    for table in TABLES {
        for one in table.keys {
            if let Range::Words(words) = one.range {
                lists.entry(words).or_insert((table.path, one.name));
            }
        }
    }
    lists
});

/// The key of a text: its steps with no other signs than Fluent's keys have.
fn key(of: &str, steps: &[&str]) -> String {
    let mut key = of.to_owned();
    for step in steps {
        let step = step.replace("[]", " each").replace('+', "plus ");
        let signed = step.strip_prefix('-').map(|rest| format!("minus {rest}"));
        let step = signed.as_deref().unwrap_or(&step);
        for word in step.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| !word.is_empty()) {
            key.push('-');
            key.push_str(word);
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Whether a text has a word, and is no formula or number alone.
    fn has_word(text: &str) -> bool {
        text.as_bytes().windows(2).any(|pair| pair.iter().all(u8::is_ascii_alphabetic))
    }

    #[test]
    fn every_text_of_the_tables_is_there_in_every_language_and_no_other() {
        let texts = TEXTS.iter().filter(|((_, text), _)| has_word(text)).map(|(_, key)| key.clone());
        let words = WORDS.iter().flat_map(|(words, first)| {
            words.iter().filter(|word| has_word(word)).map(|word| key("word", &[first.0, first.1, word]))
        });
        let wanted: BTreeSet<String> = texts.chain(words).collect();
        for language in Language::ALL.into_iter().filter(|language| *language != Language::English) {
            let there: BTreeSet<String> = language::keys_of(language, ".keys").into_iter().collect();
            let missing: Vec<_> = wanted.difference(&there).collect();
            let more: Vec<_> = there.difference(&wanted).collect();
            assert!(missing.is_empty() && more.is_empty(), "{}: lacks {missing:?}, has {more:?}", language.code());
            language.within(|| {
                let empty: Vec<_> = wanted.iter().filter(|key| language::own(key).is_none_or(str::is_empty)).collect();
                assert!(empty.is_empty(), "{}: not read: {empty:?}", language.code());
            });
        }
    }

    #[test]
    fn english_stands_as_it_is_in_the_tables() {
        assert_eq!(told(Of::Meaning, "mass, kg"), "mass, kg", "in English");
        Language::Japanese.within(|| {
            assert_eq!(told(Of::Meaning, "mass, kg"), "質量, kg");
            assert_eq!(told(Of::Meaning, "no text of a table"), "no text of a table", "what is not there stays");
        });
    }
}
