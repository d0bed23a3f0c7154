//! One of a few, by name.

use egui::{ComboBox, Response, Ui};

use super::frame::{self, SIGN, complain, reset_sign};
use super::place::{CLICK, Change, Named, Place};
use super::slider::line;
use crate::app::text;
use crate::scene::keys;

/// Choices, each with its text.
pub(in crate::app) type Choice<'a, T> = &'a [(T, &'a str)];

/// A row of a two-column grid with a list to choose from.
pub(in crate::app) fn choice<T: Copy + PartialEq + Default>(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    value: &mut T,
    options: Choice<'_, T>,
) -> Option<Change> {
    choice_by(ui, place, names, value, options, T::default())
}

/// The same with another default than that of the type.
pub(super) fn choice_by<T: Copy + PartialEq>(
    ui: &mut Ui,
    place: Place<'_>,
    named: Named<'_>,
    value: &mut T,
    options: Choice<'_, T>,
    default: T,
) -> Option<Change> {
    let Named { key, label } = named;
    let (before, complaint) = (*value, place.complaint(key));
    let name = ui.label(frame::named(ui, place, named));
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        list(ui, (place, named), (value, default), options, 79.0).labelled_by(name.id);
        let differs = (before != default).then(|| word(default, options));
        if reset_sign(ui, label, differs) {
            *value = default;
        }
    });
    ui.end_row();
    if let Some(complaint) = complaint {
        complain(ui, &complaint);
        ui.end_row();
    }
    if *value == before { None } else { CLICK }
}

/// A row of a panel with a list to choose from.
pub(in crate::app) fn choice_line<T: Copy + PartialEq + Default>(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    value: &mut T,
    options: Choice<'_, T>,
) -> Option<Change> {
    choice_line_by(ui, place, names, value, options, T::default())
}

/// The same with another default than that of the type.
pub(super) fn choice_line_by<T: Copy + PartialEq>(
    ui: &mut Ui,
    place: Place<'_>,
    named: Named<'_>,
    value: &mut T,
    options: Choice<'_, T>,
    default: T,
) -> Option<Change> {
    let Named { key, label } = named;
    let (before, complaint) = (*value, place.complaint(key));
    let name = frame::named(ui, place, named);
    let differs = (before != default).then(|| word(default, options));
    let (_, pressed) = line(ui, name, (label, differs), |ui| {
        let wide = ui.available_width() - SIGN - 8.0;
        list(ui, (place, named), (value, default), options, wide)
    });
    if pressed {
        *value = default;
    }
    if let Some(complaint) = complaint {
        complain(ui, &complaint);
    }
    if *value == before { None } else { CLICK }
}

fn word<T: PartialEq + Copy>(value: T, options: Choice<'_, T>) -> &str {
    options.iter().find(|(option, _)| *option == value).map_or("", |(_, word)| word)
}

fn list<T: Copy + PartialEq>(
    ui: &mut Ui,
    (place, Named { key, label }): (Place<'_>, Named<'_>),
    (value, default): (&mut T, T),
    options: Choice<'_, T>,
    width: f32,
) -> Response {
    let shown = word(*value, options);
    let path = place.path(key);
    let quiet = ui.visuals().override_text_color;
    let combo = ComboBox::from_id_salt((path.as_str(), label)).width(width).selected_text(shown).truncate();
    let response = combo
        .show_ui(ui, |ui| {
            ui.visuals_mut().override_text_color = quiet;
            for (option, word) in options {
                ui.selectable_value(value, *option, *word);
            }
        })
        .response;
    frame::say(ui, &response, &path, label, || {
        let known = keys::of_place(&path).map(|(_, key)| key);
        let words: Vec<&str> = options.iter().map(|(_, word)| *word).collect();
        frame::in_lines(known, &words.join(", "), &format!("{}: {}", text::DEFAULT, word(default, options)))
            + &frame::assumed_hint(place, key)
    })
}
