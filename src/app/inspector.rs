//! The numbers of what is selected, typed or dragged, and what follows from them.

use egui::{Grid, RichText, Ui};

use super::Workbench;
use super::command::Command;
use super::field::{Change, DEGREES, HERTZ, PURE, Place, SPEED, length_unit, mass_unit, number};
use super::{computed, edits, name_field, text};
use crate::scene::edit::Edit;
use crate::scene::{Abutment, Bearings, Girder, Kind, PerDirection, SharedBearings};
use crate::view::Target;

/// Shows the inspector.
pub(super) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    ui.label(RichText::new(text::INSPECTOR).strong());
    let scene = bench.scene();
    match bench.selected() {
        Some(Target::Girder(i)) => {
            if let Some(girder) = scene.girders.get(i) {
                show_girder(ui, bench, i, girder, out);
            }
        }
        Some(Target::Abutment(i)) => {
            if let Some(abutment) = scene.abutments.get(i) {
                show_abutment(ui, bench, i, abutment, out);
            }
        }
        Some(Target::Contact(contact)) => computed::show_contact(ui, bench, contact),
        None => {
            ui.label(RichText::new(text::NOTHING_SELECTED).weak());
        }
    }
}

fn grid<R>(ui: &mut Ui, salt: &str, rows: impl FnOnce(&mut Ui) -> R) -> R {
    let column = (ui.available_width() - 8.0) / 2.0;
    Grid::new(salt).num_columns(2).min_col_width(column.min(112.0)).spacing([8.0, 3.0]).show(ui, rows).inner
}

fn show_girder(ui: &mut Ui, bench: &Workbench, i: usize, girder: &Girder, out: &mut Vec<Command>) {
    let mut new = girder.clone();
    let table = format!("girder.{}", girder.name);
    let place = Place { problems: bench.problems(), table: &table };
    let change = grid(ui, "girder", |ui| {
        name_field::show(ui, bench.selected(), &girder.name, out);
        let shape = shape_rows(ui, place, &mut new);
        let stance = stance_rows(ui, place, bench.scene().kind, &mut new);
        shape.or(stance).or(bearing_rows(ui, place, bench.scene().kind, &mut new)).or(start_rows(ui, place, &mut new))
    });
    push(change, out, || edits::girder(i, new));
    computed::show_girder(ui, bench, i, girder);
}

fn push(change: Option<Change>, out: &mut Vec<Command>, edit: impl FnOnce() -> Edit) {
    if let Some(change) = change {
        out.push(Command::Edit { edit: edit(), gesture: change.gesture });
    }
}

fn shape_rows(ui: &mut Ui, place: Place<'_>, g: &mut Girder) -> Option<Change> {
    let (unit, mass) = (length_unit(g.length), mass_unit(g.mass));
    let changes = [
        number(ui, place, ("length_m", text::LENGTH), &mut g.length, unit, 0.0),
        number(ui, place, ("width_m", text::WIDTH), &mut g.width, unit, 0.0),
        number(ui, place, ("thickness_m", text::THICKNESS), &mut g.thickness, unit, 0.0),
        number(ui, place, ("skew_deg", text::SKEW), &mut g.skew_deg, DEGREES, 0.0),
        number(ui, place, ("mass_kg", text::MASS), &mut g.mass, mass, 0.0),
    ];
    changes.into_iter().flatten().next()
}

fn stance_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, g: &mut Girder) -> Option<Change> {
    let unit = length_unit(g.length);
    let [x, y, z] = &mut g.position;
    let free = f64::NEG_INFINITY;
    let mut changes = vec![
        number(ui, place, ("position_m", text::POSITION_X), x, unit, free),
        number(ui, place, ("position_m", text::POSITION_Y), y, unit, free),
    ];
    if kind == Kind::Spatial {
        changes.push(number(ui, place, ("position_m", text::POSITION_Z), z, unit, free));
    }
    changes.push(number(ui, place, ("heading_deg", text::HEADING), &mut g.heading_deg, DEGREES, free));
    changes.into_iter().flatten().next()
}

fn bearing_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, g: &mut Girder) -> Option<Change> {
    match &mut g.bearings {
        Some(Bearings::Shared(shared)) => shared_rows(ui, place, kind, shared),
        Some(Bearings::Each(_)) => note(ui, text::BEARINGS_EACH),
        None => note(ui, text::BEARINGS_NONE),
    }
}

fn note(ui: &mut Ui, words: &str) -> Option<Change> {
    ui.label("");
    ui.add(egui::Label::new(RichText::new(words).weak().small()).wrap());
    ui.end_row();
    None
}

fn shared_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, b: &mut SharedBearings) -> Option<Change> {
    let ([mut fx, mut fy], [mut hx, mut hy]) = (b.frequency_hz.xy(), b.damping_ratio.xy());
    let frequency = [
        number(ui, place, ("bearings.frequency_hz", text::FREQUENCY_X), &mut fx, HERTZ, 0.0),
        number(ui, place, ("bearings.frequency_hz", text::FREQUENCY_Y), &mut fy, HERTZ, 0.0),
    ];
    let damping = [
        number(ui, place, ("bearings.damping_ratio", text::DAMPING_X), &mut hx, PURE, 0.0),
        number(ui, place, ("bearings.damping_ratio", text::DAMPING_Y), &mut hy, PURE, 0.0),
    ];
    if frequency.iter().any(Option::is_some) {
        b.frequency_hz = per_direction(b.frequency_hz, fx, fy);
    }
    if damping.iter().any(Option::is_some) {
        b.damping_ratio = per_direction(b.damping_ratio, hx, hy);
    }
    let vertical = match &mut b.vertical_frequency_hz {
        Some(fz) if kind == Kind::Spatial => {
            number(ui, place, ("bearings.vertical_frequency_hz", text::FREQUENCY_Z), fz, HERTZ, 0.0)
        }
        _ => None,
    };
    frequency.into_iter().chain(damping).flatten().next().or(vertical)
}

/// One number stays one number as long as both directions agree.
fn per_direction(old: PerDirection, x: f64, y: f64) -> PerDirection {
    match old {
        PerDirection::Both(_) if x == y => PerDirection::Both(x),
        _ => PerDirection::Each([x, y]),
    }
}

fn start_rows(ui: &mut Ui, place: Place<'_>, g: &mut Girder) -> Option<Change> {
    let [vx, vy, _] = &mut g.initial.velocity;
    let free = f64::NEG_INFINITY;
    let along = number(ui, place, ("initial.velocity_m_s", text::START_VX), vx, SPEED, free);
    along.or(number(ui, place, ("initial.velocity_m_s", text::START_VY), vy, SPEED, free))
}

fn show_abutment(ui: &mut Ui, bench: &Workbench, i: usize, abutment: &Abutment, out: &mut Vec<Command>) {
    let mut new = abutment.clone();
    let table = format!("abutment.{}", abutment.name);
    let place = Place { problems: bench.problems(), table: &table };
    let size = bench.scene().girders.iter().find(|g| g.name == abutment.faces).map_or(1.0, |g| g.length);
    let change = grid(ui, "abutment", |ui| {
        name_field::show(ui, bench.selected(), &abutment.name, out);
        ui.label(text::FACES);
        ui.label(format!("{} {}", abutment.faces, abutment.end.label()));
        ui.end_row();
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
