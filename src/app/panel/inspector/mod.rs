//! The numbers of what is selected, typed or dragged, and what follows from them; of the scene, where nothing is.

mod abutment;
mod bearings;
mod declared;
mod girder;
mod pairs;
mod rows;
mod scene;

use egui::{RichText, Ui};

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::panel::results;
use crate::app::text;
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
