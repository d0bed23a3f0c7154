//! How the motion of the ground travels along the bridge.

use egui::Ui;

use crate::app::command::{Command, EditCommand};
use crate::app::field::{CLICK, Form, sliders};
use crate::app::text;
use crate::scene::Wave;
use crate::scene::edit::Edit;

/// Shows speed and direction, or the way to let it travel.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let look = form.look("wave");
    let mut new = form.scene.wave;
    let change = match &mut new {
        None => ui.button(text::WAVE_ADD).clicked().then(|| new = Some(Wave::default())).and(CLICK),
        Some(wave) => {
            let moved = sliders(ui, &look, wave, &[]);
            if ui.button(text::WAVE_REMOVE).clicked() {
                new = None;
                CLICK
            } else {
                moved
            }
        }
    };
    if let Some(change) = change {
        out.push(EditCommand::Change { edit: Edit::Wave(new), gesture: change.gesture }.into());
    }
}
