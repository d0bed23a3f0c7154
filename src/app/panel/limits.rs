//! Limits that the user sets, which of them the run passes, and when.

use egui::{Button, RichText, Ui};

use crate::app::bench::Workbench;
use crate::app::command::{Command, EditCommand, TimeCommand};
use crate::app::field::{Change, Place, number, tag};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::unit::{DEGREES, Unit, force_unit, length_unit};
use crate::scene::Limits;
use crate::scene::edit::Edit;

/// Shows the limits and the flags.
pub(in crate::app) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let scene = bench.scene();
    let mut new = scene.limits;
    let place = Place { problems: bench.problems(), table: "limits" };
    let (length, mass) = scene.girders.first().map_or((1.0, 1.0), |g| (g.length, g.mass));
    let summary = bench.answer().map(|a| &a.summary);
    let peak = summary.map_or(1.0, |s| s.peak_force.max(1.0));
    let turned = summary.map_or(1.0, |s| s.max_rotation.to_degrees());
    let mut changes = Vec::new();
    egui::Grid::new("limits").num_columns(2).show(ui, |ui| {
        changes = vec![
            row(
                ui,
                place,
                ("rotation_deg", text::LIMIT_ROTATION),
                (&mut new.rotation_deg, two_digits(turned)),
                DEGREES,
            ),
            row(ui, place, ("drift_m", text::LIMIT_DRIFT), (&mut new.drift, length * 0.05), length_unit(length)),
            row(
                ui,
                place,
                ("remaining_seat_m", text::LIMIT_SEAT),
                (&mut new.remaining_seat, length * 0.01),
                length_unit(length),
            ),
            row(ui, place, ("force_n", text::LIMIT_FORCE), (&mut new.force, two_digits(peak)), force_unit(mass)),
        ];
    });
    if let Some(change) = changes.into_iter().flatten().next() {
        out.push(EditCommand::Change { edit: Edit::Limits(new), gesture: change.gesture }.into());
    }
    flags(ui, bench, out);
}

/// To two digits, downwards: a limit that the run passes is the one worth looking at first.
fn two_digits(value: f64) -> f64 {
    let step = 10f64.powf(value.abs().max(1e-6).log10().floor() - 1.0);
    (value / step).floor() * step
}

fn row(
    ui: &mut Ui,
    place: Place<'_>,
    (key, label): (&str, &str),
    (limit, first): (&mut Option<f64>, f64),
    unit: Unit,
) -> Option<Change> {
    let mut on = limit.is_some();
    let response = ui.checkbox(&mut on, label);
    let switched = tag(ui, &response, place, (key, label)).changed();
    if switched {
        *limit = on.then_some(first);
    }
    ui.end_row();
    let moved = limit.as_mut().and_then(|value| number(ui, place, (key, &format!("{label} at")), value, unit));
    moved.or(switched.then_some(Change { gesture: None }))
}

/// Every limit that was passed, with a button that goes there.
fn flags(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let watched = bench.scene().limits != Limits::default();
    let Some(answer) = bench.answer().filter(|_| watched && !bench.is_stale()) else { return };
    let passed = answer.passed();
    if passed.is_empty() {
        ui.label(RichText::new(text::LIMITS_KEPT).weak());
    }
    for flag in passed {
        let words = RichText::new(text::passed(flag)).color(Palette::of(ui).problem);
        if ui.add(Button::new(words).wrap()).clicked() {
            out.push(TimeCommand::Seek(flag.t).into());
        }
    }
}
