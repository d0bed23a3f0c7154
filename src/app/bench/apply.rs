//! Does what commands ask: the one place where the workbench changes.

use egui::Ui;

use super::workbench::Workbench;
use crate::app::command::{
    Command, CompareCommand, EditCommand, HandCommand, SelectCommand, ViewCommand, WindowCommand,
};
use crate::app::edits::{self, placed};
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
        let files = (self.session.seen(), self.films.plan, self.learning, self.aim_next);
        (self.revision(), self.playback.clone(), self.selection.clone(), self.is_stale(), view, shown, files)
    }

    /// Does one thing.
    pub fn apply(&mut self, command: impl Into<Command>) {
        match command.into() {
            Command::Time(command) => {
                let end = self.end();
                self.playback.apply(command, end, self.runner.answer().map(|a| &**a));
            }
            Command::Edit(command) => self.apply_edit(command),
            Command::Place(command) => {
                if let Some(placed) = placed(command, self.document.scene(), &self.selection) {
                    self.edit(placed.edit, None);
                    if let Some(then) = placed.then.filter(|_| self.window.notice.is_none()) {
                        self.selection.these(then);
                    }
                }
            }
            Command::Hand(command) => self.apply_hand(&command),
            Command::Select(SelectCommand::Only(target)) => self.selection.only(target),
            Command::Select(SelectCommand::Also(target)) => self.selection.toggle(target),
            Command::Select(SelectCommand::All) => self.selection.everything(self.document.scene()),
            Command::View(command) => self.apply_view(command),
            Command::Compare(CompareCommand::Pin) => self.pin(),
            Command::Compare(CompareCommand::Unpin(number)) => self.comparison.unpin(number),
            Command::Compare(CompareCommand::UnpinAll) => self.comparison.clear(),
            Command::File(command) => self.apply_file(command),
            Command::Keep(command) => self.apply_keep(command),
            Command::Film(command) => self.apply_film(command),
            Command::Learn(command) => self.apply_learn(command),
            Command::Window(command) => self.apply_window(command),
        }
    }

    fn apply_edit(&mut self, command: EditCommand) {
        match command {
            EditCommand::Change { edit, gesture } => self.edit(edit, gesture),
            EditCommand::Undo => {
                let done = self.document.undo();
                self.after(done);
            }
            EditCommand::Redo => {
                let done = self.document.redo();
                self.after(done);
            }
            EditCommand::Rename(target, name) => {
                if let Some(edit) = edits::rename(self.document.scene(), target, name) {
                    self.edit(edit, None);
                }
            }
        }
    }

    fn apply_hand(&mut self, command: &HandCommand) {
        let hand = &mut self.viewport.hand;
        let keyed = match command {
            HandCommand::Take(grip, at) => {
                hand.hold_by_keys(*grip, *at, self.document.scene(), self.selection.all());
                None
            }
            HandCommand::Type(key) => hand.type_key(key),
        };
        match keyed {
            Some(Keyed::Change(edit, gesture)) => self.edit(edit, Some(gesture)),
            Some(Keyed::Abandon(gesture)) => {
                let done = self.document.abandon(gesture);
                self.after(done);
            }
            None => {}
        }
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
        match command {
            // The context of egui keeps theme and size.
            WindowCommand::Theme(_) | WindowCommand::Scale(_) => {}
            WindowCommand::Help(open) => self.window.help = open,
            WindowCommand::AskRow(draft) => self.window.row = draft,
            WindowCommand::CancelRun => self.runner.cancel(),
            WindowCommand::Dismiss => self.window.notice = None,
            WindowCommand::Close => self.close(self.is_dirty()),
            WindowCommand::CloseAnyway => self.close(false),
            WindowCommand::KeepOpen => self.window.stay_open(),
        }
    }

    /// Closes the window, or asks first; work that is given up is not kept.
    fn close(&mut self, ask: bool) {
        if self.window.close(ask) {
            self.forget_work();
        }
    }

    /// Keeps the run that is shown to compare with.
    fn pin(&mut self) {
        let Some(answer) = self.runner.answer().filter(|_| !self.runner.is_stale()) else { return };
        let what = self.document.undo_label().unwrap_or(&self.document.scene().name);
        let done = self.comparison.pin(answer, what);
        self.window.say_failure(done);
    }

    /// Changes the scene; edits of one gesture are undone together.
    pub(super) fn edit(&mut self, edit: Edit, gesture: Option<u64>) {
        let done = self.document.edit(edit, gesture);
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
        self.selection.keep_in(self.document.scene());
        self.runner.start(self.document.scene());
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
