//! Work beside the window on threads of its own: the system's dialogs, exports, films.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::app::command::{Command, FilmCommand, Wish};
use crate::app::disk::dialogs::Dialogs;
use crate::app::disk::export;
use crate::app::disk::film::{Films, Source};
use crate::app::disk::path_field::PathField;
use crate::app::disk::show_folder;
use crate::app::host::{Background, Told, Wake};
use crate::app::run::answer::Answer;
use crate::snapshot::Shot;
use crate::view::DrawList;

/// Dialogs that are open, files that are written, and a film on its way.
pub struct Tasks {
    pub(in crate::app) dialogs: Dialogs,
    /// The path that is asked for in the window.
    pub paths: PathField,
    /// The film dialog's plan, and the film that is being written.
    pub films: Films,
    background: Background,
    wake: Wake,
}

impl Default for Tasks {
    fn default() -> Self {
        let wake: Wake = Arc::new(|| ());
        Self {
            dialogs: Dialogs::new(wake.clone()),
            paths: PathField::default(),
            films: Films::default(),
            background: Background::new(wake.clone()),
            wake,
        }
    }
}

impl Tasks {
    /// Tells who is woken when a thread has news.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.dialogs.set_wake(wake.clone());
        self.background.set_wake(wake.clone());
        self.wake = wake;
    }

    pub(in crate::app) fn wake(&self) -> Wake {
        self.wake.clone()
    }

    /// Asks for no paths: there is no user to answer.
    pub fn set_silent(&mut self) {
        self.dialogs.silent = true;
    }

    /// Asks for a path: by the system's dialog, or in the window where that is wanted or there is none. New files are called
    /// `name`, and `folder` is where it begins.
    pub(in crate::app) fn ask(&mut self, wish: Wish, name: &str, folder: &Path) {
        self.paths.begin_in(folder, name);
        if self.dialogs.silent {
            return;
        }
        if self.paths.is_here() {
            self.paths.ask(wish);
        } else {
            self.dialogs.ask(wish, name);
        }
    }

    /// Shows a folder in the system's own window of files; a message where there is none.
    pub(in crate::app) fn show_folder(&self, folder: PathBuf) {
        self.begin(move || show_folder::show(&folder));
    }

    /// Choices in dialogs since the last call.
    pub(in crate::app) fn chosen(&self) -> Vec<Command> {
        self.dialogs.take()
    }

    /// Messages on work that has ended.
    pub(in crate::app) fn ended(&mut self) -> Vec<Told> {
        [self.background.take(), self.films.poll()].into_iter().flatten().collect()
    }

    /// Begins work that ends with a sentence for the user.
    pub(in crate::app) fn begin(&self, work: impl FnOnce() -> Result<Told, String> + Send + 'static) {
        self.background.run(Box::new(work));
    }

    /// Begins to write a picture of a list, `size` in pixels.
    pub(in crate::app) fn export_picture(&self, list: Arc<DrawList>, size: [u32; 2], title: String, path: PathBuf) {
        self.background.run_later(export::picture(list, size, title, path));
    }

    /// Begins to write the tables of an answer into a folder; `false` where they are being written there.
    pub(in crate::app) fn export_tables(&self, answer: Arc<Answer>, folder: PathBuf) -> bool {
        self.background.write(&folder.clone(), Box::new(move || export::tables(&answer, &folder)))
    }

    /// Begins to write the report of an answer; `false` where it is being written there.
    pub(in crate::app) fn export_report(&self, answer: Arc<Answer>, path: PathBuf) -> bool {
        self.background.write(&path.clone(), Box::new(move || export::report(&answer, &path)))
    }

    /// Files and folders that are being written.
    pub(in crate::app) fn written(&self) -> Vec<PathBuf> {
        self.background.written()
    }

    /// Executes a command on a film of an answer, of a stretch of it \[s\], each picture taken as `shot`; returns a message to the user.
    pub(in crate::app) fn apply(
        &mut self,
        command: FilmCommand,
        (answer, stretch): (Option<&Arc<Answer>>, [f64; 2]),
        (shot, name): (Shot, &str),
    ) -> Option<&'static str> {
        let source = Source { answer, stretch, shot, name, wake: self.wake.clone() };
        self.films.apply(command, source)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::channel;

    use super::*;
    use crate::app::text;

    #[test]
    fn work_that_has_ended_wakes_the_window_and_tells_how() {
        let (send, woken) = channel();
        let mut tasks = Tasks::default();
        tasks.set_wake(Arc::new(move || send.send(()).expect("the test listens")));
        tasks.begin(|| Ok("written".into()));
        woken.recv().expect("the window is woken");
        assert_eq!(tasks.ended(), [Told::from("written")], "once it has ended");
        assert!(tasks.ended().is_empty(), "once");
    }

    #[test]
    fn a_film_is_planned_over_the_stretch_in_view_and_asks_for_no_path_in_silence() {
        let mut tasks = Tasks::default();
        tasks.set_silent();
        let mut film = |command| tasks.apply(command, (None, [1.0, 3.0]), (Shot::default(), "deck"));
        assert_eq!(film(FilmCommand::Ask), None, "nothing to tell");
        assert_eq!(film(FilmCommand::Cancel), Some(text::FILM_CANCELLED.as_str()), "it is said");
        let plan = tasks.films.plan.expect("the dialog is open");
        assert_eq!((plan.from, plan.to), (1.0, 3.0), "what is in view");
        assert!(tasks.chosen().is_empty(), "no path was chosen");
    }
}
