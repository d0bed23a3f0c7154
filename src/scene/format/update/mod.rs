//! Writes a changed scene into the text that it was read from: comments, order and spelling of what has not changed stay.
//!
//! Three trees are compared, key by key: the scene that the text holds, the scene to be written, and the text itself.
//! Only where the first two differ is the third changed, so that an unchanged scene leaves every byte. New keys go
//! where the documentation lists them; a table that is removed takes its comments with it.

mod lists;
mod merge;
mod place;
mod spell;

use toml::Table;
use toml_edit::DocumentMut;

use super::{parse, write};
use crate::scene::Scene;
use merge::{Node, merge_table};

/// The text of `scene`, made from the text of an earlier state of it.
///
/// `parse(&update(text, scene)) == scene` for every scene whose numbers are numbers. Where the text cannot be kept (it
/// is no scene, or holds a form that cannot be edited to give this scene) the answer is [`write()`]'s.
pub fn update(original: &str, scene: &Scene) -> String {
    edited(original, scene).unwrap_or_else(|| write(scene))
}

/// The edited text; `None` where it would not read as the scene.
fn edited(original: &str, scene: &Scene) -> Option<String> {
    let after = Table::try_from(scene).ok()?;
    let before = Table::try_from(parse(original, "").ok()?).ok()?;
    if before == after {
        return Some(original.to_owned());
    }
    let windows = original.contains("\r\n");
    let mut document: DocumentMut = original.replace("\r\n", "\n").parse().ok()?;
    merge_table("", &mut Node::Headed(document.as_table_mut()), &before, &after);
    let text = document.to_string();
    let text = if windows { text.replace('\n', "\r\n") } else { text };
    let written = Table::try_from(parse(&text, "").ok()?).ok()?;
    (written == after).then_some(text)
}
