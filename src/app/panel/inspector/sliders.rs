//! Fields of bearings for friction and free travel.

use egui::Ui;

use crate::app::field::{Change, Look, Named, Place, Without, rows, switched};
use crate::app::text;
use crate::app::unit::{Size, Unit};
use crate::scene::keys::{BEARINGS, Key, find};
use crate::scene::{Bearing, Kind};

/// Friction \[–\], radius, displacement at which the friction is there, load \[N\] and free travel \[m\] to begin with.
const FIRST: [(&str, f64); 5] =
    [("friction", 0.05), ("radius_m", 1.0), ("slider_displacement_m", 5e-4), ("load_n", 1.0), ("travel_m", 0.1)];
/// Sizes by which lengths are shown in metres and forces in kilonewtons.
const SIZE: Size = Size { length: 30.0, mass: 3e5 };

fn first(key: &Key) -> f64 {
    FIRST.iter().find(|(name, _)| *name == key.name).map_or(0.0, |(_, number)| *number)
}

/// Free travel of equal bearings.
pub(super) fn travel(ui: &mut Ui, place: Place<'_>, unit: Unit, travel: &mut Option<f64>) -> Option<Change> {
    let key = find(BEARINGS, "travel_m")?;
    switched(ui, place, Named { key: "bearings.travel_m", label: text::field(key) }, (travel, first(key)), unit)
}

/// Rows of a single bearing for the keys that have none elsewhere.
pub(super) fn rows_of(ui: &mut Ui, place: Place<'_>, kind: Kind, n: usize, b: &mut Bearing) -> Option<Change> {
    const ELSEWHERE: &[&str] = &[
        "at_m",
        "stiffness_n_per_m",
        "damping_n_s_per_m",
        "yield_force_n",
        "yield_displacement_m",
        "yields_per_axis",
        "height_m",
        "on",
    ];
    let table = format!("{}.bearings[{n}]", place.table);
    let look = Look { without: Without::Off(&first), ..Look::new(Place { table: &table, ..place }, kind, SIZE) };
    rows(ui, &look, b, ELSEWHERE)
}
