//! A key of the scene file: its rule, its default, its meaning, its field in the window.

use super::range::Range;

/// Value of a key that is not in the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fallback {
    /// The file must have it, or another key in its place: how, in words.
    Needed(&'static str),
    /// This number, in the unit of the key.
    Number(f64),
    /// So many zeros.
    Zeros(usize),
    /// This word.
    Word(&'static str),
    /// On or off.
    Switch(bool),
    /// Something that is reckoned from other values, or nothing at all: what, in words.
    Words(&'static str),
}

/// A key of the scene file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// As it stands in the file.
    pub name: &'static str,
    /// Allowed values.
    pub range: Range,
    /// Value without the key.
    pub fallback: Fallback,
    /// Meaning, with the unit.
    pub meaning: &'static str,
    /// The text that says what its field in the window is called; none: the name itself.
    pub label: Option<&'static str>,
    /// From where to where its slider goes, in the unit of the key; what is typed may lie beyond. None: no slider.
    pub slider: Option<[f64; 2]>,
    /// Whether a planar scene has no such quantity.
    pub spatial: bool,
}

impl Key {
    pub(in crate::scene) const fn new(
        name: &'static str,
        range: Range,
        fallback: Fallback,
        meaning: &'static str,
    ) -> Self {
        Self { name, range, fallback, meaning, label: None, slider: None, spatial: false }
    }

    /// The key with a name for its field, the key of a text.
    pub(in crate::scene) const fn labelled(self, label: &'static str) -> Self {
        Self { label: Some(label), ..self }
    }

    /// The key with a slider between these bounds.
    pub(in crate::scene) const fn slid(self, bounds: [f64; 2]) -> Self {
        Self { slider: Some(bounds), ..self }
    }

    /// The key of a quantity that only spatial scenes have.
    pub(in crate::scene) const fn in_space(self) -> Self {
        Self { spatial: true, ..self }
    }

    /// The number that it is when the file does not have it, where that is always the same.
    pub fn number(&self) -> Option<f64> {
        match self.fallback {
            Fallback::Number(number) => Some(number),
            Fallback::Zeros(_) => Some(0.0),
            _ => None,
        }
    }
}
