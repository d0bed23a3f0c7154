//! Whole numbers among the keys: written as such.

use serde::Serializer;

/// Writes a whole number without a fraction, any other as it is: a check refuses that by name.
///
/// # Errors
///
/// Those of the serializer.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for")]
pub(super) fn serialize<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    match *number {
        #[expect(clippy::cast_possible_truncation, reason = "a whole number below 2⁵³")]
        whole if whole.fract() == 0.0 && whole.abs() < 1e15 => serializer.serialize_i64(whole as i64),
        other => serializer.serialize_f64(other),
    }
}
