//! One number in a panel: its label, its unit, its complaint, and the hand on it.

use egui::{DragValue, Response, RichText, Slider, Ui};

use super::theme::Palette;
use super::units::{self, Dimension};
use crate::scene::SceneErrors;

/// How a number is shown: `shown = SI × factor`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Unit {
    /// Shown units per SI unit.
    pub factor: f64,
    /// Written after the number.
    pub suffix: &'static str,
    /// Change per point of dragging, shown units.
    pub speed: f64,
    /// What may be typed into it.
    pub dimension: Dimension,
}

impl Unit {
    const fn new(dimension: Dimension, factor: f64, suffix: &'static str, speed: f64) -> Self {
        Self { factor, suffix, speed, dimension }
    }
}

/// A pure number.
pub(super) const PURE: Unit = Unit::new(Dimension::Pure, 1.0, "", 0.005);
/// Degrees that are degrees in the scene too.
pub(super) const DEGREES: Unit = Unit::new(Dimension::Angle, 1.0, "°", 0.25);
/// Hertz.
pub(super) const HERTZ: Unit = Unit::new(Dimension::Frequency, 1.0, " Hz", 0.01);
/// Seconds.
pub(super) const SECONDS: Unit = Unit::new(Dimension::Time, 1.0, " s", 0.05);
/// Metres a second.
pub(super) const SPEED: Unit = Unit::new(Dimension::Speed, 1.0, " m/s", 0.01);
/// Millimetres a second.
pub(super) const SLOW: Unit = Unit::new(Dimension::Speed, 1e3, " mm/s", 0.01);
/// Degrees a second.
pub(super) const TURNING: Unit = Unit::new(Dimension::Turning, 1.0, " °/s", 0.1);
/// Multiples of standard gravity.
pub(super) const GRAVITIES: Unit = Unit::new(Dimension::Acceleration, 1.0, " g", 0.005);
/// Newton metres.
pub(super) const MOMENTS: Unit = Unit::new(Dimension::Moment, 1.0, " N m", 1.0);
/// Pascals, in thousands of millions.
pub(super) const MODULUS: Unit = Unit::new(Dimension::Pressure, 1e-9, " GPa", 0.1);

/// Lengths of a scene: millimetres on the bench, metres at a bridge.
pub(super) fn length_unit(size: f64) -> Unit {
    if size < 2.0 {
        Unit::new(Dimension::Length, 1e3, " mm", 0.1)
    } else {
        Unit::new(Dimension::Length, 1.0, " m", 0.01)
    }
}

/// Masses of a scene: kilograms or tonnes.
pub(super) fn mass_unit(mass: f64) -> Unit {
    if mass < 5e3 { Unit::new(Dimension::Mass, 1.0, " kg", 0.01) } else { Unit::new(Dimension::Mass, 1e-3, " t", 1.0) }
}

/// Forces: newtons or kilonewtons, as the weight of the body is.
pub(super) fn force_unit(mass: f64) -> Unit {
    if mass < 5e3 { Unit::new(Dimension::Force, 1.0, " N", 0.1) } else { Unit::new(Dimension::Force, 1e-3, " kN", 1.0) }
}

/// Stiffnesses: as readable as they come.
pub(super) fn stiffness_unit(k: f64) -> Unit {
    match k.abs() {
        k if k >= 1e9 => Unit::new(Dimension::Stiffness, 1e-9, " GN/m", 0.01),
        k if k >= 1e6 => Unit::new(Dimension::Stiffness, 1e-6, " MN/m", 0.01),
        k if k >= 1e4 => Unit::new(Dimension::Stiffness, 1e-3, " kN/m", 0.1),
        _ => Unit::new(Dimension::Stiffness, 1.0, " N/m", 1.0),
    }
}

/// Dashpots: as readable as they come.
pub(super) fn damping_unit(c: f64) -> Unit {
    if c.abs() >= 1e4 {
        Unit::new(Dimension::Damping, 1e-3, " kN s/m", 0.1)
    } else {
        Unit::new(Dimension::Damping, 1.0, " N s/m", 0.1)
    }
}

/// Where a field's value stands in the scene file, and what is wrong with it.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    /// Complaints about the scene.
    pub problems: Option<&'a SceneErrors>,
    /// `girder.deck`, `contact`, `motion`.
    pub table: &'a str,
}

impl Place<'_> {
    fn complaint(&self, key: &str) -> Option<String> {
        let errors = &self.problems?.0;
        let place = format!("{}.{key}", self.table);
        // An index or a suffix may follow the key: `position_m[0]`.
        let own = |p: &str| p == place || p.strip_prefix(&place).is_some_and(|rest| rest.starts_with(['[', '.']));
        errors.iter().find(|e| own(&e.place)).map(|e| format!("{}: {}", e.value, e.remedy))
    }
}

/// What the hand did to a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Change {
    /// The same for all changes of one drag; none for typing and keys.
    pub gesture: Option<u64>,
}

/// Takes the number shown back into the scene; not when it is the same but for the rounding of two conversions.
fn take(value: &mut f64, shown: f64, unit: Unit, change: Option<Change>) -> Option<Change> {
    let new = shown / unit.factor;
    let same = (new - *value).abs() <= 1e-13 * value.abs();
    if change.is_none() || same || !new.is_finite() {
        return None;
    }
    *value = new;
    change
}

/// The gesture that a response belongs to, if it has just changed its value.
pub(super) fn change(ui: &Ui, response: &Response) -> Option<Change> {
    if !response.changed() {
        return None;
    }
    let pressed = ui.input(|i| i.pointer.press_start_time());
    let held = response.is_pointer_button_down_on() || response.dragged();
    Some(Change { gesture: pressed.filter(|_| held).map(|t| response.id.value() ^ t.to_bits()) })
}

/// A row of a two-column grid with a number that can be typed or dragged.
pub(super) fn number(
    ui: &mut Ui,
    place: Place<'_>,
    (key, label): (&str, &str),
    value: &mut f64,
    unit: Unit,
    least: f64,
) -> Option<Change> {
    let complaint = place.complaint(key);
    let name = ui.label(named(ui, label, complaint.is_some()));
    let mut shown = *value * unit.factor;
    let least = if least.is_finite() { least * unit.factor } else { f64::NEG_INFINITY };
    let drag = DragValue::new(&mut shown)
        .speed(unit.speed)
        .suffix(unit.suffix)
        .max_decimals(6)
        .custom_formatter(|v, _| trimmed(v))
        .custom_parser(|text| units::parse(text, unit))
        .range(least..=f64::INFINITY)
        .clamp_existing_to_range(false)
        .update_while_editing(false);
    let response = ui.add_sized([96.0, 20.0], drag).labelled_by(name.id);
    let change = take(value, shown, unit, change(ui, &response));
    ui.end_row();
    if let Some(complaint) = complaint {
        complain(ui, &complaint);
        ui.end_row();
    }
    change
}

/// Width of the names in front of sliders \[points\].
const NAMES: f32 = 82.0;

/// Width of the number behind a slider \[points\].
const NUMBERS: f32 = 72.0;

/// A row with a name, a slider and its number.
pub(super) fn slider(
    ui: &mut Ui,
    place: Place<'_>,
    (key, label): (&str, &str),
    value: &mut f64,
    unit: Unit,
    range: std::ops::RangeInclusive<f64>,
) -> Option<Change> {
    let complaint = place.complaint(key);
    let mut shown = *value * unit.factor;
    let (low, high) = (range.start() * unit.factor, range.end() * unit.factor);
    let slider = Slider::new(&mut shown, low..=high)
        .suffix(unit.suffix)
        .max_decimals(4)
        .custom_formatter(|v, _| trimmed(v))
        .custom_parser(|text| units::parse(text, unit))
        .clamping(egui::SliderClamping::Edits)
        .update_while_editing(false);
    let response = slider_row(ui, named(ui, label, complaint.is_some()), slider, "");
    let change = take(value, shown, unit, change(ui, &response));
    if let Some(complaint) = complaint {
        complain(ui, &complaint);
    }
    change
}

/// Lays a slider out behind its name, both as wide as in every other row; `after` stands where its number would.
pub(super) fn slider_row(ui: &mut Ui, name: RichText, slider: Slider<'_>, after: &str) -> Response {
    ui.horizontal(|ui| {
        let label = ui
            .scope(|ui| {
                ui.set_min_width(NAMES);
                ui.set_max_width(NAMES);
                ui.add(egui::Label::new(name).truncate())
            })
            .inner;
        ui.spacing_mut().slider_width = (ui.available_width() - NUMBERS - ui.spacing().item_spacing.x).max(40.0);
        ui.spacing_mut().interact_size.x = NUMBERS;
        let response = ui.add(slider).labelled_by(label.id);
        if !after.is_empty() {
            ui.add(egui::Label::new(after).truncate());
        }
        response
    })
    .inner
}

fn named(ui: &Ui, label: &str, wrong: bool) -> RichText {
    let text = RichText::new(label);
    if wrong { text.color(Palette::of(ui).problem).strong() } else { text }
}

/// The complaint, under the field.
fn complain(ui: &mut Ui, complaint: &str) {
    let color = Palette::of(ui).problem;
    ui.add(egui::Label::new(RichText::new(complaint).color(color).small()).wrap());
}

/// Rounded to a power of ten, with no digits beyond it.
pub(super) fn rounded(value: f64, step: f64) -> f64 {
    // Dividing by a whole number keeps the decimal digits short, multiplying by 0.0001 does not.
    if step < 1.0 {
        let per_unit = (1.0 / step).round();
        (value * per_unit).round() / per_unit
    } else {
        (value / step).round() * step
    }
}

/// Up to six decimals, none of them needless.
pub(super) fn trimmed(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::SceneError;

    #[test]
    fn a_complaint_stands_at_its_field_only() {
        let error = |place: &str| SceneError {
            file: "f".into(),
            place: place.into(),
            value: "-1".into(),
            remedy: "give more than 0".into(),
        };
        let errors = SceneErrors(vec![error("girder.deck.mass_kg")]);
        let place = Place { problems: Some(&errors), table: "girder.deck" };
        assert_eq!(place.complaint("mass_kg").as_deref(), Some("-1: give more than 0"), "its own");
        assert_eq!(place.complaint("length_m"), None, "another's");
    }

    #[test]
    fn numbers_show_no_needless_zeros() {
        assert_eq!(trimmed(3.2), "3.2", "short");
        assert_eq!(trimmed(-1e-9), "0", "no minus zero");
    }
}
