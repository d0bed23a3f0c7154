//! Numbers in what the command line prints.

pub(super) use crate::language::six;

/// [`six`] of each, separated by commas.
pub(super) fn list(values: &[f64]) -> String {
    values.iter().map(|&value| six(value)).collect::<Vec<_>>().join(", ")
}
