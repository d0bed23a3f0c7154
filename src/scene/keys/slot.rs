//! Value of a key, for an editor to change.

use super::key::Key;

/// A table of the scene file whose values an editor changes by their keys.
pub trait Editable {
    /// Each key with what stands under it, in the order of the documentation.
    fn slots(&mut self) -> Vec<(&'static Key, Slot<'_>)>;

    /// Takes over every value that differs between two tables; of components each by itself.
    fn carry(&mut self, old: &Self, new: &Self);
}

/// Mutable value of a key.
#[derive(Debug)]
pub enum Slot<'a> {
    /// A number, in the unit of the key.
    Number(&'a mut f64),
    /// A number that may be left out, in the unit of the key.
    Optional(&'a mut Option<f64>),
    /// Components along x, y and z, in the unit of the key.
    Numbers(&'a mut [f64]),
    /// True or false.
    Switch(&'a mut bool),
    /// One of some words.
    Word(Word<'a>),
    /// Something that has a form of its own: a table, a list, a line of text.
    Apart,
}

/// One of some words under a key.
pub struct Word<'a> {
    /// Every word, in the order of the documentation.
    pub words: &'static [&'static str],
    /// The one that stands, by its number; none where it is left out.
    pub chosen: Option<usize>,
    /// The one by default; none where the key may be left out.
    pub default: Option<usize>,
    set: Box<dyn FnOnce(Option<usize>) + 'a>,
}

impl<'a> Word<'a> {
    /// A value that is one of `all`, whose words are `words`.
    pub(in crate::scene) fn new<T: Copy + PartialEq>(
        value: &'a mut T,
        (all, words): (&'static [T], &'static [&'static str]),
        default: T,
    ) -> Self {
        let number = |value: T| all.iter().position(|one| *one == value);
        let (chosen, default) = (number(*value), number(default));
        let set = move |word: Option<usize>| {
            if let Some(new) = word.or(default).and_then(|word| all.get(word)) {
                *value = *new;
            }
        };
        Self { words, chosen, default, set: Box::new(set) }
    }

    /// A choice that may be left out.
    pub(in crate::scene) fn optional<T: Copy + PartialEq>(
        value: &'a mut Option<T>,
        (all, words): (&'static [T], &'static [&'static str]),
    ) -> Self {
        let chosen = value.and_then(|value| all.iter().position(|one| *one == value));
        let set = move |word: Option<usize>| *value = word.and_then(|word| all.get(word)).copied();
        Self { words, chosen, default: None, set: Box::new(set) }
    }

    /// Puts the word of this number there; none: as by default.
    pub fn choose(self, word: Option<usize>) {
        (self.set)(word);
    }
}

impl std::fmt::Debug for Word<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Word").field("words", &self.words).field("chosen", &self.chosen).finish_non_exhaustive()
    }
}
