//! The scene's own values: name, kind, time, gravity, tolerance.

use egui::{Id, TextEdit, Ui};

use super::{grid, push, section};
use crate::app::command::Command;
use crate::app::field::{Change, GRAVITIES, PURE, Place, SECONDS, Unit, number};
use crate::app::{Workbench, text};
use crate::scene::edit::{Edit, General};
use crate::scene::{Kind, STANDARD_GRAVITY};

/// Shows what belongs to no body.
pub(super) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let scene = bench.scene();
    section(ui, text::SCENE_SECTION, true, |ui| {
        let mut new = General::of(scene);
        let place = Place { problems: bench.problems(), table: "scene" };
        let change = grid(ui, "scene", |ui| {
            let name = line(ui, text::NAME, "scene name", &mut new.name);
            let about = line(ui, text::DESCRIPTION, "scene description", &mut new.description);
            let kind = kind_row(ui, &mut new.kind);
            let time = number(ui, place, ("duration_s", text::DURATION), &mut new.duration, SECONDS, 0.0);
            let mut g = new.gravity / STANDARD_GRAVITY;
            let gravity = number(ui, place, ("gravity_m_s2", text::GRAVITY), &mut g, GRAVITIES, 0.0);
            if gravity.is_some() {
                new.gravity = g * STANDARD_GRAVITY;
            }
            name.or(about).or(kind).or(time).or(gravity)
        });
        push(change, out, || Edit::General(Box::new(new)));
        let mut solver = scene.solver;
        let place = Place { problems: bench.problems(), table: "solver" };
        let change = grid(ui, "solver", |ui| {
            let mut digits = -solver.tolerance.log10();
            let unit = Unit { speed: 0.02, ..PURE };
            let change = number(ui, place, ("tolerance", text::TOLERANCE), &mut digits, unit, 3.0);
            if change.is_some() {
                solver.tolerance = 10f64.powf(-digits.min(13.0));
            }
            change
        });
        push(change, out, || Edit::Solver(solver));
    });
}

/// A line of text, given when the field is left.
fn line(ui: &mut Ui, label: &str, id: &str, value: &mut String) -> Option<Change> {
    let name = ui.label(label);
    let draft_id = Id::unique(("draft", id));
    let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(|| value.clone());
    let response = ui.add(TextEdit::singleline(&mut draft).desired_width(120.0)).labelled_by(name.id);
    ui.end_row();
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(draft_id, draft));
        return None;
    }
    ui.data_mut(|d| d.remove::<String>(draft_id));
    let changed = response.lost_focus() && draft != *value;
    changed.then(|| {
        *value = draft;
        Change { gesture: None }
    })
}

fn kind_row(ui: &mut Ui, kind: &mut Kind) -> Option<Change> {
    let before = *kind;
    ui.label(text::KIND);
    ui.horizontal(|ui| {
        ui.selectable_value(kind, Kind::Planar, text::PLANAR);
        ui.selectable_value(kind, Kind::Spatial, text::SPATIAL);
    });
    ui.end_row();
    (*kind != before).then_some(Change { gesture: None })
}
