//! A table of the scene file stated once: its struct, its keys with ranges and meanings, its defaults, its numbers.

use super::key::Fallback;
use super::slot::{Editable, Slot};
use crate::geometry::End;

/// Value of a key, for the check of its range.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::scene) enum Stated<'a> {
    /// No number, or none is given.
    Nothing,
    /// One number.
    Number(f64),
    /// A list of numbers.
    Numbers(&'a [f64]),
    /// A list of lists of numbers.
    Lists(Vec<&'a [f64]>),
}

/// A type whose values stand under a key.
pub(in crate::scene) trait Stands: Sized + Clone + PartialEq {
    /// The value where the file has none.
    fn by_default(fallback: Fallback) -> Self;

    /// Whether a new file leaves the key out.
    fn is_left_out(&self) -> bool {
        false
    }

    /// The numbers that the range of the key is about.
    fn stated(&self) -> Stated<'_> {
        Stated::Nothing
    }

    /// The value, for an editor.
    fn slot(&mut self) -> Slot<'_> {
        Slot::Apart
    }

    /// Takes over what differs between two values: of what has parts, the parts that differ and no other.
    fn carry(&mut self, old: &Self, new: &Self) {
        if old != new {
            self.clone_from(new);
        }
    }

    /// [`slot`](Self::slot) of a value that may be left out.
    fn optional_slot(_: &mut Option<Self>) -> Slot<'_> {
        Slot::Apart
    }
}

impl Stands for f64 {
    /// Not a number where the table of keys gives none: no scene that is checked has it.
    fn by_default(fallback: Fallback) -> Self {
        if let Fallback::Number(number) = fallback { number } else { Self::NAN }
    }

    fn stated(&self) -> Stated<'_> {
        Stated::Number(*self)
    }

    fn slot(&mut self) -> Slot<'_> {
        Slot::Number(self)
    }

    fn optional_slot(value: &mut Option<Self>) -> Slot<'_> {
        Slot::Optional(value)
    }
}

impl Stands for bool {
    fn by_default(fallback: Fallback) -> Self {
        fallback == Fallback::Switch(true)
    }

    fn slot(&mut self) -> Slot<'_> {
        Slot::Switch(self)
    }
}

impl<const N: usize> Stands for [f64; N] {
    fn by_default(_: Fallback) -> Self {
        [0.0; N]
    }

    fn stated(&self) -> Stated<'_> {
        Stated::Numbers(self)
    }

    fn slot(&mut self) -> Slot<'_> {
        Slot::Numbers(self)
    }

    fn carry(&mut self, old: &Self, new: &Self) {
        for ((own, old), new) in self.iter_mut().zip(old).zip(new) {
            own.carry(old, new);
        }
    }
}

impl<T: Stands> Stands for Option<T> {
    fn by_default(_: Fallback) -> Self {
        None
    }

    fn is_left_out(&self) -> bool {
        self.is_none()
    }

    fn stated(&self) -> Stated<'_> {
        self.as_ref().map_or(Stated::Nothing, Stands::stated)
    }

    fn slot(&mut self) -> Slot<'_> {
        T::optional_slot(self)
    }

    fn carry(&mut self, old: &Self, new: &Self) {
        match (self, old, new) {
            (Some(own), Some(old), Some(new)) => own.carry(old, new),
            (own, old, new) if old != new => own.clone_from(new),
            _ => {}
        }
    }
}

/// Of two lists as long as one another those members that differ, where `own` has such members. A list that grew or shrank goes to one
/// that was the same before; members of another list are its own.
fn carry_each<T: Clone + PartialEq>(
    own: &mut Vec<T>,
    [old, new]: [&Vec<T>; 2],
    mut carry: impl FnMut(&mut T, [&T; 2]),
) {
    if old.len() == new.len() {
        own.iter_mut().zip(old.iter().zip(new)).for_each(|(own, (old, new))| carry(own, [old, new]));
    } else if own == old {
        own.clone_from(new);
    }
}

impl<const N: usize> Stands for Vec<[f64; N]> {
    fn by_default(_: Fallback) -> Self {
        Self::new()
    }

    fn stated(&self) -> Stated<'_> {
        Stated::Lists(self.iter().map(<[f64; N]>::as_slice).collect())
    }

    fn carry(&mut self, old: &Self, new: &Self) {
        carry_each(self, [old, new], |own, [old, new]| own.carry(old, new));
    }
}

impl Stands for [String; 2] {
    fn by_default(_: Fallback) -> Self {
        Self::default()
    }
}

impl Stands for [End; 2] {
    fn by_default(_: Fallback) -> Self {
        [End::Plus; 2]
    }
}

impl Stands for String {
    fn by_default(_: Fallback) -> Self {
        Self::new()
    }
}

impl Stands for End {
    fn by_default(_: Fallback) -> Self {
        Self::Plus
    }
}

impl Stands for Vec<String> {
    fn by_default(_: Fallback) -> Self {
        Self::new()
    }
}

/// A list of tables: none is not written.
impl<T: Keyed + Editable + Clone + PartialEq> Stands for Vec<T> {
    fn by_default(_: Fallback) -> Self {
        Self::new()
    }

    fn is_left_out(&self) -> bool {
        self.is_empty()
    }

    fn carry(&mut self, old: &Self, new: &Self) {
        carry_each(self, [old, new], |own, [old, new]| own.carry(old, new));
    }
}

/// A table of the scene file.
pub(in crate::scene) trait Keyed {
    /// Values of its keys, in the order of the documentation.
    fn stated(&self) -> impl Iterator<Item = (&'static str, Stated<'_>)>;

    /// Each key as it is where the file has none.
    fn by_default() -> Self;

    /// The number under a key, if there is one.
    fn number(&self, key: &str) -> Option<f64> {
        self.stated().find_map(|(name, stated)| match stated {
            Stated::Number(number) if name == key => Some(number),
            _ => None,
        })
    }
}

/// States a table of the scene file: one line a key, of field, type, name in the file (`as` the text that names its
/// field in the window), range, default, meaning, bounds of its slider where it has one, and `in in_space` where planar scenes have no such
/// quantity.
///
/// `default struct` is a table that may be left out, with all of its keys: each field is what its [`Fallback`] says. The
/// keys of a plain `struct` must be given unless their type has a way to be nothing.
macro_rules! table {
    (
        $(#[$meta:meta])*
        default struct $Name:ident, $KEYS:ident {
            $( $(#[$how:meta])* $field:ident: $Type:ty = $key:literal $(as $label:literal)?, $range:expr, $fallback:expr, $meaning:literal
                $(, slider $bounds:expr)? $(, in $space:ident)?; )+
        }
    ) => {
        $crate::scene::keys::table! {
            $(#[$meta])*
            #[serde(default)]
            struct $Name, $KEYS {
                $( $(#[$how])* $field: $Type = $key $(as $label)?, $range, $fallback, $meaning $(, slider $bounds)? $(, in $space)?; )+
            }
        }

        impl Default for $Name {
            fn default() -> Self {
                $crate::scene::keys::Keyed::by_default()
            }
        }

        impl $crate::scene::keys::Stands for $Name {
            fn by_default(_: $crate::scene::keys::Fallback) -> Self {
                Self::default()
            }

            fn is_left_out(&self) -> bool {
                *self == Self::default()
            }

            fn carry(&mut self, old: &Self, new: &Self) {
                $crate::scene::keys::Editable::carry(self, old, new);
            }
        }
    };
    (
        $(#[$meta:meta])*
        struct $Name:ident, $KEYS:ident {
            $( $(#[$how:meta])* $field:ident: $Type:ty = $key:literal $(as $label:literal)?, $range:expr, $fallback:expr, $meaning:literal
                $(, slider $bounds:expr)? $(, in $space:ident)?; )+
        }
    ) => {
        $(#[$meta])*
        #[serde(deny_unknown_fields)]
        pub struct $Name {
            $(
                #[doc = concat!("```text\n", $meaning, "\n```")]
                #[serde(rename = $key, skip_serializing_if = "crate::scene::keys::Stands::is_left_out")]
                $(#[$how])*
                pub $field: $Type,
            )+
        }

        #[doc = concat!("The keys of [`", stringify!($Name), "`].")]
        pub const $KEYS: &[$crate::scene::keys::Key] =
            &[$( $crate::scene::keys::Key::new($key, $range, $fallback, $meaning)$(.labelled($label))?$(.slid($bounds))?$(.$space())?, )+];

        impl $crate::scene::keys::Keyed for $Name {
            fn stated(&self) -> impl Iterator<Item = (&'static str, $crate::scene::keys::Stated<'_>)> {
                [$( ($key, $crate::scene::keys::Stands::stated(&self.$field)), )+].into_iter()
            }

            fn by_default() -> Self {
                Self { $( $field: $crate::scene::keys::Stands::by_default($fallback), )+ }
            }
        }

        impl $crate::scene::keys::Editable for $Name {
            fn slots(&mut self) -> Vec<(&'static $crate::scene::keys::Key, $crate::scene::keys::Slot<'_>)> {
                $KEYS.iter().zip([$( $crate::scene::keys::Stands::slot(&mut self.$field), )+]).collect()
            }

            fn carry(&mut self, old: &Self, new: &Self) {
                $( $crate::scene::keys::Stands::carry(&mut self.$field, &old.$field, &new.$field); )+
            }
        }
    };
}

/// States the words that may stand under a key: an enum, its words and its default.
macro_rules! words {
    (
        $(#[$meta:meta])*
        $Name:ident, by default $Default:ident {
            $( $(#[$about:meta])* $Variant:ident = $word:literal, )+
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
        pub enum $Name {
            $( $(#[$about])* #[serde(rename = $word)] $Variant, )+
        }

        impl $Name {
            /// Every value, in the order of the documentation.
            pub const ALL: &'static [Self] = &[$( Self::$Variant, )+];
            /// Their words.
            pub const WORDS: &'static [&'static str] = &[$( $word, )+];
            /// Default.
            pub const DEFAULT: Self = Self::$Default;
            /// Default for the table of keys.
            pub const FALLBACK: $crate::scene::keys::Fallback =
                $crate::scene::keys::Fallback::Word(Self::DEFAULT.label());

            /// The word used in files and tables.
            pub const fn label(self) -> &'static str {
                match self { $( Self::$Variant => $word, )+ }
            }
        }

        impl Default for $Name {
            fn default() -> Self {
                Self::DEFAULT
            }
        }

        impl $crate::scene::keys::Stands for $Name {
            fn by_default(_: $crate::scene::keys::Fallback) -> Self {
                Self::DEFAULT
            }

            fn slot(&mut self) -> $crate::scene::keys::Slot<'_> {
                $crate::scene::keys::Slot::Word($crate::scene::keys::Word::new(
                    self,
                    (Self::ALL, Self::WORDS),
                    Self::DEFAULT,
                ))
            }

            fn optional_slot(value: &mut Option<Self>) -> $crate::scene::keys::Slot<'_> {
                $crate::scene::keys::Slot::Word($crate::scene::keys::Word::optional(value, (Self::ALL, Self::WORDS)))
            }
        }
    };
}

pub(in crate::scene) use {table, words};
