//! Which model computes the scene, the impact model's numbers, and how far the two models are apart.

use egui::{RichText, Ui};

use crate::app::command::{Command, EditCommand};
use crate::app::field::{Form, Look, Without, sliders};
use crate::app::text;
use crate::app::time::replay::Replay;
use crate::scene::edit::Edit;
use crate::scene::keys::Key;
use crate::scene::{ImpactSettings, Kind, ModelKind};
use crate::sim::{GirderState, RunDifference};
use crate::view::impact_state;

/// Shows the switch; the impact model's numbers and what both say where they are asked for.
pub(in crate::app) fn show(ui: &mut Ui, form: Form<'_>, replay: &Replay, out: &mut Vec<Command>) {
    let scene = form.scene;
    let mut model = scene.model;
    let spatial = scene.kind == Kind::Spatial;
    ui.add_enabled_ui(!spatial || model.kind != ModelKind::Contact, |ui| {
        sliders(ui, &form.look("model"), &mut model, &[]);
    });
    if spatial {
        ui.add(egui::Label::new(RichText::new(text::MODEL_SPATIAL).weak().small()).wrap());
    }
    if model != scene.model {
        out.push(EditCommand::Change { edit: Edit::Model(model), gesture: None }.into());
    }
    if scene.model.kind != ModelKind::Contact {
        numbers(ui, form, out);
        states(ui, replay);
    }
}

fn numbers(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let mut new: ImpactSettings = form.scene.impact;
    // A corner's numbers where it has none of its own.
    let [own_s, _] = ImpactSettings { corner_mu_static: None, ..new }.corner_friction();
    let [_, own_k] = ImpactSettings { corner_mu_kinetic: None, ..new }.corner_friction();
    let of_face = |key: &Key| if key.name == "corner_mu_static" { own_s } else { own_k };
    let look = Look { without: Without::Reckoned(&of_face), ..form.look("impact") };
    let change = sliders(ui, &look, &mut new, &[]);
    if let Some(change) = change {
        out.push(EditCommand::Change { edit: Edit::Impact(new), gesture: change.gesture }.into());
    }
}

/// The girders' states now, and how far the models are apart.
fn states(ui: &mut Ui, replay: &Replay) {
    let Some(answer) = replay.runner.fresh_answer() else { return };
    let t = replay.t();
    let by_impulses = answer.history.beside().unwrap_or(&answer.history);
    let Some(record) = by_impulses.impact() else { return };
    for (number, body) in answer.history.model().girders().iter().enumerate() {
        let state = record.state(number, t);
        let (words, paper) = (impact_state(state).as_str(), paper_name(ui, state));
        let paper = if words == state.paper() { "" } else { paper.as_str() };
        ui.label(format!("{}: {} {words}{paper}", body.name, state.letter())).on_hover_text(text::STATE_HINT);
    }
    if let Some(apart) = &answer.apart {
        difference(ui, apart.most, answer.apart_at(t));
        if apart.flush {
            ui.add(egui::Label::new(RichText::new(text::FLUSH_NOTE).weak().small()).wrap());
        }
    }
}

/// The state's name in the paper; in the first frame of a window its font is not there yet.
fn paper_name(ui: &Ui, state: GirderState) -> String {
    let font = egui::FontId::proportional(13.0);
    let there = ui.fonts_mut(|fonts| fonts.has_glyphs(&font, state.paper()));
    if there { format!(" {}", state.paper()) } else { String::new() }
}

fn difference(ui: &mut Ui, most: RunDifference, now: RunDifference) {
    let words =
        |apart: RunDifference| format!("{}, {}°", text::length(apart.place), text::short(apart.turn.to_degrees()));
    ui.label(format!("{} {}", text::APART_NOW, words(now)));
    ui.label(format!("{} {}", text::APART_MOST, words(most)));
}
