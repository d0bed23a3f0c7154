//! Ground motions that single supports have in place of `[motion]`, as written in a scene.

use std::fmt::{Formatter, Result as Written};
use std::marker::PhantomData;

use serde::de::value::{MapAccessDeserializer, StringDeserializer};
use serde::de::{DeserializeSeed, Error, IntoDeserializer, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::keys::{Fallback, Key, MOTION, Range};
use super::motion::Motion;

/// `[[ground]]`: a motion with a name, which abutments and piers have where they give that name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedGround {
    /// What supports call it.
    pub name: String,
    /// How it moves.
    #[serde(flatten)]
    pub motion: Motion,
}

/// A motion of the ground in a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum GroundId {
    /// That of `[motion]`.
    #[default]
    Reference,
    /// The `[[ground]]` of this number.
    Named(usize),
}

/// `[[ground]]`, whatever its kind; of each kind the keys of `[motion]`.
pub const GROUND: &[Key] = &[
    Key::new("name", Range::Like("unique"), Fallback::Needed("must be given"), "what abutments and piers call it"),
    MOTION[0],
];

/// The keys of a motion and, among them, the name.
impl<'de> Deserialize<'de> for NamedGround {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(GroundVisitor)
    }
}

struct GroundVisitor;

impl<'de> Visitor<'de> for GroundVisitor {
    type Value = NamedGround;

    fn expecting(&self, f: &mut Formatter<'_>) -> Written {
        f.write_str("a table of keys, a name and the kind of motion among them")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<NamedGround, A::Error> {
        let mut name = None;
        let others = WithoutName { map, name: &mut name, reader: PhantomData };
        let motion = Motion::deserialize(MapAccessDeserializer::new(others))?;
        Ok(NamedGround { name: name.ok_or_else(|| A::Error::missing_field("name"))?, motion })
    }
}

/// The keys of a table but for its name, which is put aside.
struct WithoutName<'n, 'de, A> {
    map: A,
    name: &'n mut Option<String>,
    reader: PhantomData<&'de ()>,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for WithoutName<'_, 'de, A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        while let Some(key) = self.map.next_key::<String>()? {
            if key != "name" {
                let key: StringDeserializer<A::Error> = key.into_deserializer();
                return seed.deserialize(key).map(Some);
            }
            *self.name = Some(self.map.next_value()?);
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.map.next_value_seed(seed)
    }
}
