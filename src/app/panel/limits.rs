//! Limits that the user sets, which of them the run passes, and when.

use egui::{Button, RichText, Ui};

use crate::app::command::{Command, EditCommand, TimeCommand};
use crate::app::field::{Form, Look, Without, rows};
use crate::app::run::runner::Runner;
use crate::app::run::spot::Spot;
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::unit::Size;
use crate::scene::edit::Edit;
use crate::scene::keys::Key;
use crate::scene::{Limits, Scene};
use crate::sim::Summary;
use crate::sim::readings::Passed;

/// Shows the limits and the flags.
pub(in crate::app) fn show(ui: &mut Ui, form: Form<'_>, runner: &Runner, out: &mut Vec<Command>) {
    let scene = form.scene;
    let mut new = scene.limits;
    let summary = runner.answer().map(|a| &a.summary);
    let first = |key: &Key| first_limit(key.name, scene, summary);
    let look = Look { without: Without::Off(&first), ..form.look("limits") };
    let change = egui::Grid::new("limits").num_columns(2).show(ui, |ui| rows(ui, &look, &mut new, &[])).inner;
    if let Some(change) = change {
        out.push(EditCommand::Change { edit: Edit::Limits(new), gesture: change.gesture }.into());
    }
    flags(ui, scene.limits, runner, out);
}

/// First value of a limit: a little below the run's value, or a part of a girder's length.
fn first_limit(key: &str, scene: &Scene, summary: Option<&Summary>) -> f64 {
    let length = Size::of_scene(scene).length;
    match key {
        "drift_m" => length * 0.05,
        "remaining_seat_m" | "bearing_displacement_m" | "pier_drift_m" => length * 0.01,
        "force_n" => two_digits(summary.map_or(1.0, |s| s.peak_force.max(1.0))),
        "total_force_n" => two_digits(summary.map_or(1.0, |s| s.peak_total.max(1.0))),
        "rotation_deg" => two_digits(summary.map_or(1.0, |s| s.max_rotation.to_degrees())),
        _ => 1.0,
    }
}

/// To two digits, downwards, so that the run exceeds the limit.
fn two_digits(value: f64) -> f64 {
    let step = 10f64.powf(value.abs().max(1e-6).log10().floor() - 1.0);
    (value / step).floor() * step
}

/// Every limit that was passed, with a button that goes there.
fn flags(ui: &mut Ui, limits: Limits, runner: &Runner, out: &mut Vec<Command>) {
    let Some(passed) = runner.passed(limits) else { return };
    if passed.is_empty() {
        ui.label(RichText::new(text::LIMITS_KEPT).weak());
    }
    for flag in passed {
        let words = RichText::new(text::passed(flag)).color(Palette::of(ui).problem);
        if ui.add(Button::new(words).wrap()).on_hover_text(text::GO_THERE).clicked() {
            go_to(runner, flag, out);
        }
    }
}

/// Goes to where a limit is passed.
pub(in crate::app) fn go_to(runner: &Runner, flag: &Passed, out: &mut Vec<Command>) {
    let spot = runner.fresh_answer().and_then(|answer| Spot::passed(&answer.history, flag));
    match spot {
        Some(spot) => spot.go(out),
        None => out.push(TimeCommand::Seek(flag.t).into()),
    }
}
