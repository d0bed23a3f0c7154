//! Reads a scene by the name of a preset or by path, with everything it needs from the disk.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::read::{LARGEST_INPUT, ReadError, read_regular};
use crate::language::{Message, Text, message};
use crate::motion::format::{Record, Supplement, read as read_bytes};
use crate::scene::validate::validate_file;
use crate::scene::{Motion, Scene, SceneError, SceneErrors, format, overrides, presets};

/// Reads the scene called `name_or_path`: a preset when one has that name, else a file.
///
/// `sets` are overrides such as `girder.deck.skew_deg=60`, applied before anything is checked. A record that the scene
/// names is read too, relative to the scene's file (to the working folder for a preset). The scene is validated.
///
/// # Errors
/// Every complaint, each naming file, place, value and remedy; a file that cannot be read is one of them.
pub fn load_scene(name_or_path: impl AsRef<Path>, sets: &[String]) -> Result<Scene, SceneErrors> {
    let path = name_or_path.as_ref();
    let (text, folder) = match path.to_str().and_then(presets::get) {
        Some(preset) => (preset.text.to_owned(), Path::new("")),
        None => (read_text(path)?, path.parent().unwrap_or(Path::new(""))),
    };
    complete(&text, sets, (folder, &path.to_string_lossy()))
}

/// Reads a scene from its text, which complaints call `name`.
///
/// # Errors
/// As [`load_scene`].
pub fn read_scene(text: &str, name: &str) -> Result<Scene, SceneErrors> {
    complete(text, &[], (Path::new(""), name))
}

/// The scene of a text, whose records are named from a folder on.
fn complete(text: &str, sets: &[String], (folder, file): (&Path, &str)) -> Result<Scene, SceneErrors> {
    let scene = format::parse(text, file)?;
    let mut scene = overrides::apply_all(&scene, sets).map_err(|errors| errors.in_file(file))?;
    load_record(&mut scene, folder, file)?;
    validate_file(&scene).map_err(|errors| errors.in_file(file))?;
    Ok(scene)
}

/// Reads a side file of unsaved work with the records that it names. The scene is not validated: work may be kept during an edit.
///
/// # Errors
///
/// Texts on what cannot be read.
pub fn load_unsaved(path: &Path) -> Result<Scene, SceneErrors> {
    let name = path.to_string_lossy();
    let mut scene = format::parse(&read_text(path)?, &name)?;
    load_record(&mut scene, path.parent().unwrap_or(Path::new("")), &name)?;
    Ok(scene)
}

/// Reads the records that the motions of a scene and their components name.
fn load_record(scene: &mut Scene, folder: &Path, scene_file: &str) -> Result<(), SceneErrors> {
    load_missing(scene, &mut |file, beside, place| load_one(&folder.join(file), beside, (scene_file, place)))
}

/// Reads a file of a record, with what is stated beside it, for a place in the scene's file.
type ReadOne<'a> = dyn FnMut(&str, &Supplement, &str) -> Result<Arc<Record>, SceneErrors> + 'a;

/// Has the records read that the motions of a scene name and that are not loaded.
fn load_missing(scene: &mut Scene, read: &mut ReadOne<'_>) -> Result<(), SceneErrors> {
    scene.motions_mut().try_for_each(|(place, motion)| load_motion((&place, motion), read))
}

/// The same of one motion, by its place in the scene's file.
fn load_motion((place, motion): (&str, &mut Motion), read: &mut ReadOne<'_>) -> Result<(), SceneErrors> {
    let Motion::Record(record) = motion else { return Ok(()) };
    if let (None, Some(file)) = (&record.loaded, &record.file) {
        let beside = Supplement { dt: record.dt, unit: record.unit };
        record.loaded = Some(read(file, &beside, &format!("{place}.file"))?);
    }
    record.loaded_components.resize(record.components.len(), None);
    for (n, (component, loaded)) in record.components.iter().zip(&mut record.loaded_components).enumerate() {
        if let (None, Some(file)) = (&loaded, &component.file) {
            let beside = Supplement { dt: component.dt, unit: component.unit };
            *loaded = Some(read(file, &beside, &format!("{place}.component[{n}].file"))?);
        }
    }
    Ok(())
}

/// Records that scenes made from one name, each read once.
#[derive(Debug)]
pub struct Records {
    /// Where their names are seen from.
    folder: PathBuf,
    read: Mutex<Vec<(String, Supplement, Arc<Record>)>>,
}

impl Records {
    /// Of scenes made from the one called `name_or_path`.
    pub fn beside(name_or_path: &Path) -> Self {
        let preset = name_or_path.to_str().and_then(presets::get).is_some();
        let folder = name_or_path.parent().filter(|_| !preset).unwrap_or(Path::new(""));
        Self::in_folder(folder.to_owned())
    }

    /// Of scenes whose records are named from a folder on.
    pub fn in_folder(folder: PathBuf) -> Self {
        Self { folder, read: Mutex::default() }
    }

    /// Reads the records that a scene names and that are not loaded.
    ///
    /// # Errors
    /// A file that cannot be read, or that is no record.
    pub fn complete(&self, scene: &mut Scene) -> Result<(), SceneErrors> {
        load_missing(scene, &mut |file, beside, place| self.read(file, beside, place))
    }

    /// The same of one motion, by its place in the scene's file.
    ///
    /// # Errors
    /// Those of [`complete`](Self::complete).
    pub fn complete_motion(&self, motion: (&str, &mut Motion)) -> Result<(), SceneErrors> {
        load_motion(motion, &mut |file, beside, place| self.read(file, beside, place))
    }

    fn read(&self, file: &str, beside: &Supplement, place: &str) -> Result<Arc<Record>, SceneErrors> {
        let mut all = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, _, known)) = all.iter().find(|(name, with, _)| name == file && with == beside) {
            return Ok(Arc::clone(known));
        }
        let new = load_one(&self.folder.join(file), beside, ("scene", place))?;
        all.push((file.to_owned(), *beside, Arc::clone(&new)));
        Ok(new)
    }
}

/// Reads one record of a scene, for the place in the scene's file that names it.
fn load_one(path: &Path, beside: &Supplement, (scene_file, place): (&str, &str)) -> Result<Arc<Record>, SceneErrors> {
    let remedy = |error: &ReadError| match error {
        missing if missing.is_missing() => Text::new("wrong-no-record-file"),
        other => other.remedy(),
    };
    let unreadable = |error: ReadError| {
        let value = message!("wrong-there", "place" => error.path.display().to_string(), "remedy" => error.found());
        complaint(scene_file, place, value, remedy(&error))
    };
    read_from(path, beside, unreadable).map(Arc::new)
}

/// Reads a record with what is stated beside its file.
///
/// # Errors
/// A file that cannot be read, or that is no record: line, value and remedy.
pub fn read_record(path: &Path, beside: &Supplement) -> Result<Record, SceneErrors> {
    read_from(path, beside, |error| about_file(path, &error, error.remedy()))
}

fn read_from(
    path: &Path,
    beside: &Supplement,
    unreadable: impl Fn(ReadError) -> SceneErrors,
) -> Result<Record, SceneErrors> {
    let bytes = read_regular(path, LARGEST_INPUT).map_err(unreadable)?;
    read_bytes(&bytes, path, beside).map_err(|error| {
        complaint(&path.to_string_lossy(), message!("found-line", "line" => error.line), error.value, error.remedy)
    })
}

fn read_text(path: &Path) -> Result<String, SceneErrors> {
    let bytes = read_regular(path, LARGEST_INPUT).map_err(|error| {
        if error.is_missing() { no_scene(path, &error) } else { about_file(path, &error, error.remedy()) }
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let [found, remedy] = [Text::new("found-not-text"), Text::new("wrong-not-text")];
        complaint(&path.to_string_lossy(), message!("found-byte", "byte" => at), found, remedy)
    })
}

/// Neither a file nor a preset has that name.
fn no_scene(path: &Path, error: &ReadError) -> SceneErrors {
    let names: Vec<_> = presets::all().iter().map(|preset| preset.name).collect();
    about_file(path, error, message!("wrong-no-scene", "names" => names.join(", ")))
}

fn about_file(path: &Path, error: &ReadError, remedy: impl Into<Message>) -> SceneErrors {
    complaint(&path.to_string_lossy(), Text::new("found-file-itself"), error.found(), remedy)
}

fn complaint(
    file: &str,
    place: impl Into<Message>,
    value: impl Into<Message>,
    remedy: impl Into<Message>,
) -> SceneErrors {
    SceneError { file: file.into(), place: place.into(), value: value.into(), remedy: remedy.into() }.into()
}
