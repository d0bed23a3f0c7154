//! An abutment: before which end it stands, its gap, its face.

use egui::{ComboBox, Ui};

use super::{grid, note, push};
use crate::app::command::Command;
use crate::app::field::{Change, Place, length_unit, number};
use crate::app::{Workbench, edits, name_field, text};
use crate::geometry::End;
use crate::scene::Abutment;

/// Shows an abutment.
pub(super) fn show(ui: &mut Ui, bench: &Workbench, i: usize, abutment: &Abutment, out: &mut Vec<Command>) {
    let mut new = abutment.clone();
    let table = format!("abutment.{}", abutment.name);
    let place = Place { problems: bench.problems(), table: &table };
    let size = bench.scene().girders.iter().find(|g| g.name == abutment.faces).map_or(1.0, |g| g.length);
    let change = grid(ui, "abutment", |ui| {
        name_field::show(ui, bench.selected(), &abutment.name, out);
        let faces = faces_row(ui, bench, &mut new);
        if faces.is_some() {
            return faces;
        }
        if abutment.polygon.is_some() { note(ui, text::POLYGON) } else { face_rows(ui, place, size, bench, &mut new) }
    });
    push(change, out, || edits::abutment(i, new));
}

fn face_rows(ui: &mut Ui, place: Place<'_>, size: f64, bench: &Workbench, a: &mut Abutment) -> Option<Change> {
    let unit = length_unit(size);
    let girder = bench.scene().girders.iter().find(|g| g.name == a.faces);
    let (wide, high) = girder.map_or((1.0, 1.0), |g| (3.0 * g.prism().end_length(), 3.0 * g.thickness));
    let fields = [
        ("gap_m", text::GAP, 0.0, &mut a.gap, 0.0),
        ("offset_m", text::OFFSET, f64::NEG_INFINITY, &mut a.offset, 0.0),
        ("width_m", text::FACE_WIDTH, 0.0, &mut a.width, wide),
        ("height_m", text::FACE_HEIGHT, 0.0, &mut a.height, high),
        ("depth_m", text::FACE_DEPTH, 0.0, &mut a.depth, girder.map_or(1.0, |g| g.length)),
    ];
    let mut first = None;
    for (key, label, least, value, default) in fields {
        let mut number_of = value.unwrap_or(default);
        if let Some(change) = number(ui, place, (key, label), &mut number_of, unit, least) {
            *value = Some(number_of);
            first = first.or(Some(change));
        }
    }
    first
}

/// Which girder's end it stands before.
fn faces_row(ui: &mut Ui, bench: &Workbench, a: &mut Abutment) -> Option<Change> {
    let before = (a.faces.clone(), a.end);
    let label = ui.label(text::FACES);
    let words = format!("{} {}", a.faces, a.end.label());
    let combo = ComboBox::from_id_salt("faces").width(96.0).selected_text(words).show_ui(ui, |ui| {
        for girder in &bench.scene().girders {
            for end in End::BOTH {
                let here = a.faces == girder.name && a.end == end;
                if ui.selectable_label(here, format!("{} {}", girder.name, end.label())).clicked() {
                    (a.faces, a.end) = (girder.name.clone(), end);
                }
            }
        }
    });
    combo.response.labelled_by(label.id);
    ui.end_row();
    ((a.faces.as_str(), a.end) != (before.0.as_str(), before.1)).then_some(Change { gesture: None })
}
