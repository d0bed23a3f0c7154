//! The scene's main numbers as sliders: move one, and the whole history is computed anew.

use egui::{RichText, Ui};

use crate::app::bench::Workbench;
use crate::app::command::{Command, EditCommand};
use crate::app::field::{Change, Look, Place, slider_at, slider_between, sliders};
use crate::app::panel::{comparison, ground_motion, limits, models, overlays};
use crate::app::plot::user_plots;
use crate::app::unit::Size;
use crate::app::{edits, text};
use crate::scene::edit::Edit;
use crate::view::Target;

/// Shows the sliders, then the overlays.
pub(in crate::app) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    ui.label(RichText::new(text::WHAT_IF).strong());
    geometry(ui, bench, out);
    section(ui, text::MOTION_SECTION, |ui| motion(ui, bench, out));
    section(ui, text::CONTACT_SECTION, |ui| contact(ui, bench, out));
    section(ui, text::MODEL_SECTION, |ui| models::show(ui, bench, out));
    section(ui, text::LIMITS_SECTION, |ui| limits::show(ui, bench, out));
    section(ui, text::PLOTS_SECTION, |ui| user_plots::show(ui, &bench.plot_source(), out));
    section(ui, text::PINS_SECTION, |ui| {
        comparison::show(ui, bench.comparison.pins(), bench.runner.fresh_answer().map(|a| &**a), out);
    });
    section(ui, text::SHOW_SECTION, |ui| overlays::show(ui, bench, out));
}

fn section(ui: &mut Ui, title: &str, body: impl FnOnce(&mut Ui)) {
    egui::CollapsingHeader::new(RichText::new(title).strong()).default_open(true).show_unindented(ui, body);
}

fn push(out: &mut Vec<Command>, change: Option<Change>, edit: impl FnOnce() -> Edit) {
    if let Some(change) = change {
        out.push(EditCommand::Change { edit: edit(), gesture: change.gesture }.into());
    }
}

/// The girder whose skew the slider turns, or none: all of them.
fn chosen(bench: &Workbench) -> Option<usize> {
    match bench.selected() {
        Some(Target::Girder(i)) if i < bench.scene().girders.len() => Some(i),
        _ => None,
    }
}

fn geometry(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let scene = bench.scene();
    let one = chosen(bench);
    let Some(girder) = scene.girders.get(one.unwrap_or(0)) else { return };
    let table = format!("girder.{}", girder.name);
    let place = Place { problems: bench.problems(), table: &table };
    let mut skew = girder.skew_deg;
    let whose = if one.is_some() || scene.girders.len() == 1 { girder.name.as_str() } else { text::ALL_GIRDERS };
    ui.label(RichText::new(format!("{whose}: {}", text::us_skew(skew))).weak());
    let change = slider_at(ui, &Look::new(place, scene.kind, Size::of(girder)), "skew_deg", &mut skew);
    push(out, change, || edits::skew(scene, one, skew));
    if let Some(mut gap) = edits::gap_of(scene) {
        // Between girders alone the file has no such place: the key is that of a wall all the same.
        let wall = scene.abutments.first().map_or("-", |a| a.name.as_str());
        let table = format!("abutment.{wall}");
        let place = Place { problems: bench.problems(), table: &table };
        let look = Look::new(place, scene.kind, Size::of(girder));
        let change = slider_between(ui, &look, "gap_m", &mut gap, 0.0..=girder.length * 0.05);
        push(out, change, || edits::gap(scene, gap));
    }
}

fn contact(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let scene = bench.scene();
    let mut new = scene.contact.clone();
    let place = Place { problems: bench.problems(), table: "contact" };
    let look = Look::new(place, scene.kind, Size::of_scene(scene));
    // The rules that are rarely changed stand in the inspector alone.
    let change = sliders(ui, &look, &mut new, &["sharing", "tension", "between"]);
    push(out, change, || edits::contact(new));
}

fn motion(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let scene = bench.scene();
    ground_motion::show(ui, bench, out);
    let mut duration = scene.duration;
    let place = Place { problems: bench.problems(), table: "" };
    let change = slider_at(ui, &Look::new(place, scene.kind, Size::of_scene(scene)), "duration_s", &mut duration);
    push(out, change, || edits::duration(scene, duration));
}
