//! Layout of the inspector's sections.

use egui::{CollapsingHeader, Grid, RichText, Ui};

use crate::app::command::{Command, EditCommand};
use crate::app::field::Change;
use crate::app::style::theme::Palette;
use crate::scene::edit::Edit;

/// A grid of names and values.
pub(super) fn grid<R>(ui: &mut Ui, salt: &str, rows: impl FnOnce(&mut Ui) -> R) -> R {
    let column = (ui.available_width() - 8.0) / 2.0;
    Grid::new(salt).num_columns(2).min_col_width(column.min(112.0)).spacing([8.0, 3.0]).show(ui, rows).inner
}

/// A section that can be folded away, with its name in every language and its title in the present one.
pub(super) fn section<R>(
    ui: &mut Ui,
    (name, title): (&str, &str),
    open: bool,
    rows: impl FnOnce(&mut Ui) -> R,
) -> Option<R> {
    let header = CollapsingHeader::new(RichText::new(title).strong()).id_salt(name).default_open(open);
    header.show_unindented(ui, rows).body_returned
}

/// Turns a change of a field into a command.
pub(super) fn push(change: Option<Change>, out: &mut Vec<Command>, edit: impl FnOnce() -> Edit) {
    if let Some(change) = change {
        out.push(EditCommand::Change { edit: edit(), gesture: change.gesture }.into());
    }
}

/// A line of small words under a row.
pub(super) fn note(ui: &mut Ui, words: &str) -> Option<Change> {
    below(ui, RichText::new(words).weak());
    None
}

/// The same of what the model leaves out and a run asks for.
pub(super) fn warning(ui: &mut Ui, words: &str) {
    let color = Palette::of(ui).problem;
    below(ui, RichText::new(words).color(color));
}

fn below(ui: &mut Ui, words: RichText) {
    ui.label("");
    ui.add(egui::Label::new(words.small()).wrap());
    ui.end_row();
}
