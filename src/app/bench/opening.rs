//! Scenes opened, saved and brought back, lessons, exports: what concerns files, view and replay together.

use std::path::Path;
use std::sync::Arc;

use super::workbench::Workbench;
use crate::app::command::{Export, FileCommand, KeepCommand, LearnCommand, PathCommand, Wish};
use crate::app::disk::record;
use crate::app::disk::scene_files::{Left, Saved};
use crate::app::edits;
use crate::app::host::share;
use crate::app::plot::plot_files;
use crate::app::run::answer::Answer;
use crate::app::text;
use crate::files::{Found, SceneSource, load_scene, load_unsaved};
use crate::scene::edit::Edit;
use crate::scene::{GroundId, Scene};

impl Workbench {
    pub(super) fn apply_file(&mut self, command: FileCommand) {
        match command {
            FileCommand::OpenPreset(name) => self.open(&name),
            FileCommand::Open(path) => self.open(&path.to_string_lossy()),
            FileCommand::New => self.take_up(edits::empty(), SceneSource::New),
            FileCommand::Build(draft) => match edits::bridge(draft) {
                Ok((scene, source)) => self.take_up(scene, source),
                Err(errors) => self.window.say(errors.to_string()),
            },
            FileCommand::Ask(wish) => self.ask(wish),
            FileCommand::Path(command) => self.apply_path(command),
            FileCommand::Record(ground, path) => {
                let Some(before) = self.files.document.scene().motion_of(ground) else { return };
                let shaking = record::shaking_by(&path, self.files.folder(), before);
                self.shake(ground, shaking);
            }
            FileCommand::Component(ground, number, path) => {
                let Some(before) = self.files.document.scene().motion_of(ground) else { return };
                let shaking = record::component_by(number, &path, self.files.folder(), before);
                self.shake(ground, shaking);
            }
            FileCommand::Shake(ground, record) => {
                let Some(before) = self.files.document.scene().motion_of(ground) else { return };
                let shaking = record::read_anew(*record, self.files.folder(), before);
                self.shake(ground, Ok(shaking));
            }
            FileCommand::Save => match self.files.document.file().map(Path::to_owned) {
                Some(file) => self.save(&file),
                None => self.ask(Wish::Save),
            },
            FileCommand::SaveTo(path) => self.save(&path),
            FileCommand::Export(Export::Picture, path) => {
                let Some(list) = self.view.viewport.list().cloned() else { return };
                let title = self.files.document.scene().name.clone();
                self.tasks.export_picture(list, self.view.viewport.size(), title, path);
            }
            FileCommand::Export(Export::Print, path) => {
                let Some(answer) = self.whole() else { return };
                let shot = self.view.shot_for_print(self.replay.t());
                let list = Arc::new(shot.list(&answer.history));
                let title = self.files.document.scene().name.clone();
                self.tasks.export_picture(list, shot.size, title, path);
            }
            FileCommand::Export(Export::Tables, path) => {
                if let Some(answer) = self.whole()
                    && !self.tasks.export_tables(answer, path)
                {
                    self.window.say(text::BEING_WRITTEN);
                }
            }
            FileCommand::Export(Export::Report, path) => {
                if let Some(answer) = self.whole()
                    && !self.tasks.export_report(answer, path)
                {
                    self.window.say(text::BEING_WRITTEN);
                }
            }
            FileCommand::CopyLink => match self.link() {
                Ok(link) if share(&link) => self.window.say(text::LINK_COPIED),
                Ok(_) => {}
                Err(words) => self.window.say(words),
            },
            FileCommand::Plots(path) => {
                if let Some(work) = plot_files::writing(&self.plot_source(), path) {
                    self.tasks.begin(work);
                }
            }
            FileCommand::ShowFolder(folder) => self.tasks.show_folder(folder),
        }
    }

    /// The answer, computed in full; where a coarse pass is shown that is said instead.
    fn whole(&mut self) -> Option<Arc<Answer>> {
        let answer = self.replay.runner.full_answer().cloned();
        if self.replay.runner.is_coarse() {
            self.window.say(text::STILL_COARSE);
        }
        answer
    }

    pub(super) fn apply_keep(&mut self, command: KeepCommand) {
        match self.files.apply(command) {
            Ok(Left::Nothing) => {}
            Ok(Left::Recover(found)) => self.recover(&found),
            Ok(Left::Reload(file)) => {
                // Given up; undo brings it back, and then it is kept again.
                self.files.forget_work();
                self.open(&file.to_string_lossy());
            }
            Err(problem) => self.window.say(problem),
        }
    }

    pub(super) fn apply_learn(&mut self, command: LearnCommand) {
        match command {
            LearnCommand::Open(number) => self.open_lesson(number),
            LearnCommand::Reset => self.begin_lesson_anew(),
            LearnCommand::Close => self.learning.close(),
            LearnCommand::Try(number) => {
                let (Some(open), Some(lesson)) = (self.learning.number(), self.learning.lesson()) else { return };
                if self.files.document.scene().name != lesson.name {
                    self.open_lesson(open);
                }
                let Some(to_try) = self.learning.to_try(number) else { return };
                self.edit(to_try.edit());
                self.learning.note(number);
                // Its run may not be there yet: the time is kept inside it when it comes.
                self.replay.playback.clock.t = to_try.at.unwrap_or(self.replay.playback.clock.t);
            }
        }
    }

    /// Changes the motion of a ground; a file that could not be read shows a message.
    fn shake(&mut self, ground: GroundId, shaking: Result<record::Shaking, String>) {
        match shaking {
            Ok((motion, unread)) => {
                self.edit(edits::motion(self.files.document.scene(), ground, motion));
                if let Some(words) = unread {
                    self.window.say(words);
                }
            }
            Err(problem) => self.window.say(problem),
        }
    }

    /// Changes the scene in one step.
    pub(super) fn edit(&mut self, edit: Edit) {
        let done = self.files.document.edit(edit, None);
        self.after(done);
    }

    pub(super) fn open_lesson(&mut self, number: usize) {
        let mut learning = self.learning;
        let Some(lesson) = learning.open(number) else { return };
        match lesson.scene() {
            Ok(scene) => {
                self.view.aim_next(scene.view.camera);
                self.take_up(scene, lesson.source());
                self.learning = learning;
                self.replay.playback.clock.t = lesson.at.min(self.replay.end());
            }
            Err(errors) => self.window.say(errors.to_string()),
        }
    }

    /// Brings the scene of the lesson that is open back: an edit, as what was tried is, beside which kept runs stay.
    fn begin_lesson_anew(&mut self) {
        let (Some(open), Some(lesson)) = (self.learning.number(), self.learning.lesson()) else { return };
        match lesson.scene() {
            Ok(scene) if self.files.document.scene().name == lesson.name => {
                self.view.look_as(&scene);
                self.edit(Edit::Scene(Box::new(scene)));
                self.learning.open(open);
                self.replay.playback.clock.t = lesson.at;
            }
            _ => self.open_lesson(open),
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
    pub(super) fn take_up(&mut self, scene: Scene, source: SceneSource) {
        if self.learning.lesson().is_some() {
            // What was tried in a lesson is no work.
            self.files.forget_work();
        }
        self.turn_to_another_scene(&scene);
        let taken = self.files.take_up(scene, source);
        self.after(taken);
    }

    /// Brings found work back.
    fn recover(&mut self, found: &Found) {
        match load_unsaved(&found.path) {
            Ok(scene) => {
                // What is about to be left is kept with the view that it has.
                let display = self.view.display.clone();
                self.turn_to_another_scene(&scene);
                let done = self.files.recover(found, scene, |scene| display.scene_as_seen(scene));
                self.after(done);
            }
            Err(errors) => self.window.say(errors.to_string()),
        }
    }

    /// Asks for a path.
    fn ask(&mut self, wish: Wish) {
        if wish == Wish::Save {
            self.window.begin_saving();
        }
        let folder = self.files.folder_to_begin_in();
        self.tasks.ask(wish, &self.files.document.scene().name, &folder);
    }

    fn apply_path(&mut self, command: PathCommand) {
        if command == PathCommand::Leave {
            self.window.stay_open();
        }
        if let Some(then) = self.tasks.paths.apply(command) {
            self.apply(then);
        }
    }

    /// Saves the scene with the view as it is seen.
    fn save(&mut self, path: &Path) {
        let as_seen = self.view.display.scene_as_seen(self.files.document.scene());
        match self.files.save(&as_seen, path) {
            Saved::Done(words) => {
                self.window.say(words);
                self.go_on();
            }
            Saved::Question => self.window.stay_open(),
            Saved::Failed(words) => {
                self.window.say(words);
                self.window.stay_open();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::command::{Command, CompareCommand, EditCommand, LeaveCommand, PlaceCommand};
    use crate::app::learn::lessons::lessons;
    use crate::scene::presets;

    fn opened() -> Workbench {
        let mut bench = Workbench::new(presets::load(presets::OPENING).expect("ships"), SceneSource::New);
        bench.replay.runner.set_estimates(false);
        bench.tasks.set_silent();
        bench
    }

    #[test]
    fn another_scene_is_run_looked_at_and_nothing_is_selected_in_it() {
        let mut bench = opened();
        bench.apply(PlaceCommand::AddGirder);
        assert!(!bench.files.document.selection().all().is_empty(), "the new one");
        let other = presets::all().iter().find(|p| p.name != presets::OPENING).expect("there are several");
        bench.apply(FileCommand::OpenPreset(other.name.into()));
        assert!(bench.window.asks(), "the new girder is not saved");
        bench.apply(LeaveCommand::GiveUp);
        bench.replay.runner.wait();
        assert_eq!(bench.files.document.scene().name, other.name, "opened");
        assert!(bench.files.document.selection().all().is_empty(), "nothing of the scene before");
        let run = bench.replay.runner.answer().expect("it runs");
        assert_eq!(run.history.scene(), bench.files.document.scene(), "it is what is shown");
        bench.apply(EditCommand::Undo);
        assert_eq!(bench.files.document.scene().name, presets::load(presets::OPENING).expect("ships").name, "back");
    }

    #[test]
    fn a_lesson_opens_at_its_time_and_its_tries_change_its_own_scene() {
        let mut bench = opened();
        bench.apply(Command::Learn(LearnCommand::Open(0)));
        let lesson = &lessons()[0];
        bench.replay.runner.wait();
        assert_eq!(bench.replay.t(), lesson.at.min(bench.replay.end()), "where there is something to see");
        bench.apply(FileCommand::New);
        assert!(bench.learning.lesson().is_none(), "another scene closes it");
        bench.apply(Command::Learn(LearnCommand::Open(0)));
        let before = bench.files.document.revision();
        bench.apply(Command::Learn(LearnCommand::Try(0)));
        assert!(bench.files.document.revision() > before && bench.window.notice().is_none(), "tried");
    }

    #[test]
    fn a_lesson_that_begins_anew_keeps_the_runs_to_compare_with() {
        let mut bench = opened();
        bench.apply(Command::Learn(LearnCommand::Open(0)));
        bench.apply(Command::Learn(LearnCommand::Try(0)));
        bench.replay.runner.wait();
        bench.apply(CompareCommand::Pin);
        bench.apply(Command::Learn(LearnCommand::Reset));
        let (scene, lesson) = (bench.files.document.scene(), &lessons()[0]);
        assert_eq!(*scene, lesson.scene().expect("part of the program"), "as it opens");
        assert_eq!((bench.learning.number(), bench.learning.in_force(scene)), (Some(0), None), "nothing is tried");
        assert_eq!(bench.comparison.pins().len(), 1, "what was tried is still there to compare with");
        bench.apply(EditCommand::Undo);
        assert_ne!(*bench.files.document.scene(), lesson.scene().expect("part of the program"), "as it was tried");
    }

    #[test]
    fn a_file_that_cannot_be_read_leaves_the_scene_and_is_told() {
        let mut bench = opened();
        let before = bench.files.document.revision();
        bench.apply(FileCommand::Open("no/such/file.toml".into()));
        assert_eq!(bench.files.document.revision(), before, "the scene that was there");
        assert!(bench.window.notice().is_some_and(|words| words.contains("file.toml")), "why");
    }
}
