//! Reads a scene by the name of a preset or by path, with everything it needs from the disk.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use crate::motion::format::read as read_series;
use crate::scene::validate::validate;
use crate::scene::{Motion, Scene, SceneError, SceneErrors, format, overrides, presets};

/// A file that could not be read.
#[derive(Debug, thiserror::Error)]
#[error("{}: cannot be read ({source}): give a file that is there and may be read", path.display())]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    /// What the system said.
    source: std::io::Error,
}

/// Reads a whole file.
///
/// # Errors
/// When it is not there or may not be read.
pub fn read(path: &Path) -> Result<Vec<u8>, ReadError> {
    std::fs::read(path).map_err(|source| ReadError { path: path.to_owned(), source })
}

/// Reads the scene called `name_or_path`: a preset when one has that name, else a file.
///
/// `sets` are overrides such as `girder.deck.skew_deg=60`, applied before anything is checked. A record that the scene
/// names is read too, relative to the scene's file (to the working folder for a preset). The scene is validated.
///
/// # Errors
/// Every complaint, each naming file, place, value and remedy; a file that cannot be read is one of them.
pub fn load_scene(name_or_path: &str, sets: &[String]) -> Result<Scene, SceneErrors> {
    let path = Path::new(name_or_path);
    let (text, folder) = match presets::get(name_or_path) {
        Some(preset) => (preset.text.to_owned(), Path::new("")),
        None => (read_text(path)?, path.parent().unwrap_or(Path::new(""))),
    };
    let scene = format::parse(&text, name_or_path)?;
    let mut scene = overrides::apply_all(&scene, sets).map_err(|errors| errors.in_file(name_or_path))?;
    load_record(&mut scene, folder, name_or_path)?;
    validate(&scene).map_err(|errors| errors.in_file(name_or_path))?;
    Ok(scene)
}

/// Reads the unsaved work in a side file, with the record it names; whether it makes sense is for the window to say, as
/// it was while it was edited.
///
/// # Errors
/// What cannot be read, in words.
pub fn load_unsaved(path: &Path) -> Result<Scene, SceneErrors> {
    let name = path.to_string_lossy();
    let mut scene = format::parse(&read_text(path)?, &name)?;
    load_record(&mut scene, path.parent().unwrap_or(Path::new("")), &name)?;
    Ok(scene)
}

/// Reads the record that `motion.file` names into [`RecordMotion::loaded`](crate::scene::RecordMotion::loaded).
fn load_record(scene: &mut Scene, folder: &Path, scene_file: &str) -> Result<(), SceneErrors> {
    let Motion::Record(record) = &mut scene.motion else { return Ok(()) };
    let Some(file) = &record.file else { return Ok(()) };
    let path = folder.join(file);
    let remedy = "give the record's path relative to the scene's file";
    record.loaded = Some(series(&path, |error| complaint(scene_file, "motion.file", error, remedy))?);
    Ok(())
}

/// Reads a record: its interval \[s\] and its samples \[m/s²\].
///
/// # Errors
/// A file that cannot be read, or that is no record: line, value and remedy.
pub fn read_record(path: &Path) -> Result<(f64, Vec<f64>), SceneErrors> {
    series(path, |error| {
        complaint(&path.display().to_string(), "the file itself", error, "give a record that is there")
    })
}

fn series(path: &Path, missing: impl Fn(String) -> SceneErrors) -> Result<(f64, Vec<f64>), SceneErrors> {
    let shown = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| missing(format!("{shown} ({error})")))?;
    let series = read_series(&bytes, path)
        .map_err(|error| complaint(&shown, &format!("line {}", error.line), error.value, &error.remedy))?;
    Ok((series.dt, series.samples))
}

fn read_text(path: &Path) -> Result<String, SceneErrors> {
    let file = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| unreadable(&file, &error))?;
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        complaint(
            &file,
            &format!("byte {at}"),
            "not UTF-8 text".into(),
            "a scene is a TOML file, written as UTF-8 text",
        )
    })
}

fn unreadable(file: &str, error: &std::io::Error) -> SceneErrors {
    let remedy = if error.kind() == ErrorKind::NotFound {
        let names: Vec<_> = presets::all().iter().map(|preset| preset.name).collect();
        format!("give the path of a scene file or the name of a preset: {}", names.join(", "))
    } else {
        "give a scene file that can be read".into()
    };
    complaint(file, "the file itself", error.to_string(), &remedy)
}

fn complaint(file: &str, place: &str, value: String, remedy: &str) -> SceneErrors {
    SceneError { file: file.into(), place: place.into(), value, remedy: remedy.into() }.into()
}
