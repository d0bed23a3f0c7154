//! Writes a changed scene into the text that it was read from: comments, order and spelling of what has not changed stay.
//!
//! Three trees are compared, key by key: the scene that the text holds, the scene to be written, and the text itself.
//! Only where the first two differ is the third changed, so that an unchanged scene leaves every byte. New keys go
//! where the documentation lists them; a table that is removed takes its comments with it.

mod lists;
mod spell;
mod tables;

use toml::{Table, Value};
use toml_edit::DocumentMut;

use super::{parse, write};
use crate::scene::{ImpactSettings, Initial, ModelSettings, Overlays, Push, STANDARD_GRAVITY, Scene};
use crate::scene::{SolverSettings, ViewSettings, keys};
use tables::{Node, merge_table};

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

/// The way to a key, `girder.initial`: the same for a table and for the tables of a list.
fn below(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

/// Where the documentation lists a key among those of its table; what is not listed comes last.
fn rank(path: &str, key: &str) -> usize {
    let plain = |listed: &'static str| listed.split(" kind").next().map(|way| way.trim_end_matches("[]"));
    let tables = keys::TABLES.iter().filter(|table| plain(table.path) == Some(path));
    tables.flat_map(|table| table.keys).position(|listed| listed.name == key).unwrap_or(usize::MAX)
}

/// What a key holds that is not written because it is the default; `None` where nothing holds then.
fn unwritten(path: &str) -> Option<Value> {
    match path {
        "gravity_m_s2" => Ok(Value::Float(STANDARD_GRAVITY)),
        "girder.initial" => Value::try_from(Initial::default()),
        "girder.push" => Value::try_from(Push::default()),
        "model" => Value::try_from(ModelSettings::default()),
        "impact" => Value::try_from(ImpactSettings::default()),
        "solver" => Value::try_from(SolverSettings::default()),
        "view" => Value::try_from(ViewSettings::default()),
        "view.overlays" => Value::try_from(Overlays::default()),
        _ => return None,
    }
    .ok()
}
