//! Where a field's value stands in the scene file, and what a hand did to it.

use egui::{Response, Ui};

use crate::scene::{SceneErrors, is_assumed};

/// Where a field's value stands in the scene file, and what is wrong with it.
#[derive(Clone, Copy)]
pub(in crate::app) struct Place<'a> {
    /// Complaints about the scene.
    pub problems: Option<&'a SceneErrors>,
    /// Values that were not given.
    pub assumed: &'a [String],
    /// Ways to keys whose values are not the same for all that are selected.
    pub differing: &'a [String],
    /// `girder.deck`, `contact`, `motion`; empty for the top of the file.
    pub table: &'a str,
}

impl<'a> Place<'a> {
    /// Of values that are not checked, or of another form than the scene's.
    pub(in crate::app) fn apart(table: &'a str) -> Self {
        Self { problems: None, assumed: &[], differing: &[], table }
    }

    /// The way to a key from the top of the file.
    pub(in crate::app) fn path(&self, key: &str) -> String {
        if self.table.is_empty() { key.to_owned() } else { format!("{}.{key}", self.table) }
    }

    /// Whether a key's value was not given.
    pub(in crate::app) fn is_assumed(&self, key: &str) -> bool {
        !self.assumed.is_empty() && is_assumed(self.assumed, &self.path(key))
    }

    /// Whether a key's value is not the same for all that are selected.
    pub(in crate::app) fn differs(&self, key: &str) -> bool {
        !self.differing.is_empty() && self.differing.contains(&self.path(key))
    }

    pub(in crate::app) fn complaint(&self, key: &str) -> Option<String> {
        let errors = &self.problems?.0;
        let place = self.path(key);
        // An index or a suffix may follow the key: `position_m[0]`.
        let own = |p: &str| p == place || p.strip_prefix(&place).is_some_and(|rest| rest.starts_with(['[', '.']));
        errors.iter().find(|e| own(e.place.plain())).map(|e| format!("{}: {}", e.value, e.remedy))
    }
}

/// Key of a value in the scene file, and its name in the window.
#[derive(Clone, Copy)]
pub(in crate::app) struct Named<'a> {
    /// Key in its table; empty where the value is none of a scene's.
    pub key: &'a str,
    /// Name in the language of the user.
    pub label: &'a str,
}

/// Change of a field by the hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) struct Change {
    /// The same for all changes of one drag; none for typing and keys.
    pub gesture: Option<u64>,
}

/// Change by a button, a box or a typed number.
pub(in crate::app) const CLICK: Option<Change> = Some(Change { gesture: None });

/// The gesture that a response belongs to, if it has just changed its value.
pub(in crate::app) fn change(ui: &Ui, response: &Response) -> Option<Change> {
    if !response.changed() {
        return None;
    }
    let pressed = ui.input(|i| i.pointer.press_start_time());
    let held = response.is_pointer_button_down_on() || response.dragged();
    Some(Change { gesture: pressed.filter(|_| held).map(|t| response.id.value() ^ t.to_bits()) })
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
        let place = Place { problems: Some(&errors), ..Place::apart("girder.deck") };
        assert_eq!(place.complaint("mass_kg").as_deref(), Some("-1: give more than 0"), "its own");
        assert_eq!(place.complaint("length_m"), None, "another's");
    }
}
