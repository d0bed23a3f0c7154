//! Soil behind an abutment, and the backwall that is pushed into it.

use egui::Ui;

use super::rows::{grid, note};
use crate::app::field::{CLICK, Change, Form, Look, Place, Without, act, rows};
use crate::app::text;
use crate::app::unit::Size;
use crate::scene::keys::Key;
use crate::scene::{Abutment, Backfill};

/// Shows the soil of an abutment, or the way to put some there.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, place: Place<'_>, size: Size, a: &mut Abutment) -> Option<Change> {
    let reckoned = |key: &Key| number(form, a, key.name);
    let Some(mut backfill) = a.backfill else {
        ui.label(text::BACKFILL_NONE);
        if !act(ui, place, "backfill", text::BACKFILL_ADD.as_str()) {
            return None;
        }
        a.backfill = Some(Backfill::default());
        return CLICK;
    };
    let table = format!("{}.backfill", place.table);
    let look = Look { without: Without::Reckoned(&reckoned), ..form.look_of(&table, size) };
    let change = grid(ui, "backfill", |ui| {
        let change = rows(ui, &look, &mut backfill, &[]);
        note(ui, text::BACKFILL_ASSUMED.as_str());
        change
    });
    a.backfill = Some(backfill);
    if act(ui, place, "backfill", text::BACKFILL_REMOVE.as_str()) {
        a.backfill = None;
        return CLICK;
    }
    change
}

/// The number in force where a key is left out.
fn number(form: Form<'_>, abutment: &Abutment, key: &str) -> f64 {
    let girder = form.scene.girders.iter().find(|girder| girder.name == abutment.faces);
    let Some((girder, soil)) = girder.zip(abutment.soil(form.scene)) else { return 0.0 };
    match key {
        "height_m" => girder.thickness,
        // A fuse to begin with: as strong as the soil, as stiff.
        "stiffness_n_per_m" | "fuse_stiffness_n_per_m" => soil.stiffness,
        "ultimate_n" | "fuse_force_n" => soil.ultimate,
        "failure_ratio" => soil.failure_ratio,
        "failing_push_m" => soil.limit,
        "unloading_stiffness_n_per_m" => soil.unloading,
        "wall_mass_kg" => soil.mass,
        "base_friction" => soil.base.map_or(0.0, |[force, _]| force / (soil.mass * form.scene.gravity)),
        "base_displacement_m" => soil.base.map_or(0.0, |[_, displacement]| displacement),
        _ => 0.0,
    }
}
