//! What follows from the numbers of a girder, and the forces of a contact at the time shown.

use egui::{Grid, RichText, Ui};

use super::answer::Answer;
use super::command::Command;
use super::{Workbench, field, text};
use crate::dynamics::bearing::Quantities;
use crate::geometry::End;
use crate::scene::Girder;
use crate::sim::quantity::{OfPair, Quantity};
use crate::sim::readings::{Extreme, Reading};
use crate::sim::{ContactNow, Touch};

/// A list of names and values.
fn table(ui: &mut Ui, salt: &str, rows: impl IntoIterator<Item = (&'static str, String)>) {
    ui.add_space(4.0);
    Grid::new(salt).num_columns(2).spacing([8.0, 2.0]).striped(true).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(RichText::new(name).weak());
            ui.add(egui::Label::new(value).wrap());
            ui.end_row();
        }
    });
}

/// What (3), (4) and (6) say of a girder.
pub(super) fn show_girder(ui: &mut Ui, bench: &Workbench, i: usize, girder: &Girder) {
    ui.add_space(4.0);
    ui.label(RichText::new(text::COMPUTED).strong());
    // A straight girder's is 0 but for the rounding of sin π.
    let number = Some(girder.prism().rotation_number()).filter(|n| n.abs() > 1e-12).unwrap_or(0.0);
    let turns = if number >= 1.0 { "≥ 1: can turn" } else { "< 1: cannot" };
    let mut rows = vec![("US skew", format!("{}°", field::trimmed(90.0 - girder.skew_deg)))];
    let body = bench.answer().and_then(|a| a.history.model().bodies.get(i)).filter(|b| b.name == girder.name);
    if let Some(body) = body.filter(|_| !bench.is_stale()) {
        rows.extend(quantities(&body.quantities()));
    }
    rows.push(("condition (6)", format!("{} {turns}", text::short(number))));
    table(ui, "computed", rows);
    let answer = bench.answer().filter(|_| !bench.is_stale());
    if let Some(reading) = answer.and_then(|a| a.reading(i)) {
        show_reading(ui, reading);
    }
}

/// What a designer reads off the run for one girder.
fn show_reading(ui: &mut Ui, reading: &Reading) {
    ui.add_space(4.0);
    ui.label(RichText::new(text::READINGS).strong());
    let at = |words: String, e: &Extreme| format!("{words} at {:.3} s", e.t);
    let length = |e: &Extreme| at(text::length(e.value), e);
    let mut rows: Vec<(&'static str, String)> =
        vec![("turns", at(format!("{}°", text::short(reading.rotation.value.to_degrees())), &reading.rotation))];
    let corners = ["drift 1", "drift 2", "drift 3", "drift 4"];
    rows.extend(corners.into_iter().zip(reading.drift.iter().map(length)));
    for seat in &reading.seats {
        let name = if seat.end == End::Plus { "seat +x" } else { "seat -x" };
        let corners = seat.at_corners.map(text::length).join(", ");
        rows.push((
            name,
            format!("{} left of {}; at the corners {corners}", length(&seat.least), text::length(seat.length)),
        ));
        if let Some(t) = seat.left_at {
            rows.push(("unseats", format!("at {t:.4} s")));
        }
    }
    rows.extend(reading.gap.as_ref().map(|gap| ("least gap", length(gap))));
    rows.extend(reading.force.as_ref().map(|force| ("peak force", at(text::force(force.value), force))));
    table(ui, "readings", rows);
}

/// (3), (4) in words.
fn quantities(q: &Quantities) -> [(&'static str, String); 6] {
    let three = |v: [f64; 3]| v.map(text::short).join("  ");
    let millimetres = |v: [f64; 2]| format!("{} mm", v.map(|e| text::short(e * 1e3)).join("  "));
    let hertz = q.omega.map(|w| w / std::f64::consts::TAU);
    [
        ("ω x y θ", format!("{} rad/s", three(q.omega))),
        ("f x y θ", format!("{} Hz", three(hertz))),
        ("h x y θ", three(q.damping_ratio)),
        ("ε x y", millimetres(q.stiffness_eccentricity)),
        ("η x y", millimetres(q.damping_eccentricity)),
        ("i (4e)", text::length(q.gyration)),
    ]
}

/// A contact at the time shown, and its touches.
pub(super) fn show_contact(ui: &mut Ui, bench: &Workbench, contact: usize, out: &mut Vec<Command>) {
    let Some(answer) = bench.answer() else { return };
    let Some(site) = answer.history.model().contacts.get(contact) else { return };
    ui.label(format!("{} | {}", site.node, site.face_name));
    if let Some(now) = answer.history.contact_at(contact, bench.clock().t) {
        table(ui, "contact", rows(&now));
    } else {
        ui.label(RichText::new(text::CONTACT_OPEN).weak());
        let gap = Quantity::Pair(site.pair, OfPair::Gap).at(&answer.history, bench.clock().t);
        table(ui, "contact", [("gap of pair", text::length(gap))]);
    }
    touches(ui, answer, contact, bench.clock().t, out);
}

fn rows(c: &ContactNow) -> [(&'static str, String); 11] {
    let newtons = text::force;
    let used = if c.normal_force > 0.0 { c.tangential_force.length() / c.normal_force } else { 0.0 };
    let stretch = c.point + c.normal * c.penetration - c.anchor;
    [
        ("state", c.state.label().to_owned()),
        ("normal K δ", newtons(c.normal_force)),
        ("tangential", newtons(c.tangential_force.length())),
        ("T / N", format!("{} of {}", text::short(used), text::short(c.mu_static))),
        ("cone used", format!("{} %", text::short(100.0 * c.cone_use()))),
        ("dashpots", newtons((c.normal * c.normal_damping + c.tangential_damping).length())),
        ("all of it |R|", newtons(c.force.length())),
        ("overlap δ", format!("{} µm", text::short(c.penetration * 1e6))),
        ("anchor off", format!("{} µm", text::short(stretch.length() * 1e6))),
        ("closing", format!("{} mm/s", text::short(-c.normal_velocity * 1e3))),
        ("sliding", format!("{} mm/s", text::short(c.sliding.length() * 1e3))),
    ]
}

/// Most touches listed.
const MOST_TOUCHES: usize = 200;

/// Every touch of a contact; a click goes to its peak.
fn touches(ui: &mut Ui, answer: &Answer, contact: usize, t: f64, out: &mut Vec<Command>) {
    let all: Vec<&Touch> = answer.history.touches().iter().filter(|touch| touch.contact == contact).collect();
    ui.add_space(4.0);
    ui.label(RichText::new(text::touches(all.len())).strong());
    for touch in all.iter().take(MOST_TOUCHES) {
        let words = text::touch(touch.start, touch.end, touch.peak_force, touch.impulse);
        let here = (touch.start..=touch.end).contains(&t);
        if ui.add(egui::Button::selectable(here, words)).on_hover_text(text::GO_TO_PEAK).clicked() {
            out.push(Command::Seek(touch.peak_time));
        }
    }
    if all.len() > MOST_TOUCHES {
        ui.label(RichText::new(text::more(all.len() - MOST_TOUCHES)).weak());
    }
}
