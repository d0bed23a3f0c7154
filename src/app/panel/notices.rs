//! Notices over the view: complaints, progress, and questions.

use std::path::PathBuf;
use std::time::Duration;

use egui::{Align2, Area, Color32, Frame, Id, Order, ProgressBar, Rect, RichText, Ui, pos2, vec2};

use crate::app::bench::{Next, WindowState};
use crate::app::command::{Command, FileCommand, LeaveCommand, RunCommand, Tool, WindowCommand};
use crate::app::host::PAGE;
use crate::app::run::runner::Runner;
use crate::app::style::theme::Palette;
use crate::app::text;

/// Time after which a message on a written file disappears \[s\]. Chosen: a path is read twice in it.
const NOTICE_SHOWN: f64 = 10.0;

/// Greys an old answer and says why it is old.
pub(in crate::app) fn over_view(ui: &mut Ui, rect: Rect, (runner, tool): (&Runner, Tool), out: &mut Vec<Command>) {
    if runner.shows_older() {
        let veil: Color32 = Palette::of(ui).view.gamma_multiply(0.55);
        ui.painter().rect_filled(rect, 0.0, veil);
    }
    if tool != Tool::Select {
        let at = rect.center_bottom() - vec2(0.0, 10.0);
        let font = egui::FontId::proportional(12.0);
        ui.painter().text(at, Align2::CENTER_BOTTOM, text::TOOL_ENDS, font, Palette::of(ui).weak);
    }
    if let Some(problems) = runner.problems() {
        let lines: Vec<String> =
            problems.0.iter().map(|e| format!("{}: {} — {}", e.place, e.value, e.remedy)).collect();
        let headline = if runner.answer().is_some() { text::PROBLEM } else { text::PROBLEM_AT_ONCE };
        // Not over a handle that is pulled too far.
        let low = is_held_above(ui, rect);
        plate(ui, rect, ("problem", low), |ui| {
            ui.label(RichText::new(headline).color(Palette::of(ui).problem).strong());
            for line in &lines {
                ui.add(egui::Label::new(line).wrap());
            }
        });
    } else if let Some(progress) = runner.progress() {
        plate(ui, rect, ("progress", false), |ui| computing(ui, progress, out));
    } else if runner.is_stale() {
        plate(ui, rect, ("cancelled", false), |ui| {
            let words = if runner.answer().is_some() { text::CANCELLED } else { text::CANCELLED_AT_ONCE };
            ui.add(egui::Label::new(words).wrap());
            if ui.button(text::RUN_AGAIN).clicked() {
                out.push(RunCommand::Again.into());
            }
        });
    } else if let Some(stop) = runner.answer().and_then(|a| a.history.stop()) {
        let words = format!("{} ({} s): {} — {}", text::STOPPED_EARLY, text::short(stop.t), stop.place, stop.reason);
        plate(ui, rect, ("stopped", false), |ui| {
            ui.add(egui::Label::new(RichText::new(words).color(Palette::of(ui).problem)).wrap());
        });
    }
}

/// Tells at the bottom of the view what is being written.
pub(in crate::app) fn writing(ui: &mut Ui, rect: Rect, written: &[PathBuf]) {
    let Some(path) = written.first() else { return };
    let place = Rect::from_center_size(rect.center_bottom() - vec2(0.0, 44.0), vec2(320.0_f32.min(rect.width()), 28.0));
    let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(place).id_salt("writing"));
    Frame::popup(ui.style()).show(&mut inner, |ui| {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        ui.add(egui::Label::new(text::is_writing(&name)).truncate());
    });
}

#[expect(clippy::cast_possible_truncation, reason = "a share of a bar")]
fn computing(ui: &mut Ui, progress: f64, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        if progress < 1.0 {
            ui.label(text::COMPUTING);
            ui.add(ProgressBar::new(progress as f32).desired_width(140.0).show_percentage());
        } else {
            // Its motion is there: touches, peaks and the ledger are found in it, by no measure of which a part is known.
            ui.label(text::EVALUATING);
        }
        if ui.button(text::CANCEL).clicked() {
            out.push(RunCommand::Cancel.into());
        }
    });
}

/// Room at the bottom of the view for a plate of a few lines \[points\].
const LOW_PLATE: f32 = 90.0;

/// Whether the mouse holds something in the upper half of the view.
fn is_held_above(ui: &Ui, rect: Rect) -> bool {
    let held = ui.input(|i| i.pointer.interact_pos().filter(|_| i.pointer.any_down()));
    held.is_some_and(|at| rect.contains(at) && at.y < rect.center().y)
}

/// A plate at the top of the view, or low in it, no wider than it.
fn plate(ui: &mut Ui, rect: Rect, (id, low): (&str, bool), body: impl FnOnce(&mut Ui)) {
    let width = (rect.width() - 32.0).clamp(80.0, 560.0);
    let top = if low { (rect.bottom() - LOW_PLATE).max(rect.top()) } else { rect.top() + 10.0 };
    let place = Rect::from_min_size(pos2(rect.center().x - width / 2.0, top), vec2(width, 40.0));
    let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(place).id_salt(id));
    Frame::popup(ui.style()).show(&mut inner, body);
}

/// Whether a notice, by its number, has been shown for [`NOTICE_SHOWN`] since the mouse was over it.
fn has_been_read(ui: &Ui, number: u64, is_pointed_at: bool) -> bool {
    let (id, now) = (Id::unique("notice since"), ui.input(|i| i.time));
    let since = ui.data_mut(|data| {
        let since = data.get_temp_mut_or_insert_with(id, || (number, now));
        if since.0 != number || is_pointed_at {
            *since = (number, now);
        }
        since.1
    });
    let left = since + NOTICE_SHOWN - now;
    if left > 0.0 {
        ui.ctx().request_repaint_after(Duration::from_secs_f64(left));
    }
    left <= 0.0
}

/// The question before closing, and the notice of what has happened to a file.
pub(in crate::app) fn over_all(ui: &mut Ui, window: &WindowState, out: &mut Vec<Command>) {
    if let (Some(notice), Some(number)) = (window.notice(), window.notice_number()) {
        let area =
            Area::new(Id::unique("notice")).order(Order::Foreground).anchor(Align2::CENTER_BOTTOM, vec2(0.0, -40.0));
        let shown = area.show(ui, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.horizontal(|ui| {
                    ui.label(notice);
                    if let Some(place) = window.place().filter(|_| !PAGE) {
                        if ui.button(text::SHOW_FOLDER).on_hover_text(text::SHOW_FOLDER_HINT).clicked() {
                            out.push(FileCommand::ShowFolder(place.to_owned()).into());
                        }
                        if ui.button(text::COPY_PATH).clicked() {
                            ui.copy_text(place.display().to_string());
                        }
                    }
                    if ui.button(text::DISMISS).clicked() {
                        out.push(WindowCommand::Dismiss.into());
                    }
                });
            });
        });
        // What failed stays until it is dismissed.
        if window.place().is_some() && has_been_read(ui, number, shown.response.contains_pointer()) {
            out.push(WindowCommand::Dismiss.into());
        }
    }
    if let Some(next) = window.asked_before() {
        let anyway = match next {
            Next::Close => (text::CLOSE_ANYWAY, LeaveCommand::CloseAnyway),
            Next::File(_) | Next::Learn(_) => (text::GIVE_UP, LeaveCommand::GiveUp),
        };
        let asked = egui::Modal::new(Id::unique("unsaved")).show(ui, |ui| {
            ui.label(text::UNSAVED_QUESTION);
            ui.horizontal(|ui| {
                for (words, command) in [
                    (text::SAVE_FIRST, Command::File(FileCommand::Save)),
                    (anyway.0, Command::Leave(anyway.1)),
                    (text::KEEP_OPEN, Command::Leave(LeaveCommand::Stay)),
                ] {
                    if ui.button(words).clicked() {
                        out.push(command);
                    }
                }
            });
        });
        // Escape, or a click beside it, is no answer: nothing is lost.
        if asked.should_close() {
            out.push(LeaveCommand::Stay.into());
        }
    }
}
