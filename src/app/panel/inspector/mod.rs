//! The numbers of what is selected, typed or dragged, and what follows from them; of the scene, where nothing is.

mod abutment;
mod backfill;
mod bearings;
mod declared;
mod device;
mod elastic;
mod girder;
mod pairs;
mod pier;
mod rows;
mod scene;
mod sliders;

use egui::{RichText, Ui};

use crate::app::command::Command;
use crate::app::edits::Document;
use crate::app::field::Form;
use crate::app::panel::results;
use crate::app::text;
use crate::app::time::replay::Replay;
use crate::view::Target;

/// Shows the inspector of a scene and its answer.
pub(in crate::app) fn show(ui: &mut Ui, document: &Document, replay: &Replay, out: &mut Vec<Command>) {
    ui.label(RichText::new(text::INSPECTOR).strong());
    let several = document.selection().all().len();
    if several > 1 {
        let scene = document.scene();
        let lead = match document.selection().lead() {
            Some(Target::Girder(i)) => scene.girders.get(i).map(|girder| girder.name.clone()),
            Some(Target::Abutment(i)) => scene.abutments.get(i).map(|abutment| abutment.name.clone()),
            Some(Target::Pier(i)) => scene.piers.get(i).map(|pier| pier.name.clone()),
            Some(Target::Device(id)) => scene
                .devices()
                .into_iter()
                .find(|(known, _)| *known == id)
                .map(|(_, device)| device.ends().name.to_owned()),
            Some(Target::Contact(contact)) => replay
                .runner
                .answer()
                .and_then(|answer| Some(answer.history.model().sites.get(contact)?.node_in_words())),
            None => None,
        };
        let girder = matches!(document.selection().lead(), Some(Target::Girder(_)));
        ui.label(RichText::new(text::several(several, lead.as_deref().unwrap_or_default(), girder)).weak());
    }
    let form = Form { scene: document.scene(), problems: replay.runner.problems() };
    let fresh = replay.runner.fresh_answer().map(|answer| &**answer);
    match document.selection().lead() {
        Some(Target::Girder(i)) => {
            if let Some(girder) = form.scene.girders.get(i) {
                girder::show(ui, form, (i, girder), document.selection().all(), out);
                results::show_girder(ui, fresh, (i, girder), replay.t(), out);
                pairs::show(ui, form, fresh, Some(&girder.name), out);
            }
        }
        Some(Target::Abutment(i)) => {
            if let Some(abutment) = form.scene.abutments.get(i) {
                abutment::show(ui, form, (i, abutment), fresh, out);
                pairs::show(ui, form, fresh, Some(&abutment.name), out);
            }
        }
        Some(Target::Pier(i)) => {
            if let Some(placed) = form.scene.piers.get(i) {
                pier::show(ui, form, (i, placed), fresh, out);
            }
        }
        Some(Target::Device(id)) => {
            device::show(ui, form, id, out);
            results::show_device(ui, fresh, id, replay.t(), out);
        }
        Some(Target::Contact(contact)) => results::show_contact(ui, replay, contact, out),
        None => {
            ui.add(egui::Label::new(RichText::new(text::NOTHING_SELECTED).weak()).wrap());
            results::show_verdicts(ui, fresh, out);
            scene::show(ui, form, out);
            pairs::show(ui, form, fresh, None, out);
        }
    }
}
