//! An abutment: before which end it stands, its gap, its face.

use egui::{ComboBox, Ui};

use super::backfill;
use super::rows::{grid, note, push, section, warning};
use crate::app::command::Command;
use crate::app::field::{CLICK, Change, Form, Look, Named, Place, Without, act, number, rows, tag};
use crate::app::panel::{grounds, name_field};
use crate::app::run::answer::Answer;
use crate::app::unit::{Size, length_unit};
use crate::app::{edits, text};
use crate::geometry::End;
use crate::language::said;
use crate::scene::keys::Key;
use crate::scene::overrides::replaced_by;
use crate::scene::{Abutment, Girder, Scene, placed};
use crate::tables::BackfillReport;
use crate::view::Target;

/// Shows an abutment.
pub(super) fn show(
    ui: &mut Ui,
    form: Form<'_>,
    (i, abutment): (usize, &Abutment),
    answer: Option<&Answer>,
    out: &mut Vec<Command>,
) {
    let mut new = abutment.clone();
    let table = format!("abutment.{}", abutment.name);
    let (scene, place) = (form.scene, form.place(&table));
    let girder = scene.girders.iter().find(|g| g.name == abutment.faces);
    let size = girder.map_or(Size::of_scene(scene), Size::of);
    let ground = scene.moving_supports().and_then(|supports| supports.of_abutment(i));
    let reckoned = |key: &Key| match key.name {
        "delay_s" => ground.map_or(0.0, |ground| ground.delay),
        "motion_factor" => ground.map_or(1.0, |ground| ground.factor),
        face => face_number(girder, face),
    };
    let look = Look { without: Without::Reckoned(&reckoned), ..form.look_of(&table, size) };
    let change = grid(ui, "abutment", |ui| {
        name_field::show(ui, place, Target::Abutment(i), &abutment.name, out);
        let faces = faces_row(ui, place, scene, &mut new);
        let corners = new.polygon.as_mut().and_then(|corners| corner_rows(ui, place, girder, corners));
        let by_corners = if new.polygon.is_some() { replaced_by("polygon_m") } else { &[] };
        let ground = grounds::row(ui, place, scene, &mut new.ground);
        faces.or(corners).or(ground).or(rows(ui, &look, &mut new, &[&["name", "faces", "end"], by_corners].concat()))
    });
    let change = change.or(way_of_face(ui, place, scene, &mut new));
    let soil = section(ui, (text::BACKFILL_SECTION.key(), &text::BACKFILL_SECTION), false, |ui| {
        backfill::show(ui, form, place, size, &mut new)
    });
    let change = change.or(soil.flatten());
    push(change, out, || edits::abutment(i, new));
    if let Some(soil) = answer.and_then(|answer| answer.soil(&abutment.name)) {
        grid(ui, "soil-of-the-run", |ui| pushed(ui, soil));
    }
}

/// Readings of the soil.
fn pushed(ui: &mut Ui, soil: &BackfillReport) {
    let (push, gap) = (text::length(soil.push), text::length(soil.remaining_gap));
    let share = format!("{:.0}", 100.0 * soil.force / soil.ultimate);
    let (t, force) = (format!("{:.2}", soil.t), text::force(soil.force));
    note(ui, &said!("soil-pushed", "push" => push, "t" => t, "force" => force, "share" => share, "gap" => gap));
    if let Some(words) = soil.fails() {
        warning(ui, &words);
    }
}

/// Defaults of the numbers of a face \[m\].
fn face_number(girder: Option<&Girder>, key: &str) -> f64 {
    let Some(girder) = girder else { return 1.0 };
    match key {
        "width_m" => 3.0 * girder.prism().end_length(),
        "height_m" => 3.0 * girder.thickness,
        "depth_m" => girder.length,
        _ => 0.0,
    }
}

/// The face by its corners in the world.
fn corner_rows(ui: &mut Ui, place: Place<'_>, girder: Option<&Girder>, corners: &mut [[f64; 3]]) -> Option<Change> {
    let unit = length_unit(girder.map_or(1.0, |g| g.length));
    let mut change = None;
    for (n, corner) in corners.iter_mut().enumerate() {
        let key = format!("polygon_m[{n}]");
        for (value, axis) in corner.iter_mut().zip(["x", "y", "z"]) {
            let label = format!("{} {} {axis}", text::CORNER, n + 1);
            change = change.or(number(ui, place, Named { key: &key, label: &label }, value, unit));
        }
    }
    change
}

/// The other way to say where the face is; the face stays where it is.
fn way_of_face(ui: &mut Ui, place: Place<'_>, scene: &Scene, a: &mut Abutment) -> Option<Change> {
    if a.polygon.is_some() {
        if !act(ui, place, "gap_m", text::FACE_BY_GAP.as_str()) {
            return None;
        }
        (a.gap, a.polygon) = (edits::gap_before(scene, a).or(edits::gap_of(scene)).or(Some(0.0)), None);
        return CLICK;
    }
    if !act(ui, place, "polygon_m", text::FACE_BY_CORNERS.as_str()) {
        return None;
    }
    let corners = placed::abutment_face(scene, a)?;
    (a.gap, a.width, a.height, a.offset) = (None, None, None, None);
    a.polygon = Some(corners.map(edits::tidy).to_vec());
    CLICK
}

/// Which girder's end it stands before.
fn faces_row(ui: &mut Ui, place: Place<'_>, scene: &Scene, a: &mut Abutment) -> Option<Change> {
    let before = (a.faces.clone(), a.end);
    let label = ui.label(text::FACES);
    let combo = ComboBox::from_id_salt("faces").width(79.0).selected_text(a.faces.as_str()).show_ui(ui, |ui| {
        for girder in &scene.girders {
            if ui.selectable_label(a.faces == girder.name, &girder.name).clicked() {
                a.faces.clone_from(&girder.name);
            }
        }
    });
    tag(ui, &combo.response.labelled_by(label.id), place, Named { key: "faces", label: text::FACES.as_str() });
    ui.end_row();
    let label = ui.label(text::END);
    ui.horizontal(|ui| {
        for end in End::BOTH {
            let response = ui.selectable_value(&mut a.end, end, end.label()).labelled_by(label.id);
            tag(ui, &response, place, Named { key: "end", label: end.label() });
        }
    });
    ui.end_row();
    if (a.faces.as_str(), a.end) == (before.0.as_str(), before.1) { None } else { CLICK }
}
