//! One value in a panel: its label, its unit, what is allowed, what it is by itself, its complaint, the hand on it.
//!
//! What may stand in a field and its default come from [`keys`], as the checks of a scene do. Every field says them to
//! the mouse and to a screen reader; one that is not as it would be by itself has a small sign beside it that takes it
//! back, and so do its context menu and an emptied field.

mod choice;
mod frame;
mod number;
mod slider;
mod unit;
pub(super) mod units;

use egui::{Id, Response, Ui};

use crate::scene::SceneErrors;
use crate::scene::keys::{self, Key};

pub(in crate::app) use choice::{choice, choice_line};
use frame::reset_sign;
pub(in crate::app) use frame::{act, complain, mark, tag};
pub(in crate::app) use number::{laid_over, number, optional};
use slider::line;
pub(in crate::app) use slider::{slider, slider_of, slider_row};
pub(in crate::app) use unit::*;

/// Where a field's value stands in the scene file, and what is wrong with it.
#[derive(Clone, Copy)]
pub(in crate::app) struct Place<'a> {
    /// Complaints about the scene.
    pub problems: Option<&'a SceneErrors>,
    /// `girder.deck`, `contact`, `motion`; empty for the top of the file.
    pub table: &'a str,
}

impl Place<'_> {
    /// The way to a key from the top of the file.
    pub(in crate::app) fn path(&self, key: &str) -> String {
        if self.table.is_empty() { key.to_owned() } else { format!("{}.{key}", self.table) }
    }

    pub(in crate::app) fn complaint(&self, key: &str) -> Option<String> {
        let errors = &self.problems?.0;
        let place = self.path(key);
        // An index or a suffix may follow the key: `position_m[0]`.
        let own = |p: &str| p == place || p.strip_prefix(&place).is_some_and(|rest| rest.starts_with(['[', '.']));
        errors.iter().find(|e| own(&e.place)).map(|e| format!("{}: {}", e.value, e.remedy))
    }
}

/// What the hand did to a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) struct Change {
    /// The same for all changes of one drag; none for typing and keys.
    pub gesture: Option<u64>,
}

/// What a button, a box or a typed number did.
pub(in crate::app) const CLICK: Option<Change> = Some(Change { gesture: None });

/// A field that is about to be shown.
struct Field<'a> {
    place: Place<'a>,
    key: &'a str,
    label: &'a str,
    unit: Unit,
    known: Option<&'static Key>,
    /// Tells it from other fields of the same key.
    scope: Id,
}

/// What was done to a number in a field.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Done {
    /// It is this now, in the unit of the scene.
    Set(f64, Change),
    /// It is as it would be by itself.
    Reset,
}

impl<'a> Field<'a> {
    fn new(ui: &Ui, place: Place<'a>, (key, label): (&'a str, &'a str), unit: Unit) -> Self {
        let known = keys::of_place(&place.path(key)).map(|(_, key)| key);
        Self { place, key, label, unit, known, scope: ui.scope_id() }
    }

    fn range(&self) -> keys::Range {
        self.known.map_or(keys::Range::Any, |key| key.range)
    }
}

/// The gesture that a response belongs to, if it has just changed its value.
pub(in crate::app) fn change(ui: &Ui, response: &Response) -> Option<Change> {
    if !response.changed() {
        return None;
    }
    let pressed = ui.input(|i| i.pointer.press_start_time());
    let held = response.is_pointer_button_down_on() || response.dragged();
    Some(Change { gesture: pressed.filter(|_| held).map(|t| response.id.value() ^ t.to_bits()) })
}

/// Rounded to a power of ten, with no digits beyond it.
pub(in crate::app) fn rounded(value: f64, step: f64) -> f64 {
    // Dividing by a whole number keeps the decimal digits short, multiplying by 0.0001 does not.
    if step < 1.0 {
        let per_unit = (1.0 / step).round();
        (value * per_unit).round() / per_unit
    } else {
        (value / step).round() * step
    }
}

/// Up to six decimals, none of them needless.
pub(in crate::app) fn trimmed(value: f64) -> String {
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
