//! A girder: its shape, where it stands, how it starts, what pushes and holds it, its seats.

use egui::Ui;

use super::rows::{grid, push, section};
use super::{bearings, elastic};
use crate::app::command::Command;
use crate::app::field::{Change, Form, Look, Named, Place, Without, named, rows, tag};
use crate::app::panel::name_field;
use crate::app::unit::Size;
use crate::app::{edits, text};
use crate::scene::difference::differing_keys;
use crate::scene::keys::Key;
use crate::scene::{Direction, Girder, Kind};
use crate::view::Target;

/// Shows a girder; what is changed goes to every girder that is selected.
pub(super) fn show(
    ui: &mut Ui,
    form: Form<'_>,
    (i, girder): (usize, &Girder),
    selected: &[Target],
    out: &mut Vec<Command>,
) {
    let mut new = girder.clone();
    let kind = form.scene.kind;
    let table = format!("girder.{}", girder.name);
    let [starts, pushes, seats] = ["initial", "push", "seat_m"].map(|below| format!("{table}.{below}"));
    let others = selected.iter().filter_map(|target| match target {
        Target::Girder(k) if *k != i => form.scene.girders.get(*k),
        _ => None,
    });
    let differing: Vec<String> =
        differing_keys(girder, others).into_iter().map(|key| format!("{table}.{key}")).collect();
    let place = Place { differing: &differing, ..form.place(&table) };
    let reckoned = |key: &Key| if key.name == "drop_m" { girder.drop() } else { 0.0 };
    let look = |place| Look { without: Without::Reckoned(&reckoned), ..Look::new(place, kind, Size::of(girder)) };
    let first = grid(ui, "girder", |ui| {
        name_field::show(ui, place, Target::Girder(i), &girder.name, out);
        rows(ui, &look(place), &mut new, &["name"])
    });
    let stands = section(ui, (text::BEARINGS.key(), &text::BEARINGS), true, |ui| {
        bearings::show(ui, (place, form.scene), kind, &mut new)
    })
    .flatten();
    let more = section(ui, (text::START_SECTION.key(), &text::START_SECTION), false, |ui| {
        grid(ui, "start", |ui| {
            let start = rows(ui, &look(Place { table: &starts, ..place }), &mut new.initial, &[]);
            let push = rows(ui, &look(Place { table: &pushes, ..place }), &mut new.push, &[]);
            start.or(push).or(held_rows(ui, place, kind, &mut new))
        })
    });
    let some = |_: &Key| girder.length * 0.05;
    let seat = section(ui, (text::SEAT_SECTION.key(), &text::SEAT_SECTION), false, |ui| {
        let look = Look { without: Without::Off(&some), ..look(Place { table: &seats, ..place }) };
        grid(ui, "seat", |ui| rows(ui, &look, &mut new.seat, &[]))
    });
    let bends = section(ui, (text::ELASTIC_SECTION.key(), &text::ELASTIC_SECTION), false, |ui| {
        elastic::show(ui, form, place, &mut new)
    });
    let change = first.or(stands).or(more.flatten()).or(seat.flatten()).or(bends.flatten());
    push(change, out, || edits::girders_alike(form.scene, i, &new, selected));
}

/// Which ways it is held.
fn held_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, g: &mut Girder) -> Option<Change> {
    let planar = [Direction::X, Direction::Y, Direction::Yaw];
    let spatial = [Direction::X, Direction::Y, Direction::Z, Direction::Roll, Direction::Pitch, Direction::Yaw];
    let ways: &[Direction] = if kind == Kind::Planar { &planar } else { &spatial };
    let mut changed = false;
    ui.label(named(ui, place, Named { key: "held", label: text::HELD.as_str() }));
    ui.vertical(|ui| {
        for way in ways {
            let mut held = g.held.contains(way);
            let label = text::direction(*way);
            let response = ui.checkbox(&mut held, label);
            if tag(ui, &response, place, Named { key: "held", label }).changed() {
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
