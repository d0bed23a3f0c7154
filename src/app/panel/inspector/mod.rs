//! The numbers of what is selected, typed or dragged, and what follows from them; of the scene, where nothing is.

mod abutment;
mod bearings;
mod declared;
mod girder;
mod pairs;
mod scene;
mod stiffness;

use egui::{CollapsingHeader, Grid, RichText, Ui};

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::field::Change;
use crate::app::panel::results;
use crate::app::text;
use crate::scene::edit::Edit;
use crate::view::Target;

/// Shows the inspector.
pub(in crate::app) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    ui.label(RichText::new(text::INSPECTOR).strong());
    let several = bench.selection().len();
    if several > 1 {
        ui.label(RichText::new(text::several(several)).weak());
    }
    let scene = bench.scene();
    match bench.selected() {
        Some(Target::Girder(i)) => {
            if let Some(girder) = scene.girders.get(i) {
                girder::show(ui, bench, i, girder, out);
                pairs::show(ui, bench, Some(&girder.name), out);
            }
        }
        Some(Target::Abutment(i)) => {
            if let Some(abutment) = scene.abutments.get(i) {
                abutment::show(ui, bench, i, abutment, out);
                pairs::show(ui, bench, Some(&abutment.name), out);
            }
        }
        Some(Target::Contact(contact)) => results::show_contact(ui, bench, contact, out),
        None => {
            ui.add(egui::Label::new(RichText::new(text::NOTHING_SELECTED).weak()).wrap());
            scene::show(ui, bench, out);
            pairs::show(ui, bench, None, out);
        }
    }
}

fn grid<R>(ui: &mut Ui, salt: &str, rows: impl FnOnce(&mut Ui) -> R) -> R {
    let column = (ui.available_width() - 8.0) / 2.0;
    Grid::new(salt).num_columns(2).min_col_width(column.min(112.0)).spacing([8.0, 3.0]).show(ui, rows).inner
}

/// A section that can be folded away.
fn section<R>(ui: &mut Ui, title: &str, open: bool, rows: impl FnOnce(&mut Ui) -> R) -> Option<R> {
    let header = CollapsingHeader::new(RichText::new(title).strong()).default_open(open);
    header.show_unindented(ui, rows).body_returned
}

fn push(change: Option<Change>, out: &mut Vec<Command>, edit: impl FnOnce() -> Edit) {
    if let Some(change) = change {
        out.push(Command::Edit { edit: edit(), gesture: change.gesture });
    }
}

fn note(ui: &mut Ui, words: &str) -> Option<Change> {
    ui.label("");
    ui.add(egui::Label::new(RichText::new(words).weak().small()).wrap());
    ui.end_row();
    None
}
