//! Which ground's motion is shown: that of `[motion]`, or one that supports have of their own; its name, more of them.

use egui::{ComboBox, Id, TextEdit, Ui};

use crate::app::command::{Command, EditCommand};
use crate::app::field::{CLICK, Change, Form, Named, Place, tag};
use crate::app::{edits, text};
use crate::scene::edit::Edit;
use crate::scene::{GroundId, Scene};

/// Where the number of the ground that is shown is kept.
fn shown_id() -> Id {
    Id::unique("ground shown")
}

/// Shows the choice where there is one; the ground that is chosen.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) -> GroundId {
    let scene = form.scene;
    let shown = ui.data(|d| d.get_temp::<GroundId>(shown_id())).unwrap_or_default();
    // One that was taken away, or that is not added yet.
    let mut shown = if scene.motion_of(shown).is_some() { shown } else { GroundId::Reference };
    if scene.grounds.is_empty() {
        return shown;
    }
    let before = shown;
    ui.horizontal_wrapped(|ui| choose(ui, scene, &mut shown));
    if let GroundId::Named(number) = shown {
        ui.horizontal_wrapped(|ui| {
            name(ui, form, number, out);
            if ui.small_button(text::GROUND_REMOVE).clicked() {
                change(edits::rename_ground(scene, number, None), out);
            }
        });
    }
    if shown != before {
        ui.data_mut(|d| d.insert_temp(shown_id(), shown));
    }
    shown
}

/// Shows the way to one more, in a scene with supports that could stand on it.
pub(super) fn add(ui: &mut Ui, scene: &Scene, out: &mut Vec<Command>) {
    let stands = !scene.abutments.is_empty() || !scene.piers.is_empty();
    if stands && ui.button(text::GROUND_ADD).on_hover_text(text::GROUND_ADD_HINT).clicked() {
        change(edits::add_ground(scene), out);
        ui.data_mut(|d| d.insert_temp(shown_id(), GroundId::Named(scene.grounds.len())));
    }
}

fn change(edit: Edit, out: &mut Vec<Command>) {
    out.push(EditCommand::Change { edit, gesture: None }.into());
}

fn choose(ui: &mut Ui, scene: &Scene, shown: &mut GroundId) {
    let label = ui.label(text::GROUND_SHOWN);
    let called = |ground: GroundId| match ground {
        GroundId::Reference => text::GROUND_OF_MOTION.to_string(),
        GroundId::Named(number) => scene.grounds[number].name.clone(),
    };
    let combo = ComboBox::from_id_salt("ground shown").width(120.0).selected_text(called(*shown)).show_ui(ui, |ui| {
        for ground in std::iter::once(GroundId::Reference).chain((0..scene.grounds.len()).map(GroundId::Named)) {
            ui.selectable_value(shown, ground, called(ground));
        }
    });
    let name = text::GROUND_SHOWN.as_str();
    let response = combo.response.labelled_by(label.id);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, name));
}

/// Its name, typed freely, given when the field is left.
fn name(ui: &mut Ui, form: Form<'_>, number: usize, out: &mut Vec<Command>) {
    let ground = &form.scene.grounds[number];
    let label = ui.label(text::GROUND_NAME);
    let draft_id = Id::unique(("ground name draft", number));
    let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(|| ground.name.clone());
    let response = ui.add(TextEdit::singleline(&mut draft).desired_width(96.0)).labelled_by(label.id);
    let table = format!("ground[{number}]");
    let response = tag(ui, &response, form.place(&table), Named { key: "name", label: text::GROUND_NAME.as_str() });
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(draft_id, draft));
        return;
    }
    ui.data_mut(|d| d.remove::<String>(draft_id));
    if response.lost_focus() && draft != ground.name {
        change(edits::rename_ground(form.scene, number, Some(&draft)), out);
    }
}

/// A row for the ground under a support; none in a scene whose supports all stand on that of `[motion]`.
pub(in crate::app) fn row(ui: &mut Ui, place: Place<'_>, scene: &Scene, on: &mut Option<String>) -> Option<Change> {
    if scene.grounds.is_empty() && on.is_none() {
        return None;
    }
    let before = on.clone();
    let name = ui.label(text::GROUND_UNDER);
    let now = on.as_deref().unwrap_or(text::GROUND_OF_MOTION.as_str()).to_owned();
    let combo = ComboBox::from_id_salt("ground under").width(79.0).selected_text(now).show_ui(ui, |ui| {
        if ui.selectable_label(on.is_none(), text::GROUND_OF_MOTION).clicked() {
            *on = None;
        }
        for ground in &scene.grounds {
            if ui.selectable_label(on.as_ref() == Some(&ground.name), &ground.name).clicked() {
                *on = Some(ground.name.clone());
            }
        }
    });
    tag(ui, &combo.response.labelled_by(name.id), place, Named { key: "ground", label: text::GROUND_UNDER.as_str() });
    ui.end_row();
    if *on == before { None } else { CLICK }
}
