//! The name of what is selected: typed freely, given when the field is left.

use egui::{Id, TextEdit, Ui};

use crate::app::command::{Command, EditCommand};
use crate::app::field::{Named, Place, tag};
use crate::app::text;
use crate::view::Target;

/// A grid row with the name of a body.
pub(in crate::app) fn show(ui: &mut Ui, place: Place<'_>, target: Target, name: &str, out: &mut Vec<Command>) {
    let label = ui.label(text::NAME);
    let draft_id = Id::unique(("name draft", target));
    let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(|| name.to_owned());
    let response = ui.add(TextEdit::singleline(&mut draft).desired_width(104.0)).labelled_by(label.id);
    let response = tag(ui, &response, place, Named { key: "name", label: text::NAME.as_str() });
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(draft_id, draft));
    } else {
        ui.data_mut(|d| d.remove::<String>(draft_id));
        if response.lost_focus() && draft != name {
            out.push(EditCommand::Rename(target, draft).into());
        }
    }
    ui.end_row();
}
