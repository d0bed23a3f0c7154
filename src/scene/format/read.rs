//! Reads plain values into the scene's types, and keeps what a good complaint needs.
//!
//! serde's ready-made errors are sentences; a complaint here needs the place, the value and the keys that are known
//! there as data. So this is a small deserializer over [`toml::Value`] whose error is a [`Fault`], with the way to the
//! value collected while the error travels up. A table hands out its `kind` first, so that a type whose other keys
//! depend on it (`[motion]`) need not buffer them.

use std::fmt::Display;

use serde::de::value::StrDeserializer;
use serde::de::{
    self, DeserializeSeed, Deserializer, Expected, IntoDeserializer, MapAccess, SeqAccess, Unexpected, Visitor,
};
use serde::forward_to_deserialize_any;
use toml::Value;

use super::fault::{Fault, Step, What};

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: Display>(msg: T) -> Self {
        Self::new(What::Wrong(msg.to_string()))
    }

    fn invalid_type(_: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::new(What::Type(expected.to_string()))
    }

    fn invalid_value(_: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::new(What::Type(expected.to_string()))
    }

    fn invalid_length(_: usize, expected: &dyn Expected) -> Self {
        Self::new(What::Type(expected.to_string()))
    }

    fn unknown_variant(_: &str, expected: &'static [&'static str]) -> Self {
        Self::new(What::Word(expected))
    }

    fn unknown_field(field: &str, expected: &'static [&'static str]) -> Self {
        Self::new(What::UnknownKey(field.to_owned(), expected))
    }

    fn missing_field(field: &'static str) -> Self {
        Self::new(What::MissingKey(field))
    }
}

/// A value, ready to be read.
pub(super) struct Reader<'a>(pub(super) &'a Value);

impl<'de> Deserializer<'de> for Reader<'_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let read = match self.0 {
            Value::String(s) => visitor.visit_str(s),
            Value::Integer(i) => visitor.visit_i64(*i),
            Value::Float(x) => visitor.visit_f64(*x),
            Value::Boolean(b) => visitor.visit_bool(*b),
            Value::Datetime(_) => Err(de::Error::invalid_type(Unexpected::Other("a date"), &visitor)),
            Value::Array(list) => read_list(list, visitor),
            Value::Table(table) => visitor.visit_map(Keys::of(table)),
        };
        read.map_err(|fault| fault.found(self.0))
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        words: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let read = match self.0 {
            Value::String(s) => {
                let word: StrDeserializer<'_, Fault> = s.as_str().into_deserializer();
                visitor.visit_enum(word)
            }
            _ => Err(Fault::new(What::Word(words))),
        };
        read.map_err(|fault| fault.found(self.0))
    }

    /// serde's structs would also take their values as a list, without keys; a file says them by key.
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        if self.0.is_table() {
            return self.deserialize_any(visitor);
        }
        Err(Fault::new(What::Type((&visitor as &dyn Expected).to_string())).found(self.0))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct
        newtype_struct seq tuple tuple_struct map identifier ignored_any
    }
}

/// Reads a list to its end; what the type does not take is one too many.
fn read_list<'de, V: Visitor<'de>>(list: &[Value], visitor: V) -> Result<V::Value, Fault> {
    let wanted = (&visitor as &dyn Expected).to_string();
    let mut items = Items { list, next: 0 };
    let read = visitor.visit_seq(&mut items)?;
    if items.next < list.len() { Err(Fault::new(What::Type(wanted))) } else { Ok(read) }
}

struct Items<'a> {
    list: &'a [Value],
    next: usize,
}

impl<'de> SeqAccess<'de> for &mut Items<'_> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Fault> {
        let Some(value) = self.list.get(self.next) else { return Ok(None) };
        let step = Step::item(self.next, value);
        self.next += 1;
        seed.deserialize(Reader(value)).map(Some).map_err(|fault| fault.inside(step))
    }
}

struct Keys<'a> {
    rest: std::vec::IntoIter<(&'a str, &'a Value)>,
    current: Option<(&'a str, &'a Value)>,
}

impl<'a> Keys<'a> {
    fn of(table: &'a toml::Table) -> Self {
        let mut keys: Vec<_> = table.iter().map(|(key, value)| (key.as_str(), value)).collect();
        keys.sort_by_key(|(key, _)| *key != "kind");
        Self { rest: keys.into_iter(), current: None }
    }
}

impl<'de> MapAccess<'de> for Keys<'_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Fault> {
        self.current = self.rest.next();
        self.current.map(|(key, _)| seed.deserialize(key.into_deserializer())).transpose()
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        let (key, value) =
            self.current.take().ok_or_else(|| Fault::new(What::Wrong("a value without a key".into())))?;
        seed.deserialize(Reader(value)).map_err(|fault| fault.inside(Step::Key(key.to_owned())))
    }
}
