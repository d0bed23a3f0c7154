//! The scene's main numbers as sliders: move one, and the whole history is computed anew.

use egui::{RichText, Ui};

use crate::app::command::{Command, EditCommand, Pane};
use crate::app::edits::Document;
use crate::app::field::{Change, Form, slider_at, slider_between, sliders};
use crate::app::panel::{comparison, fold, ground_motion, limits, models, overlays};
use crate::app::plot::source::Source;
use crate::app::plot::user_plots;
use crate::app::time::replay::Replay;
use crate::app::unit::Size;
use crate::app::viewport::display::Display;
use crate::app::{edits, text};
use crate::language::{Message, Text};
use crate::scene::edit::Edit;
use crate::view::Target;

/// Subject of the sliders and of the results beside them.
#[derive(Clone, Copy)]
pub(in crate::app) struct Shown<'a> {
    /// The scene, and what is selected in it.
    pub(in crate::app) document: &'a Document,
    /// Its answer, and the time of it that is shown.
    pub(in crate::app) replay: &'a Replay,
    /// Layers and force scale of the view.
    pub(in crate::app) display: &'a Display,
    pub(in crate::app) plots: Source<'a>,
}

/// Shows the sliders, then the overlays.
pub(in crate::app) fn show(ui: &mut Ui, shown: Shown<'_>, out: &mut Vec<Command>) {
    let Shown { document, replay, display, plots } = shown;
    let form = Form { scene: document.scene(), problems: replay.runner.problems() };
    fold::head(ui, Pane::WhatIf, out, |_, _| ());
    geometry(ui, form, &chosen(document), out);
    section(ui, text::MOTION_SECTION, |ui| {
        motion(ui, form, replay.runner.answer().map_or(&[], |answer| &answer.unused), out);
    });
    section(ui, text::CONTACT_SECTION, |ui| contact(ui, form, out));
    section(ui, text::MODEL_SECTION, |ui| models::show(ui, form, replay, out));
    section(ui, text::LIMITS_SECTION, |ui| limits::show(ui, form, &replay.runner, out));
    section(ui, text::PLOTS_SECTION, |ui| user_plots::show(ui, &plots, out));
    section(ui, text::PINS_SECTION, |ui| {
        comparison::show(ui, (plots.pins, plots.differences), replay.runner.fresh_answer().map(|a| &**a), out);
    });
    section(ui, text::SHOW_SECTION, |ui| overlays::show(ui, form, display, out));
}

/// A section that can be folded away; it stays as it is in every language.
fn section(ui: &mut Ui, title: Text, body: impl FnOnce(&mut Ui)) {
    let header = egui::CollapsingHeader::new(RichText::new(title).strong()).id_salt(title.key()).default_open(true);
    header.show_unindented(ui, body);
}

fn push(out: &mut Vec<Command>, change: Option<Change>, edit: impl FnOnce() -> Edit) {
    if let Some(change) = change {
        out.push(EditCommand::Change { edit: edit(), gesture: change.gesture }.into());
    }
}

/// The girders whose skew the slider turns, the one that is shown first, or none: all of them.
fn chosen(document: &Document) -> Vec<usize> {
    let selection = document.selection();
    let Some(Target::Girder(lead)) = selection.lead() else { return Vec::new() };
    let others = selection.girders().filter(|girder| *girder != lead);
    let there = |girder: &usize| *girder < document.scene().girders.len();
    std::iter::once(lead).chain(others).filter(there).collect()
}

fn geometry(ui: &mut Ui, form: Form<'_>, these: &[usize], out: &mut Vec<Command>) {
    let scene = form.scene;
    let Some(girder) = scene.girders.get(these.first().copied().unwrap_or(0)) else { return };
    let (table, size) = (format!("girder.{}", girder.name), Size::of(girder));
    let mut skew = girder.skew_deg;
    let named: Vec<&str> = these.iter().map(|i| scene.girders[*i].name.as_str()).collect();
    let whose = match (these, scene.girders.len()) {
        ([], 1) => girder.name.clone(),
        ([], _) => text::ALL_GIRDERS.to_string(),
        _ => named.join(", "),
    };
    ui.add(egui::Label::new(RichText::new(format!("{whose}: {}", text::us_skew(skew))).weak()).truncate());
    let change = slider_at(ui, &form.look_of(&table, size), "skew_deg", &mut skew);
    push(out, change, || edits::skew(scene, these, skew));
    let gaps = edits::gaps(scene);
    if let Some(&(mut gap)) = gaps.first() {
        // Between girders alone the file has no such place: the key is that of a wall all the same.
        let wall = scene.abutments.first().map_or("-", |a| a.name.as_str());
        let table = format!("abutment.{wall}");
        if gaps.iter().any(|other| (other - gap).abs() > 1e-6) {
            ui.add(egui::Label::new(RichText::new(text::gaps(&gaps)).weak().small()).wrap());
        }
        let change = slider_between(ui, &form.look_of(&table, size), "gap_m", &mut gap, 0.0..=girder.length * 0.05);
        push(out, change, || edits::gap(scene, gap));
    }
}

fn contact(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let mut new = form.scene.contact.clone();
    // The rules that are rarely changed stand in the inspector alone.
    let change = sliders(ui, &form.look("contact"), &mut new, &["sharing", "tension", "between"]);
    push(out, change, || edits::contact(new));
}

fn motion(ui: &mut Ui, form: Form<'_>, unused: &[Message], out: &mut Vec<Command>) {
    ground_motion::show(ui, form, out);
    let mut duration = form.scene.duration;
    let change = slider_at(ui, &form.look(""), "duration_s", &mut duration);
    for words in unused {
        ui.add(egui::Label::new(RichText::new(words.to_string()).weak().small()).wrap());
    }
    push(out, change, || edits::duration(form.scene, duration));
}
