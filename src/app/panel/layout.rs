//! The whole window as one function of its state: where the panels stand, and what is done with their commands.

use std::path::Path;
use std::time::Duration;

use egui::{CentralPanel, Frame, Margin, Panel, Popup, ScrollArea, Ui};

use crate::app::bench::{Folded, Workbench};
use crate::app::command::{Command, FileCommand, Pane};
use crate::app::disk::{film_dialog, path_dialog};
use crate::app::learn::lesson_panel;
use crate::app::map;
use crate::app::panel::shortcuts::{Above, Keyboard};
use crate::app::panel::{
    file_questions, fold, help, inspector, menu, notices, outliner, row_dialog, shortcuts, start, status, view_menu,
    whatif,
};
use crate::app::plot::plots;
use crate::app::quake;
use crate::app::style::letters;
use crate::app::style::theme::{self, Palette, greyed};
use crate::app::text;
use crate::app::time::replay::Replay;
use crate::app::time::timeline;
use crate::app::time::transport::{self, PlotsButton};
use crate::app::viewport::show;
use crate::files::is_record;
use crate::scene::{GroundId, Scene};

/// Height below which the list of what is placed and the numbers of what is selected are scrolled as one \[points\]: the head and the
/// least of the list take 240. Chosen.
const PLACED_APART: f32 = 360.0;

/// How often progress on a thread is shown.
const PROGRESS: Duration = Duration::from_millis(50);

/// Shows everything and does what is asked.
pub fn show(bench: &mut Workbench, ui: &mut Ui) {
    bench.window.language.speak();
    theme::install(ui.ctx());
    letters::install(ui.ctx(), bench.window.language);
    shortcuts::wait_for_focus(ui);
    listen(bench, ui);
    let [left, returned] =
        [false, true].map(|focused| ui.input(|i| i.events.contains(&egui::Event::WindowFocused(focused))));
    if left {
        bench.tasks.dialogs.leave();
    }
    if bench.files.session.is_time_to_look(returned)
        && let Some(words) = bench.files.compare().notice
    {
        bench.window.say(words);
    }
    let out = commands(bench, ui);
    bench.apply_all(ui, out);
    let view = Frame::new().fill(Palette::of(ui).view);
    CentralPanel::no_frame().frame(view).show(ui, |ui| scene_view(bench, ui));
    go_on(bench, ui);
}

/// Commands of panels, dialogs and keys in this frame.
fn commands(bench: &Workbench, ui: &mut Ui) -> Vec<Command> {
    let mut out = Vec::new();
    let (document, window) = (&bench.files.document, &bench.window);
    let (typing, listed) = (ui.text_edit_focused(), Popup::is_any_open(ui.ctx()));
    if bench.view.display.sight.lecture {
        lecture_panels(bench, ui, &mut out);
    } else {
        panels(bench, ui, &mut out);
    }
    map::show(ui, &bench.maps, document.scene(), &mut out);
    map::show_angles(ui, &bench.angles, document.scene(), &mut out);
    let answer = bench.replay.runner.answer().map(|answer| &**answer);
    quake::show(ui, &bench.shaking, answer, bench.replay.playback.clock.t, &mut out);
    help::show(ui, window.help, &mut out);
    if let (Some(draft), Some(girder)) = (window.row, document.scene().girders.get(document.girder_shown())) {
        row_dialog::show(ui, draft, girder, &mut out);
    }
    notices::over_all(ui, window, &mut out);
    let scope = film_dialog::Scope { end: bench.replay.end(), view: bench.view.viewport.size() };
    film_dialog::show(ui, &bench.tasks.films, scope, &mut out);
    path_dialog::show(ui, &bench.tasks.paths, bench.files.session.recent(), &mut out);
    if !window.asks() {
        file_questions::show(ui, &bench.files, &mut out);
    }
    if !dialog_is_open(bench) {
        let (display, hand) = (&bench.view.display, &bench.view.viewport.hand);
        let (clock, folded) = (&bench.replay.playback.clock, folded(bench, ui));
        let (help, tool, scene) = (window.help, display.tool, document.scene());
        let above = [
            (bench.angles.is_open(), Above::Angles),
            (bench.maps.draft().is_some(), Above::Map),
            (bench.shaking.is_open(), Above::Quake),
        ];
        let above = above.into_iter().find(|(open, _)| *open).map(|(_, above)| above);
        let on = Keyboard { typing, listed, help, hand, tool, clock, scene, folded, above };
        shortcuts::keys(ui, on, &mut out);
    }
    out
}

/// Whether a question is open that takes the keys.
fn dialog_is_open(bench: &Workbench) -> bool {
    let asked = bench.window.asks() || bench.files.session.asks();
    let asked = asked || bench.tasks.paths.asked().is_some();
    asked || bench.tasks.films.plan.is_some() || bench.window.row.is_some()
}

/// Takes in what threads, dialogs and dropped files have brought, and lets the clock run.
fn listen(bench: &mut Workbench, ui: &Ui) {
    bench.replay.runner.poll();
    bench.maps.poll(bench.files.document.scene());
    bench.angles.poll(bench.files.document.scene());
    bench.shaking.follow(bench.replay.runner.answer().map(|answer| &**answer));
    bench.view.aim();
    for words in bench.tasks.ended() {
        bench.window.say(words);
    }
    let mut brought = bench.tasks.chosen();
    let dropped = ui.input(|i| i.raw.dropped_files.clone());
    brought.extend(dropped.iter().map(|file| dropped_on(file.path()).into()));
    bench.apply_all(ui, brought);
    bench.replay.advance(f64::from(ui.input(|i| i.stable_dt)));
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
    let scene = bench.files.document.scene();
    if scene.girders.is_empty() && scene.abutments.is_empty() {
        start::show(ui, response.rect, (&bench.files, bench.window.bridge), &mut out);
    } else {
        notices::over_view(ui, response.rect, (&bench.replay.runner, bench.view.display.tool), &mut out);
        notices::writing(ui, response.rect, &bench.tasks.written());
    }
    bench.apply_all(ui, out);
}

fn panels(bench: &Workbench, ui: &mut Ui, out: &mut Vec<Command>) {
    let Workbench { files, replay, view, learning, .. } = bench;
    let (document, display, plots) = (&files.document, &view.display, bench.plot_source());
    Panel::top("bar")
        .resizable(false)
        .show(ui, |ui| menu::show(ui, files, (*learning, view, bench.tasks.paths.is_here()), out));
    let scene = document.scene();
    let empty = scene.girders.is_empty() && scene.abutments.is_empty();
    let adapter = view.adapter();
    let about = (scene.limits, empty, adapter.as_str());
    Panel::bottom("status").resizable(false).show(ui, |ui| status::show(ui, &replay.runner, about, out));
    let room = ui.available_height();
    let folded = folded(bench, ui);
    if folded.has(Pane::Plots) {
        Panel::bottom("time alone")
            .resizable(false)
            .show(ui, |ui| time_rows(scene, replay, ui, PlotsButton::Folded, 0.0, out));
    } else {
        let time = Panel::bottom("time").resizable(true).default_size(room * 0.37).min_size(180.0).max_size(room * 0.7);
        time.show(ui, |ui| {
            time_rows(scene, replay, ui, PlotsButton::Open, plots::legend_width(ui), out);
            greyed(ui, replay.runner.shows_older(), |ui| plots::show(ui, &plots, out));
        });
    }
    beside(ui, (Pane::Placed, folded), out, |ui, out| {
        // What is shown of one thing is not scrolled as another was.
        let area = |of| ScrollArea::vertical().id_salt((of, document.selection().lead())).auto_shrink(false);
        if ui.available_height() < PLACED_APART {
            area("placed").show(ui, |ui| {
                outliner::show(ui, document, out);
                ui.separator();
                inspector::show(ui, document, replay, out);
            });
            return;
        }
        outliner::show(ui, document, out);
        ui.separator();
        area("inspector").show(ui, |ui| inspector::show(ui, document, replay, out));
    });
    beside(ui, (Pane::WhatIf, folded), out, |ui, out| {
        let shown = whatif::Shown { document, replay, display, plots };
        ScrollArea::vertical().id_salt("what if").auto_shrink(false).show(ui, |ui| whatif::show(ui, shown, out));
    });
    lesson(bench, ui, folded, out);
}

/// The lesson that is open, beside the view.
fn lesson(bench: &Workbench, ui: &mut Ui, folded: Folded, out: &mut Vec<Command>) {
    let Some(lesson) = bench.learning.lesson() else { return };
    let tried = bench.learning.in_force(bench.files.document.scene());
    beside(ui, (Pane::Lesson, folded), out, |ui, out| {
        fold::head(ui, Pane::Lesson, out, |_, _| ());
        // A lesson begins at its head, wherever the one before was left.
        let area = ScrollArea::vertical().id_salt(("lesson", &lesson.title)).auto_shrink(false);
        area.show(ui, |ui| lesson_panel::show(ui, lesson, tried, out));
    });
}

/// Which panels are folded in this window.
fn folded(bench: &Workbench, ui: &Ui) -> Folded {
    let size = ui.ctx().content_rect().size();
    bench.window.folds.in_window(size.into(), bench.learning.lesson().is_some())
}

/// A panel beside the view, or its strip where it is folded.
fn beside(
    ui: &mut Ui,
    (pane, folded): (Pane, Folded),
    out: &mut Vec<Command>,
    body: impl FnOnce(&mut Ui, &mut Vec<Command>),
) {
    if folded.has(pane) {
        fold::strip(ui, pane, out);
        return;
    }
    let (panel, width, range) = match pane {
        Pane::Placed => (Panel::left("placed"), 244.0, 220.0..=420.0),
        Pane::Lesson => (Panel::right("lesson"), 264.0, 220.0..=420.0),
        Pane::WhatIf | Pane::Plots => (Panel::right("what if"), 264.0, 240.0..=440.0),
    };
    let side = Frame::side_top_panel(ui.style()).inner_margin(Margin::same(8));
    panel.frame(side).default_size(width).size_range(range).show(ui, |ui| body(ui, out));
}

/// The view, the time, the lesson that is open, and the way back.
fn lecture_panels(bench: &Workbench, ui: &mut Ui, out: &mut Vec<Command>) {
    let document = &bench.files.document;
    Panel::top("bar").resizable(false).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.menu_button(text::VIEWS, |ui| view_menu::menu(ui, &bench.view, document, out));
            ui.menu_button(text::LEARN, |ui| lesson_panel::menu(ui, bench.learning, out));
        });
    });
    let time = Panel::bottom("lecture time").resizable(false);
    time.show(ui, |ui| time_rows(document.scene(), &bench.replay, ui, PlotsButton::Absent, 0.0, out));
    lesson(bench, ui, folded(bench, ui), out);
}

/// The row of buttons, and the timeline under it, which ends `right` before the right edge as the plots do \[points\].
fn time_rows(scene: &Scene, replay: &Replay, ui: &mut Ui, plots: PlotsButton, right: f32, out: &mut Vec<Command>) {
    transport::show(ui, &replay.playback, &scene.motion, plots, out);
    let shown = timeline::Shown {
        playback: &replay.playback,
        end: replay.end(),
        answer: replay.runner.answer().map(|a| &**a),
        passed: replay.runner.passed(scene.limits).unwrap_or_default(),
        falls: replay.runner.fresh_answer().map(|answer| answer.falls()).unwrap_or_default(),
    };
    greyed(ui, replay.runner.shows_older(), |ui| timeline::show(ui, shown, [plots::AXIS_WIDTH, right], out));
}

/// Asks for another frame only when there is a reason.
fn go_on(bench: &mut Workbench, ui: &Ui) {
    if bench.replay.playback.clock.playing {
        ui.request_repaint();
    } else if let Some(wait) = bench.replay.runner.when_idle() {
        ui.request_repaint_after(wait);
    }
    if let Some(wait) = keep_work(bench) {
        ui.request_repaint_after(wait);
    }
    if bench.replay.runner.progress().is_some()
        || bench.tasks.films.progress().is_some()
        || bench.maps.progress().is_some()
        || bench.angles.progress().is_some()
    {
        ui.request_repaint_after(PROGRESS);
    }
}

/// Keeps unsaved work when it is time; when to come back.
fn keep_work(bench: &mut Workbench) -> Option<Duration> {
    let Workbench { files, view, window, .. } = bench;
    if window.closes() {
        return None;
    }
    let (again, problem) = files.keep_work(|scene| view.display.scene_as_seen(scene));
    if let Some(words) = problem {
        window.say(words);
    }
    again
}

/// Command for a file that is dropped onto the window: a record by its extension, anything else a scene.
fn dropped_on(path: &Path) -> FileCommand {
    let path = path.to_owned();
    if is_record(&path) { FileCommand::Record(GroundId::Reference, path) } else { FileCommand::Open(path) }
}
