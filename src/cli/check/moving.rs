//! What `check` says of ground that does not move as one: delays, factors, how far supports move apart.

use crate::cli::moved::words;
use crate::dynamics::Model;
use crate::language::said;
use crate::scene::Scene;
use crate::sim::moving_ground::moved_supports;

/// A line a support that moves otherwise than the ground of reference.
pub(super) fn texts(scene: &Scene, model: &Model) -> Vec<String> {
    let text = |moved| format!("{}\n", said!("check-moving", "moved" => words(&moved)));
    moved_supports(scene, model).into_iter().map(text).collect()
}
