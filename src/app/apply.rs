//! Does what commands ask: the one place where the workbench changes.

use std::path::{Path, PathBuf};

use egui::Ui;

use super::command::{Command, Export, Way};
use super::workbench::Closing;
use super::{Workbench, edits, export, text, viewport};
use crate::files::{load_scene, save_scene};
use crate::scene::Scene;
use crate::scene::edit::{Edit, EditError};
use crate::view::Target;

/// Steps of the arrow keys in a second of the answer at speed 1 \[s\]: a frame of a film.
const STEP: f64 = 1.0 / 60.0;

impl Workbench {
    /// Does what is asked and, if that made a difference, asks for a frame that shows it: a mouse that is held still
    /// must not keep the window awake.
    pub(super) fn apply_all(&mut self, ui: &Ui, commands: Vec<Command>) {
        let before = self.seen();
        for command in commands {
            if let Command::Theme(theme) = command {
                ui.set_theme(theme);
            }
            self.apply(command);
        }
        self.rescale();
        if self.seen() != before {
            ui.request_repaint();
        }
    }

    /// Everything that commands can change and a frame shows.
    fn seen(&self) -> impl PartialEq + use<> {
        let view = (self.viewport.camera().copied(), self.viewport.wanted(), self.overlays, self.force_scale);
        let asked = (
            self.help,
            self.closing,
            self.notice.clone(),
            self.keeping.asked(),
            self.films.plan,
            self.lesson,
            self.aim_next,
        );
        (self.revision(), self.clock.clone(), self.selected, self.time_window, self.is_stale(), view, asked)
    }

    /// Does one thing.
    pub fn apply(&mut self, command: Command) {
        match command {
            Command::Edit { edit, gesture } => self.edit(edit, gesture),
            Command::Undo => {
                let done = self.document.undo();
                self.after(done);
            }
            Command::Redo => {
                let done = self.document.redo();
                self.after(done);
            }
            Command::Select(target) => self.selected = target,
            Command::AddGirder | Command::AddAbutment | Command::Duplicate | Command::Remove => self.place(&command),
            Command::Rename(target, name) => {
                if let Some(edit) = edits::rename(self.scene(), target, name) {
                    self.edit(edit, None);
                }
            }
            Command::View(preset) => self.viewport.want(preset),
            Command::Camera(camera) => self.viewport.set_camera(camera),
            Command::Frame => {
                let bounds = viewport::bounds_of(self, self.selected);
                self.viewport.frame(bounds);
            }
            Command::Overlays(overlays) => self.overlays = overlays,
            Command::ForceScale(scale) => self.force_scale = scale.filter(|s| s.is_finite() && *s > 0.0),
            // The context keeps the theme.
            Command::Theme(_) => {}
            Command::Help(open) => self.help = open,
            Command::CancelRun => self.runner.cancel(),
            Command::Dismiss => self.notice = None,
            Command::Close | Command::CloseAnyway | Command::KeepOpen => self.close(&command),
            time @ (Command::TogglePlay
            | Command::Step(_)
            | Command::StepEvent(_)
            | Command::Seek(_)
            | Command::Speed(_)
            | Command::StepSpeed(_)
            | Command::Loop(_)
            | Command::SlowAtHits(_)
            | Command::TimeWindow(_)) => self.apply_time(&time),
            file => self.apply_file(file),
        }
    }

    pub(super) fn edit(&mut self, edit: Edit, gesture: Option<u64>) {
        let done = self.document.edit(edit, gesture);
        self.after(done);
    }

    /// Runs the scene when something was done to it; an edit that does not fit says so.
    pub(super) fn after(&mut self, done: Result<bool, EditError>) {
        match done {
            Ok(true) => self.changed(),
            Ok(false) => {}
            Err(error) => self.notice = Some(error.to_string()),
        }
    }

    /// The scene is another one: run it, and let go of what is no longer there.
    fn changed(&mut self) {
        let scene = self.document.scene();
        let there = match self.selected {
            Some(Target::Girder(i)) => i < scene.girders.len(),
            Some(Target::Abutment(i)) => i < scene.abutments.len(),
            Some(Target::Contact(_)) => false,
            None => true,
        };
        if !there {
            self.selected = None;
        }
        self.run();
        self.clock.t = self.clock.t.min(self.end());
        self.keep_window_inside();
    }

    fn keep_window_inside(&mut self) {
        let end = self.end();
        self.time_window = self.time_window.filter(|w| w[1] <= end);
    }

    fn place(&mut self, command: &Command) {
        let scene = self.scene();
        let girder = match self.selected {
            Some(Target::Girder(i)) => Some(i),
            _ => None,
        };
        let (girders, abutments) = (scene.girders.len(), scene.abutments.len());
        let (edit, then) = match (command, self.selected_body()) {
            (Command::AddGirder, _) => (Some(edits::add_girder(scene, girder)), Some(Target::Girder(girders))),
            (Command::Duplicate, Some(Target::Girder(i))) => {
                (Some(edits::add_girder(scene, Some(i))), Some(Target::Girder(girders)))
            }
            (Command::AddAbutment, _) | (Command::Duplicate, Some(Target::Abutment(_))) => {
                (edits::add_abutment(scene, girder), Some(Target::Abutment(abutments)))
            }
            (Command::Remove, Some(target)) => (edits::remove(target), None),
            _ => (None, self.selected),
        };
        if let Some(edit) = edit {
            self.selected = None;
            self.edit(edit, None);
            self.selected = then;
        }
    }

    fn apply_time(&mut self, command: &Command) {
        let end = self.end();
        match *command {
            Command::TogglePlay => {
                self.clock.playing = !self.clock.playing;
                if self.clock.playing && self.clock.t >= end {
                    self.clock.t = 0.0;
                }
            }
            Command::Step(steps) => self.seek(self.clock.t + steps * STEP * self.clock.speed),
            Command::StepEvent(way) => self.seek_event(way),
            Command::Seek(t) => self.seek(t),
            Command::Speed(speed) => self.clock.speed = speed.clamp(0.001, 10.0),
            Command::StepSpeed(by) => self.clock.step_speed(by),
            Command::Loop(on) => self.clock.looping = on,
            Command::SlowAtHits(on) => self.clock.slow_at_hits = on,
            Command::TimeWindow(window) => self.time_window = window,
            _ => {}
        }
    }

    fn seek(&mut self, t: f64) {
        self.clock.t = t.clamp(0.0, self.end());
        self.follow();
    }

    fn seek_event(&mut self, way: Way) {
        let t = self.clock.t;
        if let Some(event) = self.answer().and_then(|a| a.neighbour_event(t, way == Way::Forward)) {
            self.clock.playing = false;
            self.seek(event);
        }
    }

    /// Moves the window of time so that the playhead is in it.
    fn follow(&mut self) {
        if let Some([from, to]) = self.time_window
            && !(from..=to).contains(&self.clock.t)
        {
            let span = to - from;
            let start = (self.clock.t - span / 2.0).clamp(0.0, (self.end() - span).max(0.0));
            self.time_window = Some([start, start + span]);
        }
    }

    fn apply_file(&mut self, command: Command) {
        match command {
            Command::OpenPreset(name) => self.open(&name, None),
            Command::OpenFile(path) => self.open(&path.to_string_lossy(), Some(path.clone())),
            Command::New => self.take_up(edits::empty(), None),
            Command::Learn(wish) => self.apply_learn(wish),
            Command::Film(wish) => self.apply_film(wish),
            Command::Keep(wish) => self.apply_keep(wish),
            Command::OpenDialog => self.dialogs.open(),
            Command::Save => match self.document.file() {
                Some(file) => {
                    let file = file.to_owned();
                    self.save(&file);
                }
                None => self.ask_where_to_save(),
            },
            Command::SaveAs => self.ask_where_to_save(),
            Command::SaveFile(path) => self.save(&path),
            Command::Export(what) => self.dialogs.export(what, &self.scene().name),
            Command::ExportTo(what, path) => self.export(what, path),
            _ => {}
        }
    }

    pub(super) fn open(&mut self, name: &str, file: Option<PathBuf>) {
        match load_scene(name, &[]) {
            Ok(scene) => self.take_up(scene, file),
            Err(errors) => self.notice = Some(errors.to_string()),
        }
    }

    /// Goes on with another scene; undo brings the one before back.
    pub(super) fn take_up(&mut self, scene: Scene, file: Option<PathBuf>) {
        self.keep_work_now();
        self.lesson = None;
        self.look_as(&scene);
        let opened = self.document.open(scene, file.clone());
        self.after(opened.map(|()| true));
        if let Some(file) = file {
            self.opened(&file);
        }
    }

    /// Looks at a scene as it wants to be looked at, from its start.
    pub(super) fn look_as(&mut self, scene: &Scene) {
        self.overlays = scene.view.overlays;
        self.force_scale = scene.view.force_scale;
        self.viewport.want(scene.view.camera);
        self.selected = None;
        self.time_window = None;
        self.clock.t = 0.0;
        self.clock.playing = false;
    }

    fn ask_where_to_save(&mut self) {
        if self.closing == Closing::Asking {
            self.closing = Closing::Saving;
        }
        self.dialogs.save(&self.scene().name);
    }

    /// Saves the scene with the view as it is seen.
    fn save(&mut self, path: &Path) {
        if self.document.file() == Some(path) && self.is_kept() && !self.compare_with_disk() {
            // First the question what to do about the other program's changes.
            self.closing = Closing::Open;
            return;
        }
        match save_scene(&self.scene_as_seen(), path) {
            Ok(()) => {
                self.forget_work();
                self.document.saved_as(path.to_owned());
                self.opened(path);
                self.notice = Some(format!("{}: {}", text::SAVED, path.display()));
                if matches!(self.closing, Closing::Asking | Closing::Saving) {
                    self.closing = Closing::Now;
                }
            }
            Err(error) => {
                self.notice = Some(error.to_string());
                self.closing = Closing::Open;
            }
        }
    }

    fn export(&mut self, what: Export, path: PathBuf) {
        match (what, self.viewport.list().cloned(), self.answer().cloned()) {
            (Export::Picture, Some(list), _) => {
                let (size, title) = (self.viewport.size(), self.scene().name.clone());
                self.in_background(move || export::picture(&list, size, &title, &path));
            }
            (Export::Tables, _, Some(answer)) => self.in_background(move || export::tables(&answer, &path)),
            _ => {}
        }
    }

    fn close(&mut self, command: &Command) {
        self.closing = match command {
            Command::Close if self.is_dirty() => Closing::Asking,
            Command::KeepOpen => Closing::Open,
            _ => {
                self.forget_work();
                Closing::Now
            }
        };
    }
}
