//! A field that is about to be shown, and what was done to its number.

use egui::{Id, Ui};

use super::place::{Change, Named, Place};
use crate::app::unit::Unit;
use crate::scene::keys::{self, Key};

/// A field that is about to be shown.
pub(super) struct Field<'a> {
    pub(super) place: Place<'a>,
    pub(super) names: Named<'a>,
    pub(super) unit: Unit,
    pub(super) known: Option<&'static Key>,
    /// Tells it from other fields of the same key.
    pub(super) scope: Id,
}

/// Entry into a number's field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Done {
    /// It is this now, in the unit of the scene.
    Set(f64, Change),
    /// It is as it would be by itself.
    Reset,
}

impl<'a> Field<'a> {
    pub(super) fn new(ui: &Ui, place: Place<'a>, names: Named<'a>, unit: Unit) -> Self {
        let known = keys::of_place(&place.path(names.key)).map(|(_, key)| key);
        Self { place, names, unit, known, scope: ui.scope_id() }
    }

    pub(super) fn range(&self) -> keys::Range {
        self.known.map_or(keys::Range::Any, |key| key.range)
    }
}
