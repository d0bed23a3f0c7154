//! Toggles for everything that the view draws over the bodies, and the scale of the force arrows.

use egui::{Slider, Ui};

use crate::app::command::{Command, EditCommand, ViewCommand};
use crate::app::field::{Form, Named, choice_line, slider_row, tag};
use crate::app::panel::view_menu;
use crate::app::text;
use crate::app::viewport::display::Display;
use crate::language::Text;
use crate::scene::edit::Edit;
use crate::scene::{Overlays, ViewPreset, ViewSettings};

/// Shows the toggles in two columns, then the force scale.
pub(in crate::app) fn show(ui: &mut Ui, form: Form<'_>, display: &Display, out: &mut Vec<Command>) {
    let mut overlays = display.overlays;
    let layers = form.place("view.overlays");
    let mut changed = false;
    egui::Grid::new("overlays").num_columns(2).min_col_width((ui.available_width() - 6.0) / 2.0).show(ui, |ui| {
        for (i, layer) in Overlays::ALL.iter().enumerate() {
            let name = Text::new(layer.label).as_str();
            let response = ui.checkbox((layer.switch)(&mut overlays), name);
            changed |= tag(ui, &response, layers, Named { key: layer.key, label: name }).changed();
            if i % 2 == 1 {
                ui.end_row();
            }
        }
    });
    if changed {
        out.push(ViewCommand::Overlays(overlays).into());
    }
    force_scale(ui, form, display, out);
    view_menu::exaggeration(ui, display.sight, out);
    first_view(ui, form, out);
}

fn views() -> [(ViewPreset, &'static str); 4] {
    [
        (ViewPreset::Iso, text::VIEW_ISO.as_str()),
        (ViewPreset::Top, text::VIEW_TOP.as_str()),
        (ViewPreset::Side, text::VIEW_SIDE.as_str()),
        (ViewPreset::Contact, text::VIEW_CONTACT.as_str()),
    ]
}

/// Where the camera stands when the scene is opened.
fn first_view(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let place = form.place("view");
    let mut view = ViewSettings { ..form.scene.view.clone() };
    if choice_line(ui, place, Named { key: "camera", label: text::FIRST_VIEW.as_str() }, &mut view.camera, &views())
        .is_some()
    {
        out.push(EditCommand::Change { edit: Edit::View(view), gesture: None }.into());
    }
}

fn force_scale(ui: &mut Ui, form: Form<'_>, display: &Display, out: &mut Vec<Command>) {
    let automatic = display.automatic_force_scale();
    let mut auto = display.force_scale().is_none();
    if ui.checkbox(&mut auto, text::AUTO_SCALE).changed() {
        out.push(ViewCommand::ForceScale((!auto).then_some(automatic)).into());
    }
    let mut scale = display.force_scale().unwrap_or(automatic);
    let words = format!("{}/m", text::force(scale));
    let slider = Slider::new(&mut scale, automatic / 50.0..=automatic * 50.0)
        .logarithmic(true)
        .clamping(egui::SliderClamping::Edits)
        .show_value(false);
    let place = form.place("view");
    let response = slider_row(ui, text::FORCE_SCALE.into(), slider, &words);
    if tag(ui, &response, place, Named { key: "force_scale_n_per_m", label: text::FORCE_SCALE.as_str() }).changed() {
        out.push(ViewCommand::ForceScale(Some(scale)).into());
    }
}
