//! A pier: its mass, how stiff it is and from what, its yield, its size, and what a run did to it.

use egui::Ui;

use super::rows::{grid, note, push, section, warning};
use crate::app::command::Command;
use crate::app::field::{Change, Form, Look, Named, Place, Without, choice, number, rows, switched};
use crate::app::panel::{grounds, name_field};
use crate::app::run::answer::Answer;
use crate::app::unit::{Size, trimmed, unit_of};
use crate::app::{edits, text};
use crate::language::Text;
use crate::scene::keys::Key;
use crate::scene::{ColumnTop, PerDirection, Pier, ResolvedPier, Scene};
use crate::view::Target;

/// Input of a pier's stiffness.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Way {
    #[default]
    Stiffness,
    Frequency,
    RoundColumns,
    RectangularColumns,
}

impl Way {
    fn of(pier: &Pier) -> Self {
        match (pier.column, pier.frequency) {
            (Some(PerDirection::Both(_)), _) => Self::RoundColumns,
            (Some(PerDirection::Each(_)), _) => Self::RectangularColumns,
            (None, Some(_)) => Self::Frequency,
            (None, None) => Self::Stiffness,
        }
    }

    /// The key that says it.
    fn key(self) -> &'static str {
        match self {
            Self::Stiffness => "stiffness_n_per_m",
            Self::Frequency => "frequency_hz",
            Self::RoundColumns | Self::RectangularColumns => "column_m",
        }
    }
}

/// Shows a pier.
pub(super) fn show(
    ui: &mut Ui,
    form: Form<'_>,
    (i, pier): (usize, &Pier),
    answer: Option<&Answer>,
    out: &mut Vec<Command>,
) {
    let (mut new, scene, resolved) = (pier.clone(), form.scene, form.scene.pier(i));
    let table = format!("pier.{}", pier.name);
    let place = form.place(&table);
    let size = scene.girders.first().map_or(Size::of_scene(scene), Size::of);
    let ground = scene.moving_supports().and_then(|supports| supports.of_pier(i));
    let reckoned = |key: &Key| match key.name {
        "delay_s" => ground.map_or(0.0, |ground| ground.delay),
        other => number_in_force(other, &resolved),
    };
    let look = Look { without: Without::Off(&reckoned), ..form.look_of(&table, size) };
    let first = grid(ui, "pier", |ui| {
        name_field::show(ui, place, Target::Pier(i), &pier.name, out);
        let way = way_rows(ui, place, size, &mut new, &resolved);
        let columns: &[&str] = if new.column.is_some() { &[] } else { &["young_modulus_pa", "column_top"] };
        let yields: &[&str] = if new.yield_force.is_some() { &[] } else { &["post_yield_ratio"] };
        let turns: &[&str] = if new.turn_stiffness.is_some() { &[] } else { &["turn_inertia_kg_m2"] };
        way.or(rows(ui, &look, &mut new, &[&["name"], columns, yields, turns].concat()))
    });
    let more = section(ui, (text::PIER_MORE.key(), &text::PIER_MORE), false, |ui| {
        grid(ui, "pier more", |ui| more(ui, (place, scene), size, &mut new, &resolved))
    });
    let change = first.or(more.flatten());
    // What belongs to another key goes with it.
    if new.turn_stiffness.is_none() {
        new.turn_inertia = None;
    }
    if new.yield_force.is_none() {
        new.post_yield_ratio = None;
    }
    new.columns = new.columns.round();
    push(change, out, || edits::pier(i, new));
    grid(ui, "pier facts", |ui| facts(ui, scene, i, answer));
}

/// Number in force where it is left out.
fn number_in_force(key: &str, pier: &ResolvedPier) -> f64 {
    match key {
        "heading_deg" => pier.axes.x_axis.y.atan2(pier.axes.x_axis.x).to_degrees(),
        "young_modulus_pa" => 3e10,
        // To begin with, as stiff as the columns at both ends of the cap make it.
        "turn_stiffness_n_m_per_rad" => (0.25 * pier.stiffness[0] * pier.cap[1] * pier.cap[1]).max(1.0),
        "turn_inertia_kg_m2" => pier.inertia,
        "post_yield_ratio" => 0.05,
        "height_m" => pier.height,
        "motion_factor" => 1.0,
        _ => 0.0,
    }
}

/// Which of these ways its stiffness is given in, and the numbers of that way; another way begins with the same stiffness.
fn way_rows(ui: &mut Ui, place: Place<'_>, size: Size, pier: &mut Pier, resolved: &ResolvedPier) -> Option<Change> {
    let mut way = Way::of(pier);
    let options = [
        (Way::Stiffness, text::PIER_BY_STIFFNESS.as_str()),
        (Way::Frequency, text::PIER_BY_FREQUENCY.as_str()),
        (Way::RoundColumns, text::PIER_BY_ROUND_COLUMNS.as_str()),
        (Way::RectangularColumns, text::PIER_BY_RECTANGULAR_COLUMNS.as_str()),
    ];
    let chosen =
        choice(ui, place, Named { key: "stiffness_n_per_m", label: text::PIER_WAY.as_str() }, &mut way, &options);
    if chosen.is_some() {
        begin(pier, way, resolved);
        return chosen;
    }
    let (value, labels) = match way {
        Way::Stiffness => (&mut pier.stiffness, [text::PIER_K_ALONG, text::PIER_K_ACROSS]),
        Way::Frequency => (&mut pier.frequency, [text::PIER_F_ALONG, text::PIER_F_ACROSS]),
        Way::RoundColumns => {
            let Some(PerDirection::Both(diameter)) = &mut pier.column else { return None };
            let unit = unit_of(&place.path(way.key()), *diameter, size);
            return number(
                ui,
                place,
                Named { key: way.key(), label: text::PIER_COLUMN_DIAMETER.as_str() },
                diameter,
                unit,
            );
        }
        Way::RectangularColumns => (&mut pier.column, [text::PIER_COLUMN_ALONG, text::PIER_COLUMN_ACROSS]),
    };
    two(ui, place, (way.key(), labels.map(Text::as_str)), value.as_mut()?, size)
}

/// Another way to give the stiffness.
fn begin(pier: &mut Pier, way: Way, resolved: &ResolvedPier) {
    (pier.stiffness, pier.frequency, pier.column) = (None, None, None);
    (pier.modulus, pier.top) = (None, ColumnTop::Free);
    let hertz = |omega: f64| omega / std::f64::consts::TAU;
    let [along, across, _] = resolved.frequencies();
    match way {
        Way::Stiffness => pier.stiffness = Some(PerDirection::Each(resolved.stiffness)),
        Way::Frequency => pier.frequency = Some(PerDirection::Each([along, across].map(hertz))),
        Way::RoundColumns | Way::RectangularColumns => {
            let sides = resolved.column.xy();
            let round = PerDirection::Both(sides[0]);
            pier.column = Some(if way == Way::RoundColumns { round } else { PerDirection::Each(sides) });
            pier.height = Some(resolved.height);
        }
    }
}

/// One number for both directions, or one each.
fn two(
    ui: &mut Ui,
    place: Place<'_>,
    (key, labels): (&str, [&str; 2]),
    value: &mut PerDirection,
    size: Size,
) -> Option<Change> {
    let mut each = value.xy();
    let mut change = None;
    for (number_of, label) in each.iter_mut().zip(labels) {
        let unit = unit_of(&place.path(key), *number_of, size);
        change = number(ui, place, Named { key, label }, number_of, unit).or(change);
    }
    if change.is_some() {
        *value = match *value {
            PerDirection::Both(_) if each[0] == each[1] => PerDirection::Both(each[0]),
            _ => PerDirection::Each(each),
        };
    }
    change
}

/// Damping, yield, place and cap.
fn more(
    ui: &mut Ui,
    (place, scene): (Place<'_>, &Scene),
    size: Size,
    pier: &mut Pier,
    resolved: &ResolvedPier,
) -> Option<Change> {
    let mut change = None;
    let mut ratio = pier.damping_ratio.unwrap_or(PerDirection::Both(0.05));
    let ground = grounds::row(ui, place, scene, &mut pier.ground);
    change = ground.or(change);
    let damping =
        two(ui, place, ("damping_ratio", [text::DAMPING_X.as_str(), text::DAMPING_Y.as_str()]), &mut ratio, size);
    if damping.is_some() {
        pier.damping_ratio = Some(ratio);
    }
    change = damping.or(change);
    let mut force = pier.yield_force.map(|force| force.xy()[0]);
    let first = 0.2 * resolved.mass * crate::scene::STANDARD_GRAVITY;
    let unit = unit_of(&place.path("yield_force_n"), first, size);
    if let Some(yields) =
        switched(ui, place, Named { key: "yield_force_n", label: text::PIER_YIELD.as_str() }, (&mut force, first), unit)
    {
        pier.yield_force = force.map(PerDirection::Both);
        change = Some(yields);
    }
    let unit = unit_of(&place.path("position_m"), 0.0, size);
    let mut at = pier.position.unwrap_or([resolved.top.x, resolved.top.y]);
    for (axis, label) in [text::PIER_X, text::PIER_Y].into_iter().enumerate() {
        if let Some(moved) = number(ui, place, Named { key: "position_m", label: &label }, &mut at[axis], unit) {
            (pier.position, change) = (Some(at), Some(moved));
        }
    }
    let mut cap = pier.cap.unwrap_or(resolved.cap);
    for (axis, label) in [text::PIER_CAP_ALONG, text::PIER_CAP_ACROSS, text::PIER_CAP_DEPTH].into_iter().enumerate() {
        if let Some(sized) = number(ui, place, Named { key: "cap_m", label: &label }, &mut cap[axis], unit) {
            (pier.cap, change) = (Some(cap), Some(sized));
        }
    }
    change
}

/// Periods, and what the run did to it.
fn facts(ui: &mut Ui, scene: &Scene, i: usize, answer: Option<&Answer>) {
    let [along, across, _] =
        scene.pier(i).frequencies().map(|omega| (1e3 * std::f64::consts::TAU / omega).round() / 1e3);
    note(ui, &format!("{} {} s, {} s", text::PIER_PERIODS, trimmed(along), trimmed(across)));
    let Some(reading) = answer.and_then(|answer| answer.pier(i)) else { return };
    let yielded = reading.yielded_at.map_or(String::new(), |t| {
        let ductility = reading.ductility_words().unwrap_or_default();
        format!(", {} {t:.2} s, {} {ductility}", text::PIER_YIELDS, text::PIER_DUCTILITY)
    });
    note(
        ui,
        &format!(
            "{} {:.1} mm ({:.2} s), {} {:.0} kN ({:.2} s){yielded}",
            text::PIER_DRIFT,
            1e3 * reading.drift,
            reading.drift_t,
            text::PIER_SHEAR,
            1e-3 * reading.shear,
            reading.shear_t
        ),
    );
    if let Some(words) = reading.second_order_counts() {
        warning(ui, &words);
    }
}
