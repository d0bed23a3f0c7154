//! Contents of a record, its channel in use, and the processing of its samples.

use egui::{CollapsingHeader, Grid, Label, RichText, Ui};

use crate::app::command::{Command, FileCommand};
use crate::app::field::{Change, Look, Named, Place, Without, choice, choice_line, rows, switched};
use crate::app::text;
use crate::app::unit::SECONDS;
use crate::scene::keys::{Fallback, Key};
use crate::scene::{GroundId, RecordMotion, RecordUnit};

/// Units of files.
pub(super) fn units() -> [(Option<RecordUnit>, &'static str); 4] {
    [
        (None, text::AS_FILE_STATES.as_str()),
        (Some(RecordUnit::G), "g"),
        (Some(RecordUnit::Gal), "gal"),
        (Some(RecordUnit::MetrePerSecond2), "m/s²"),
    ]
}

/// Contents: format, channel, unit, processing of the file's numbers.
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
    choice_line(ui, place, Named { key: "channel", label: text::CHANNEL.as_str() }, &mut record.channel, &options)
}

/// Unit and interval stated beside a file that leaves them out. It is then read anew.
pub(super) fn beside(
    ui: &mut Ui,
    place: Place<'_>,
    (ground, record): (GroundId, &RecordMotion),
    out: &mut Vec<Command>,
) {
    if record.file.is_none() {
        return;
    }
    let mut new = record.clone();
    let grid = Grid::new("beside").num_columns(2).spacing([8.0, 3.0]);
    let changed = grid.show(ui, |ui| {
        let unit = choice(ui, place, Named { key: "unit", label: text::RECORD_UNIT.as_str() }, &mut new.unit, &units());
        unit.or(switched(
            ui,
            place,
            Named { key: "dt_s", label: text::INTERVAL.as_str() },
            (&mut new.dt, 0.01),
            SECONDS,
        ))
    });
    if changed.inner.is_some() {
        out.push(FileCommand::Shake(ground, Box::new(new)).into());
    }
}

/// Every key of `[motion.processing]`, folded away.
pub(super) fn processing(ui: &mut Ui, look: &Look<'_>, record: &mut RecordMotion) -> Option<Change> {
    let table = format!("{}.processing", look.place.table);
    let place = Place { table: &table, ..look.place };
    let length = record.series().map_or(1.0, |(dt, samples)| dt * (samples.len().max(1) - 1) as f64);
    let first = move |key: &Key| match (key.name, key.fallback) {
        ("to_s", _) => length,
        ("peak_g", _) => 0.4,
        (_, Fallback::Number(number)) => number,
        _ => 0.0,
    };
    let look = Look { place, without: Without::Off(&first), ..*look };
    let folded = CollapsingHeader::new(text::PROCESSING_FOLD)
        .id_salt(text::PROCESSING_FOLD.key())
        .default_open(false)
        .show_unindented(ui, |ui| {
            let grid = Grid::new("processing").num_columns(2).spacing([8.0, 3.0]);
            grid.show(ui, |ui| rows(ui, &look, &mut record.processing, &[])).inner
        });
    folded.body_returned.flatten()
}

/// A quiet line.
pub(super) fn weak(ui: &mut Ui, words: &str) {
    ui.add(Label::new(RichText::new(words).weak().small()).wrap());
}
