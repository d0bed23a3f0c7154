//! All keys on one page.

use egui::{Grid, Id, Modal, RichText, ScrollArea, Ui};

use crate::app::command::{Command, WindowCommand};
use crate::app::text;

/// Height that is kept for heading, button, frame and a margin, and the least of the list itself \[points\].
const AROUND: f32 = 120.0;
const LEAST: f32 = 80.0;

/// Shows the help while it is open.
pub(in crate::app) fn show(ui: &mut Ui, open: bool, out: &mut Vec<Command>) {
    if !open {
        return;
    }
    let modal = Modal::new(Id::unique("help")).show(ui, |ui| {
        ui.heading(text::HELP);
        // Heading, button and frame take what is left.
        let most = (ui.ctx().content_rect().height() - AROUND).max(LEAST);
        ScrollArea::vertical().max_height(most).show(ui, |ui| {
            Grid::new("keys").num_columns(2).spacing([18.0, 3.0]).striped(true).show(ui, |ui| {
                for (keys, words) in text::KEYS {
                    ui.label(RichText::new(*keys).strong());
                    ui.label(*words);
                    ui.end_row();
                }
            });
        });
        if ui.button(text::CLOSE).clicked() {
            out.push(WindowCommand::Help(false).into());
        }
    });
    if modal.should_close() {
        out.push(WindowCommand::Help(false).into());
    }
}
