//! How the ground moves: still, a sine, a record, an earthquake or a sweep, with every number of each.

use egui::{Grid, RichText, TextEdit, Ui};

use super::{components, grounds, record_of, samples, target, wave};
use crate::app::command::{AngleCommand, Command, EditCommand, FileCommand, QuakeCommand, Wish};
use crate::app::field::{
    CLICK, Change, Form, Look, Named, Place, Without, act, choice_line, complain, optional_at, slider_at, sliders, tag,
};
use crate::app::{edits, text};
use crate::files::formats_in_words;
use crate::scene::edit::{Edit, General};
use crate::scene::keys::Key;
use crate::scene::{GroundId, Motion, RecordMotion, STANDARD_GRAVITY, SineMotion, SweepMotion, SyntheticMotion};

/// Which kind of motion it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Kind {
    #[default]
    Still,
    Sine,
    Record,
    Synthetic,
    Sweep,
}

fn kinds() -> [(Kind, &'static str); 5] {
    [
        (Kind::Still, text::STILL.as_str()),
        (Kind::Sine, text::SINE.as_str()),
        (Kind::Record, text::RECORD.as_str()),
        (Kind::Synthetic, text::SYNTHETIC.as_str()),
        (Kind::Sweep, text::SWEEP.as_str()),
    ]
}

/// Whether an amplitude is said in m/s² rather than in g.
const UNITS: [(bool, &str); 2] = [(false, "g"), (true, "m/s²")];

/// Keys of the vertical share of a sine.
const VERTICAL: [&str; 3] = ["vertical_amplitude_g", "vertical_amplitude_m_s2", "vertical_phase_deg"];

/// Shows the kind and what belongs to it.
pub(in crate::app) fn show(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let ground = grounds::show(ui, form, out);
    let Some(before) = form.scene.motion_of(ground) else { return };
    let mut new = before.clone();
    let table = form.scene.motion_place(ground);
    let look = form.look(&table);
    let kind = kind(ui, look.place, &mut new);
    let change = match &mut new {
        Motion::None => still(ui, &mut new),
        Motion::Sine(sine) => sine_rows(ui, &look, sine),
        Motion::Record(record) => record_rows(ui, &look, (ground, record), out),
        Motion::Synthetic(quake) => synthetic_rows(ui, &look, quake),
        Motion::Sweep(sweep) => sliders(ui, &look, sweep, &[]),
    };
    if ground == GroundId::Reference && !matches!(form.scene.motion, Motion::None) {
        wave::show(ui, form, out);
        windows(ui, out);
    }
    grounds::add(ui, form.scene, out);
    let chosen = kind.is_some();
    if let Some(change) = kind.or(change) {
        let whole = length(&new).filter(|length| chosen && *length > form.scene.duration);
        let motion = edits::motion(form.scene, ground, new);
        let edit = match whole {
            // What has an end is chosen with it.
            Some(duration) => {
                let general = General { duration, ..General::of(form.scene) };
                Edit::Batch(vec![motion, Edit::General(Box::new(general))])
            }
            None => motion,
        };
        out.push(EditCommand::Change { edit, gesture: change.gesture }.into());
    }
}

/// How long a motion of its own length lasts \[s\].
fn length(motion: &Motion) -> Option<f64> {
    match motion {
        Motion::Synthetic(quake) => Some(quake.duration),
        Motion::Sweep(sweep) => Some(sweep.length),
        Motion::None | Motion::Sine(_) | Motion::Record(_) => None,
    }
}

/// Longest period of an earthquake that comes to rest to begin with \[s\]: longer than that of any girder on its bearings.
const LONGEST: f64 = 10.0;

/// An earthquake, its target spectrum, and where it has none the longest period with which it comes to rest.
fn synthetic_rows(ui: &mut Ui, look: &Look<'_>, quake: &mut SyntheticMotion) -> Option<Change> {
    let change = sliders(ui, look, quake, &[]).or(target::show(ui, look.place, quake));
    if quake.target.is_some() && quake.longest.is_none() {
        return change;
    }
    let first = LONGEST.min(quake.duration);
    let start = |_: &Key| first;
    let look = Look { without: Without::Off(&start), ..*look };
    let rows = |ui: &mut Ui| optional_at(ui, &look, "longest_period_s", &mut quake.longest);
    change.or(Grid::new("longest period").num_columns(2).show(ui, rows).inner)
}

/// Buttons that open the windows about the motion.
fn windows(ui: &mut Ui, out: &mut Vec<Command>) {
    if ui.button(text::QUAKE_OPEN).on_hover_text(text::QUAKE_OPEN_HINT).clicked() {
        out.push(QuakeCommand::Show(true).into());
    }
    if ui.button(text::ANGLES_OPEN).on_hover_text(text::ANGLES_OPEN_HINT).clicked() {
        out.push(AngleCommand::Show(true).into());
    }
}

/// Another kind keeps the angle, as `--set motion.kind` does.
fn kind(ui: &mut Ui, place: Place<'_>, motion: &mut Motion) -> Option<Change> {
    let mut kind = match motion {
        Motion::None => Kind::Still,
        Motion::Sine(_) => Kind::Sine,
        Motion::Record(_) => Kind::Record,
        Motion::Synthetic(_) => Kind::Synthetic,
        Motion::Sweep(_) => Kind::Sweep,
    };
    let change = choice_line(ui, place, Named { key: "kind", label: text::GROUND.as_str() }, &mut kind, &kinds())?;
    let angle_deg = motion.angle_deg();
    *motion = match kind {
        Kind::Still => Motion::None,
        Kind::Sine => Motion::Sine(SineMotion { angle_deg, ..shaken() }),
        Kind::Record => Motion::Record(RecordMotion { angle_deg, ..silence() }),
        Kind::Synthetic => Motion::Synthetic(SyntheticMotion { angle_deg, ..SyntheticMotion::default() }),
        Kind::Sweep => Motion::Sweep(SweepMotion { angle_deg, ..SweepMotion::default() }),
    };
    Some(change)
}

/// The paper's: 0.4 g at 2.6 Hz.
fn shaken() -> SineMotion {
    SineMotion {
        amplitude_g: Some(0.4),
        amplitude: None,
        frequency_hz: 2.6,
        phase_deg: 0.0,
        angle_deg: 0.0,
        vertical_amplitude_g: None,
        vertical_amplitude: None,
        vertical_phase_deg: None,
    }
}

/// A record in which nothing happens, until one is chosen.
fn silence() -> RecordMotion {
    let (samples, dt) = (Some(vec![0.0, 0.0]), Some(0.01));
    RecordMotion { samples, dt, ..RecordMotion::default() }
}

fn still(ui: &mut Ui, motion: &mut Motion) -> Option<Change> {
    if !ui.button(text::SHAKE).clicked() {
        return None;
    }
    *motion = Motion::Sine(shaken());
    CLICK
}

fn sine_rows(ui: &mut Ui, look: &Look<'_>, sine: &mut SineMotion) -> Option<Change> {
    let mut metric = sine.amplitude.is_some();
    let moved = sliders(ui, look, sine, &VERTICAL).or(vertical_rows(ui, look, sine, metric));
    let said = choice_line(
        ui,
        look.place,
        Named { key: "amplitude_m_s2", label: text::AMPLITUDE_IN.as_str() },
        &mut metric,
        &UNITS,
    );
    if said.is_some() {
        let a = sine.amplitude_si();
        let said = |a: f64| if metric { (Some(a), None) } else { (None, Some(a / STANDARD_GRAVITY)) };
        (sine.amplitude, sine.amplitude_g) = said(a);
        if sine.vertical_si() != 0.0 {
            (sine.vertical_amplitude, sine.vertical_amplitude_g) = said(sine.vertical_si());
        }
    }
    moved.or(said)
}

/// The vertical share, in the unit of the other; none in plan.
fn vertical_rows(ui: &mut Ui, look: &Look<'_>, sine: &mut SineMotion, metric: bool) -> Option<Change> {
    let phase = sine.phase_deg;
    let otherwise = move |key: &Key| if key.name == "vertical_phase_deg" { phase } else { 0.0 };
    let look = Look { without: Without::Reckoned(&otherwise), ..*look };
    let other = if metric { "vertical_amplitude_g" } else { "vertical_amplitude_m_s2" };
    sliders(ui, &look, sine, &["amplitude_g", "amplitude_m_s2", "frequency_hz", "phase_deg", "angle_deg", other])
}

fn record_rows(
    ui: &mut Ui,
    look: &Look<'_>,
    (ground, record): (GroundId, &mut RecordMotion),
    out: &mut Vec<Command>,
) -> Option<Change> {
    if !record.components.is_empty() {
        let change = components::show(ui, look, (ground, record), out);
        let scale = slider_at(ui, look, "scale", &mut record.scale);
        return change.or(scale).or(record_of::processing(ui, look, record));
    }
    file_row(ui, look.place, (ground, record), out);
    about(ui, record);
    record_of::read(ui, record);
    let channel = record_of::channel(ui, look.place, record);
    let kept = channel.or(kept_rows(ui, look, record));
    record_of::beside(ui, look.place, (ground, record), out);
    if act(ui, look.place, "component", text::ADD_COMPONENT.as_str()) {
        components::add(record);
        out.push(FileCommand::Shake(ground, Box::new(record.clone())).into());
    }
    let kept = kept.or(record_of::processing(ui, look, record));
    let scale = slider_at(ui, look, "scale", &mut record.scale);
    let vertical = slider_at(ui, look, "vertical_scale", &mut record.vertical_scale);
    kept.or(scale).or(slider_at(ui, look, "angle_deg", &mut record.angle_deg)).or(vertical)
}

/// The record's file: chosen, or typed.
fn file_row(ui: &mut Ui, place: Place<'_>, (ground, record): (GroundId, &RecordMotion), out: &mut Vec<Command>) {
    let file = record.file.clone().unwrap_or_default();
    ui.horizontal(|ui| {
        let name = ui.label(text::RECORD_FILE);
        let draft_id = egui::Id::unique(("record file draft", ground));
        let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(|| file.clone());
        let wide = (ui.available_width() - 74.0).max(40.0);
        let edit = TextEdit::singleline(&mut draft).hint_text(text::RECORD_IN_SCENE).desired_width(wide);
        let response = ui.add(edit).labelled_by(name.id);
        let response = tag(ui, &response, place, Named { key: "file", label: text::RECORD_FILE.as_str() });
        if response.has_focus() {
            ui.data_mut(|d| d.insert_temp(draft_id, draft));
        } else {
            ui.data_mut(|d| d.remove::<String>(draft_id));
            if response.lost_focus() && draft != file && !draft.trim().is_empty() {
                out.push(FileCommand::Record(ground, draft.trim().into()).into());
            }
        }
        if ui.button(text::CHOOSE).on_hover_text(formats_in_words()).clicked() {
            out.push(FileCommand::Ask(Wish::Record(ground)).into());
        }
    });
    if let Some(complaint) = place.complaint("file") {
        complain(ui, &complaint);
    }
}

/// How many samples, how long, how strong.
fn about(ui: &mut Ui, record: &RecordMotion) {
    let Some((dt, samples)) = record.series() else { return };
    let peak = samples.iter().fold(0.0_f64, |most, a| most.max(a.abs())) * record.scale.abs();
    let words = text::record(samples.len(), dt, peak);
    ui.add(egui::Label::new(RichText::new(words).weak().small()).wrap());
}

/// Samples that the scene keeps itself, or a way to have it keep them.
fn kept_rows(ui: &mut Ui, look: &Look<'_>, record: &mut RecordMotion) -> Option<Change> {
    let Some(list) = record.samples.clone() else {
        record.series()?;
        let keep = ui.button(text::KEEP_RECORD).on_hover_text(text::KEEP_RECORD_HINT).clicked();
        return if keep && record.keep_samples() { CLICK } else { None };
    };
    let mut dt = record.dt.unwrap_or(0.01);
    let interval = slider_at(ui, look, "dt_s", &mut dt);
    if interval.is_some() {
        record.dt = Some(dt);
    }
    let typed = egui::CollapsingHeader::new(text::SAMPLES_FOLD)
        .id_salt(text::SAMPLES_FOLD.key())
        .default_open(false)
        .show_unindented(ui, |ui| samples::show(ui, look.place, text::SAMPLES.as_str(), &list));
    if let Some(samples) = typed.body_returned.flatten() {
        record.samples = Some(samples);
        return CLICK;
    }
    interval
}
