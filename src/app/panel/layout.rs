//! The whole window as one function of its state: where the panels stand, and what is done with their commands.

use std::path::Path;
use std::time::Duration;

use egui::{CentralPanel, Frame, Margin, Panel, ScrollArea, Ui};

use crate::app::bench::{Closing, Workbench};
use crate::app::command::{Command, FileCommand};
use crate::app::disk::film_dialog;
use crate::app::learn::lesson_panel;
use crate::app::panel::{
    file_questions, help, inspector, menu, notices, outliner, row_dialog, shortcuts, status, view_menu, whatif,
};
use crate::app::plot::plots;
use crate::app::style::theme::{self, Palette};
use crate::app::text;
use crate::app::time::{timeline, transport};
use crate::app::viewport::show;
use crate::files::is_record;

/// How often progress on a thread is shown.
const PROGRESS: Duration = Duration::from_millis(50);

impl Workbench {
    /// Shows everything and does what is asked.
    pub fn ui(&mut self, ui: &mut Ui) {
        if !self.dressed {
            theme::install(ui.ctx());
            self.dressed = true;
        }
        listen(self, ui);
        if self.files.session.is_time_to_look(ui.input(|i| i.events.contains(&egui::Event::WindowFocused(true))))
            && let Some(words) = self.files.compare().notice
        {
            self.window.say(words);
        }
        let out = commands(self, ui);
        self.apply_all(ui, out);
        let view = Frame::new().fill(Palette::of(ui).view);
        CentralPanel::no_frame().frame(view).show(ui, |ui| scene_view(self, ui));
        go_on(self, ui);
    }
}

/// What panels, dialogs and keys ask for in this frame.
fn commands(bench: &Workbench, ui: &mut Ui) -> Vec<Command> {
    let mut out = Vec::new();
    shortcuts::keys(ui, bench, &mut out);
    if bench.sight().lecture {
        lecture_panels(bench, ui, &mut out);
    } else {
        panels(bench, ui, &mut out);
    }
    help::show(ui, bench.help_is_open(), &mut out);
    row_dialog::show(ui, bench, &mut out);
    notices::over_all(ui, bench, &mut out);
    let scope = film_dialog::Scope { end: bench.end(), view: bench.viewport.size() };
    film_dialog::show(ui, &bench.films, scope, &mut out);
    file_questions::show(ui, bench, &mut out);
    out
}

/// Takes in what threads, dialogs and dropped files have brought, and lets the clock run.
fn listen(bench: &mut Workbench, ui: &Ui) {
    bench.runner.poll();
    if let Some(preset) = bench.aim_next.take() {
        bench.viewport.want(preset);
    }
    for words in [bench.background.take(), bench.films.poll()].into_iter().flatten() {
        bench.window.say(words);
    }
    let mut brought = bench.dialogs.take();
    let dropped = ui.input(|i| i.raw.dropped_files.clone());
    brought.extend(dropped.iter().map(|file| dropped_on(file.path()).into()));
    bench.apply_all(ui, brought);
    let dt = f64::from(ui.input(|i| i.stable_dt));
    if let Some(answer) = bench.runner.answer() {
        bench.playback.clock.advance(dt, answer.history.end(), &answer.touches);
    }
}

/// The 3D view, and what stands over it.
fn scene_view(bench: &mut Workbench, ui: &mut Ui) {
    let mut out = Vec::new();
    let (viewport, seen) = bench.view_and_seen();
    let response = show::begin(ui, (viewport, &seen), &mut out);
    bench.apply_all(ui, out);
    let Some(response) = response else { return };
    let mut out = Vec::new();
    let (viewport, seen) = bench.view_and_seen();
    show::finish(ui, &response, (viewport, &seen), &mut out);
    notices::over_view(ui, response.rect, bench, &mut out);
    bench.apply_all(ui, out);
}

fn panels(bench: &Workbench, ui: &mut Ui, out: &mut Vec<Command>) {
    Panel::top("bar").resizable(false).show(ui, |ui| menu::show(ui, bench, out));
    Panel::bottom("status").resizable(false).show(ui, |ui| status::show(ui, bench, out));
    let room = ui.available_height();
    let time = Panel::bottom("time").resizable(true).default_size(room * 0.37).min_size(180.0).max_size(room * 0.7);
    time.show(ui, |ui| {
        time_rows(bench, ui, out);
        plots::show(ui, &bench.plot_source(), out);
    });
    let side = Frame::side_top_panel(ui.style()).inner_margin(Margin::same(8));
    Panel::left("placed").frame(side).default_size(244.0).size_range(220.0..=420.0).show(ui, |ui| {
        outliner::show(ui, (bench.scene(), &bench.selection), out);
        ui.separator();
        ScrollArea::vertical().id_salt("inspector").auto_shrink(false).show(ui, |ui| inspector::show(ui, bench, out));
    });
    Panel::right("what if").frame(side).default_size(264.0).size_range(240.0..=440.0).show(ui, |ui| {
        ScrollArea::vertical().id_salt("what if").auto_shrink(false).show(ui, |ui| whatif::show(ui, bench, out));
    });
    lesson_panel::show(ui, bench.learning, out);
}

/// The view and the time, and the way back.
fn lecture_panels(bench: &Workbench, ui: &mut Ui, out: &mut Vec<Command>) {
    Panel::top("bar").resizable(false).show(ui, |ui| {
        ui.menu_button(text::VIEWS, |ui| view_menu::menu(ui, bench, out));
    });
    Panel::bottom("lecture time").resizable(false).show(ui, |ui| time_rows(bench, ui, out));
}

/// The row of buttons, and the timeline under it.
fn time_rows(bench: &Workbench, ui: &mut Ui, out: &mut Vec<Command>) {
    transport::show(ui, &bench.playback, &bench.scene().motion, out);
    let answer = bench.answer().map(|a| &**a);
    let shown = timeline::Shown {
        playback: &bench.playback,
        end: bench.end(),
        answer,
        passed: bench.runner.passed(bench.scene()),
    };
    timeline::show(ui, shown, plots::AXIS_WIDTH, out);
}

/// Asks for another frame only when there is a reason.
fn go_on(bench: &mut Workbench, ui: &Ui) {
    if bench.playback.clock.playing {
        ui.request_repaint();
    } else if let Some(wait) = bench.runner.when_idle() {
        ui.request_repaint_after(wait);
    }
    if let Some(wait) = keep_work(bench) {
        ui.request_repaint_after(wait);
    }
    if bench.progress().is_some() || bench.filming().is_some() {
        ui.request_repaint_after(PROGRESS);
    }
}

/// Keeps unsaved work when it is time; when to come back.
fn keep_work(bench: &mut Workbench) -> Option<Duration> {
    let Workbench { files, display, window, .. } = bench;
    if window.closing() == Closing::Now {
        return None;
    }
    let (again, problem) = files.keep_work(|scene| display.scene_as_seen(scene));
    if let Some(words) = problem {
        window.say(words);
    }
    again
}

/// What a file that is dropped onto the window is for: a record by its extension, anything else a scene.
fn dropped_on(path: &Path) -> FileCommand {
    let path = path.to_owned();
    if is_record(&path) { FileCommand::Record(path) } else { FileCommand::Open(path) }
}
