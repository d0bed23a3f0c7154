//! Frame of a value: its hint, the sign that resets it, its complaint.

use egui::{Button, Response, RichText, Ui, vec2};

use super::entry::Field;
use super::place::{Named, Place};
use crate::app::style::icons::{self, Icon};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::unit::{PURE, Unit};
use crate::language::Text;
use crate::scene::keys::{self, Fallback, Key};

/// Room for the sign that takes a value back \[points\].
pub(super) const SIGN: f32 = 15.0;

/// A value's default as it is shown now, and whether the value is another.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Own {
    /// In words, with its unit; none when it must be given.
    pub(super) words: Option<String>,
    /// Whether there is anything to take back.
    pub(super) differs: bool,
}

impl Field<'_> {
    pub(super) fn hint(&self, own: &Own) -> String {
        hint(self.known, self.unit, own) + &assumed_hint(self.place, self.names.key)
    }
}

/// That a value was not given, and that those that are selected have several.
pub(super) fn assumed_hint(place: Place<'_>, key: &str) -> String {
    let line = |said: bool, hint: Text| if said { format!("\n{hint}") } else { String::new() };
    line(place.is_assumed(key), text::ASSUMED_HINT) + &line(place.differs(key), text::DIFFERS_HINT)
}

/// The meaning, what is allowed, the default.
pub(super) fn hint(key: Option<&Key>, unit: Unit, own: &Own) -> String {
    let Some(key) = key else { return String::new() };
    let allowed = key.range.words(|v| unit.words(v));
    let told = key.fallback.told().unwrap_or_default();
    let default = match (&own.words, key.fallback) {
        (Some(words), Fallback::Words(from)) if words != from => format!("{}: {told} ({words})", text::DEFAULT),
        (Some(words), _) => format!("{}: {words}", text::DEFAULT),
        (None, Fallback::Needed(_)) => format!("{}: {told}", text::NO_DEFAULT),
        (None, Fallback::Words(_)) => format!("{}: {told}", text::DEFAULT),
        (None, _) => text::NO_DEFAULT.to_string(),
    };
    in_lines(Some(key), &allowed, &default)
}

/// The meaning, what is allowed, and a line about the default.
pub(super) fn in_lines(key: Option<&Key>, allowed: &str, default: &str) -> String {
    let Some(key) = key else { return String::new() };
    let meaning = key.meaning_told();
    // There is nothing below in the window.
    let meaning = meaning.replace(", see below", "");
    format!("{}: {meaning}\n{}: {allowed}\n{default}", key.name, text::ALLOWED)
}

/// Tells the mouse, a screen reader and whoever looks for it which key a widget is the field of.
pub(in crate::app) fn tag(ui: &Ui, response: &Response, place: Place<'_>, Named { key, label }: Named<'_>) -> Response {
    let path = place.path(key);
    let known = keys::of_place(&path).map(|(_, key)| key);
    let words = known.and_then(|key| match key.fallback {
        Fallback::Switch(on) => Some((if on { text::ON } else { text::OFF }).to_string()),
        Fallback::Word(word) => Some(key.word_told(word).to_owned()),
        _ => None,
    });
    say(ui, response, &path, label, || {
        hint(known, PURE, &Own { words: words.clone(), differs: false }) + &assumed_hint(place, key)
    })
}

/// The same for a widget that has more to say.
pub(super) fn say(ui: &Ui, response: &Response, path: &str, label: &str, words: impl Fn() -> String) -> Response {
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_author_id(format!("{path}/{label}"));
        node.set_description(words());
    });
    if keys::of_place(path).is_none() {
        return response.clone();
    }
    response.clone().on_hover_ui(|ui| {
        ui.set_max_width(300.0);
        ui.label(words());
    })
}

/// The sign that takes a value back, where there is something to take back; else its room. Whether it was pressed.
pub(in crate::app) fn reset_sign(ui: &mut Ui, label: &str, differs: Option<&str>) -> bool {
    let size = vec2(SIGN, 18.0);
    let Some(default) = differs else {
        ui.allocate_exact_size(size, egui::Sense::hover());
        return false;
    };
    let response = ui.add(Button::new("").frame(false).min_size(size));
    let words = format!("{} {label}", text::RESET_VALUE);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &words));
    let palette = Palette::of(ui);
    let near = response.hovered() || response.has_focus();
    let color = if near { ui.visuals().strong_text_color() } else { palette.weak };
    icons::draw(ui.painter(), response.rect, Icon::TakeBack, color);
    response.on_hover_text(format!("{} {default}", text::RESET_TO)).clicked()
}

/// The context menu of a value: take it back. Whether that was chosen.
pub(super) fn menu(response: &Response, own: &Own) -> bool {
    let mut chosen = false;
    let Some(default) = &own.words else { return false };
    response.context_menu(|ui| {
        if ui.add_enabled(own.differs, Button::new(format!("{} {default}", text::RESET_TO))).clicked() {
            chosen = true;
            ui.close();
        }
    });
    chosen
}

/// The name of a value: in italics where it was not given, with a sign where those that are selected have several, in the colour of
/// problems where it is wrong.
pub(in crate::app) fn named(ui: &Ui, place: Place<'_>, Named { key, label }: Named<'_>) -> RichText {
    let text = if place.differs(key) { RichText::new(format!("{label} ≠")) } else { RichText::new(label) };
    let text = if place.is_assumed(key) { text.italics() } else { text };
    if place.complaint(key).is_some() { text.color(Palette::of(ui).problem).strong() } else { text }
}

/// The complaint, under the field.
pub(in crate::app) fn complain(ui: &mut Ui, complaint: &str) {
    let color = Palette::of(ui).problem;
    ui.add(egui::Label::new(RichText::new(complaint).color(color).small()).wrap());
}

/// A button that makes, removes or chooses what stands under a key. Whether it was pressed.
pub(in crate::app) fn act(ui: &mut Ui, place: Place<'_>, key: &str, label: &str) -> bool {
    let response = ui.small_button(label);
    mark(&response, place, Named { key, label });
    response.clicked()
}

/// Only tells whoever looks for it which key a widget is for: its own hover text says more.
pub(in crate::app) fn mark(response: &Response, place: Place<'_>, Named { key, label }: Named<'_>) {
    response.ctx.accesskit_node_builder(response.id, |node| node.set_author_id(format!("{}/{label}", place.path(key))));
}
