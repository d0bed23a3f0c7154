//! Faults of devices.

use crate::language::{Message, Text};

/// Fault of a key of a device: its name, the value found, the remedy.
pub type Fault = (&'static str, Message, Message);

/// A number as it stands in a file.
pub(super) fn written(value: f64) -> Message {
    format!("{value:?}").into()
}

/// A fault of a key that is not given.
pub(super) fn missing(key: &'static str, remedy: Text) -> Fault {
    (key, Text::new("found-nothing").into(), remedy.into())
}
