//! Fault of a value of a scene file, its place, and its text.

use toml::Value;

use crate::language::{Message, Text, message};
use crate::scene::SceneError;
use crate::scene::keys::{self, Range};
use crate::scene::shown::shown;

/// One step on the way from the top of the file to a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Step {
    /// Into a table.
    Key(String),
    /// Into a list, by number.
    Item(usize),
    /// Into a list of named tables, by name.
    Named(String),
}

impl Step {
    /// The step to an item of a list: by its name where it has one.
    pub(super) fn item(index: usize, value: &Value) -> Self {
        let name = value.get("name").and_then(Value::as_str);
        name.map_or(Self::Item(index), |name| Self::Named(name.to_owned()))
    }
}

/// Kind of a fault.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum What {
    /// A key that is not known here, and those that are.
    UnknownKey(String, &'static [&'static str]),
    /// A key that must be given.
    MissingKey(&'static str),
    /// A value of the wrong type, and what is expected.
    Type(String),
    /// A word that is not one of these.
    Word(&'static [&'static str]),
    /// Anything else.
    Wrong(String),
}

/// Fault of a value, with the path to it, collected from the inside out.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fault {
    what: What,
    value: Option<String>,
    way: Vec<Step>,
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.place(), self.remedy())
    }
}

impl Fault {
    pub(super) fn new(what: What) -> Self {
        Self { what, value: None, way: Vec::new() }
    }

    /// Notes the value in which the fault was met; the innermost stays.
    pub(super) fn found(mut self, value: &Value) -> Self {
        if self.value.is_none() && self.way.is_empty() {
            self.value = match &self.what {
                What::UnknownKey(key, _) => value.get(key).map(short),
                What::MissingKey(_) => None,
                _ => Some(short(value)),
            };
        }
        self
    }

    /// Adds the step by which the value was reached.
    pub(super) fn inside(mut self, step: Step) -> Self {
        self.way.push(step);
        self
    }

    fn place(&self) -> String {
        let mut place = String::new();
        for step in self.way.iter().rev() {
            match step {
                Step::Key(key) | Step::Named(key) => place = joined(&place, key),
                Step::Item(index) => place = format!("{place}[{index}]"),
            }
        }
        match &self.what {
            What::UnknownKey(key, _) => joined(&place, key),
            What::MissingKey(key) => joined(&place, key),
            _ => place,
        }
    }

    fn remedy(&self) -> Message {
        match &self.what {
            What::UnknownKey(key, known) => {
                message!("wrong-key", "meant" => did_you_mean(key, known), "known" => known.join(", "))
            }
            What::MissingKey(key) => match keys::of_place(&self.place()).map(|(_, known)| known.range) {
                Some(Range::Words(words)) => {
                    message!("wrong-missing-word", "key" => *key, "words" => quoted(words))
                }
                _ => message!("wrong-missing-key", "key" => *key),
            },
            What::Type(expected) => message!("wrong-type", "expected" => in_words(expected)),
            What::Word(words) => {
                let found = self.value.as_deref().unwrap_or_default().trim_matches('"');
                message!("wrong-word", "words" => quoted(words), "meant" => did_you_mean(found, words))
            }
            What::Wrong(message) => message.as_str().into(),
        }
    }

    /// The complaint about `file`.
    pub(super) fn complaint(&self, file: &str) -> SceneError {
        SceneError {
            file: file.to_owned(),
            place: self.place().into(),
            value: self.value.clone().map_or_else(|| Text::new("found-nothing").into(), Message::from),
            remedy: self.remedy(),
        }
    }
}

/// Words that may stand under a key, as they stand there.
fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}

fn joined(place: &str, key: &str) -> String {
    if place.is_empty() { key.to_owned() } else { format!("{place}.{key}") }
}

/// Characters of a value or a line that are shown.
pub(super) const LONGEST: usize = 60;

/// A value as it would stand in the file, cut where it gets long.
pub(super) fn short(value: &Value) -> String {
    shown(&value.to_string().replace('\n', " "), LONGEST)
}

/// serde names Rust's types; a user writes TOML.
fn in_words(expected: &str) -> Message {
    let number_of = expected.strip_prefix("an array of length ");
    match expected {
        "f64" | "f32" => Text::new("type-number").into(),
        "u32" | "usize" => Text::new("type-count").into(),
        "a sequence" => Text::new("type-list").into(),
        _ if expected.starts_with("struct ") => Text::new("type-table").into(),
        _ if expected.starts_with("enum ") => Text::new("type-word").into(),
        _ => number_of.map_or_else(|| expected.into(), |n| message!("type-list-of", "n" => n)),
    }
}

/// `; did you mean …` when one of the known words is near.
pub(crate) fn did_you_mean(word: &str, known: &[&str]) -> Message {
    // A word so long is none of them; the distance would take its length times theirs.
    if word.len() > 4 * LONGEST {
        return "".into();
    }
    let near = known.iter().map(|k| (distance(word, k), *k)).min();
    match near {
        Some((d, known)) if d <= 2.max(known.len() / 3) => message!("wrong-did-you-mean", "known" => known),
        _ => "".into(),
    }
}

/// Number of letters to add, drop or change (Levenshtein) to make `a` into `b`.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, to) in b.iter().enumerate() {
            let changed = diagonal + usize::from(from != *to);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
