//! Which model computes the scene, the impact model's numbers, and how far the two models are apart.

use egui::{RichText, Ui};

use crate::app::bench::Workbench;
use crate::app::command::{Command, EditCommand};
use crate::app::field::{Place, choice_line, slider, slider_of};
use crate::app::run::answer::Apart;
use crate::app::text;
use crate::app::unit::{PURE, SLOW};
use crate::scene::edit::Edit;
use crate::scene::{Flush, ImpactSettings, Kind, ModelKind};
use crate::sim::State;

/// Shows the switch; the impact model's numbers and what both say where they are asked for.
pub(in crate::app) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let scene = bench.scene();
    let mut model = scene.model;
    let spatial = scene.kind == Kind::Spatial;
    ui.add_enabled_ui(!spatial || model.kind != ModelKind::Contact, |ui| {
        let place = Place { problems: bench.problems(), table: "model" };
        choice_line(ui, place, ("kind", text::MODEL), &mut model.kind, &MODELS);
    });
    if spatial {
        ui.add(egui::Label::new(RichText::new(text::MODEL_SPATIAL).weak().small()).wrap());
    }
    if model != scene.model {
        out.push(EditCommand::Change { edit: Edit::Model(model), gesture: None }.into());
    }
    if scene.model.kind != ModelKind::Contact {
        numbers(ui, bench, out);
        states(ui, bench);
    }
}

const MODELS: [(ModelKind, &str); 3] = [
    (ModelKind::Contact, text::MODEL_CONTACT),
    (ModelKind::Impact, text::MODEL_IMPACT),
    (ModelKind::Both, text::MODEL_BOTH),
];

const RULES: [(Flush, &str); 2] = [(Flush::Paper, text::FLUSH_PAPER), (Flush::TwoCorner, text::FLUSH_TWO_CORNER)];

fn numbers(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let mut new: ImpactSettings = bench.scene().impact;
    let place = Place { problems: bench.problems(), table: "impact" };
    // A corner's numbers where it has none of its own.
    let [own_s, _] = ImpactSettings { corner_mu_static: None, ..new }.corner_friction();
    let [_, own_k] = ImpactSettings { corner_mu_kinetic: None, ..new }.corner_friction();
    let changes = [
        slider(ui, place, ("restitution_normal", text::IMPACT_E_NORMAL), &mut new.restitution_normal, PURE, 0.0..=1.0),
        slider(
            ui,
            place,
            ("restitution_tangential", text::IMPACT_E_TANGENTIAL),
            &mut new.restitution_tangential,
            PURE,
            -1.0..=1.0,
        ),
        slider(ui, place, ("mu_static", text::IMPACT_MU_STATIC), &mut new.mu_static, PURE, 0.0..=1.0),
        slider(ui, place, ("mu_kinetic", text::IMPACT_MU_KINETIC), &mut new.mu_kinetic, PURE, 0.0..=1.0),
    ];
    let corner = [
        slider_of(
            ui,
            place,
            ("corner_mu_static", text::CORNER_MU_STATIC),
            (&mut new.corner_mu_static, own_s),
            PURE,
            0.0..=1.0,
        ),
        slider_of(
            ui,
            place,
            ("corner_mu_kinetic", text::CORNER_MU_KINETIC),
            (&mut new.corner_mu_kinetic, own_k),
            PURE,
            0.0..=1.0,
        ),
    ];
    let speed = slider(ui, place, ("stop_speed_m_s", text::STOP_SPEED), &mut new.stop_speed, SLOW, 1e-6..=1e-2);
    let rule = choice_line(ui, place, ("flush", text::FLUSH_HITS), &mut new.flush, &RULES);
    let change = changes.into_iter().chain(corner).flatten().next().or(speed).or(rule);
    if let Some(change) = change {
        out.push(EditCommand::Change { edit: Edit::Impact(new), gesture: change.gesture }.into());
    }
}

/// The girders' states now, and how far the models are apart.
fn states(ui: &mut Ui, bench: &Workbench) {
    let Some(answer) = bench.answer().filter(|_| !bench.is_stale()) else { return };
    let t = bench.clock().t;
    let by_impulses = answer.history.beside().unwrap_or(&answer.history);
    let Some(record) = by_impulses.impact() else { return };
    for (number, body) in answer.history.model().bodies.iter().enumerate() {
        let state = record.state(number, t);
        let paper = paper_name(ui, state);
        ui.label(format!("{}: {} {}{paper}", body.name, state.letter(), state.label())).on_hover_text(text::STATE_HINT);
    }
    if let Some(apart) = &answer.apart {
        difference(ui, apart, answer.apart_at(t));
        if apart.flush {
            ui.add(egui::Label::new(RichText::new(text::FLUSH_NOTE).weak().small()).wrap());
        }
    }
}

/// The state's name in the paper; in the first frame of a window its font is not there yet.
fn paper_name(ui: &Ui, state: State) -> String {
    let font = egui::FontId::proportional(13.0);
    let there = ui.fonts_mut(|fonts| fonts.has_glyphs(&font, state.paper()));
    if there { format!(" {}", state.paper()) } else { String::new() }
}

fn difference(ui: &mut Ui, largest: &Apart, [place, turn]: [f64; 2]) {
    let words = |place: f64, turn: f64| format!("{}, {}°", text::length(place), text::short(turn.to_degrees()));
    ui.label(format!("{} {}", text::APART_NOW, words(place, turn)));
    ui.label(format!("{} {}", text::APART_MOST, words(largest.place, largest.turn)));
}
