//! A list in a menu that is narrowed by typing.

use egui::containers::menu::{self, MenuButton, MenuConfig, SubMenuButton};
use egui::{Id, InnerResponse, IntoAtoms, PopupCloseBehavior, ScrollArea, TextEdit, Ui};

use crate::app::text;

/// Highest list \[points\].
const HIGHEST: f32 = 280.0;

/// A button that opens a list under a field. The field has the keyboard and stays open when it is clicked; `list` is given what was
/// typed, and closes the menu with what was chosen.
pub(in crate::app) fn narrowed<'a, R>(
    ui: &mut Ui,
    words: impl IntoAtoms<'a>,
    (id, width): (Id, f32),
    list: impl FnOnce(&mut Ui, &str) -> Option<R>,
) -> InnerResponse<Option<R>> {
    let content = |ui: &mut Ui| {
        let mut part = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_default();
        let field = ui.add(TextEdit::singleline(&mut part).hint_text(text::NARROW).desired_width(width));
        if ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        let chosen = ScrollArea::vertical().max_height(HIGHEST).show(ui, |ui| list(ui, part.trim())).inner;
        if chosen.is_some() {
            part.clear();
            ui.close();
        }
        ui.data_mut(|data| data.insert_temp(id, part));
        chosen
    };
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let (response, inner) = if menu::is_in_menu(ui) {
        SubMenuButton::new(words).config(config).ui(ui, content)
    } else {
        MenuButton::new(words).config(config).ui(ui, content)
    };
    InnerResponse::new(inner.and_then(|inner| inner.inner), response)
}
