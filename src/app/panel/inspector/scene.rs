//! The scene's own values: name, kind, time, gravity, tolerance; contact numbers of all pairs; pairs that are declared.

use egui::{Id, TextEdit, Ui};

use super::declared;
use super::rows::{grid, push, section};
use crate::app::command::{Command, EditCommand};
use crate::app::field::{CLICK, Change, Form, Look, Named, Place, Without, act, choice, number_at, rows, tag};
use crate::app::{edits, text};
use crate::codes;
use crate::scene::Kind;
use crate::scene::edit::{Edit, General};
use crate::scene::keys::Key;

fn kinds() -> [(Kind, &'static str); 2] {
    [(Kind::Planar, text::PLANAR.as_str()), (Kind::Spatial, text::SPATIAL.as_str())]
}

/// Shows what belongs to no body.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    section(ui, (text::SCENE_SECTION.key(), &text::SCENE_SECTION), true, |ui| {
        general(ui, form, out);
        solver(ui, form, out);
    });
    section(ui, (text::ALL_PAIRS_SECTION.key(), &text::ALL_PAIRS_SECTION), false, |ui| contact(ui, form, out));
    if !form.scene.assumed.is_empty() {
        section(ui, (text::ASSUMED_SECTION.key(), &text::ASSUMED_SECTION), false, |ui| assumed(ui, form, out));
    }
    section(ui, (text::CODES_SECTION.key(), &text::CODES_SECTION), false, |ui| codes(ui, form, out));
    section(ui, (text::DECLARED_SECTION.key(), &text::DECLARED_SECTION), false, |ui| declared::show(ui, form, out));
}

fn general(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let mut new = General::of(form.scene);
    let look = form.look("");
    let change = grid(ui, "scene", |ui| {
        let name = line(ui, look.place, Named { key: "name", label: text::NAME.as_str() }, &mut new.name);
        let about =
            line(ui, look.place, Named { key: "description", label: text::DESCRIPTION.as_str() }, &mut new.description);
        let kind = choice(ui, look.place, Named { key: "kind", label: text::KIND.as_str() }, &mut new.kind, &kinds());
        let time = number_at(ui, &look, "duration_s", &mut new.duration);
        let gravity = number_at(ui, &look, "gravity_m_s2", &mut new.gravity);
        name.or(about).or(kind).or(time).or(gravity)
    });
    push(change, out, || Edit::General(Box::new(new)));
}

fn solver(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let mut solver = form.scene.solver;
    let look = form.look("solver");
    let change = grid(ui, "solver", |ui| rows(ui, &look, &mut solver, &[]));
    push(change, out, || Edit::Solver(solver));
}

/// Contact numbers of every pair that has none of its own.
fn contact(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let mut new = form.scene.contact.clone();
    let elastic = |key: &Key| edits::elastic(form.scene, key.name);
    let look = Look { whose: text::WHOSE_ALL.as_str(), without: Without::Reckoned(&elastic), ..form.look("contact") };
    let change = grid(ui, "all pairs", |ui| rows(ui, &look, &mut new, &[]));
    push(change, out, || edits::contact(new));
}

/// Values that were not given, each with a button that says that it is right.
fn assumed(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let place = form.place("");
    let scene = form.scene;
    for (path, value) in scene.assumed_numbers() {
        ui.horizontal_wrapped(|ui| {
            if act(ui, place, "assumed", &text::given(&path)) {
                let edit = Edit::Assumed(scene.assumed_without(&path));
                out.push(EditCommand::Change { edit, gesture: None }.into());
            }
            ui.label(value);
        });
    }
}

/// Inputs of design codes, each begun with what is assumed without it.
fn codes(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let mut new = form.scene.codes;
    let length = form.scene.girders.first().map_or(1.0, |girder| girder.length);
    let assumed = |key: &Key| codes::assumed(key.name, &form.scene.codes, length);
    let look = Look { without: Without::Off(&assumed), ..form.look("codes") };
    let change = grid(ui, "codes", |ui| rows(ui, &look, &mut new, &[]));
    push(change, out, || Edit::Codes(new));
}

/// A line of text, given when the field is left.
fn line(ui: &mut Ui, place: Place<'_>, names: Named<'_>, value: &mut String) -> Option<Change> {
    let name = ui.label(names.label);
    let draft_id = Id::unique(("draft", names.key));
    let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(|| value.clone());
    let response = ui.add(TextEdit::singleline(&mut draft).desired_width(104.0)).labelled_by(name.id);
    let response = tag(ui, &response, place, names);
    ui.end_row();
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(draft_id, draft));
        return None;
    }
    ui.data_mut(|d| d.remove::<String>(draft_id));
    if response.lost_focus() && draft != *value {
        *value = draft;
        return CLICK;
    }
    None
}
