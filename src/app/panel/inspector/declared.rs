//! Entries of `[[contact.pair]]`: between whom, at which ends, added and removed.
//!
//! Most pairs are found by themselves; an entry with ends declares one that is not. What an entry says of numbers stands
//! among the numbers of its pair.

use egui::{ComboBox, RichText, Ui};

use crate::app::command::{Command, EditCommand};
use crate::app::field::{Form, Named, Place, act, complain, tag};
use crate::app::{edits, text};
use crate::geometry::End;
use crate::scene::{PairSettings, Scene};

/// Shows every entry.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let scene = form.scene;
    let mut new = scene.contact.clone();
    let mut gone = None;
    for (n, pair) in new.pairs.iter_mut().enumerate() {
        let table = format!("contact.pair[{n}]");
        let place = form.place(&table);
        ui.horizontal(|ui| {
            ui.label(RichText::new(text::entry(n + 1)).strong());
            if ui.small_button(text::remove_entry(n + 1)).clicked() {
                gone = Some(n);
            }
        });
        entry(ui, place, scene, n, pair);
    }
    if let Some(n) = gone {
        new.pairs.remove(n);
    }
    let whole = form.place("contact");
    ui.add_enabled_ui(names(scene).len() > 1, |ui| {
        if act(ui, whole, "pair", text::ADD_ENTRY.as_str()) {
            new.pairs.extend(fresh(scene));
        }
    });
    if new != scene.contact {
        out.push(EditCommand::Change { edit: edits::contact(new), gesture: None }.into());
    }
}

fn entry(ui: &mut Ui, place: Place<'_>, scene: &Scene, n: usize, pair: &mut PairSettings) {
    for (side, whom) in pair.between.iter_mut().enumerate() {
        let label = text::body_of_entry(n + 1, side + 1);
        ui.horizontal(|ui| {
            let combo = ComboBox::from_id_salt(("between", n, side)).width(120.0).selected_text(whom.as_str());
            let response = combo
                .show_ui(ui, |ui| {
                    for name in names(scene) {
                        if ui.selectable_label(whom == name, name).clicked() {
                            name.clone_into(whom);
                        }
                    }
                })
                .response;
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, &label));
            tag(ui, &response, place, Named { key: "between", label: &label });
            if let Some(ends) = &mut pair.ends {
                for end in End::BOTH {
                    ui.selectable_value(&mut ends[side], end, end.label());
                }
            }
        });
    }
    let mut only = pair.ends.is_some();
    let label = text::ends_of_entry(n + 1);
    let response = ui.checkbox(&mut only, &label);
    if tag(ui, &response, place, Named { key: "ends", label: &label }).changed() {
        pair.ends = only.then_some([End::Plus, End::Minus]);
    }
    let complaint = ["between", "ends"].into_iter().find_map(|key| place.complaint(key));
    if let Some(complaint) = complaint {
        complain(ui, &complaint);
    }
}

fn names(scene: &Scene) -> Vec<&String> {
    scene.girders.iter().map(|g| &g.name).chain(scene.abutments.iter().map(|a| &a.name)).collect()
}

/// An entry between the first two bodies that says nothing yet.
fn fresh(scene: &Scene) -> Option<PairSettings> {
    let [a, b, ..] = names(scene)[..] else { return None };
    Some(edits::pair_between([a.clone(), b.clone()], None))
}
