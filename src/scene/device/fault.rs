//! What is wrong with a device.

/// What is wrong with a key of a device: its name, what stands there, what would be right.
pub type Fault = (&'static str, String, String);

/// A number as it stands in a file.
pub(super) fn written(value: f64) -> String {
    format!("{value:?}")
}

/// A fault of a key that is not given.
pub(super) fn missing(key: &'static str, remedy: &str) -> Fault {
    (key, "nothing".to_owned(), remedy.to_owned())
}
