//! Toggles for everything that the view draws over the bodies, and the scale of the force arrows.

use egui::{Slider, Ui};

use super::Workbench;
use super::command::Command;
use super::field::slider_row;
use super::text;
use crate::scene::Overlays;

/// Every layer, in the order of [`text::OVERLAYS`].
fn switches(overlays: &mut Overlays) -> [&mut bool; 13] {
    [
        &mut overlays.grid,
        &mut overlays.bearings,
        &mut overlays.gap,
        &mut overlays.contacts,
        &mut overlays.normal,
        &mut overlays.tangential,
        &mut overlays.resultant,
        &mut overlays.damping,
        &mut overlays.cones,
        &mut overlays.axes,
        &mut overlays.legend,
        &mut overlays.title,
        &mut overlays.names,
    ]
}

/// Shows the toggles in two columns, then the force scale.
pub(super) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let mut overlays = bench.overlays();
    let mut changed = false;
    egui::Grid::new("overlays").num_columns(2).min_col_width((ui.available_width() - 6.0) / 2.0).show(ui, |ui| {
        for (i, (on, label)) in switches(&mut overlays).into_iter().zip(text::OVERLAYS).enumerate() {
            changed |= ui.checkbox(on, label).changed();
            if i % 2 == 1 {
                ui.end_row();
            }
        }
    });
    if changed {
        out.push(Command::Overlays(overlays));
    }
    force_scale(ui, bench, out);
    super::views::exaggeration(ui, bench, out);
}

fn force_scale(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let automatic = bench.automatic_force_scale();
    let mut auto = bench.force_scale().is_none();
    if ui.checkbox(&mut auto, text::AUTO_SCALE).changed() {
        out.push(Command::ForceScale((!auto).then_some(automatic)));
    }
    let mut scale = bench.force_scale().unwrap_or(automatic);
    let words = format!("{}/m", text::force(scale));
    let slider = Slider::new(&mut scale, automatic / 50.0..=automatic * 50.0)
        .logarithmic(true)
        .clamping(egui::SliderClamping::Edits)
        .show_value(false);
    let moved = slider_row(ui, text::FORCE_SCALE.into(), slider, &words).changed();
    if moved {
        out.push(Command::ForceScale(Some(scale)));
    }
}
