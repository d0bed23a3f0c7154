//! How a girder bends, or the way to let it.

use egui::Ui;

use super::rows::{grid, note};
use crate::app::field::{CLICK, Change, Form, Look, Place, Without, act, rows};
use crate::app::text;
use crate::app::unit::Size;
use crate::scene::keys::Key;
use crate::scene::{CONCRETE_DENSITY, Elastic, Girder, Rayleigh};

/// Shows the elastic numbers of a girder, or the way to give it some.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, place: Place<'_>, girder: &mut Girder) -> Option<Change> {
    let size = Size::of(girder);
    let Some(mut elastic) = girder.elastic else {
        ui.label(text::ELASTIC_NONE);
        if !act(ui, place, "elastic", text::ELASTIC_ADD.as_str()) {
            return None;
        }
        girder.elastic = Some(Elastic::of_density(CONCRETE_DENSITY));
        return CLICK;
    };
    let whole = girder.clone();
    let reckoned = move |key: &Key| number(&whole, &elastic, key.name);
    let table = format!("{}.elastic", place.table);
    let look = Look { without: Without::Reckoned(&reckoned), ..form.look_of(&table, size) };
    let change = grid(ui, "elastic", |ui| {
        let change = rows(ui, &look, &mut elastic, &[]);
        let damping = rayleigh(ui, form, (&table, size), &mut elastic);
        note(ui, text::ELASTIC_ASSUMED.as_str());
        change.or(damping)
    });
    girder.elastic = Some(elastic);
    if act(ui, place, "elastic", text::ELASTIC_REMOVE.as_str()) {
        girder.elastic = None;
        return CLICK;
    }
    change
}

/// Rayleigh's α and β; given, they stand in the place of the damping ratio.
fn rayleigh(ui: &mut Ui, form: Form<'_>, (table, size): (&str, Size), elastic: &mut Elastic) -> Option<Change> {
    let table = format!("{table}.rayleigh");
    let look = form.look_of(&table, size);
    let mut values = elastic.rayleigh.unwrap_or_default();
    let change = rows(ui, &look, &mut values, &[]);
    if change.is_some() {
        elastic.rayleigh = (values != Rayleigh::default()).then_some(values);
        elastic.damping_ratio = if elastic.rayleigh.is_some() { None } else { elastic.damping_ratio };
    }
    change
}

/// The number in force where a key is left out.
fn number(girder: &Girder, elastic: &Elastic, key: &str) -> f64 {
    let section = elastic.resolve(girder);
    match key {
        "area_m2" => section.area,
        "density_kg_m3" => girder.mass / (section.area * girder.length),
        "second_moment_m4" => section.second_moment,
        "second_moment_vertical_m4" => section.second_moment_vertical,
        "torsion_constant_m4" => section.torsion_constant,
        "damping_ratio" => section.damping.unwrap_or(0.0),
        // What a reader begins with where nothing is asked for.
        "modes" => 8.0,
        "shear_factor" => 5.0 / 6.0,
        "strength_pa" => 1e-3 * elastic.young_modulus,
        _ => 0.0,
    }
}
