//! The scene file: TOML in, [`Scene`] out, and back.
//!
//! Reading says what stands where and what would be right instead; whether the numbers make sense is
//! [`validate`](super::validate)'s business, so that a scene may pass through a senseless state while it is edited.
//! Writing keeps every digit: `parse(&write(&scene)) == scene`; [`update`] writes into the text that a scene was read
//! from and keeps its comments.

mod fault;
mod read;
mod update;
mod write;

use crate::language::{Text, message};
use serde::Deserialize;
use toml::{Table, Value};

pub use super::top::VERSION;
pub(crate) use fault::did_you_mean;
pub use update::update;
pub use write::write;

use super::shown::shown;
use super::{Scene, SceneError, SceneErrors};

/// Reads the text of a scene file; `file` is how complaints call it.
///
/// # Errors
/// The text is not TOML, or a key or value is not what stands in `docs/scene-format.md`.
pub fn parse(text: &str, file: &str) -> Result<Scene, SceneErrors> {
    from_table(table(text, file)?, file)
}

/// Reads the text of a scene file and checks what it says.
///
/// # Errors
/// Every complaint of [`parse`] and [`validate_file`](super::validate::validate_file).
pub fn read(text: &str, file: &str) -> Result<Scene, SceneErrors> {
    let scene = parse(text, file)?;
    super::validate::validate_file(&scene).map_err(|errors| errors.in_file(file))?;
    Ok(scene)
}

/// The text as a plain table.
pub(super) fn table(text: &str, file: &str) -> Result<Table, SceneErrors> {
    text.parse().map_err(|error| not_toml(&error, text, file).into())
}

/// A plain table as a scene.
pub(super) fn from_table(table: Table, file: &str) -> Result<Scene, SceneErrors> {
    check_version(&table, file)?;
    let value = Value::Table(table);
    Scene::deserialize(read::Reader(&value)).map_err(|fault| fault.complaint(file).into())
}

/// The version comes first: a later format's keys are not this one's mistakes.
fn check_version(table: &Table, file: &str) -> Result<(), SceneErrors> {
    match table.get("format") {
        None => Ok(()),
        Some(Value::Integer(n)) if *n == i64::from(VERSION) => Ok(()),
        Some(other) => Err(SceneError {
            file: file.to_owned(),
            place: "format".into(),
            value: fault::short(other).into(),
            remedy: message!("wrong-format-write", "version" => VERSION),
        }
        .into()),
    }
}

fn not_toml(error: &toml::de::Error, text: &str, file: &str) -> SceneError {
    let at = error.span().map_or(0, |span| span.start.min(text.len()));
    let before = text.get(..at).unwrap_or_default();
    let line = before.matches('\n').count();
    let column = before.rsplit('\n').next().unwrap_or_default().chars().count();
    let found = part_around(text.lines().nth(line).unwrap_or_default(), column);
    SceneError {
        file: file.to_owned(),
        place: message!("found-line-column", "line" => line + 1, "column" => column + 1),
        value: if found.is_empty() { Text::new("found-nothing").into() } else { format!("`{found}`").into() },
        remedy: message!("wrong-toml", "message" => shown(&error.message().replace('\n', "; "), 4 * fault::LONGEST)),
    }
}

/// The line, or of a long one the part around a column.
fn part_around(line: &str, column: usize) -> String {
    let start = if line.chars().count() > fault::LONGEST { column.saturating_sub(fault::LONGEST / 2) } else { 0 };
    let part: String = line.chars().skip(start).take(fault::LONGEST + 1).collect();
    format!("{}{}", if start > 0 { "…" } else { "" }, shown(part.trim(), fault::LONGEST))
}
