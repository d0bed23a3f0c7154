//! Commands about files, films and lessons: what they do to the parts of the workbench together.

use std::path::{Path, PathBuf};

use super::workbench::Workbench;
use crate::app::command::{Export, FileCommand, FilmPlan, Filming, Keep, Learn};
use crate::app::disk::{export, film, record};
use crate::app::plot::plot_files;
use crate::app::{edits, text};
use crate::files::{load_scene, load_unsaved, save_scene};
use crate::scene::Scene;
use crate::scene::edit::Edit;
use crate::snapshot::Shot;

impl Workbench {
    pub(super) fn apply_file(&mut self, command: FileCommand) {
        match command {
            FileCommand::OpenPreset(name) => self.open(&name, None),
            FileCommand::Open(path) => self.open(&path.to_string_lossy(), Some(path.clone())),
            FileCommand::New => self.take_up(edits::empty(), None),
            FileCommand::AskOpen => self.dialogs.open(),
            FileCommand::AskRecord => self.dialogs.record(),
            FileCommand::Record(path) => {
                let folder = self.document.file().and_then(Path::parent).unwrap_or(Path::new(""));
                match record::shaking_by(&path, folder, &self.document.scene().motion) {
                    Ok(motion) => self.edit(edits::motion(motion), None),
                    Err(problem) => self.window.say(problem),
                }
            }
            FileCommand::Save => match self.document.file().map(Path::to_owned) {
                Some(file) => self.save(&file),
                None => self.ask_where_to_save(),
            },
            FileCommand::SaveAs => self.ask_where_to_save(),
            FileCommand::SaveTo(path) => self.save(&path),
            FileCommand::AskExport(what) => self.dialogs.export(what, &self.document.scene().name),
            FileCommand::Export(what, path) => self.export(what, path),
            FileCommand::AskPlots(format) => self.dialogs.plots(format, &self.document.scene().name),
            FileCommand::Plots(path) => {
                if let Some(work) = plot_files::writing(&self.plot_source(), path) {
                    self.background.run(work);
                }
            }
        }
    }

    pub(super) fn apply_keep(&mut self, command: Keep) {
        match command {
            Keep::Recover => self.recover(),
            Keep::Discard => {
                let done = self.session.discard();
                self.window.say_failure(done);
            }
            Keep::Later => drop(self.session.take_found()),
            Keep::Reload => self.reload(),
            Keep::KeepMine => self.session.keep_mine(&mut self.document),
            Keep::Forget(file) => {
                let done = self.session.forget(&file);
                self.window.say_failure(done);
            }
            Keep::ForgetAll => {
                let done = self.session.forget_all();
                self.window.say_failure(done);
            }
        }
    }

    pub(super) fn apply_film(&mut self, command: Filming) {
        match command {
            Filming::Ask => {
                let [from, to] = self.playback.window.unwrap_or([0.0, self.end()]);
                self.films.plan = Some(FilmPlan::of(from, to));
            }
            Filming::Plan(plan) => self.films.plan = Some(plan),
            Filming::Never => self.films.plan = None,
            Filming::Choose => {
                if let Some(plan) = self.films.plan {
                    self.dialogs.film(plan.format, &film::file_stem(&self.document.scene().name));
                }
            }
            Filming::Shoot(path) => self.shoot(path),
            Filming::Cancel => {
                self.films.cancel();
                self.window.say(text::FILM_CANCELLED);
            }
        }
    }

    fn shoot(&mut self, path: PathBuf) {
        let (Some(plan), Some(answer)) = (self.films.plan.take(), self.runner.answer().cloned()) else { return };
        let shot = Shot {
            camera: self.viewport.camera().copied(),
            size: plan.size.unwrap_or(self.viewport.size()),
            overlays: Some(self.display.overlays),
            background: self.viewport.background(),
            force_scale: self.display.force_scale(),
            ..Shot::default()
        };
        let name = film::file_stem(&self.document.scene().name);
        self.films.shoot(film::Order { answer, plan, shot, name }, path, self.wake());
    }

    pub(super) fn apply_learn(&mut self, command: Learn) {
        match command {
            Learn::Open(number) => self.open_lesson(number),
            Learn::Reset => self.learning.number().into_iter().for_each(|number| self.open_lesson(number)),
            Learn::Close => self.learning.close(),
            Learn::Try(number) => {
                let (Some(open), Some(lesson)) = (self.learning.number(), self.learning.lesson()) else { return };
                if self.document.scene().name != lesson.name {
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
                self.take_up(scene, None);
                self.learning = learning;
                self.playback.clock.t = lesson.at.min(self.end());
            }
            Err(errors) => self.window.say(errors.to_string()),
        }
    }

    fn open(&mut self, name: &str, file: Option<PathBuf>) {
        match load_scene(name, &[]) {
            Ok(scene) => self.take_up(scene, file),
            Err(errors) => self.window.say(errors.to_string()),
        }
    }

    /// Goes on with another scene; undo brings the one before back.
    fn take_up(&mut self, scene: Scene, file: Option<PathBuf>) {
        self.keep_work_now();
        self.learning.close();
        self.look_as(&scene);
        let opened = self.document.open(scene, file.clone());
        self.after(opened.map(|()| true));
        if let Some(file) = file {
            self.session.opened(&file, self.document.scene());
        }
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
        self.dialogs.save(&self.document.scene().name);
    }

    /// Saves the scene with the view as it is seen.
    fn save(&mut self, path: &Path) {
        if self.document.file() == Some(path) && self.session.is_kept() && !self.compare_with_disk() {
            // First the question what to do about the other program's changes.
            self.window.stay_open();
            return;
        }
        match save_scene(&self.display.scene_as_seen(self.document.scene()), self.document.file(), path) {
            Ok(()) => {
                self.forget_work();
                self.document.saved_as(path.to_owned());
                self.session.opened(path, self.document.scene());
                self.window.say(format!("{}: {}", text::SAVED, path.display()));
                self.window.saved();
            }
            Err(error) => {
                self.window.say(error.to_string());
                self.window.stay_open();
            }
        }
    }

    fn export(&self, what: Export, path: PathBuf) {
        match what {
            Export::Picture => {
                let Some(list) = self.viewport.list().cloned() else { return };
                let (size, title) = (self.viewport.size(), self.document.scene().name.clone());
                self.background.run(move || export::picture(&list, size, &title, &path));
            }
            Export::Tables => {
                let Some(answer) = self.runner.answer().cloned() else { return };
                self.background.run(move || export::tables(&answer, &path));
            }
        }
    }

    /// Keeps unsaved work now: something else is about to be opened, or the window ends otherwise than by being closed.
    pub(in crate::app) fn keep_work_now(&mut self) {
        let Self { session, document, display, .. } = self;
        session.keep_work_now(document, || display.scene_as_seen(document.scene()));
    }

    /// The work is saved or given up.
    pub(in crate::app) fn forget_work(&mut self) {
        self.session.forget_work(self.document.origin_id());
    }

    /// Whether the file is as it was last seen; if not, the window says so or asks.
    pub(in crate::app) fn compare_with_disk(&mut self) -> bool {
        let compared = self.session.compare(&mut self.document);
        if let Some(words) = compared.notice {
            self.window.say(words);
        }
        compared.same
    }

    /// Reads the file again that another program has changed.
    fn reload(&mut self) {
        let Some(file) = self.document.file().map(Path::to_owned) else { return };
        let mine = self.document.origin_id();
        self.session.keep_mine(&mut self.document);
        self.open(&file.to_string_lossy(), Some(file.clone()));
        // Given up; undo brings it back, and then it is kept again.
        self.session.forget_work(mine);
    }

    /// Brings found work back as an edit of its file's scene, or as a scene without a file.
    fn recover(&mut self) {
        let Some(found) = self.session.take_found() else { return };
        let scene = match load_unsaved(&found.path) {
            Ok(scene) => scene,
            Err(errors) => return self.window.say(errors.to_string()),
        };
        self.look_as(&scene);
        if found.file.is_some() && found.file.as_deref() == self.document.file() {
            self.edit(Edit::Scene(Box::new(scene)), None);
        } else {
            self.keep_work_now();
            let opened = self.document.open(scene, found.file);
            self.document.unsave();
            self.after(opened.map(|()| true));
        }
        self.session.adopt(self.document.origin_id(), self.document.revision(), &found.path);
    }
}
