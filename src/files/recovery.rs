//! Unsaved work in side files: `NAME.toml.unsaved` beside the scene.
//!
//! A side file holds one whole scene: a temporary file is written and renamed. The process that writes it keeps it locked, and the
//! system releases the lock when the process ends. A side file without a lock is work of a process that has ended.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use super::save::{folder_of, stage_scene};
use super::scene_source::{SceneSource, text_of};
use super::staging::hold;
use super::write_error::WriteError;
use crate::scene::Scene;

/// Ending of a side file's name; that of a scene's second one is `.unsaved2`.
const ENDING: &str = ".unsaved";

/// Most side files of one scene (chosen); [`SideFile::create`] fails beyond them.
const MOST_SIDE_FILES: u32 = 99;

/// A side file of this process.
#[derive(Debug)]
pub struct SideFile {
    path: PathBuf,
    /// Open for as long as it is ours.
    held: Option<File>,
}

/// A side file that nobody holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Found {
    /// The side file.
    pub path: PathBuf,
    /// The scene's own file, if it has one.
    pub file: Option<PathBuf>,
    /// When it was written.
    pub written: SystemTime,
}

impl Found {
    /// Source of the recovered work, into which it is saved: the scene's own file, or the side file's text.
    pub fn source(&self) -> SceneSource {
        let text = || text_of(&self.path).map_or(SceneSource::New, |text| SceneSource::Text(text.into()));
        self.file.clone().map_or_else(text, SceneSource::File)
    }
}

impl SideFile {
    /// Writes a scene into a new side file of `file`, under the first name that is free; of the text that it was read from
    /// comments, order and spelling stay.
    ///
    /// # Errors
    /// When the folder cannot be written to.
    pub fn create(scene: &Scene, source: &SceneSource, file: &Path) -> Result<Self, WriteError> {
        let folder = folder_of(file);
        let fail = |cause| WriteError::new(numbered(file, 1), cause);
        std::fs::create_dir_all(folder).map_err(fail)?;
        let mut staged = stage_scene(scene, source.text().as_deref(), &numbered(file, 1))?;
        hold(staged.as_file());
        for number in 1..=MOST_SIDE_FILES {
            let path = numbered(file, number);
            match staged.persist_noclobber(&path) {
                Ok(held) => return Ok(Self { path, held: Some(held) }),
                Err(error) if error.error.kind() == std::io::ErrorKind::AlreadyExists => staged = error.file,
                Err(error) => return Err(fail(error.error)),
            }
        }
        Err(fail(std::io::ErrorKind::AlreadyExists.into()))
    }

    /// Takes over a side file that was found, to write and remove it from now on.
    pub fn adopt(path: PathBuf) -> Self {
        let held = File::open(&path).ok();
        held.iter().for_each(hold);
        Self { path, held }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the scene as it is now, in the text that it was read from, in place of what stood there.
    ///
    /// # Errors
    /// When it cannot be written; what stood there still does.
    pub fn write(&mut self, scene: &Scene, source: &SceneSource) -> Result<(), WriteError> {
        let staged = stage_scene(scene, source.text().as_deref(), &self.path)?;
        hold(staged.as_file());
        // Not every system puts a file in the place of one that is open.
        self.held = None;
        let fail = |error: tempfile::PersistError| WriteError::new(&self.path, error.error);
        self.held = Some(staged.persist(&self.path).map_err(fail)?);
        Ok(())
    }

    /// Removes it: the work is saved, or given up.
    pub fn remove(self) {
        drop(self.held);
        // Gone already is as good.
        let _ = std::fs::remove_file(&self.path);
    }
}

/// Whether a window that still runs holds a side file.
fn is_held(path: &Path) -> bool {
    File::open(path).is_ok_and(|file| matches!(file.try_lock_shared(), Err(std::fs::TryLockError::WouldBlock)))
}

/// `NAME.toml.unsaved`, `NAME.toml.unsaved2` …
fn numbered(file: &Path, number: u32) -> PathBuf {
    let mut name = file.as_os_str().to_owned();
    name.push(ENDING);
    if number > 1 {
        name.push(number.to_string());
    }
    name.into()
}

/// Side files beside a scene's file that nobody holds, the newest first.
pub fn find_beside(file: &Path) -> Vec<Found> {
    let all = (1..=MOST_SIDE_FILES).map(|number| numbered(file, number));
    newest_first(all.filter_map(|path| found(path, Some(file.to_owned()))).collect())
}

/// Side files of scenes without a file that nobody holds, the newest first.
pub fn find_in(folder: &Path) -> Vec<Found> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let is_side = |path: &PathBuf| {
        let end = path.extension().map(|end| format!(".{}", end.to_string_lossy())).unwrap_or_default();
        end.strip_prefix(ENDING).is_some_and(|number| number.chars().all(|c| c.is_ascii_digit()))
    };
    newest_first(entries.filter(is_side).filter_map(|path| found(path, None)).collect())
}

fn found(path: PathBuf, file: Option<PathBuf>) -> Option<Found> {
    let about = std::fs::metadata(&path).ok().filter(std::fs::Metadata::is_file)?;
    let written = about.modified().unwrap_or(SystemTime::UNIX_EPOCH);
    (!is_held(&path)).then_some(Found { path, file, written })
}

fn newest_first(mut found: Vec<Found>) -> Vec<Found> {
    found.sort_by(|a, b| b.written.cmp(&a.written).then_with(|| a.path.cmp(&b.path)));
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::load_unsaved;
    use crate::scene::presets;

    fn scene() -> Scene {
        presets::load(presets::OPENING).expect("ships")
    }

    #[test]
    fn a_side_file_is_found_once_its_window_is_gone() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("mine.toml");
        let mut side = SideFile::create(&scene(), &SceneSource::New, &file).expect("written");
        assert!(find_beside(&file).is_empty(), "held while its window lives");
        side.write(&scene(), &SceneSource::New).expect("written again");
        assert!(find_beside(&file).is_empty(), "and after another writing");
        let path = side.path().to_owned();
        assert_eq!(path, folder.path().join("mine.toml.unsaved"), "beside its scene");
        drop(side);
        let found = find_beside(&file);
        assert_eq!(found.iter().map(|f| &f.path).collect::<Vec<_>>(), [&path], "found now");
        assert_eq!(load_unsaved(&path).expect("a scene"), scene(), "whole");
        SideFile::adopt(path).remove();
        assert!(find_beside(&file).is_empty(), "and gone when it is given up");
    }

    #[test]
    fn nobody_writes_over_another_windows_work() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("mine.toml");
        let one = SideFile::create(&scene(), &SceneSource::New, &file).expect("written");
        let other = SideFile::create(&Scene { duration: 3.0, ..scene() }, &SceneSource::New, &file).expect("written");
        assert_ne!(one.path(), other.path(), "two names");
        drop((one, other));
        assert_eq!(find_beside(&file).len(), 2, "both are found");
        assert_eq!(find_in(folder.path()).len(), 2, "by looking through the folder too");
    }

    #[test]
    fn a_side_file_keeps_the_comments_of_what_its_scene_was_read_from() {
        let folder = tempfile::tempdir().expect("a folder");
        let source = SceneSource::of(presets::OPENING);
        let text = source.text().expect("it ships").into_owned();
        let mut side = SideFile::create(&scene(), &source, &folder.path().join("mine.toml")).expect("written");
        let path = side.path().to_owned();
        assert_eq!(text_of(&path).as_deref(), Some(text.as_str()), "as it was read");
        side.write(&Scene { duration: 7.25, ..scene() }, &source).expect("written again");
        drop(side);
        let line = text.lines().find(|line| line.starts_with("duration_s = ")).expect("it has one");
        let changed = text.replacen(line, "duration_s = 7.25", 1);
        let found = find_in(folder.path()).pop().expect("it is held no more");
        assert_eq!(found.source(), SceneSource::Text(changed.into()), "and saved into that text");
        let file = folder.path().join("mine.toml");
        assert_eq!(find_beside(&file).pop().map(|f| f.source()), Some(SceneSource::File(file)), "or into its file");
    }

    #[test]
    fn work_in_an_impossible_state_is_kept_too() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut wrong = scene();
        wrong.girders[0].mass = -1.0;
        let side = SideFile::create(&wrong, &SceneSource::New, &folder.path().join("mine.toml")).expect("written");
        assert_eq!(load_unsaved(side.path()).expect("read"), wrong, "as it was being edited");
    }
}
