//! Does what commands ask: each goes to the part that it concerns, and the scene is run when it is another one.

use egui::Ui;

use super::window_state::Next;
use super::workbench::Workbench;
use crate::app::command::{
    AngleCommand, Command, CompareCommand, FileCommand, Filming, HandCommand, Learn, MapCommand, ViewCommand,
    WindowCommand,
};
use crate::app::host::share;
use crate::app::style::size::LECTURE;
use crate::app::text;
use crate::scene::edit::EditError;

impl Workbench {
    /// Does what is asked and, if that made a difference, asks for a frame that shows it: a mouse that is held still
    /// must not keep the window awake.
    pub(in crate::app) fn apply_all(&mut self, ui: &Ui, commands: Vec<Command>) {
        let before = self.state_shown();
        for command in commands {
            dress(ui, &command, self.view.display.sight.lecture);
            self.apply(command);
        }
        if let Some(answer) = self.replay.runner.answer() {
            self.view.display.rescale(answer);
        }
        if self.state_shown() != before {
            ui.request_repaint();
        }
    }

    /// Everything that commands can change and a frame shows.
    fn state_shown(&self) -> impl PartialEq + use<> {
        let document = (self.files.document.revision(), self.files.document.selection().clone());
        let replay = (self.replay.playback.clone(), self.replay.runner.is_stale());
        let beside = (
            self.files.session.seen(),
            self.tasks.films.plan,
            self.tasks.paths.seen(),
            self.learning,
            (self.maps.seen(), self.angles.seen(), self.shaking.seen()),
        );
        (
            document,
            replay,
            self.view.shown(),
            (self.comparison.numbers(), self.comparison.differences()),
            self.plots.clone(),
            (self.window.clone(), beside),
        )
    }

    /// Does one thing.
    pub fn apply(&mut self, command: impl Into<Command>) {
        match command.into() {
            Command::Time(command) => self.replay.apply(command),
            Command::Edit(command) => {
                let work = self.files.document.work();
                let done = self.files.document.apply(command);
                if self.files.document.work() != work {
                    // Taken back, or done again: another scene had been opened.
                    let scene = self.files.document.scene().clone();
                    self.turn_to_another_scene(&scene);
                }
                self.after(done);
            }
            Command::Place(command) => {
                let done = self.files.document.place(command);
                self.after(done);
            }
            Command::Hand(command) => self.apply_hand(&command),
            Command::Select(command) => self.files.document.select(command),
            Command::View(command) => self.view.apply(command, &self.files.document, &self.replay),
            Command::Compare(command) => self.apply_compare(command),
            Command::File(command) if self.would_replace_work(&command) => {
                self.window.ask_before(Next::File(command));
            }
            Command::File(command) => self.apply_file(command),
            Command::Keep(command) => self.apply_keep(command),
            Command::Film(command) => self.apply_film(command),
            Command::Learn(command @ Learn::Open(_)) if self.is_left_unsaved() => {
                self.window.ask_before(Next::Learn(command));
            }
            Command::Learn(command) => self.apply_learn(command),
            Command::Map(command) => self.apply_map(command),
            Command::Angles(command) => self.apply_angles(command),
            Command::Quake(command) => self.shaking.apply(command),
            Command::Plot(command) => self.plots.apply(command),
            Command::Window(command) => self.apply_window(command),
        }
    }

    /// Runs the scene when something was done to it; an edit that does not fit is told to the user.
    pub(super) fn after(&mut self, done: Result<bool, EditError>) {
        self.window.say_failure(done);
        self.run();
    }

    fn apply_hand(&mut self, command: &HandCommand) {
        let done = self.view.apply_hand(command, &mut self.files.document);
        self.after(done);
    }

    fn apply_compare(&mut self, command: CompareCommand) {
        let (document, answer) = (&self.files.document, self.replay.runner.fresh_answer());
        let what = document.undo_label().unwrap_or(&document.scene().name);
        let done = self.comparison.apply(command, answer, what);
        self.window.say_failure(done);
    }

    fn apply_map(&mut self, command: MapCommand) {
        let (scene, folder) = (self.files.document.scene(), self.files.folder());
        if let Some(edit) = self.maps.apply(command, scene, folder) {
            let done = self.files.document.edit(edit, None);
            self.after(done);
        }
    }

    fn apply_angles(&mut self, command: AngleCommand) {
        let (scene, folder) = (self.files.document.scene(), self.files.folder());
        if let Some(edit) = self.angles.apply(command, scene, folder) {
            let done = self.files.document.edit(edit, None);
            self.after(done);
        }
    }

    fn apply_film(&mut self, command: Filming) {
        let replayed = (self.replay.runner.full_answer(), self.replay.stretch());
        let pictured = (self.view.shot(), self.files.document.scene().name.as_str());
        if let Some(words) = self.tasks.apply(command, replayed, pictured) {
            self.window.say(words);
        }
    }

    fn apply_window(&mut self, command: WindowCommand) {
        if command == WindowCommand::CancelRun {
            self.replay.runner.cancel();
        }
        if command == WindowCommand::RunAgain {
            let document = &self.files.document;
            self.replay.runner.start(document.scene(), document.revision());
        }
        if command == WindowCommand::CopyLink {
            match self.link() {
                Ok(link) if share(&link) => self.window.say(text::LINK_COPIED),
                Ok(_) => {}
                Err(words) => self.window.say(words),
            }
        }
        if let WindowCommand::Language(language) = command {
            let kept = self.files.session.keep_language(language);
            self.window.say_failure(kept);
        }
        if command == WindowCommand::GiveUp {
            // Undo brings it back, and then it is kept again.
            self.files.forget_work();
            self.go_on();
        }
        if self.window.apply(command, self.files.document.is_dirty()) {
            // Saved, or given up.
            self.files.forget_work();
        }
    }

    /// Does what has waited for the scene to be saved or given up.
    pub(super) fn go_on(&mut self) {
        match self.window.go_on() {
            Some(Next::File(command)) => self.apply_file(command),
            Some(Next::Learn(command)) => self.apply_learn(command),
            Some(Next::Close) | None => {}
        }
    }

    /// Whether unsaved work would be left: what was tried in a lesson is none.
    fn is_left_unsaved(&self) -> bool {
        self.files.document.is_dirty() && self.learning.lesson().is_none()
    }

    fn would_replace_work(&self, command: &FileCommand) -> bool {
        self.is_left_unsaved()
            && matches!(
                command,
                FileCommand::OpenPreset(_) | FileCommand::Open(_) | FileCommand::New | FileCommand::Build(_)
            )
    }
}

/// What a command changes in egui's context: theme and size.
fn dress(ui: &Ui, command: &Command, lecture: bool) {
    if let Command::Window(WindowCommand::Theme(theme)) = command {
        ui.set_theme(*theme);
    }
    if let Command::Window(WindowCommand::Scale(scale)) = command {
        ui.set_zoom_factor(scale.clamp(0.5, 4.0));
    }
    if let Command::View(ViewCommand::Sight(sight)) = command
        && sight.lecture != lecture
    {
        ui.set_zoom_factor(if sight.lecture { LECTURE } else { 1.0 });
    }
}
