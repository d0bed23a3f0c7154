//! Runs that are kept to compare with: up to four "before"s, seen as ghosts, as thin lines, and in a table.

use std::sync::Arc;

use egui::{Grid, RichText, Ui};

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::run::answer::Answer;
use crate::app::style::theme::PINS;
use crate::app::text;

/// Most runs that are kept: more cannot be told apart.
pub(in crate::app) const MOST: usize = PINS.len();

/// A run that is kept.
#[derive(Clone)]
pub(in crate::app) struct Pin {
    /// What it is called: what was different, as far as undo knows it.
    pub(in crate::app) name: String,
    /// The run.
    pub(in crate::app) answer: Arc<Answer>,
    /// Which of the colours it has.
    pub(in crate::app) color: usize,
}

impl Workbench {
    /// Keeps the run that is shown, unless it is kept already or there is no room.
    pub(in crate::app) fn pin(&mut self) {
        let Some(answer) = self.answer().filter(|_| !self.is_stale()).cloned() else { return };
        let digest = answer.history.digest();
        if self.pins.iter().any(|p| p.answer.history.digest() == digest) {
            self.notice = Some(text::PIN_THERE.to_owned());
            return;
        }
        let Some(color) = (0..MOST).find(|c| self.pins.iter().all(|p| p.color != *c)) else {
            self.notice = Some(text::PINS_FULL.to_owned());
            return;
        };
        self.pin_count += 1;
        let what = self.undo_label().map_or_else(|| self.scene().name.clone(), str::to_owned);
        let name = format!("{} {}: {what}", text::PIN, self.pin_count);
        self.pins.push(Pin { name, answer, color });
    }
}

/// Shows what is kept, and how the run that is shown differs from each.
pub(in crate::app) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let fits = bench.answer().is_some() && !bench.is_stale();
        if ui.add_enabled(fits, egui::Button::new(text::PIN_THIS)).on_hover_text(text::PIN_HINT).clicked() {
            out.push(Command::Pin);
        }
        if !bench.pins.is_empty() && ui.button(text::UNPIN_ALL).clicked() {
            out.push(Command::UnpinAll);
        }
    });
    if bench.pins.is_empty() {
        ui.add(egui::Label::new(RichText::new(text::NO_PINS).weak().small()).wrap());
        return;
    }
    for (i, pin) in bench.pins.iter().enumerate() {
        ui.horizontal(|ui| {
            let (rect, _) = ui.allocate_exact_size(egui::vec2(14.0, 14.0), egui::Sense::hover());
            ui.painter().rect_filled(rect.shrink(2.0), 2.0, PINS[pin.color]);
            let gone = ui.small_button(text::unpin(i + 1)).clicked();
            ui.add(egui::Label::new(&pin.name).truncate());
            if gone {
                out.push(Command::Unpin(i));
            }
        });
    }
    differences(ui, bench);
}

/// A number's name, and how a run's is written.
type Row = (&'static str, fn(&Answer) -> String);

/// A row for each number, a column for each run, the run that is shown first.
fn differences(ui: &mut Ui, bench: &Workbench) {
    let now = bench.answer().filter(|_| !bench.is_stale());
    let runs: Vec<(String, &Answer)> = now
        .map(|a| (text::NOW.to_owned(), &**a))
        .into_iter()
        .chain(bench.pins.iter().enumerate().map(|(i, p)| (format!("{}", i + 1), &*p.answer)))
        .collect();
    let rows: [Row; 5] = [
        (text::MOVES, |a| text::length(a.summary.max_displacement)),
        (text::TURNS, |a| format!("{}°", text::short(a.summary.max_rotation.to_degrees()))),
        (text::PEAK, |a| text::force(a.summary.peak_force)),
        (text::HITS, |a| a.summary.hits.to_string()),
        (text::LOST, |a| text::energy(a.lost())),
    ];
    Grid::new("pins").striped(true).spacing([8.0, 2.0]).show(ui, |ui| {
        ui.label("");
        for (name, _) in &runs {
            ui.label(RichText::new(name).strong());
        }
        ui.end_row();
        for (what, words) in rows {
            ui.label(RichText::new(what).weak());
            for (_, answer) in &runs {
                ui.label(words(answer));
            }
            ui.end_row();
        }
    });
    let Some(now) = now else { return };
    for (i, pin) in bench.pins.iter().enumerate() {
        let [place, turn] = now.apart_from(&pin.answer);
        let words = text::apart_from(i + 1, place, turn);
        ui.add(egui::Label::new(RichText::new(words).weak().small()).wrap());
    }
}
