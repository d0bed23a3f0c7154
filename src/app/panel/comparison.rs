//! Runs that are kept to compare with: up to four "before"s, seen as ghosts, as thin lines, and in a table.

use egui::{Grid, RichText, Ui};
use toml::Value;

use crate::app::command::{Command, CompareCommand};
use crate::app::run::answer::Answer;
use crate::app::run::comparison::Pin;
use crate::app::run::spot::Spot;
use crate::app::style::theme::PINS;
use crate::app::text;
use crate::app::unit::{Size, unit_of};
use crate::scene::difference::Difference;
use crate::scene::shown::shown;
use crate::scene::{DeviceKind, Scene};

/// Shows what is kept, and how the run that is shown, `now`, differs from each.
pub(in crate::app) fn show(
    ui: &mut Ui,
    (pins, mut differences): (&[Pin], bool),
    now: Option<&Answer>,
    out: &mut Vec<Command>,
) {
    ui.horizontal(|ui| {
        let fits = now.is_some();
        if ui.add_enabled(fits, egui::Button::new(text::PIN_THIS)).on_hover_text(text::PIN_HINT).clicked() {
            out.push(CompareCommand::Pin.into());
        }
        if !pins.is_empty() && ui.button(text::UNPIN_ALL).clicked() {
            out.push(CompareCommand::UnpinAll.into());
        }
    });
    if pins.is_empty() {
        ui.add(egui::Label::new(RichText::new(text::NO_PINS).weak().small()).wrap());
        return;
    }
    for (i, pin) in pins.iter().enumerate() {
        ui.horizontal(|ui| {
            let (rect, _) = ui.allocate_exact_size(egui::vec2(14.0, 14.0), egui::Sense::hover());
            ui.painter().rect_filled(rect.shrink(2.0), 2.0, PINS[pin.color]);
            let gone = ui.small_button(text::unpin(i + 1)).clicked();
            // By the number that plots and the table give it.
            ui.add(egui::Label::new(format!("{} {}: {}", text::PIN, i + 1, pin.name)).truncate());
            if gone {
                out.push(CompareCommand::Unpin(i).into());
            }
        });
        if let Some(now) = now {
            differences_of(ui, pin, now);
        }
    }
    if ui.checkbox(&mut differences, text::DIFFERENCES).on_hover_text(text::DIFFERENCES_HINT).changed() {
        out.push(CompareCommand::Differences(differences).into());
    }
    table(ui, pins, now, out);
}

/// Keys that are named under a pin; the others stand in its hint.
const MOST_NAMED: usize = 2;

/// Where the scene of a run that is kept differs from that of the run shown: its own values.
fn differences_of(ui: &mut Ui, pin: &Pin, now: &Answer) {
    let found = pin.answer.values().differences(now.values());
    if found.is_empty() {
        return;
    }
    let words: Vec<String> = found.iter().map(|difference| own_value(difference, pin.answer.history.scene())).collect();
    let first = words[..words.len().min(MOST_NAMED)].join(", ");
    let line = if words.len() > MOST_NAMED { text::and_more(&first, words.len() - MOST_NAMED) } else { first };
    let hint = format!("{}\n{}", text::PIN_DIFFERS_HINT, words.join("\n"));
    ui.add(egui::Label::new(RichText::new(line).weak().small()).wrap()).on_hover_text(hint);
}

/// A key and what the first of two scenes has there.
fn own_value(difference: &Difference<'_>, scene: &Scene) -> String {
    let number = |value: f64| unit_of(difference.place, value, Size::of_scene(scene)).words(value);
    let value = |value: &Value| match value {
        Value::Float(value) => number(*value),
        #[expect(clippy::cast_precision_loss, reason = "a key's whole number is far below 2⁵³")]
        Value::Integer(value) => number(*value as f64),
        Value::String(words) => shown(words, MOST_LETTERS),
        other => shown(&other.to_string(), MOST_LETTERS),
    };
    let own = difference.values[0].map_or_else(|| NONE.to_owned(), value);
    text::pin_differs(&text::title_of(difference.place), &own)
}

/// Letters of a value that is a list or a name: what the panel has room for.
const MOST_LETTERS: usize = 40;

/// Where something is seen in a run.
type SeenAt = dyn Fn(&Answer) -> Option<Spot>;

/// A number of every run.
struct Row {
    name: String,
    /// How it is written of a run.
    words: Box<dyn Fn(&Answer) -> String>,
    /// Where it is seen in a run; asked for by a click alone. `None` of a number of the whole run.
    there: Option<Box<SeenAt>>,
}

impl Row {
    fn new(name: &str, words: impl Fn(&Answer) -> String + 'static) -> Self {
        Self { name: name.to_owned(), words: Box::new(words), there: None }
    }

    fn seen(self, there: impl Fn(&Answer) -> Option<Spot> + 'static) -> Self {
        Self { there: Some(Box::new(there)), ..self }
    }
}

/// Most devices that have a row.
const MOST_DEVICES: usize = 4;

/// Text in place of a number that a run has not.
const NONE: &str = "–";

/// The numbers of these runs, of which the first is shown.
fn rows(runs: &[&Answer]) -> Vec<Row> {
    let mut rows = vec![
        Row::new(&text::MOVES, |a| text::length(a.summary.max_displacement)).seen(|a| Spot::farthest(&a.history)),
        Row::new(&text::TURNS, |a| format!("{}°", text::short(a.summary.max_rotation.to_degrees())))
            .seen(|a| Spot::most_turned(&a.history)),
    ];
    if runs.iter().any(|run| run.least_seat().is_some()) {
        let least = |a: &Answer| a.least_seat().map_or(NONE.to_owned(), |(_, least)| text::length(least.value));
        let there = |a: &Answer| a.least_seat().map(|(girder, least)| Spot::girder(girder, least.t));
        rows.push(Row::new(&text::LEAST_SEAT, least).seen(there));
    }
    rows.extend([
        Row::new(&text::PEAK, |a| text::force(a.summary.peak_total)).seen(|a| Spot::hardest(&a.history)),
        Row::new(&text::HITS, |a| a.summary.hits.to_string()).seen(|a| Spot::first_touch(&a.history)),
        Row::new(&text::LOST, |a| text::energy(a.lost())),
    ]);
    rows.extend(devices(runs).into_iter().map(|name| {
        let [of, at] = [name.to_owned(), name.to_owned()];
        let words = move |a: &Answer| a.device(&of).map_or(NONE.to_owned(), |reading| text::force(reading.force.value));
        let there = move |a: &Answer| Spot::device(&a.history, a.device(&at)?);
        Row::new(&text::force_of(name), words).seen(there)
    }));
    rows
}

/// Names of the devices of these runs that have a row, those first in which the scenes of two of them differ.
fn devices<'a>(runs: &[&'a Answer]) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for name in runs.iter().flat_map(|run| run.device_names()) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    if names.len() > MOST_DEVICES {
        let others = runs.iter().skip(1).flat_map(|run| run.values().differences(runs[0].values()));
        let places: Vec<&str> = others.map(|difference| difference.place).collect();
        names.sort_by_cached_key(|name| {
            let mut tables = DeviceKind::ALL.iter().map(|kind| format!("{}.{name}.", kind.label()));
            !tables.any(|table| places.iter().any(|place| place.starts_with(&table)))
        });
        names.truncate(MOST_DEVICES);
    }
    names
}

/// A row for each number, a column for each run, the run that is shown first: its numbers lead to where they are seen.
fn table(ui: &mut Ui, pins: &[Pin], now: Option<&Answer>, out: &mut Vec<Command>) {
    let runs: Vec<(String, &Answer)> = now
        .map(|answer| (text::NOW.to_string(), answer))
        .into_iter()
        .chain(pins.iter().enumerate().map(|(i, p)| (format!("{}", i + 1), &*p.answer)))
        .collect();
    let answers: Vec<&Answer> = runs.iter().map(|(_, answer)| *answer).collect();
    Grid::new("pins").striped(true).spacing([8.0, 2.0]).show(ui, |ui| {
        ui.label("");
        for (name, _) in &runs {
            ui.label(RichText::new(name).strong());
        }
        ui.end_row();
        for Row { name, words, there } in rows(&answers) {
            ui.label(RichText::new(name).weak());
            for answer in &answers {
                let shown = now.is_some_and(|now| std::ptr::eq(now, *answer));
                let words = words(answer);
                let Some(there) = there.as_ref().filter(|_| shown && words != NONE) else {
                    ui.label(words);
                    continue;
                };
                let button = egui::Button::new(RichText::new(words).underline()).frame(false);
                if ui.add(button).on_hover_text(text::GO_THERE).clicked()
                    && let Some(spot) = there(answer)
                {
                    spot.go(out);
                }
            }
            ui.end_row();
        }
    });
    let Some(now) = now else { return };
    for (i, pin) in pins.iter().enumerate() {
        let apart = now.apart_from(&pin.answer);
        let words = text::apart_from(i + 1, apart.place, apart.turn);
        ui.add(egui::Label::new(RichText::new(words).weak().small()).wrap());
    }
}
