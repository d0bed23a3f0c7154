//! A row with a name, a slider and its number.

use egui::{Response, RichText, Slider, Ui};

use super::entry::{Done, Field};
use super::frame::{self, Own, SIGN, complain, reset_sign};
use super::number::{Typed, reader, refusal};
use super::place::{CLICK, Change, Named, Place};
use crate::app::unit::Unit;
use crate::scene::keys::Key;

/// Width of the names in front of sliders \[points\].
const NAMES: f32 = 82.0;

/// Width of the number behind a slider \[points\].
const NUMBERS: f32 = 72.0;

/// Least length of a slider \[points\].
const SHORTEST: f32 = 24.0;

/// From where to where a slider goes: a part of what is allowed; what is typed may lie beyond.
pub(in crate::app) type Bounds = std::ops::RangeInclusive<f64>;

/// A slider for a number that the scene always has.
pub(in crate::app) fn slider(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    value: &mut f64,
    unit: Unit,
    bounds: Bounds,
) -> Option<Change> {
    let field = Field::new(ui, place, names, unit);
    let default = field.known.and_then(Key::number);
    let own = Own { words: default.map(|v| unit.words(v)), differs: default.is_some_and(|v| v != *value) };
    match field.slide(ui, *value, bounds, &own)? {
        Done::Set(new, change) => {
            *value = new;
            Some(change)
        }
        Done::Reset => {
            *value = default?;
            CLICK
        }
    }
}

/// A slider for a number that the scene may have; without it, it is `reckoned`.
pub(in crate::app) fn slider_of(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    (value, reckoned): (&mut Option<f64>, f64),
    unit: Unit,
    bounds: Bounds,
) -> Option<Change> {
    let field = Field::new(ui, place, names, unit);
    let own = Own { words: Some(unit.words(reckoned)), differs: value.is_some() };
    match field.slide(ui, value.unwrap_or(reckoned), bounds, &own)? {
        Done::Set(new, change) => {
            *value = Some(new);
            Some(change)
        }
        Done::Reset => {
            *value = None;
            CLICK
        }
    }
}

impl Field<'_> {
    fn slide(&self, ui: &mut Ui, value: f64, bounds: Bounds, own: &Own) -> Option<Done> {
        let complaint = self.place.complaint(self.names.key);
        let (unit, typed) = (self.unit, Typed::default());
        let mut shown = value * unit.factor;
        let number = number_width(ui, format!("{}{}", unit.written(shown), unit.suffix));
        let slider = Slider::new(&mut shown, bounds.start() * unit.factor..=bounds.end() * unit.factor)
            .suffix(unit.suffix)
            .max_decimals(4)
            .custom_formatter(|v, _| unit.written(v))
            .custom_parser(reader(&typed, unit))
            .clamping(egui::SliderClamping::Never)
            .update_while_editing(false);
        let name = frame::named(ui, self.place, self.names);
        let differs = own.words.as_deref().filter(|_| own.differs);
        let (response, pressed) = line(ui, name, (self.names.label, differs), |ui| slider_in(ui, slider, (number, "")));
        let menu = frame::menu(&response, own);
        let done =
            if menu || pressed { Some(Done::Reset) } else { self.done(ui, &response, (value, shown), own, typed) };
        for words in refusal(ui, self.refused()).into_iter().chain(complaint) {
            complain(ui, &words);
        }
        done
    }
}

/// A name, something behind it, and the sign that takes it back; all as wide as in every other row.
pub(in crate::app) fn line(
    ui: &mut Ui,
    name: RichText,
    (label, differs): (&str, Option<&str>),
    body: impl FnOnce(&mut Ui) -> Response,
) -> (Response, bool) {
    ui.horizontal(|ui| {
        let name = ui
            .scope(|ui| {
                ui.set_min_width(NAMES);
                ui.set_max_width(NAMES);
                ui.add(egui::Label::new(name).truncate())
            })
            .inner;
        ui.spacing_mut().item_spacing.x = 4.0;
        let response = body(ui).labelled_by(name.id);
        let pressed = reset_sign(ui, label, differs);
        (response, pressed)
    })
    .inner
}

/// Width of the number behind a slider: a long one takes from the slider, for a row wider than its panel would widen that frame by frame
/// \[points\].
fn number_width(ui: &Ui, words: String) -> f32 {
    let words = egui::WidgetText::from(words).into_galley(
        ui,
        Some(egui::TextWrapMode::Extend),
        f32::INFINITY,
        egui::TextStyle::Button,
    );
    (words.size().x + 2.0 * ui.spacing().button_padding.x).max(NUMBERS)
}

/// A slider that leaves room for its number, of a width, and the sign; `after` stands where its number would.
fn slider_in(ui: &mut Ui, slider: Slider<'_>, (number, after): (f32, &str)) -> Response {
    let spacing = ui.spacing().item_spacing.x;
    ui.spacing_mut().slider_width = (ui.available_width() - number - SIGN - 2.0 * spacing).max(SHORTEST);
    ui.spacing_mut().interact_size.x = NUMBERS;
    let response = ui.add(slider);
    if !after.is_empty() {
        ui.add_sized([NUMBERS, 18.0], egui::Label::new(after).truncate());
    }
    response
}

/// Lays a slider out behind its name, both as wide as in every other row; `after` stands where its number would.
pub(in crate::app) fn slider_row(ui: &mut Ui, name: RichText, slider: Slider<'_>, after: &str) -> Response {
    line(ui, name, ("", None), |ui| slider_in(ui, slider, (NUMBERS, after))).0
}
