//! Writes files whole or not at all.

use std::ffi::OsStr;
use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

#[cfg(target_arch = "wasm32")]
use super::page::{self, Stage};
use super::scene_source::SceneSource;
#[cfg(not(target_arch = "wasm32"))]
use super::staging::Stage;
use super::staging::{file_in, sweep};
use super::write_error::WriteError;
use crate::language::Text;
use crate::scene::{Motion, Scene, format};

/// Saves a scene as TOML.
///
/// A record is written by the path it was read from if that path, seen from the new folder, is there; else its samples
/// go into the scene, so that a saved scene always opens again. Of the text that the scene was read from comments, order and
/// spelling stay; where there is none the text is written anew.
///
/// # Errors
/// When the file cannot be written; what stood there before then still does.
pub fn save_scene(scene: &Scene, source: &SceneSource, path: &Path) -> Result<(), WriteError> {
    #[cfg(target_arch = "wasm32")]
    return page::write(path, scene_text(scene, source, path).as_bytes());
    #[cfg(not(target_arch = "wasm32"))]
    persist(stage_scene(scene, source.text().as_deref(), path)?, path)
}

/// The text of a scene that is saved at a path.
pub fn scene_text(scene: &Scene, source: &SceneSource, path: &Path) -> String {
    text_at(scene, source.text().as_deref(), path)
}

fn text_at(scene: &Scene, text: Option<&str>, path: &Path) -> String {
    let scene = portable(scene, path);
    text.map_or_else(|| format::write(&scene), |text| format::update(text, &scene))
}

/// Puts a scene on the disk beside `path`, in `text` where there is one, down to the medium: a power cut after the
/// renaming must not leave a name without its contents.
pub(super) fn stage_scene(scene: &Scene, text: Option<&str>, path: &Path) -> Result<NamedTempFile, WriteError> {
    let file = stage(path, text_at(scene, text, path).as_bytes())?;
    file.as_file().sync_all().map_err(|cause| WriteError::new(path, cause))?;
    Ok(file)
}

/// A scene that can be opened again at `path`.
fn portable(scene: &Scene, path: &Path) -> Scene {
    let mut scene = scene.clone();
    for (_, motion) in scene.motions_mut() {
        let Motion::Record(record) = motion else { continue };
        let named = record.file.iter().chain(record.components.iter().filter_map(|component| component.file.as_ref()));
        let missing = named.into_iter().any(|file| !folder_of(path).join(file).is_file());
        if missing {
            record.keep_samples();
        }
    }
    scene
}

/// A name as part of a file's name: every character but letters, digits, `-`, `_` and `.` becomes `_`.
pub fn as_file_name(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect()
}

/// Writes one file: readers see what stood there before or all of `bytes`.
///
/// # Errors
/// When the file cannot be written; what stood there before then still does.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    #[cfg(target_arch = "wasm32")]
    return page::write(path, bytes);
    #[cfg(not(target_arch = "wasm32"))]
    persist(stage(path, bytes)?, path)
}

/// Files that come one by one and get their names together; dropped before that, nothing of them stays.
#[derive(Debug, Default)]
pub struct FileSet {
    /// One a folder.
    stages: Vec<Stage>,
    made: Folders,
}

impl FileSet {
    /// Puts a file on the disk beside where it will be, making the folder if it is missing.
    ///
    /// # Errors
    /// When the folder or the file cannot be written.
    pub fn add(&mut self, path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
        self.add_with(path, |out| out.write_all(bytes))
    }

    /// The same of a file that is written portion by portion.
    ///
    /// # Errors
    /// When the folder or the file cannot be written, or `write` fails.
    pub fn add_with(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
    ) -> Result<(), WriteError> {
        let fail = |cause| WriteError::new(path, cause);
        if path.is_dir() {
            // Found when names are given, files before it would have theirs.
            return Err(fail(std::io::ErrorKind::IsADirectory.into()));
        }
        let stage = self.stage(folder_of(path))?;
        stage.write(path.file_name().unwrap_or_default(), write).map_err(fail)
    }

    fn stage(&mut self, folder: &Path) -> Result<&mut Stage, WriteError> {
        let at = self.stages.iter().position(|stage| stage.folder == folder).unwrap_or(self.stages.len());
        if at == self.stages.len() {
            self.made.make(folder)?;
            self.stages.push(Stage::in_folder(folder).map_err(|cause| WriteError::new(folder, cause))?);
        }
        Ok(&mut self.stages[at])
    }

    /// How many files have come.
    pub fn count(&self) -> usize {
        self.stages.iter().map(Stage::count).sum()
    }

    /// Gives all of them their names.
    ///
    /// # Errors
    /// When something that is no file stands in the way of one.
    pub fn finish(mut self) -> Result<(), WriteError> {
        std::mem::take(&mut self.stages).into_iter().try_for_each(Stage::finish)
    }
}

/// Folders that were made, the inner ones last. Dropped, those go again that have nothing in them.
#[derive(Debug, Default)]
struct Folders(Vec<PathBuf>);

impl Folders {
    /// A page has no folders, and needs none.
    #[cfg(target_arch = "wasm32")]
    #[expect(clippy::unnecessary_wraps, clippy::unused_self, reason = "a disk may refuse")]
    fn make(&mut self, _: &Path) -> Result<(), WriteError> {
        Ok(())
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn make(&mut self, folder: &Path) -> Result<(), WriteError> {
        let missing = folder.ancestors().take_while(|f| *f != Path::new("") && !f.exists()).map(Path::to_owned);
        self.0.extend(missing.collect::<Vec<_>>().into_iter().rev());
        std::fs::create_dir_all(folder).map_err(|cause| WriteError::new(folder, cause))
    }
}

impl Drop for Folders {
    fn drop(&mut self) {
        self.0.iter().rev().take_while(|folder| std::fs::remove_dir(folder).is_ok()).for_each(drop);
    }
}

/// One file that grows as it is written to and gets its name at the end; dropped before that, nothing of it stays.
#[derive(Debug)]
pub struct Draft {
    file: BufWriter<NamedTempFile>,
    path: PathBuf,
    /// Dropped after the file, so that its folder is empty by then.
    _made: Folders,
}

impl Draft {
    /// Begins beside where it will be, making the folder if it is missing.
    ///
    /// # Errors
    /// When nothing can be written there.
    pub fn create(path: &Path) -> Result<Self, WriteError> {
        let mut made = Folders::default();
        made.make(folder_of(path))?;
        sweep(folder_of(path));
        let file = file_in(folder_of(path)).map_err(|cause| WriteError::new(path, cause))?;
        Ok(Self { file: BufWriter::new(file), path: path.to_owned(), _made: made })
    }

    /// Gives it its name.
    ///
    /// # Errors
    /// When the rest cannot be written, or something that is no file stands in the way.
    pub fn finish(self) -> Result<(), WriteError> {
        let file = self.file.into_inner().map_err(|error| WriteError::new(&self.path, error.into_error()))?;
        persist(file, &self.path)
    }
}

/// Errors name the file as it will be called.
impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.file.write(bytes).map_err(|cause| named(&self.path, cause))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush().map_err(|cause| named(&self.path, cause))
    }
}

fn named(path: &Path, cause: std::io::Error) -> std::io::Error {
    match cause.kind() {
        // A writer tries again.
        ErrorKind::Interrupted => cause,
        kind => std::io::Error::new(kind, WriteError::new(path, cause)),
    }
}

/// Endings of files that commands write, and of other pictures: no folder is made under such a name.
const FILE_ENDINGS: [&str; 12] =
    ["csv", "gif", "html", "jpeg", "jpg", "json", "md", "mp4", "parquet", "png", "svg", "toml"];

/// Makes sure that files can be written into a folder, before the work of finding out what to write.
///
/// A folder that is missing is not made: its nearest ancestor must be one that may be written to.
///
/// # Errors
/// When something else stands there, nothing may be written, or a folder that is missing has the name of a file.
pub fn check_folder(folder: &Path) -> Result<(), WriteError> {
    let ending = folder.extension().and_then(OsStr::to_str).map(str::to_ascii_lowercase);
    if !folder.exists() && ending.is_some_and(|ending| FILE_ENDINGS.contains(&ending.as_str())) {
        let cause = std::io::Error::new(ErrorKind::InvalidInput, Text::new("unwritten-file-name").to_string());
        return Err(WriteError::new(folder, cause));
    }
    let there = folder.ancestors().find(|path| path.exists() && *path != Path::new("")).unwrap_or(Path::new("."));
    // Gone again when dropped.
    file_in(there).map(drop).map_err(|cause| WriteError::new(folder, cause))
}

/// Puts the bytes on the disk beside `path`, under a name of its own; dropped, it is removed.
fn stage(path: &Path, bytes: &[u8]) -> Result<NamedTempFile, WriteError> {
    let write = || {
        let mut file = file_in(folder_of(path))?;
        file.write_all(bytes)?;
        Ok(file)
    };
    write().map_err(|cause| WriteError::new(path, cause))
}

fn persist(file: NamedTempFile, path: &Path) -> Result<(), WriteError> {
    file.persist(path).map(|_| ()).map_err(|error| WriteError::new(path, error.error))
}

pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}
