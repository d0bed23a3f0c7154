//! The scene that is worked on and its files: opening, saving, unsaved work that is found, changes by other programs.

use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::app::command::{KeepCommand, SelectCommand};
use crate::app::disk::export::told;
use crate::app::disk::session_files::{Compared, SessionFiles};
use crate::app::edits::Document;
use crate::app::host::{Told, Wake};
use crate::app::text;
use crate::files::{Found, SceneSource, save_scene};
use crate::scene::Scene;
use crate::scene::edit::{Edit, EditError};

/// Outcome of a command to save.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::app) enum Saved {
    /// It is on the disk; in words.
    Done(Told),
    /// Another program has changed the file: first the question what to do about it.
    Question,
    /// It is not; in words.
    Failed(String),
}

/// Step left to do by a command on kept files.
#[derive(Clone, Debug)]
pub(in crate::app) enum Left {
    /// Nothing.
    Nothing,
    /// Found work is brought back.
    Recover(Found),
    /// The file is read again.
    Reload(PathBuf),
}

/// The document, and what is kept beside it.
pub struct SceneFiles {
    /// The scene with its past.
    pub document: Document,
    /// Recent files, unsaved work, the file's state on the disk.
    pub session: SessionFiles,
}

impl SceneFiles {
    /// A scene as it was read; nothing is kept yet.
    pub(in crate::app) fn new(scene: Scene, source: SceneSource) -> Self {
        Self { document: Document::new(scene, source), session: SessionFiles::default() }
    }

    /// Keeps recent files and unsaved work in a folder from now on, and looks for work that was left there.
    pub(in crate::app) fn keep_in(&mut self, folder: &Path, wake: Wake) {
        self.session.keep_in(folder, wake);
        if let Some(file) = self.document.file() {
            self.session.opened(file, self.document.scene());
        }
    }

    /// The name of the file, or of a scene without one.
    pub fn name(&self) -> String {
        let file = self.document.file().and_then(Path::file_name).map(|f| f.to_string_lossy().into_owned());
        file.unwrap_or_else(|| self.document.scene().name.clone())
    }

    /// The folder from which a scene names its records; empty without a file.
    pub(in crate::app) fn folder(&self) -> &Path {
        self.document.file().and_then(Path::parent).unwrap_or(Path::new(""))
    }

    /// Where paths are asked for from: the file's own folder, else that of the file used last, else the current one.
    pub(in crate::app) fn folder_to_begin_in(&self) -> PathBuf {
        let own = Some(self.folder()).filter(|folder| !folder.as_os_str().is_empty());
        let last = || self.session.recent().first().and_then(|file| file.parent());
        own.or_else(last).map(Path::to_owned).or_else(|| std::env::current_dir().ok()).unwrap_or_default()
    }

    /// Another scene from now on; the one before can be had back by undo.
    ///
    /// # Errors
    /// As [`Document::open`].
    pub(in crate::app) fn take_up(&mut self, scene: Scene, source: SceneSource) -> Result<bool, EditError> {
        let file = source.file().map(Path::to_owned);
        let opened = self.document.open(scene, source);
        if let Some(file) = file {
            self.session.opened(&file, self.document.scene());
        }
        opened.map(|()| true)
    }

    /// Saves the scene as it is seen.
    pub(in crate::app) fn save(&mut self, as_seen: &Scene, path: &Path) -> Saved {
        if self.document.file() == Some(path) && self.session.is_kept() && !self.compare().same {
            return Saved::Question;
        }
        if let Err(error) = save_scene(as_seen, &self.document.source(), path) {
            return Saved::Failed(error.to_string());
        }
        self.forget_work();
        self.document.saved_as(path.to_owned());
        self.session.opened(path, self.document.scene());
        Saved::Done(told(text::SAVED.as_str(), path))
    }

    /// Compares the file with what was last seen of it.
    pub(in crate::app) fn compare(&mut self) -> Compared {
        self.session.compare(&mut self.document)
    }

    /// Executes a command; returns the step left to do.
    ///
    /// # Errors
    /// In words: a file that cannot be removed or written.
    pub(in crate::app) fn apply(&mut self, command: KeepCommand) -> Result<Left, String> {
        match command {
            KeepCommand::Recover(number) => {
                return Ok(self.session.take_found(number).map_or(Left::Nothing, Left::Recover));
            }
            KeepCommand::Discard(number) => self.session.discard(number).map_err(|e| e.to_string())?,
            KeepCommand::Later => self.session.leave_found(),
            KeepCommand::Reload => {
                self.session.keep_mine(&mut self.document);
                return Ok(self.document.file().map_or(Left::Nothing, |file| Left::Reload(file.to_owned())));
            }
            KeepCommand::KeepMine => self.session.keep_mine(&mut self.document),
            KeepCommand::Forget(file) => self.session.forget(&file)?,
            KeepCommand::ForgetAll => self.session.forget_all()?,
        }
        Ok(Left::Nothing)
    }

    /// Brings found work back as an edit of its file's scene, or as a scene without a file.
    ///
    /// # Errors
    /// As [`Document::open`].
    pub(in crate::app) fn recover(
        &mut self,
        found: &Found,
        scene: Scene,
        as_seen: impl FnOnce(&Scene) -> Scene,
    ) -> Result<bool, EditError> {
        self.document.select(SelectCommand::Only(None));
        let done = if found.file.is_some() && found.file.as_deref() == self.document.file() {
            self.document.edit(Edit::Scene(Box::new(scene)), None)
        } else {
            self.keep_work_now(as_seen);
            let opened = self.document.open(scene, found.source());
            self.document.unsave();
            opened.map(|()| true)
        };
        self.session.adopt(self.document.origin_id(), self.document.revision(), &found.path);
        done
    }

    /// Keeps unsaved work when it is time: when to come back, and what went wrong.
    pub(in crate::app) fn keep_work(
        &mut self,
        as_seen: impl FnOnce(&Scene) -> Scene,
    ) -> (Option<Duration>, Option<String>) {
        self.session.keep_work(&self.document, || as_seen(self.document.scene()))
    }

    /// Keeps unsaved work now: something else is about to be opened, or the window ends otherwise than by being closed.
    pub(in crate::app) fn keep_work_now(&mut self, as_seen: impl FnOnce(&Scene) -> Scene) {
        self.session.keep_work_now(&self.document, || as_seen(self.document.scene()));
    }

    /// The work is saved or given up.
    pub(in crate::app) fn forget_work(&mut self) {
        self.session.forget_work(self.document.origin_id());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::edits;
    use crate::scene::presets;

    #[test]
    fn a_saved_scene_is_named_after_its_file_and_lost_no_more() {
        let folder = tempfile::tempdir().expect("a folder");
        let scene = presets::load(presets::OPENING).expect("ships");
        let mut files = SceneFiles::new(scene.clone(), SceneSource::New);
        assert_eq!((files.name(), files.folder()), (scene.name.clone(), Path::new("")), "no file yet");
        let renamed = Scene { name: "east".into(), ..scene };
        files.document.edit(Edit::Scene(Box::new(renamed)), None).expect("fits");
        let path = folder.path().join("bridge.toml");
        let as_seen = files.document.scene().clone();
        assert!(matches!(files.save(&as_seen, &path), Saved::Done(_)), "there is room");
        assert!(!files.document.is_dirty(), "it is on the disk");
        assert_eq!((files.name().as_str(), files.folder()), ("bridge.toml", folder.path()), "named after it");
        assert!(matches!(files.save(&as_seen, folder.path()), Saved::Failed(_)), "a folder is no file");
    }

    #[test]
    fn work_on_a_preset_that_is_brought_back_is_saved_with_its_comments() {
        let folder = tempfile::tempdir().expect("a folder");
        let preset = presets::get(presets::OPENING).expect("ships");
        let scene = presets::load(preset.name).expect("ships");
        let opened = |source| {
            let mut files = SceneFiles::new(scene.clone(), source);
            files.keep_in(folder.path(), std::sync::Arc::new(|| ()));
            files
        };
        let mut left = opened(SceneSource::of(preset.name));
        left.document.edit(edits::duration(&scene, 7.25), None).expect("fits");
        left.keep_work_now(Scene::clone);
        left.session.wait();
        drop(left);
        let mut files = opened(SceneSource::New);
        let Ok(Left::Recover(found)) = files.apply(KeepCommand::Recover(0)) else { panic!("it was left") };
        let unsaved = crate::files::load_unsaved(&found.path).expect("a scene");
        assert!(files.recover(&found, unsaved, Scene::clone).expect("fits"), "another scene");
        let path = folder.path().join("saved.toml");
        let back = files.document.scene().clone();
        assert!(matches!(files.save(&back, &path), Saved::Done(_)), "there is room");
        let line = preset.text.lines().find(|line| line.starts_with("duration_s = ")).expect("it has one");
        let saved = std::fs::read_to_string(&path).expect("text");
        assert_eq!(saved, preset.text.replacen(line, "duration_s = 7.25", 1), "its comments and its order");
    }

    #[test]
    fn a_preset_is_saved_with_its_comments() {
        let folder = tempfile::tempdir().expect("a folder");
        for preset in presets::all() {
            let scene = presets::load(preset.name).expect("ships");
            let mut files = SceneFiles::new(scene.clone(), SceneSource::of(preset.name));
            let path = folder.path().join(preset.name).with_extension("toml");
            let saved = |files: &mut SceneFiles| {
                let scene = files.document.scene().clone();
                assert!(matches!(files.save(&scene, &path), Saved::Done(_)), "there is room");
                std::fs::read_to_string(&path).expect("text")
            };
            assert_eq!(saved(&mut files), preset.text, "{}: as it comes", preset.name);
            let mut files = SceneFiles::new(edits::empty(), SceneSource::New);
            files.take_up(scene.clone(), SceneSource::of(preset.name)).expect("fits");
            files.document.edit(edits::duration(&scene, 7.25), None).expect("fits");
            let line = preset.text.lines().find(|line| line.starts_with("duration_s = ")).expect("it has one");
            assert_eq!(saved(&mut files), preset.text.replacen(line, "duration_s = 7.25", 1), "{}", preset.name);
            assert!(line.contains('#') || preset.text.contains('#'), "{} has comments", preset.name);
            assert_eq!(files.document.source(), SceneSource::File(path.clone()), "from then on a file");
        }
    }
}
