//! Fields for a whole table of the scene file, made from its keys: what each is called, its unit, range, default, meaning
//! and slider stand with the key, so that a new key of a table has its field here without being named.

use egui::Ui;

use super::choice::{choice_by, choice_line_by};
use super::frame::tag;
use super::number::{laid_over, number, optional, switched};
use super::place::{CLICK, Change, Named, Place};
use super::slider::{Bounds, slider, slider_of};
use crate::app::text;
use crate::app::unit::{Size, Unit, unit_of};
use crate::scene::Kind;
use crate::scene::keys::{self, Editable, Fallback, Key, Slot, Word};
use crate::scene::overrides::replaced_by;

/// Value of a number that the table leaves out, in the unit of its key.
#[derive(Clone, Copy)]
pub(in crate::app) enum Without<'a> {
    /// Reckoned from other values.
    Reckoned(&'a dyn Fn(&Key) -> f64),
    /// That of what the table is laid over.
    Under(&'a dyn Fn(&Key) -> f64),
    /// Nothing; switched on it begins with this.
    Off(&'a dyn Fn(&Key) -> f64),
}

/// Context of the fields of a table beside its keys.
#[derive(Clone, Copy)]
pub(in crate::app) struct Look<'a> {
    /// Where the table stands.
    pub place: Place<'a>,
    /// Whether there is a third direction.
    pub kind: Kind,
    /// Size that units follow.
    pub size: Size,
    /// Whose numbers they are, empty of the table alone: a field of a `pair` is called `K of pair`.
    pub whose: &'a str,
    /// Numbers that are left out.
    pub without: Without<'a>,
}

impl<'a> Look<'a> {
    /// A table of which nothing is left out, or what is left out is shown elsewhere.
    pub(in crate::app) fn new(place: Place<'a>, kind: Kind, size: Size) -> Self {
        Self { place, kind, size, whose: "", without: Without::Off(&|_| 0.0) }
    }

    /// Whether a scene of this kind has no such quantity.
    fn lacks(&self, key: &Key) -> bool {
        key.spatial && self.kind == Kind::Planar
    }

    fn label(&self, key: &Key) -> String {
        let name = text::field(key);
        if self.whose.is_empty() { name.to_owned() } else { text::of_whom(name, self.whose) }
    }

    fn unit(&self, key: &Key, now: f64) -> Unit {
        unit_of(&self.place.path(key.name), now, self.size)
    }

    fn unit_of_optional(&self, key: &Key, value: Option<f64>) -> Unit {
        let (Without::Reckoned(other) | Without::Under(other) | Without::Off(other)) = self.without;
        self.unit(key, value.unwrap_or_else(|| other(key)))
    }
}

/// Rows of a two-column grid for every key of a table that a plain field can show, but for those `apart`.
pub(in crate::app) fn rows(ui: &mut Ui, look: &Look<'_>, table: &mut impl Editable, apart: &[&str]) -> Option<Change> {
    each(table, apart, |key, slot| row(ui, look, key, slot))
}

/// Sliders, and lists of words, as rows of a panel: for every key of a table that has one, but for those `apart`.
pub(in crate::app) fn sliders(
    ui: &mut Ui,
    look: &Look<'_>,
    table: &mut impl Editable,
    apart: &[&str],
) -> Option<Change> {
    each(table, apart, |key, slot| panel_row(ui, look, key, slot))
}

/// The slider of one key; none where it has none.
pub(in crate::app) fn slider_at(ui: &mut Ui, look: &Look<'_>, key: &str, value: &mut f64) -> Option<Change> {
    let (_, key) = keys::of_place(&look.place.path(key))?;
    panel_row(ui, look, key, Slot::Number(value))
}

/// The slider of one key between other bounds.
pub(in crate::app) fn slider_between(
    ui: &mut Ui,
    look: &Look<'_>,
    key: &str,
    value: &mut f64,
    bounds: Bounds,
) -> Option<Change> {
    let (_, key) = keys::of_place(&look.place.path(key))?;
    let unit = look.unit(key, *value);
    slider(ui, look.place, Named { key: key.name, label: &look.label(key) }, value, unit, bounds)
}

/// The row of one number.
pub(in crate::app) fn number_at(ui: &mut Ui, look: &Look<'_>, key: &str, value: &mut f64) -> Option<Change> {
    let (_, key) = keys::of_place(&look.place.path(key))?;
    row(ui, look, key, Slot::Number(value))
}

/// The row of one number that a table may have.
pub(in crate::app) fn optional_at(ui: &mut Ui, look: &Look<'_>, key: &str, value: &mut Option<f64>) -> Option<Change> {
    let (_, key) = keys::of_place(&look.place.path(key))?;
    row(ui, look, key, Slot::Optional(value))
}

/// Shows each key; what was given last stands, and other ways of saying the same go.
fn each(
    table: &mut impl Editable,
    apart: &[&str],
    mut show: impl FnMut(&'static Key, Slot<'_>) -> Option<Change>,
) -> Option<Change> {
    let mut changed = None;
    for (key, slot) in table.slots() {
        if !apart.contains(&key.name) {
            changed = show(key, slot).map(|change| (key, change)).or(changed);
        }
    }
    let (key, change) = changed?;
    let is_given = |(other, slot): &(&Key, Slot<'_>)| other.name == key.name && !matches!(slot, Slot::Optional(None));
    if table.slots().iter().any(is_given) {
        for (other, slot) in table.slots() {
            if let (Slot::Optional(value), true) = (slot, replaced_by(key.name).contains(&other.name)) {
                *value = None;
            }
        }
    }
    Some(change)
}

fn row(ui: &mut Ui, look: &Look<'_>, key: &'static Key, slot: Slot<'_>) -> Option<Change> {
    if look.lacks(key) {
        return None;
    }
    let (place, label) = (look.place, look.label(key));
    let names = Named { key: key.name, label: &label };
    match slot {
        Slot::Number(value) => {
            let unit = look.unit(key, *value);
            number(ui, place, names, value, unit)
        }
        Slot::Optional(value) => optional_row(ui, look, key, &label, value),
        Slot::Numbers(values) => {
            let mut change = None;
            let components = values.iter_mut().zip(["x", "y", "z"]).take(components(key, look.kind));
            for (i, (value, axis)) in components.enumerate() {
                let unit = look.unit(key, *value);
                // One number may be the same where another one differs.
                let differs = place.differs(&format!("{}[{i}]", key.name));
                let place = Place { differing: if differs { place.differing } else { &[] }, ..place };
                change = number(ui, place, Named { key: key.name, label: &format!("{label} {axis}") }, value, unit)
                    .or(change);
            }
            change
        }
        Slot::Switch(value) => {
            ui.label("");
            let response = ui.checkbox(value, &label);
            let changed = tag(ui, &response, place, names).changed();
            ui.end_row();
            if changed { CLICK } else { None }
        }
        Slot::Word(word) => {
            let (mut chosen, default) = (word.chosen, word.default);
            let change = choice_by(ui, place, names, &mut chosen, &options(&word), default);
            change.inspect(|_| word.choose(chosen))
        }
        Slot::Apart => None,
    }
}

fn optional_row(
    ui: &mut Ui,
    look: &Look<'_>,
    key: &'static Key,
    label: &str,
    value: &mut Option<f64>,
) -> Option<Change> {
    let (place, names, unit) = (look.place, Named { key: key.name, label }, look.unit_of_optional(key, *value));
    // What another key says in its place is reckoned, or off.
    let otherwise = value.is_none() && !matches!(look.without, Without::Under(_));
    if let (Fallback::Needed(_), false) = (key.fallback, otherwise) {
        let mut given = value.unwrap_or(0.0);
        let change = number(ui, place, names, &mut given, unit);
        return change.inspect(|_| *value = Some(given));
    }
    match look.without {
        Without::Reckoned(other) => {
            optional(ui, place, names, (value, key.number().unwrap_or_else(|| other(key))), unit)
        }
        Without::Under(other) => laid_over(ui, place, names, (value, other(key)), unit),
        Without::Off(first) => switched(ui, place, names, (value, first(key)), unit),
    }
}

fn panel_row(ui: &mut Ui, look: &Look<'_>, key: &'static Key, slot: Slot<'_>) -> Option<Change> {
    if look.lacks(key) {
        return None;
    }
    let (place, label) = (look.place, look.label(key));
    let names = Named { key: key.name, label: &label };
    let bounds = key.slider.map(|[from, to]| Bounds::new(from, to));
    match (slot, bounds) {
        (Slot::Number(value), Some(bounds)) => {
            let unit = look.unit(key, *value);
            slider(ui, place, names, value, unit, bounds)
        }
        (Slot::Optional(value), Some(bounds)) => {
            let unit = look.unit_of_optional(key, *value);
            match (look.without, value) {
                (Without::Off(_), None) => None,
                (Without::Off(_), Some(value)) => slider(ui, place, names, value, unit, bounds),
                (Without::Reckoned(other) | Without::Under(other), value) => {
                    slider_of(ui, place, names, (value, other(key)), unit, bounds)
                }
            }
        }
        (Slot::Word(word), _) => {
            let (mut chosen, default) = (word.chosen, word.default);
            let change = choice_line_by(ui, place, names, &mut chosen, &options(&word), default);
            change.inspect(|_| word.choose(chosen))
        }
        _ => None,
    }
}

/// The words as choices, and that of having none where the key may be left out.
fn options(word: &Word<'_>) -> Vec<(Option<usize>, &'static str)> {
    let none = word.default.is_none().then_some((None, text::THE_SCENES.as_str()));
    none.into_iter()
        .chain(word.words.iter().enumerate().map(|(n, one)| (Some(n), keys::word_told(word.words, one))))
        .collect()
}

/// How many of three components there are to be given.
fn components(key: &Key, kind: Kind) -> usize {
    match key.fallback {
        Fallback::Zeros(count) if kind == Kind::Planar => count,
        _ => 3,
    }
}
