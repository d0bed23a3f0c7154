//! A girder: its shape, where it stands, how it starts, what pushes and holds it, its seats.

use egui::Ui;

use super::bearings;
use super::rows::{grid, push, section};
use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::field::{Change, Place, number, tag};
use crate::app::panel::{name_field, results};
use crate::app::unit::{DEGREES, MOMENTS, SPEED, TURNING, force_unit, length_unit, mass_unit};
use crate::app::{edits, text};
use crate::geometry::End;
use crate::scene::{Direction, Girder, Kind};

/// Shows a girder; what is changed goes to every girder that is selected.
pub(super) fn show(ui: &mut Ui, bench: &Workbench, i: usize, girder: &Girder, out: &mut Vec<Command>) {
    let mut new = girder.clone();
    let kind = bench.scene().kind;
    let table = format!("girder.{}", girder.name);
    let place = Place { problems: bench.problems(), table: &table };
    let first = grid(ui, "girder", |ui| {
        name_field::show(ui, place, bench.selected(), &girder.name, out);
        let shape = shape_rows(ui, place, &mut new);
        shape.or(stance_rows(ui, place, &mut new))
    });
    let stands = section(ui, text::BEARINGS, true, |ui| bearings::show(ui, place, kind, &mut new)).flatten();
    let more = section(ui, text::START_SECTION, false, |ui| {
        grid(ui, "start", |ui| {
            let start = start_rows(ui, place, kind, &mut new);
            start.or(push_rows(ui, place, kind, &mut new)).or(held_rows(ui, place, kind, &mut new))
        })
    });
    let seat = section(ui, text::SEAT_SECTION, false, |ui| grid(ui, "seat", |ui| seat_rows(ui, place, &mut new)));
    let change = first.or(stands).or(more.flatten()).or(seat.flatten());
    push(change, out, || edits::girders_alike(bench.scene(), i, &new, bench.selection()));
    results::show_girder(ui, bench, i, girder);
}

fn shape_rows(ui: &mut Ui, place: Place<'_>, g: &mut Girder) -> Option<Change> {
    let (unit, mass) = (length_unit(g.length), mass_unit(g.mass));
    let changes = [
        number(ui, place, ("length_m", text::LENGTH), &mut g.length, unit),
        number(ui, place, ("width_m", text::WIDTH), &mut g.width, unit),
        number(ui, place, ("thickness_m", text::THICKNESS), &mut g.thickness, unit),
        number(ui, place, ("skew_deg", text::SKEW), &mut g.skew_deg, DEGREES),
        number(ui, place, ("mass_kg", text::MASS), &mut g.mass, mass),
    ];
    changes.into_iter().flatten().next()
}

fn stance_rows(ui: &mut Ui, place: Place<'_>, g: &mut Girder) -> Option<Change> {
    let unit = length_unit(g.length);
    let [x, y, z] = &mut g.position;
    let changes = [
        number(ui, place, ("position_m", text::POSITION_X), x, unit),
        number(ui, place, ("position_m", text::POSITION_Y), y, unit),
        number(ui, place, ("position_m", text::POSITION_Z), z, unit),
        number(ui, place, ("heading_deg", text::HEADING), &mut g.heading_deg, DEGREES),
    ];
    changes.into_iter().flatten().next()
}

fn start_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, g: &mut Girder) -> Option<Change> {
    let unit = length_unit(g.length);
    let start = &mut g.initial;
    let ([x, y, z], [vx, vy, vz]) = (&mut start.displacement, &mut start.velocity);
    let mut changes = vec![
        number(ui, place, ("initial.displacement_m", text::START_X), x, unit),
        number(ui, place, ("initial.displacement_m", text::START_Y), y, unit),
        number(ui, place, ("initial.rotation_deg", text::START_TURN), &mut start.rotation_deg, DEGREES),
        number(ui, place, ("initial.velocity_m_s", text::START_VX), vx, SPEED),
        number(ui, place, ("initial.velocity_m_s", text::START_VY), vy, SPEED),
        number(ui, place, ("initial.spin_deg_s", text::START_SPIN), &mut start.spin_deg_s, TURNING),
    ];
    if kind == Kind::Spatial {
        changes.push(number(ui, place, ("initial.displacement_m", text::START_Z), z, unit));
        changes.push(number(ui, place, ("initial.velocity_m_s", text::START_VZ), vz, SPEED));
    }
    changes.into_iter().flatten().next()
}

fn push_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, g: &mut Girder) -> Option<Change> {
    let unit = force_unit(g.mass);
    let [fx, fy, fz] = &mut g.push.force;
    let mut changes = vec![
        number(ui, place, ("push.force_n", text::PUSH_X), fx, unit),
        number(ui, place, ("push.force_n", text::PUSH_Y), fy, unit),
        number(ui, place, ("push.moment_n_m", text::PUSH_MOMENT), &mut g.push.moment, MOMENTS),
    ];
    if kind == Kind::Spatial {
        changes.push(number(ui, place, ("push.force_n", text::PUSH_Z), fz, unit));
    }
    changes.into_iter().flatten().next()
}

/// Which ways it is held.
fn held_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, g: &mut Girder) -> Option<Change> {
    let planar = [Direction::X, Direction::Y, Direction::Yaw];
    let spatial = [Direction::X, Direction::Y, Direction::Z, Direction::Roll, Direction::Pitch, Direction::Yaw];
    let ways: &[Direction] = if kind == Kind::Planar { &planar } else { &spatial };
    let mut changed = false;
    ui.label(text::HELD);
    ui.vertical(|ui| {
        for way in ways {
            let mut held = g.held.contains(way);
            let label = text::direction(*way);
            let response = ui.checkbox(&mut held, label);
            if tag(ui, &response, place, ("held", label)).changed() {
                g.held.retain(|h| h != way);
                if held {
                    g.held.push(*way);
                }
                changed = true;
            }
        }
    });
    ui.end_row();
    changed.then_some(Change { gesture: None })
}

fn seat_rows(ui: &mut Ui, place: Place<'_>, g: &mut Girder) -> Option<Change> {
    let unit = length_unit(g.length);
    let mut change = None;
    for end in End::BOTH {
        let (seat, key, label) = match end {
            End::Plus => (&mut g.seat.plus, "seat_m.+x", text::SEAT_PLUS),
            End::Minus => (&mut g.seat.minus, "seat_m.-x", text::SEAT_MINUS),
        };
        let mut given = seat.is_some();
        let response = ui.checkbox(&mut given, label).on_hover_text(text::SEAT_HINT);
        if tag(ui, &response, place, (key, label)).changed() {
            *seat = given.then_some(g.length * 0.05);
            change = Some(Change { gesture: None });
        }
        ui.end_row();
        if let Some(seat) = seat {
            change = number(ui, place, (key, text::SEAT_LENGTH), seat, unit).or(change);
        }
    }
    change
}
