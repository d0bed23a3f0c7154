//! Writes a scene as TOML.

use crate::scene::Scene;

/// The scene as the text of a file, readable by hand; every float with all its digits.
///
/// TOML has a way to write everything that a scene holds, so the error that the serializer could answer with never
/// comes; it would stand in the text as a comment.
pub fn write(scene: &Scene) -> String {
    toml::to_string(scene).unwrap_or_else(|error| format!("# {error}\n"))
}
