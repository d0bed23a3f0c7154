//! Asks for a row: how many spans like the one selected, and the gap between neighbours.

use egui::{Id, Modal, RichText, Ui};

use crate::app::command::{Command, PlaceCommand, RowDraft, WindowCommand};
use crate::app::edits::MOST_SPANS;
use crate::app::field::{Named, Place, number};
use crate::app::text;
use crate::app::unit::{PURE, Unit, length_unit};
use crate::scene::Girder;

/// Shows the question, with the numbers as they are so far, for a row of spans like this girder.
pub(in crate::app) fn show(ui: &mut Ui, draft: RowDraft, girder: &Girder, out: &mut Vec<Command>) {
    let modal = Modal::new(Id::unique("row")).show(ui, |ui| {
        ui.heading(text::ROW);
        ui.label(RichText::new(format!("{} {}", text::ROW_OF, girder.name)).weak());
        let mut new = draft;
        let mut spans = draft.spans as f64;
        let place = Place::apart("");
        egui::Grid::new("row").num_columns(2).show(ui, |ui| {
            let whole = Unit { speed: 0.05, ..PURE };
            number(ui, place, Named { key: "", label: text::ROW_SPANS.as_str() }, &mut spans, whole);
            number(
                ui,
                place,
                Named { key: "", label: text::ROW_GAP.as_str() },
                &mut new.gap,
                length_unit(girder.length),
            );
        });
        new = RowDraft { spans: whole(spans), gap: new.gap.max(0.0) };
        if new != draft {
            out.push(WindowCommand::AskRow(Some(new)).into());
        }
        ui.horizontal(|ui| {
            if ui.button(text::ROW_MAKE).clicked() {
                out.extend([Command::Place(PlaceCommand::Array(new)), Command::Window(WindowCommand::AskRow(None))]);
            }
            if ui.button(text::CANCEL).clicked() {
                out.push(WindowCommand::AskRow(None).into());
            }
        });
    });
    if modal.should_close() {
        out.push(WindowCommand::AskRow(None).into());
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a small whole number")]
fn whole(spans: f64) -> usize {
    spans.round().clamp(2.0, MOST_SPANS as f64) as usize
}
