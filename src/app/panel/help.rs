//! All keys on one page.

use egui::{Grid, Id, Modal, RichText, Ui};

use crate::app::command::{Command, WindowCommand};
use crate::app::text;

/// Shows the help while it is open.
pub(in crate::app) fn show(ui: &mut Ui, open: bool, out: &mut Vec<Command>) {
    if !open {
        return;
    }
    let modal = Modal::new(Id::unique("help")).show(ui, |ui| {
        ui.heading(text::HELP);
        Grid::new("keys").num_columns(2).spacing([18.0, 3.0]).striped(true).show(ui, |ui| {
            for (keys, words) in text::KEYS {
                ui.label(RichText::new(*keys).strong());
                ui.label(*words);
                ui.end_row();
            }
        });
        if ui.button(text::CLOSE).clicked() {
            out.push(WindowCommand::Help(false).into());
        }
    });
    if modal.should_close() {
        out.push(WindowCommand::Help(false).into());
    }
}
