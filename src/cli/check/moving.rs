//! Text of `check` on ground that does not move as one: delays, factors, relative displacements of supports.

use crate::cli::moved::words;
use crate::language::said;
use crate::sim::moving_ground::MovedSupport;

/// A line a support that moves otherwise than the ground of reference.
pub(super) fn texts(supports: &[MovedSupport]) -> Vec<String> {
    supports.iter().map(|moved| format!("{}\n", said!("check-moving", "moved" => words(moved)))).collect()
}
