//! Does what commands ask: the one place where the workbench changes.

use std::path::{Path, PathBuf};

use egui::Ui;

use crate::app::bench::Workbench;
use crate::app::bench::workbench::Closing;
use crate::app::command::{Command, Export, Way};
use crate::app::disk::export;
use crate::app::viewport::view;
use crate::app::viewport::view_options::{self, Sight};
use crate::app::{edits, text};
use crate::files::{load_scene, save_scene};
use crate::scene::Scene;
use crate::scene::edit::{Edit, EditError};
use crate::view::Target;

/// Steps of the arrow keys in a second of the answer at speed 1 \[s\]: a frame of a film.
const STEP: f64 = 1.0 / 60.0;

impl Workbench {
    /// Does what is asked and, if that made a difference, asks for a frame that shows it: a mouse that is held still
    /// must not keep the window awake.
    pub(in crate::app) fn apply_all(&mut self, ui: &Ui, commands: Vec<Command>) {
        let before = self.seen();
        for command in commands {
            if let Command::Theme(theme) = command {
                ui.set_theme(theme);
            }
            match command {
                Command::Scale(scale) => ui.set_zoom_factor(scale.clamp(0.5, 4.0)),
                Command::Sight(sight) if sight.lecture != self.sight.lecture => {
                    ui.set_zoom_factor(if sight.lecture { view_options::LECTURE } else { 1.0 });
                }
                _ => {}
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
        let hand = self.viewport.hand.seen();
        let view = (self.viewport.camera().copied(), self.viewport.wanted(), self.overlays, self.force_scale, hand);
        let asked = (self.tool, self.sight, self.row, self.pin_numbers(), self.help, self.closing, self.notice.clone());
        let files = (self.keeping.asked(), self.films.plan, self.lesson, self.aim_next);
        let time = (self.clock.clone(), self.time_window);
        (self.revision(), time, self.selection.clone(), self.is_stale(), view, asked, files)
    }

    /// Does one thing.
    pub fn apply(&mut self, command: Command) {
        match command {
            Command::Edit { edit, gesture } => self.edit(edit, gesture),
            Command::Take(grip, at) => self.take_by_keys(grip, at),
            Command::Type(key) => self.type_in_hand(&key),
            Command::Undo => {
                let done = self.document.undo();
                self.after(done);
            }
            Command::Redo => {
                let done = self.document.redo();
                self.after(done);
            }
            Command::Select(target) => self.selection.only(target),
            Command::SelectAlso(target) => self.selection.toggle(target),
            Command::SelectAll => self.select_all(),
            Command::Pin => self.pin(),
            Command::Unpin(i) => drop((i < self.pins.len()).then(|| self.pins.remove(i))),
            Command::UnpinAll => self.pins.clear(),
            Command::Sight(sight) => self.look_with(sight),
            Command::Tool(tool) => self.tool = tool,
            Command::AskRow(draft) => self.row = draft,
            Command::Place(_)
            | Command::AddGirder
            | Command::AddAbutment
            | Command::Duplicate
            | Command::Array { .. }
            | Command::Nudge(_)
            | Command::Remove => self.place(&command),
            Command::Rename(target, name) => {
                if let Some(edit) = edits::rename(self.scene(), target, name) {
                    self.edit(edit, None);
                }
            }
            Command::View(preset) => self.viewport.want(preset),
            Command::Camera(camera) => self.viewport.set_camera(camera),
            Command::Frame => {
                let bounds = view::bounds_of(self, self.selection.all());
                self.viewport.frame(bounds);
            }
            Command::Overlays(overlays) => self.overlays = overlays,
            Command::ForceScale(scale) => self.force_scale = scale.filter(|s| s.is_finite() && *s > 0.0),
            // The context keeps the theme and the size.
            Command::Theme(_) | Command::Scale(_) => {}
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
            | Command::PlaySpan(_)
            | Command::SpanFrom
            | Command::SpanTo
            | Command::TimeWindow(_)) => self.apply_time(&time),
            file => self.apply_file(file),
        }
    }

    pub(in crate::app) fn edit(&mut self, edit: Edit, gesture: Option<u64>) {
        let done = self.document.edit(edit, gesture);
        self.after(done);
    }

    /// Runs the scene when something was done to it; an edit that does not fit says so.
    pub(in crate::app) fn after(&mut self, done: Result<bool, EditError>) {
        match done {
            Ok(true) => self.changed(),
            Ok(false) => {}
            Err(error) => self.notice = Some(error.to_string()),
        }
    }

    /// The scene is another one: run it, and let go of what is no longer there.
    fn changed(&mut self) {
        self.selection.keep_in(self.document.scene());
        self.run();
        self.clock.t = self.clock.t.min(self.end());
        self.keep_window_inside();
    }

    /// Looks otherwise; what is followed is taken from where it is now.
    fn look_with(&mut self, sight: Sight) {
        self.sight = sight;
        self.viewport.followed = None;
    }

    fn select_all(&mut self) {
        let scene = self.document.scene();
        let girders = (0..scene.girders.len()).map(Target::Girder);
        self.selection.these(girders.chain((0..scene.abutments.len()).map(Target::Abutment)));
    }

    fn keep_window_inside(&mut self) {
        let end = self.end();
        self.time_window = self.time_window.filter(|w| w[1] <= end);
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
            Command::PlaySpan(span) => self.clock.span = span.filter(|s| s[0] < s[1]),
            Command::SpanFrom => self.play_span([self.clock.t, self.clock.span.map_or(end, |s| s[1])], end),
            Command::SpanTo => self.play_span([self.clock.span.map_or(0.0, |s| s[0]), self.clock.t], end),
            Command::TimeWindow(window) => self.time_window = window,
            _ => {}
        }
    }

    /// A stretch whose ends have passed one another begins or ends with the run.
    fn play_span(&mut self, [from, to]: [f64; 2], end: f64) {
        let span = match from < to {
            true => [from, to],
            false if from == self.clock.t => [from, end],
            false => [0.0, to],
        };
        self.clock.span = Some(span).filter(|s| s[0] < s[1]);
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
            Command::AskRecord => self.dialogs.record(),
            Command::Record(path) => self.take_record(&path),
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
            Command::AskPlots(format) => self.dialogs.plots(format, &self.scene().name),
            Command::Plots(path) => self.write_plots(path),
            _ => {}
        }
    }

    pub(in crate::app) fn open(&mut self, name: &str, file: Option<PathBuf>) {
        match load_scene(name, &[]) {
            Ok(scene) => self.take_up(scene, file),
            Err(errors) => self.notice = Some(errors.to_string()),
        }
    }

    /// Goes on with another scene; undo brings the one before back.
    pub(in crate::app) fn take_up(&mut self, scene: Scene, file: Option<PathBuf>) {
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
    pub(in crate::app) fn look_as(&mut self, scene: &Scene) {
        self.overlays = scene.view.overlays;
        self.force_scale = scene.view.force_scale;
        self.viewport.want(scene.view.camera);
        self.selection.only(None);
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
        match save_scene(&self.scene_as_seen(), self.document.file(), path) {
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
