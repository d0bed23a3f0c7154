//! Results on a girder, and the forces of a contact at the time shown.

use egui::{Grid, RichText, Ui};

use super::seat_orbit;
use crate::app::command::{Command, Look, TimeCommand};
use crate::app::run::answer::{Answer, MOST_VERDICTS};
use crate::app::run::spot::Spot;
use crate::app::style::theme::Palette;
use crate::app::time::replay::Replay;
use crate::app::{text, unit};
use crate::codes::RotationCondition;
use crate::dynamics::model::bearing::BearingQuantities;
use crate::language::Text;
use crate::scene::seating;
use crate::scene::{DeviceId, Girder};
use crate::sim::quantity::{OfPair, Quantity};
use crate::sim::readings::{Extreme, Reading};
use crate::sim::{BearingsReading, ContactNow, History, Touch};
use crate::view::contact_state;

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

/// Quantities of (3), (4) and (6) of a girder, from its scene's answer where there is one.
pub(in crate::app) fn show_girder(
    ui: &mut Ui,
    answer: Option<&Answer>,
    (i, girder): (usize, &Girder),
    t: f64,
    out: &mut Vec<Command>,
) {
    ui.add_space(4.0);
    ui.label(RichText::new(text::COMPUTED).strong());
    let number = RotationCondition::of(&girder.prism()).number;
    let mut rows = vec![(text::US_SKEW.as_str(), format!("{}°", unit::trimmed(90.0 - girder.skew_deg)))];
    let run =
        answer.map(|a| &a.history).filter(|run| run.scene().girders.get(i).is_some_and(|g| g.name == girder.name));
    if let Some(run) = run {
        rows.extend(quantities(&run.connections().bearing_quantities(i)));
    }
    rows.push((text::CONDITION.as_str(), format!("{} {}", text::short(number), text::turns_or_not(number))));
    table(ui, "computed", rows);
    if let Some((answer, reading)) = answer.and_then(|a| Some((a, a.reading(i)?))) {
        ui.add_space(4.0);
        ui.label(RichText::new(text::READINGS).strong());
        verdict(ui, (i, &girder.name), (answer, reading), out);
        goes_on(ui, answer);
        if answer.carried_from().is_finite() {
            ui.label(RichText::new(text::REACHED_AFTER_MEANS).weak());
        }
        links(ui, "readings", readings(answer, i, reading), out);
        show_seats(ui, answer, i, t);
    }
}

/// Whether the girder stays on its seats, in a sentence that leads to the moment that decides it.
fn verdict(ui: &mut Ui, (girder, name): (usize, &str), (answer, reading): (&Answer, &Reading), out: &mut Vec<Command>) {
    let Some(verdict) = answer.history.seats().verdict_of(girder, &reading.seats, reading.tipped) else {
        ui.add(egui::Label::new(RichText::new(text::NO_SEATS).weak()).wrap());
        return;
    };
    let words = RichText::new(format!("{name} {}", verdict.words())).strong();
    let words = if verdict.stays() { words } else { words.color(Palette::of(ui).problem) };
    if ui.add(egui::Button::new(words).wrap()).on_hover_text(text::GO_THERE).clicked() {
        Spot::verdict(girder, &verdict).go(out);
    }
    let scene = answer.history.scene();
    let off = scene.girders.get(girder).map_or(Vec::new(), |girder| seating::bearings_off(scene, girder));
    if !off.is_empty() {
        ui.add(egui::Label::new(RichText::new(text::off_seats(name, &off)).color(Palette::of(ui).problem)).wrap());
    }
}

/// The verdicts on all girders that have seats.
pub(in crate::app) fn show_verdicts(ui: &mut Ui, answer: Option<&Answer>, out: &mut Vec<Command>) {
    let Some(answer) = answer else { return };
    let scene = answer.history.scene();
    let mut seated =
        scene.girders.iter().enumerate().filter(|(_, girder)| girder.seat.plus.or(girder.seat.minus).is_some());
    let listed: Vec<_> = seated.by_ref().take(MOST_VERDICTS).collect();
    if listed.is_empty() {
        return;
    }
    ui.add_space(4.0);
    ui.label(RichText::new(text::VERDICTS).strong());
    for (i, girder) in listed {
        if let Some(reading) = answer.reading(i) {
            verdict(ui, (i, &girder.name), (answer, reading), out);
        }
    }
    let more = seated.count();
    if more > 0 {
        ui.label(RichText::new(text::more(more)).weak());
    }
    goes_on(ui, answer);
}

/// That the run goes on as if ends were carried that have come off, where it does.
fn goes_on(ui: &mut Ui, answer: &Answer) {
    if answer.goes_on_as_carried() {
        ui.add(egui::Label::new(RichText::new(text::GOES_ON).color(Palette::of(ui).problem)).wrap());
    }
}

/// A list of names and values, each value a button to where it is seen.
fn links(ui: &mut Ui, salt: &str, rows: Vec<(&'static str, String, Spot)>, out: &mut Vec<Command>) {
    ui.add_space(4.0);
    Grid::new(salt).num_columns(2).spacing([8.0, 2.0]).striped(true).show(ui, |ui| {
        for (name, value, spot) in rows {
            ui.label(RichText::new(name).weak());
            let button = egui::Button::new(RichText::new(value).underline()).frame(false).wrap();
            if ui.add(button).on_hover_text(text::GO_THERE).clicked() {
                spot.go(out);
            }
            ui.end_row();
        }
    });
}

/// Readings of the run for one girder, each with the place where it is seen.
fn readings(answer: &Answer, girder: usize, reading: &Reading) -> Vec<(&'static str, String, Spot)> {
    let (history, carried) = (&answer.history, answer.carried_from());
    let at = |words: &str, e: &Extreme| {
        let reached = text::reached_at(words, e.t);
        if e.t > carried { text::reached_after(&reached) } else { reached }
    };
    let length = |e: &Extreme| at(&text::length(e.value), e);
    let turned = &reading.rotation;
    let degrees = format!("{}°", text::short(turned.value.to_degrees()));
    let mut rows = vec![(text::TURNS.as_str(), at(&degrees, turned), Spot::girder(girder, turned.t))];
    let drifts = text::DRIFTS.map(Text::as_str).into_iter().zip(&reading.drift).enumerate();
    rows.extend(drifts.map(|(corner, (name, e))| (name, length(e), Spot::corner(girder, corner, e.t))));
    if let Some(BearingsReading { deformation: (_, moved), force: (_, force), .. }) = &reading.bearings {
        rows.push((text::BEARINGS_MOVE.as_str(), length(moved), Spot::girder(girder, moved.t)));
        rows.push((text::BEARING_FORCE.as_str(), at(&text::force(force.value), force), Spot::girder(girder, force.t)));
    }
    for seat in &reading.seats {
        let least = seat.corners.map(|corner| (corner.corner, corner.least.value));
        let words = text::seat_left(&length(&seat.least()), seat.ledge.placed(), least);
        let end = |t: f64| Spot { look: Look::End(girder, seat.ledge.end), ..Spot::girder(girder, t) };
        rows.push((text::seat_at(seat.ledge.end), words, end(seat.least().t)));
        let off = seat.first_off();
        rows.extend(off.map(|(corner, t)| (text::CORNER_OFF.as_str(), text::corner_off_at(corner, t), end(t))));
        rows.extend(seat.lost_at.map(|t| (text::UNSEATS.as_str(), text::at_time(t), end(t))));
    }
    rows.extend(
        reading.gap.as_ref().map(|gap| (text::LEAST_GAP.as_str(), length(gap), Spot::gap(history, girder, gap.t))),
    );
    // The girder stays selected: its other readings are followed next.
    let hardest = Spot::hardest_on(history, girder).map(|(spot, most)| (spot.keeping_selection(), most));
    rows.extend(hardest.map(|(spot, most)| (text::PEAK_FORCE.as_str(), at(&text::force(most.value), &most), spot)));
    let force = reading.force.as_ref().and_then(|force| {
        let mut touches = history.hits().touches().iter();
        let touch = touches.find(|touch| touch.peak_time == force.t && touch.peak_force == force.value)?;
        Some((
            text::PEAK_OF_CORNER.as_str(),
            at(&text::force(force.value), force),
            Spot::touch(touch).keeping_selection(),
        ))
    });
    rows.extend(force);
    rows
}

/// A length of a contact: in µm below 1 mm \[m\].
fn small(length: f64) -> String {
    if length.abs() < 1e-3 { format!("{} µm", text::short(length * 1e6)) } else { text::length(length) }
}

/// The orbit of the corners of a girder over its seats, and what codes require.
fn show_seats(ui: &mut Ui, answer: &Answer, girder: usize, t: f64) {
    for seat in answer.seats().iter().filter(|seat| seat.demands.girder == girder) {
        let (demands, end) = (&seat.demands, seat.demands.seat.ledge.end);
        ui.add_space(4.0);
        ui.label(RichText::new(text::seat_at(end)).strong());
        seat_orbit::show(ui, &answer.history, (girder, &demands.seat), &seat.orbit, t);
        // Both are too long to stand side by side.
        for demand in &demands.demands {
            ui.add(egui::Label::new(RichText::new(demand.rule.as_str()).weak().small()).wrap());
            ui.add(egui::Label::new(text::demand(demand)).wrap());
        }
    }
}

/// (3), (4) in words.
fn quantities(q: &BearingQuantities) -> [(&'static str, String); 6] {
    let three = |v: [f64; 3]| v.map(text::short).join("  ");
    // What is no eccentricity but the rounding of a sum over bearings is 0.
    let known = |e: f64| if e.abs() < 1e-12 * q.gyration { 0.0 } else { e };
    let millimetres = |v: [f64; 2]| format!("{} mm", v.map(|e| text::short(known(e) * 1e3)).join("  "));
    let hertz = q.omega.map(|w| w / std::f64::consts::TAU);
    [
        (text::OMEGAS.as_str(), format!("{} rad/s", three(q.omega))),
        (text::FREQUENCIES.as_str(), format!("{} Hz", three(hertz))),
        (text::DAMPING_RATIOS.as_str(), three(q.damping_ratio)),
        (text::STIFFNESS_ECCENTRICITY.as_str(), millimetres(q.stiffness_eccentricity)),
        (text::DAMPING_ECCENTRICITY.as_str(), millimetres(q.damping_eccentricity)),
        (text::GYRATION.as_str(), text::length(q.gyration)),
    ]
}

/// A device at the time shown, each side of a stopper by itself, and every change of its state; a click goes there.
pub(in crate::app) fn show_device(ui: &mut Ui, answer: Option<&Answer>, id: DeviceId, t: f64, out: &mut Vec<Command>) {
    let Some(answer) = answer else { return };
    let history = &answer.history;
    let Some(device) = history.model().devices.iter().find(|device| device.id == id) else { return };
    ui.add_space(4.0);
    ui.label(RichText::new(text::COMPUTED).strong());
    for number in device.links.clone() {
        let Some(now) = history.connections().link(number, t) else { continue };
        let name = &history.model().links[number].name;
        ui.label(RichText::new(name).weak());
        let mut rows = vec![
            (text::STATE.as_str(), now.state.into()),
            (text::DEVICE_FORCE.as_str(), text::force(now.force.length())),
            (text::DEVICE_DEFORMATION.as_str(), text::length(now.along.deformation[0])),
        ];
        let used = now.part_of_strength().zip(now.strength);
        rows.extend(used.map(|(part, strength)| (text::DEVICE_USE.as_str(), text::used_of(part, strength))));
        if !now.acts {
            rows.push((text::DEVICE_LEFT.as_str(), text::length(now.gap)));
        }
        table(ui, name, rows);
        phases(ui, history, number, t, out);
    }
}

/// When a device changes its state.
fn phases(ui: &mut Ui, history: &History, number: usize, t: f64, out: &mut Vec<Command>) {
    let (all, law) = (history.connections().link_phases(number), &history.model().links[number].device);
    for (n, (from, phase)) in all.iter().enumerate().take(MOST_TOUCHES) {
        let until = all.get(n + 1).map_or(f64::INFINITY, |next| next.0);
        let words = text::phase(*from, &law.state(phase));
        if ui.add(egui::Button::selectable((*from..until).contains(&t), words)).clicked() {
            out.push(TimeCommand::Seek(*from).into());
        }
    }
    if all.len() > MOST_TOUCHES {
        ui.label(RichText::new(text::more(all.len() - MOST_TOUCHES)).weak());
    }
}

/// A contact at the time shown, and its touches.
pub(in crate::app) fn show_contact(ui: &mut Ui, replay: &Replay, contact: usize, out: &mut Vec<Command>) {
    let Some(answer) = replay.runner.answer() else { return };
    let t = replay.t();
    let Some(site) = answer.history.model().sites.get(contact) else { return };
    if ui.link(format!("{} | {}", site.node_in_words(), site.face_name)).on_hover_text(text::GO_THERE).clicked() {
        Spot::contact(contact, t).go(out);
    }
    if let Some(now) = answer.history.contacts().contact_at(contact, t) {
        table(ui, "contact", rows(&now));
    } else {
        ui.label(RichText::new(text::CONTACT_OPEN).weak());
        let gap = Quantity::Pair(site.pair, OfPair::Gap).at(&answer.history, t);
        table(ui, "contact", [(text::GAP_OF_PAIR.as_str(), text::length(gap))]);
    }
    touches(ui, answer, contact, t, out);
}

fn rows(c: &ContactNow) -> [(&'static str, String); 12] {
    let newtons = text::force;
    let used = if c.normal_force > 0.0 { c.tangential_force.length() / c.normal_force } else { 0.0 };
    let stretch = c.point + c.normal * c.penetration - c.anchor;
    [
        (text::STATE.as_str(), contact_state(c.state).into()),
        (text::WHOLE_FORCE.as_str(), newtons(c.force.length())),
        (text::ELASTIC_FORCE.as_str(), newtons(c.elastic_force().length())),
        (text::NORMAL_SPRING.as_str(), newtons(c.normal_force)),
        (text::TANGENTIAL_SPRING.as_str(), newtons(c.tangential_force.length())),
        (text::FORCE_RATIO.as_str(), text::one_of(&text::short(used), &text::short(c.mu()))),
        (text::CONE_USED.as_str(), format!("{} %", text::short(100.0 * c.cone_use()))),
        (text::DASHPOTS.as_str(), newtons((c.normal * c.normal_damping + c.tangential_damping).length())),
        (text::OVERLAP.as_str(), small(c.penetration)),
        (text::ANCHOR_OFF.as_str(), small(stretch.length())),
        (text::CLOSING.as_str(), format!("{} mm/s", text::short(-c.normal_velocity * 1e3))),
        (text::SLIDING.as_str(), format!("{} mm/s", text::short(c.sliding.length() * 1e3))),
    ]
}

/// Most touches listed.
const MOST_TOUCHES: usize = 200;

/// Every touch of a contact; a click goes to its peak.
fn touches(ui: &mut Ui, answer: &Answer, contact: usize, t: f64, out: &mut Vec<Command>) {
    let all: Vec<&Touch> = answer.history.hits().touches().iter().filter(|touch| touch.contact == contact).collect();
    ui.add_space(4.0);
    ui.label(RichText::new(text::touches(all.len())).strong());
    for touch in all.iter().take(MOST_TOUCHES) {
        let words = text::touch(touch.start, touch.end, touch.peak_force, touch.impulse);
        let here = (touch.start..=touch.end).contains(&t);
        if ui.add(egui::Button::selectable(here, words)).on_hover_text(text::GO_TO_PEAK).clicked() {
            Spot::touch(touch).go(out);
        }
    }
    if all.len() > MOST_TOUCHES {
        ui.label(RichText::new(text::more(all.len() - MOST_TOUCHES)).weak());
    }
}
