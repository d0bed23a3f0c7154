//! Commands about files, films and lessons: what they do to the parts of the workbench together.

use std::path::Path;

use super::workbench::Workbench;
use crate::app::command::{Export, FileCommand, Filming, Keep, Learn};
use crate::app::disk::scene_files::{Left, Saved};
use crate::app::disk::{export, film, record};
use crate::app::edits;
use crate::app::plot::plot_files;
use crate::files::{Found, SceneSource, load_scene, load_unsaved};
use crate::scene::Scene;
use crate::snapshot::Shot;

impl Workbench {
    pub(super) fn apply_file(&mut self, command: FileCommand) {
        match command {
            FileCommand::OpenPreset(name) => self.open(&name),
            FileCommand::Open(path) => self.open(&path.to_string_lossy()),
            FileCommand::New => self.take_up(edits::empty(), SceneSource::New),
            FileCommand::AskOpen => self.dialogs.open(),
            FileCommand::AskRecord => self.dialogs.record(),
            FileCommand::Record(path) => {
                match record::shaking_by(&path, self.files.folder(), &self.files.document.scene().motion) {
                    Ok(motion) => self.edit(edits::motion(motion), None),
                    Err(problem) => self.window.say(problem),
                }
            }
            FileCommand::Save => match self.files.document.file().map(Path::to_owned) {
                Some(file) => self.save(&file),
                None => self.ask_where_to_save(),
            },
            FileCommand::SaveAs => self.ask_where_to_save(),
            FileCommand::SaveTo(path) => self.save(&path),
            FileCommand::AskExport(what) => self.dialogs.export(what, &self.files.document.scene().name),
            FileCommand::Export(Export::Picture, path) => {
                let Some(list) = self.viewport.list().cloned() else { return };
                let (size, title) = (self.viewport.size(), self.files.document.scene().name.clone());
                self.background.run(move || export::picture(&list, size, &title, &path));
            }
            FileCommand::Export(Export::Tables, path) => {
                let Some(answer) = self.runner.answer().cloned() else { return };
                self.background.run(move || export::tables(&answer, &path));
            }
            FileCommand::AskPlots(format) => self.dialogs.plots(format, &self.files.document.scene().name),
            FileCommand::Plots(path) => {
                if let Some(work) = plot_files::writing(&self.plot_source(), path) {
                    self.background.run(work);
                }
            }
        }
    }

    pub(super) fn apply_keep(&mut self, command: Keep) {
        match self.files.apply(command) {
            Ok(Left::Nothing) => {}
            Ok(Left::Recover(found)) => self.recover(found),
            Ok(Left::Reload(file)) => {
                let mine = self.files.document.origin_id();
                self.open(&file.to_string_lossy());
                // Given up; undo brings it back, and then it is kept again.
                self.files.session.forget_work(mine);
            }
            Err(problem) => self.window.say(problem),
        }
    }

    pub(super) fn apply_film(&mut self, command: Filming) {
        let shot = Shot {
            camera: self.viewport.camera().copied(),
            size: self.viewport.size(),
            overlays: Some(self.display.overlays),
            background: self.viewport.background(),
            force_scale: self.display.force_scale(),
            ..Shot::default()
        };
        let source = film::Source {
            answer: self.runner.answer(),
            stretch: self.playback.window.unwrap_or([0.0, self.end()]),
            shot,
            name: &self.files.document.scene().name,
            dialogs: &self.dialogs,
            wake: self.wake(),
        };
        if let Some(words) = self.films.apply(command, source) {
            self.window.say(words);
        }
    }

    pub(super) fn apply_learn(&mut self, command: Learn) {
        match command {
            Learn::Open(number) => self.open_lesson(number),
            Learn::Reset => self.learning.number().into_iter().for_each(|number| self.open_lesson(number)),
            Learn::Close => self.learning.close(),
            Learn::Try(number) => {
                let (Some(open), Some(lesson)) = (self.learning.number(), self.learning.lesson()) else { return };
                if self.files.document.scene().name != lesson.name {
                    self.open_lesson(open);
                }
                if let Some(edit) = self.learning.try_edit(number) {
                    self.edit(edit, None);
                }
            }
        }
    }

    fn open_lesson(&mut self, number: usize) {
        let mut learning = self.learning;
        let Some(lesson) = learning.open(number) else { return };
        match lesson.scene() {
            Ok(scene) => {
                self.aim_next = Some(scene.view.camera);
                self.take_up(scene, lesson.source());
                self.learning = learning;
                self.playback.clock.t = lesson.at.min(self.end());
            }
            Err(errors) => self.window.say(errors.to_string()),
        }
    }

    /// Opens a preset or a file.
    fn open(&mut self, name: &str) {
        match load_scene(name, &[]) {
            Ok(scene) => self.take_up(scene, SceneSource::of(name)),
            Err(errors) => self.window.say(errors.to_string()),
        }
    }

    /// Goes on with another scene; undo brings the one before back.
    fn take_up(&mut self, scene: Scene, source: SceneSource) {
        self.keep_work_now();
        self.learning.close();
        self.look_as(&scene);
        let taken = self.files.take_up(scene, source);
        self.after(taken);
    }

    /// Looks at a scene as it wants to be looked at, from its start.
    fn look_as(&mut self, scene: &Scene) {
        self.display.take_from(scene);
        self.viewport.want(scene.view.camera);
        self.selection.only(None);
        self.playback.rewind();
    }

    fn ask_where_to_save(&mut self) {
        self.window.begin_saving();
        self.dialogs.save(&self.files.document.scene().name);
    }

    /// Saves the scene with the view as it is seen.
    fn save(&mut self, path: &Path) {
        let as_seen = self.display.scene_as_seen(self.files.document.scene());
        match self.files.save(&as_seen, path) {
            Saved::Done(words) => {
                self.window.say(words);
                self.window.saved();
            }
            Saved::Question => self.window.stay_open(),
            Saved::Failed(words) => {
                self.window.say(words);
                self.window.stay_open();
            }
        }
    }

    /// Keeps unsaved work now: something else is about to be opened, or the window ends otherwise than by being closed.
    pub(super) fn keep_work_now(&mut self) {
        self.files.keep_work_now(|scene| self.display.scene_as_seen(scene));
    }

    /// Brings found work back.
    fn recover(&mut self, found: Found) {
        match load_unsaved(&found.path) {
            Ok(scene) => {
                self.look_as(&scene);
                let done = self.files.recover(found, scene, |scene| self.display.scene_as_seen(scene));
                self.after(done);
            }
            Err(errors) => self.window.say(errors.to_string()),
        }
    }
}
