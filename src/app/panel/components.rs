//! Several components of a record: each from a file or from samples of its own, turned by its azimuth.

use egui::{CollapsingHeader, Grid, RichText, TextEdit, Ui};

use super::record_of::{units, weak};
use crate::app::command::{Command, FileCommand, Wish};
use crate::app::field::{
    CLICK, Change, Look, Named, Place, Without, act, choice, complain, number, rows, switched, tag,
};
use crate::app::text;
use crate::app::unit::{DEGREES, SECONDS};
use crate::files::formats_in_words;
use crate::scene::keys::Key;
use crate::scene::{Component, GroundId, Heading, RecordMotion};

/// Most components: two in plan and one upwards.
const MOST_COMPONENTS: usize = 3;

/// Directions of a component.
fn ways() -> [(Option<bool>, &'static str); 3] {
    [(None, text::AS_FILE_STATES.as_str()), (Some(false), text::IN_PLAN.as_str()), (Some(true), text::UPWARDS.as_str())]
}

/// Shows every component with its numbers, and the ways to add and to take away.
pub(super) fn show(
    ui: &mut Ui,
    look: &Look<'_>,
    (ground, record): (GroundId, &mut RecordMotion),
    out: &mut Vec<Command>,
) -> Option<Change> {
    let mut change = azimuth_of_x(ui, look.place, record);
    let (mut gone, mut reread) = (None, false);
    for n in 0..record.components.len() {
        let head = heading(record, n);
        let about = about(record, n);
        let fold = CollapsingHeader::new(head).id_salt(("component", n)).default_open(true);
        fold.show_unindented(ui, |ui| {
            weak(ui, &about);
            let (own, again) = one(ui, look, (ground, record, n), out);
            (change, reread) = (change.or(own), reread || again);
            if act(ui, look.place, "component", &text::remove_component(n + 1)) {
                gone = Some(n);
            }
        });
    }
    if let Some(n) = gone {
        record.components.remove(n);
        reread = true;
    }
    if record.components.len() < MOST_COMPONENTS && act(ui, look.place, "component", text::ADD_COMPONENT.as_str()) {
        add(record);
        reread = true;
    }
    if record.components.iter().any(|component| component.file.is_some())
        && ui.button(text::KEEP_RECORD).on_hover_text(text::KEEP_RECORD_HINT).clicked()
        && record.keep_samples()
    {
        change = CLICK;
    }
    if reread {
        // The files of others are known by what they are, not by their numbers.
        out.push(FileCommand::Shake(ground, Box::new(record.clone())).into());
        return None;
    }
    change
}

fn azimuth_of_x(ui: &mut Ui, place: Place<'_>, record: &mut RecordMotion) -> Option<Change> {
    let mut azimuth = record.x_azimuth_deg.unwrap_or(0.0);
    let grid = Grid::new("azimuth of x").num_columns(2).spacing([8.0, 3.0]);
    let change = grid
        .show(ui, |ui| {
            number(ui, place, Named { key: "x_azimuth_deg", label: text::X_AZIMUTH.as_str() }, &mut azimuth, DEGREES)
        })
        .inner;
    change.inspect(|_| record.x_azimuth_deg = Some(azimuth))
}

/// Its number and where it points.
fn heading(record: &RecordMotion, n: usize) -> String {
    let way = match record.heading(n) {
        Some(Heading::Up) => text::UPWARDS.to_string(),
        Some(Heading::InPlan(angle)) => text::from_x(angle),
        None => text::NO_DIRECTION.to_string(),
    };
    text::component(n + 1, &way)
}

fn about(record: &RecordMotion, n: usize) -> String {
    let Some((dt, samples)) = record.component_series(n) else { return text::NOT_READ.to_string() };
    let peak = samples.iter().fold(0.0_f64, |most, a| most.max(a.abs())) * record.components[n].scale.abs();
    text::record(samples.len(), dt, peak)
}

/// One component; whether its file is to be read anew.
fn one(
    ui: &mut Ui,
    look: &Look<'_>,
    (ground, record, n): (GroundId, &mut RecordMotion, usize),
    out: &mut Vec<Command>,
) -> (Option<Change>, bool) {
    let table = format!("{}.component[{n}]", look.place.table);
    let whose = text::whose_component(n + 1);
    let zero = |_: &Key| 0.0;
    let place = Place { table: &table, ..look.place };
    let look = Look { place, whose: &whose, without: Without::Off(&zero), ..*look };
    file_row(ui, place, (record.components[n].file.as_deref().unwrap_or_default(), ground, n), out);
    let channels = record.component_record(n).map(|read| {
        let named = (1..).zip(&read.channels).map(|(number, channel)| format!("{number} {}", channel.name));
        named.collect::<Vec<_>>()
    });
    let component = &mut record.components[n];
    let (before, beside) = (component.clone(), component.file.is_some());
    let grid = Grid::new(("component", n)).num_columns(2).spacing([8.0, 3.0]);
    let mut change = grid
        .show(ui, |ui| {
            let named = |key: &str| text::of_whom(key, &whose);
            let numbers = rows(ui, &look, component, &["file", "channel", "unit", "samples_m_s2", "dt_s", "vertical"]);
            let points = named(text::POINTS.as_str());
            let way = choice(ui, place, Named { key: "vertical", label: &points }, &mut component.vertical, &ways());
            let (unit, dt) = (named(text::RECORD_UNIT.as_str()), named(text::INTERVAL.as_str()));
            let dt = Named { key: "dt_s", label: &dt };
            let stated = if beside {
                let unit = choice(ui, place, Named { key: "unit", label: &unit }, &mut component.unit, &units());
                unit.or(switched(ui, place, dt, (&mut component.dt, 0.01), SECONDS))
            } else {
                let mut interval = component.dt.unwrap_or(0.01);
                number(ui, place, dt, &mut interval, SECONDS).inspect(|_| component.dt = Some(interval))
            };
            let channel = channels.filter(|all| all.len() > 1).and_then(|all| {
                let options: Vec<(Option<usize>, &str)> = (1..).map(Some).zip(all.iter().map(String::as_str)).collect();
                choice(
                    ui,
                    place,
                    Named { key: "channel", label: &named(text::CHANNEL.as_str()) },
                    &mut component.channel,
                    &options,
                )
            });
            numbers.or(way).or(stated).or(channel)
        })
        .inner;
    if let Some(samples) = component.samples.clone() {
        let label = text::of_whom(text::SAMPLES.as_str(), &whose);
        let typed = super::samples::show(ui, place, &label, &samples);
        change = typed.map_or(change, |typed| {
            component.samples = Some(typed);
            CLICK
        });
    }
    let again = beside && (before.unit, before.dt) != (component.unit, component.dt);
    (change, again)
}

/// A component's file: chosen, or typed.
fn file_row(ui: &mut Ui, place: Place<'_>, (file, ground, n): (&str, GroundId, usize), out: &mut Vec<Command>) {
    let label = text::of_whom(text::RECORD_FILE.as_str(), &text::whose_component(n + 1));
    ui.horizontal(|ui| {
        let name = ui.label(text::RECORD_FILE);
        let draft_id = egui::Id::unique(("component file draft", ground, n));
        let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(|| file.to_owned());
        let wide = (ui.available_width() - 74.0).max(40.0);
        let edit = TextEdit::singleline(&mut draft).hint_text(text::RECORD_IN_SCENE).desired_width(wide);
        let response = ui.add(edit).labelled_by(name.id);
        let response = tag(ui, &response, place, Named { key: "file", label: &label });
        if response.has_focus() {
            ui.data_mut(|d| d.insert_temp(draft_id, draft));
        } else {
            ui.data_mut(|d| d.remove::<String>(draft_id));
            if response.lost_focus() && draft != file && !draft.trim().is_empty() {
                out.push(FileCommand::Component(ground, n, draft.trim().into()).into());
            }
        }
        let words = RichText::new(text::CHOOSE);
        if ui.button(words).on_hover_text(formats_in_words()).clicked() {
            out.push(FileCommand::Ask(Wish::Component(ground, n)).into());
        }
    });
    if let Some(complaint) = place.complaint("file") {
        complain(ui, &complaint);
    }
}

/// One more: of a record of one component its first, then square to the one before, then upwards.
pub(super) fn add(record: &mut RecordMotion) {
    let still = Component { samples: Some(vec![0.0, 0.0]), dt: Some(0.01), ..Component::default() };
    if record.components.is_empty() {
        let (file, channel, unit) = (record.file.take(), record.channel.take(), record.unit.take());
        let (samples, dt) = (record.samples.take(), record.dt.take());
        // World x is east while nothing else is said: its azimuth is 90°, and α is anticlockwise from it.
        let x = *record.x_azimuth_deg.get_or_insert(90.0);
        let azimuth_deg = Some((x - record.angle_deg).rem_euclid(360.0));
        (record.angle_deg, record.vertical_scale) = (0.0, 0.0);
        let scale = std::mem::replace(&mut record.scale, 1.0);
        record.components.push(Component { file, channel, unit, samples, dt, azimuth_deg, vertical: None, scale });
        return;
    }
    let dt = record.component_series(0).map_or(0.01, |(dt, _)| dt);
    let before = record.components.last().and_then(|component| component.azimuth_deg);
    let azimuth_deg = Some((before.unwrap_or(0.0) + 90.0).rem_euclid(360.0));
    record.components.push(Component { azimuth_deg, dt: Some(dt), ..still });
}
