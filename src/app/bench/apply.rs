//! Does what commands ask: each goes to the part that it concerns, and the scene is run when it is another one.

use egui::{Theme, Ui};

use super::window_state::Next;
use super::workbench::Workbench;
use crate::app::command::{
    AngleCommand, AppearanceCommand, Command, CompareCommand, FileCommand, FilmCommand, HandCommand, LearnCommand,
    LeaveCommand, MapCommand, RunCommand, ViewCommand, WindowCommand,
};
use crate::app::style::size::LECTURE;
use crate::files::{Chosen, Settings};
use crate::scene::edit::EditError;

impl Workbench {
    /// Does what is asked and, if that made a difference, asks for a frame that shows it: a mouse that is held still
    /// must not keep the window awake.
    pub(in crate::app) fn apply_all(&mut self, ui: &Ui, commands: Vec<Command>) {
        let before = self.state_shown();
        for command in commands {
            dress(ui, &command, self.view.display.sight.lecture, self.files.session.chosen().scale);
            self.apply(command);
        }
        if let Some(answer) = self.replay.runner.answer() {
            self.view.display.rescale(answer);
        }
        if self.state_shown() != before {
            ui.request_repaint();
        }
    }

    /// Everything that commands can change and a frame shows; a part that is added has to be named here.
    fn state_shown(&self) -> impl PartialEq + use<> {
        let Self { files, replay, comparison, view, learning, maps, angles, shaking, plots, tasks, window, samples: _ } =
            self;
        let document = (files.document.revision(), files.document.selection().clone());
        (
            (document, files.session.seen()),
            (replay.playback.clone(), replay.runner.is_stale()),
            (comparison.numbers(), comparison.differences()),
            (view.shown(), plots.clone()),
            (*learning, maps.seen(), angles.seen(), shaking.seen()),
            (tasks.films.plan, tasks.paths.seen()),
            window.clone(),
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
            Command::Learn(command @ LearnCommand::Open(_)) if self.is_left_unsaved() => {
                self.window.ask_before(Next::Learn(command));
            }
            Command::Learn(command) => self.apply_learn(command),
            Command::Map(command) => self.apply_map(command),
            Command::Angles(command) => self.apply_angles(command),
            Command::Quake(command) => self.shaking.apply(command),
            Command::Plot(command) => self.plots.apply(command),
            Command::Run(command) => self.apply_run(command),
            Command::Appearance(command) => self.apply_appearance(command),
            Command::Leave(command) => self.apply_leave(command),
            Command::Window(command) => self.apply_window(command),
        }
    }

    fn apply_window(&mut self, command: WindowCommand) {
        self.window.apply(command);
        let folded = self.window.folds.panels();
        if folded != self.files.session.chosen().folded {
            self.keep_chosen(Chosen { folded, ..*self.files.session.chosen() });
        }
    }

    /// Keeps a choice for the next start.
    fn keep_chosen(&mut self, chosen: Chosen) {
        let kept = self.files.session.keep(chosen);
        self.window.say_failure(kept);
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
            self.edit(edit);
        }
    }

    fn apply_angles(&mut self, command: AngleCommand) {
        let (scene, folder) = (self.files.document.scene(), self.files.folder());
        if let Some(edit) = self.angles.apply(command, scene, folder) {
            self.edit(edit);
        }
    }

    fn apply_film(&mut self, command: FilmCommand) {
        let replayed = (self.replay.runner.full_answer(), self.replay.stretch());
        let pictured = (self.view.shot(), self.files.document.scene().name.as_str());
        if let Some(words) = self.tasks.apply(command, replayed, pictured) {
            self.window.say(words);
        }
    }

    fn apply_run(&mut self, command: RunCommand) {
        match command {
            RunCommand::Cancel => self.replay.runner.cancel(),
            RunCommand::Again => {
                let document = &self.files.document;
                self.replay.runner.start(document.scene(), document.revision());
            }
        }
    }

    /// Keeps what was chosen for the next start; theme and size are those of egui's context, which [`dress`] changes.
    fn apply_appearance(&mut self, command: AppearanceCommand) {
        let mut chosen = *self.files.session.chosen();
        match command {
            AppearanceCommand::Language(language) => {
                self.window.language = language;
                chosen.language = Some(language);
            }
            AppearanceCommand::Theme(theme) => chosen.dark = Some(theme == Theme::Dark),
            AppearanceCommand::Scale(scale) => chosen.scale = Some(Settings::scale_within(scale)),
        }
        self.keep_chosen(chosen);
    }

    fn apply_leave(&mut self, command: LeaveCommand) {
        if command == LeaveCommand::GiveUp {
            // Undo brings it back, and then it is kept again.
            self.files.forget_work();
            self.go_on();
        } else if self.window.leave(command, self.files.document.is_dirty()) {
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

/// Brings egui's context to the theme and the size that were chosen in an earlier window.
pub(in crate::app) fn dress_as_chosen(context: &egui::Context, chosen: &Chosen) {
    if let Some(dark) = chosen.dark {
        context.set_theme(if dark { Theme::Dark } else { Theme::Light });
    }
    if let Some(scale) = chosen.scale {
        context.set_zoom_factor(scale);
    }
}

/// Applies a command's change to egui's context: theme and size; outside the lecture mode the chosen size.
fn dress(ui: &Ui, command: &Command, lecture: bool, chosen: Option<f32>) {
    match command {
        Command::Appearance(AppearanceCommand::Theme(theme)) => ui.set_theme(*theme),
        Command::Appearance(AppearanceCommand::Scale(scale)) => ui.set_zoom_factor(Settings::scale_within(*scale)),
        _ => {}
    }
    if let Command::View(ViewCommand::Sight(sight)) = command
        && sight.lecture != lecture
    {
        ui.set_zoom_factor(if sight.lecture { LECTURE } else { chosen.unwrap_or(1.0) });
    }
}
