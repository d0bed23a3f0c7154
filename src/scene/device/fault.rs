//! What is wrong with a device.

use crate::language::{Message, Text};

/// What is wrong with a key of a device: its name, what stands there, what would be right.
pub type Fault = (&'static str, Message, Message);

/// A number as it stands in a file.
pub(super) fn written(value: f64) -> Message {
    format!("{value:?}").into()
}

/// A fault of a key that is not given.
pub(super) fn missing(key: &'static str, remedy: Text) -> Fault {
    (key, Text::new("found-nothing").into(), remedy.into())
}
