//! What was read of a record, which channel of it shakes, and what is done to its samples.

use egui::{CollapsingHeader, Grid, Label, RichText, Ui};

use crate::app::field::{Change, Look, Place, Without, choice_line, rows};
use crate::app::text;
use crate::scene::keys::{Fallback, Key};
use crate::scene::{Heading, RecordMotion};

/// What was read: format, channel, unit, what was done to the file's numbers.
pub(super) fn read(ui: &mut Ui, record: &RecordMotion) {
    let Some(loaded) = &record.loaded else { return };
    let Ok(channel) = loaded.channel(record.channel) else { return };
    weak(ui, &text::record_read(loaded.format, &channel.name, channel.unit.label(), &channel.done));
}

/// The channel, where the file has several.
pub(super) fn channel(ui: &mut Ui, place: Place<'_>, record: &mut RecordMotion) -> Option<Change> {
    let loaded = record.loaded.clone()?;
    if loaded.channels.len() < 2 {
        return None;
    }
    let names: Vec<String> = (1..).zip(&loaded.channels).map(|(n, channel)| format!("{n} {}", channel.name)).collect();
    let options: Vec<(Option<usize>, &str)> = (1..).map(Some).zip(names.iter().map(String::as_str)).collect();
    choice_line(ui, place, ("channel", text::CHANNEL), &mut record.channel, &options)
}

/// Components, a line each; they are stated in the scene's file.
pub(super) fn components(ui: &mut Ui, record: &RecordMotion) {
    for n in 0..record.components.len() {
        let (dt, samples) = record.component_series(n).unwrap_or((0.0, &[]));
        let peak = samples.iter().fold(0.0_f64, |most, a| most.max(a.abs())) * record.components[n].scale.abs();
        let heading = match record.heading(n) {
            Some(Heading::Up) => text::UPWARDS.to_owned(),
            Some(Heading::InPlan(angle)) => text::from_x(angle),
            None => text::NO_DIRECTION.to_owned(),
        };
        weak(ui, &format!("{heading}: {}", text::record(samples.len(), dt, peak)));
    }
}

/// Every key of `[motion.processing]`, folded away.
pub(super) fn processing(ui: &mut Ui, look: &Look<'_>, record: &mut RecordMotion) -> Option<Change> {
    let place = Place { table: "motion.processing", ..look.place };
    let length = record.series().map_or(1.0, |(dt, samples)| dt * (samples.len().max(1) - 1) as f64);
    let first = move |key: &Key| match (key.name, key.fallback) {
        ("to_s", _) => length,
        ("peak_g", _) => 0.4,
        (_, Fallback::Number(number)) => number,
        _ => 0.0,
    };
    let look = Look { place, without: Without::Off(&first), ..*look };
    let folded = CollapsingHeader::new(text::PROCESSING_FOLD).default_open(false).show_unindented(ui, |ui| {
        let grid = Grid::new("processing").num_columns(2).spacing([8.0, 3.0]);
        grid.show(ui, |ui| rows(ui, &look, &mut record.processing, &[])).inner
    });
    folded.body_returned.flatten()
}

fn weak(ui: &mut Ui, words: &str) {
    ui.add(Label::new(RichText::new(words).weak().small()).wrap());
}
