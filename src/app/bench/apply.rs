//! Does what commands ask: the one place where the workbench changes.

use egui::Ui;

use super::workbench::Workbench;
use crate::app::command::{Command, HandCommand, PlaceCommand, ViewCommand, WindowCommand};
use crate::app::edits::placed;
use crate::app::style::size::LECTURE;
use crate::app::viewport::hand::Keyed;
use crate::app::viewport::picture::bounds_of;
use crate::scene::edit::{Edit, EditError};

impl Workbench {
    /// Does what is asked and, if that made a difference, asks for a frame that shows it: a mouse that is held still
    /// must not keep the window awake.
    pub(in crate::app) fn apply_all(&mut self, ui: &Ui, commands: Vec<Command>) {
        let before = self.state_shown();
        for command in commands {
            dress(ui, &command, self.display.sight.lecture);
            self.apply(command);
        }
        if let Some(answer) = self.runner.answer() {
            self.display.rescale(answer);
        }
        if self.state_shown() != before {
            ui.request_repaint();
        }
    }

    /// Everything that commands can change and a frame shows.
    fn state_shown(&self) -> impl PartialEq + use<> {
        let view = (self.viewport.camera().copied(), self.viewport.wanted(), self.viewport.hand.seen());
        let shown = (self.display.seen(), self.comparison.numbers(), self.window.clone());
        let files = (self.files.session.seen(), self.films.plan, self.learning, self.aim_next);
        (
            self.files.document.revision(),
            self.playback.clone(),
            self.selection.clone(),
            self.is_stale(),
            view,
            shown,
            files,
        )
    }

    /// Does one thing.
    pub fn apply(&mut self, command: impl Into<Command>) {
        match command.into() {
            Command::Time(command) => {
                let end = self.end();
                self.playback.apply(command, end, self.runner.answer().map(|a| &**a));
            }
            Command::Edit(command) => {
                let done = self.files.document.apply(command);
                self.after(done);
            }
            Command::Place(command) => self.apply_place(command),
            Command::Hand(command) => self.apply_hand(&command),
            Command::Select(command) => self.selection.apply(command, self.files.document.scene()),
            Command::View(command) => self.apply_view(command),
            Command::Compare(command) => {
                let (document, answer) = (&self.files.document, self.runner.fresh_answer());
                let what = document.undo_label().unwrap_or(&document.scene().name);
                let done = self.comparison.apply(command, answer, what);
                self.window.say_failure(done);
            }
            Command::File(command) => self.apply_file(command),
            Command::Keep(command) => self.apply_keep(command),
            Command::Film(command) => self.apply_film(command),
            Command::Learn(command) => self.apply_learn(command),
            Command::Window(command) => self.apply_window(command),
        }
    }

    fn apply_place(&mut self, command: PlaceCommand) {
        let Some(placed) = placed(command, self.files.document.scene(), &self.selection) else { return };
        self.edit(placed.edit, None);
        if let Some(then) = placed.then.filter(|_| self.window.notice.is_none()) {
            self.selection.these(then);
        }
    }

    fn apply_hand(&mut self, command: &HandCommand) {
        let (scene, selected) = (self.files.document.scene(), self.selection.all());
        let done = match self.viewport.hand.apply(command, scene, selected) {
            Some(Keyed::Change(edit, gesture)) => self.files.document.edit(edit, Some(gesture)),
            Some(Keyed::Abandon(gesture)) => self.files.document.abandon(gesture),
            None => return,
        };
        self.after(done);
    }

    fn apply_view(&mut self, command: ViewCommand) {
        match command {
            ViewCommand::Preset(preset) => self.viewport.want(preset),
            ViewCommand::Camera(camera) => self.viewport.set_camera(camera),
            ViewCommand::Frame => {
                let (viewport, seen) = self.view_and_seen();
                viewport.frame(bounds_of(&seen, seen.selection));
            }
            ViewCommand::Overlays(overlays) => self.display.overlays = overlays,
            ViewCommand::ForceScale(scale) => self.display.set_force_scale(scale),
            ViewCommand::Sight(sight) => {
                self.display.sight = sight;
                // What is followed is taken from where it is now.
                self.viewport.followed = None;
            }
            ViewCommand::Tool(tool) => self.display.tool = tool,
        }
    }

    fn apply_window(&mut self, command: WindowCommand) {
        if command == WindowCommand::CancelRun {
            self.runner.cancel();
        }
        if self.window.apply(command, self.is_dirty()) {
            // Saved, or given up.
            self.files.forget_work();
        }
    }

    /// Changes the scene; edits of one gesture are undone together.
    pub(super) fn edit(&mut self, edit: Edit, gesture: Option<u64>) {
        let done = self.files.document.edit(edit, gesture);
        self.after(done);
    }

    /// Runs the scene when something was done to it; an edit that does not fit says so.
    pub(super) fn after(&mut self, done: Result<bool, EditError>) {
        match done {
            Ok(true) => self.changed(),
            Ok(false) => {}
            Err(error) => self.window.say(error.to_string()),
        }
    }

    /// The scene is another one: run it, and let go of what is no longer there.
    fn changed(&mut self) {
        self.selection.keep_in(self.files.document.scene());
        self.runner.start(self.files.document.scene());
        let end = self.end();
        self.playback.keep_inside(end);
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
