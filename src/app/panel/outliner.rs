//! Bodies and devices, as a list to select from.

use egui::{Button, RichText, Ui};

use crate::app::command::{Command, Pane, PlaceCommand, SelectCommand, ViewCommand};
use crate::app::edits::{Document, Selection};
use crate::app::field::{Named, Place, mark};
use crate::app::panel::fold;
use crate::app::{text, unit};
use crate::scene::DeviceKind;
use crate::view::Target;

/// Part of the panel's height that the list takes at the most, and the least height that it has \[points\]: six rows. Chosen.
const LISTED: f32 = 0.35;
const LEAST: f32 = 150.0;

/// Shows the list of a scene with what is selected, and the buttons that add to it.
pub(in crate::app) fn show(ui: &mut Ui, document: &Document, out: &mut Vec<Command>) {
    let (scene, selection) = (document.scene(), document.selection());
    fold::head(ui, Pane::Placed, out, |_, _| ());
    adders(ui, !scene.girders.is_empty(), out);
    let height = (LISTED * ui.available_height()).max(LEAST);
    egui::ScrollArea::vertical().id_salt("outliner").max_height(height).show(ui, |ui| {
        for (i, girder) in scene.girders.iter().enumerate() {
            let about = format!("β {}°", unit::trimmed(girder.skew_deg));
            row(ui, selection, Target::Girder(i), &girder.name, &about, out);
        }
        for (i, abutment) in scene.abutments.iter().enumerate() {
            let about = format!("{} {} {}", text::BEFORE, abutment.faces, abutment.end.label());
            row(ui, selection, Target::Abutment(i), &abutment.name, &about, out);
        }
        for (i, pier) in scene.piers.iter().enumerate() {
            let about = format!("T {} s", unit::trimmed(rounded(scene.pier(i).frequencies()[0])));
            row(ui, selection, Target::Pier(i), &pier.name, &about, out);
        }
        for (id, part) in scene.devices() {
            let ends = part.ends();
            let to = ends.to.unwrap_or(text::GROUND_ITSELF.as_str());
            let about = format!("{} – {to}", ends.girder);
            row(ui, selection, Target::Device(id), ends.name, &about, out);
        }
        if scene.girders.is_empty() && scene.abutments.is_empty() {
            ui.label(text::EMPTY);
        }
    });
}

/// A period in hundredths of a second \[s\].
fn rounded(omega: f64) -> f64 {
    (100.0 * std::f64::consts::TAU / omega).round() / 100.0
}

/// The buttons that add, in two rows; devices need a girder.
fn adders(ui: &mut Ui, any: bool, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        adder(ui, ("girder", text::ADD_GIRDER.as_str(), "G"), PlaceCommand::AddGirder, out);
        adder(ui, ("abutment", text::ADD_ABUTMENT.as_str(), "B"), PlaceCommand::AddAbutment, out);
    });
    ui.horizontal(|ui| {
        adder(ui, ("pier", text::ADD_PIER.as_str(), "Shift P"), PlaceCommand::AddPier, out);
        ui.add_enabled_ui(any, |ui| {
            ui.menu_button(text::ADD_DEVICE, |ui| {
                for kind in DeviceKind::ALL {
                    if ui.button(text::device_kind(*kind)).clicked() {
                        out.push(PlaceCommand::AddDevice(*kind).into());
                        ui.close();
                    }
                }
            });
        });
    });
}

/// A button that adds what stands under a key of the file.
fn adder(ui: &mut Ui, (key, words, keys): (&str, &str, &str), command: PlaceCommand, out: &mut Vec<Command>) {
    let add = ui.small_button(words).on_hover_text(keys);
    mark(&add, Place::apart(""), Named { key, label: words });
    if add.clicked() {
        out.push(command.into());
    }
}

fn row(ui: &mut Ui, selection: &Selection, target: Target, name: &str, about: &str, out: &mut Vec<Command>) {
    let selected = selection.all().contains(&target);
    let button = Button::selectable(selected, name).right_text(RichText::new(about).weak()).truncate();
    let size = egui::vec2(ui.available_width(), 20.0);
    let response = ui.add(button.min_size(size));
    let known = ui.scope_id().with("listed as selected");
    let is_last = selection.all().last() == Some(&target);
    if is_last && ui.data(|data| data.get_temp::<String>(known)).is_none_or(|before| before != name) {
        // What is selected elsewhere comes into view here.
        ui.data_mut(|data| data.insert_temp(known, name.to_owned()));
        response.scroll_to_me(None);
    }
    if response.clicked() {
        let alone = selected && selection.all().len() == 1;
        let also = ui.input(|i| i.modifiers.command || i.modifiers.shift);
        let one = Command::Select(SelectCommand::Only(if alone { None } else { Some(target) }));
        out.push(if also { Command::Select(SelectCommand::Also(target)) } else { one });
    }
    if response.double_clicked() {
        out.push(SelectCommand::Only(Some(target)).into());
        out.push(ViewCommand::Frame.into());
    }
}
